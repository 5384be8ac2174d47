#pragma once

#include "hexoderm/session/session.h"

#include <functional>
#include <memory>
#include <vector>

namespace hexoderm {

/// The session with other captures: `change` gets every pose's.
inline Session withCaptures(const Session& session, const std::function<void(std::size_t pose, PoseCapture&)>& change) {
  Session result(session.model(), session.neighbors());
  for (std::size_t p = 0; p < session.poses().size(); ++p) {
    PoseCapture capture = *session.poses()[p].capture;
    change(p, capture);
    result.addPose({std::make_shared<const PoseCapture>(std::move(capture)), false});
  }
  return result;
}

/// The session with other readings: `change` gets every sample of every pose.
inline Session changed(const Session& session, const std::function<void(std::size_t pose, GravitySample&)>& change) {
  return withCaptures(session, [&](std::size_t pose, PoseCapture& capture) {
    for (GravitySample& sample : capture.samples) change(pose, sample);
  });
}

inline Session withoutReadings(const Session& session, CellId cell) {
  return withCaptures(session, [cell](std::size_t /*pose*/, PoseCapture& capture) {
    std::erase_if(capture.samples, [cell](const GravitySample& sample) { return sample.cell == cell; });
  });
}

/// The same poses of a skin that reports other neighbours.
inline Session withNeighbors(const Session& session, const NeighborList& neighbors) {
  Session result(session.model(), neighbors);
  for (const SessionPose& pose : session.poses()) result.addPose(pose);
  return result;
}

/// The poses at these indices, in this order.
inline Session onlyPosesOf(const Session& session, const std::vector<std::size_t>& indices) {
  Session result(session.model(), session.neighbors());
  for (const std::size_t index : indices) result.addPose(session.poses()[index]);
  return result;
}

}  // namespace hexoderm
