#pragma once

#include "hexoderm/session/session.h"

#include <functional>
#include <memory>

namespace hexoderm {

/// The session with other readings: `change` gets every sample of every pose.
inline Session changed(const Session& session, const std::function<void(std::size_t pose, GravitySample&)>& change) {
  Session result(session.model(), session.neighbors());
  for (std::size_t p = 0; p < session.poses().size(); ++p) {
    PoseCapture capture = *session.poses()[p].capture;
    for (GravitySample& sample : capture.samples) change(p, sample);
    result.addPose({std::make_shared<const PoseCapture>(capture), false});
  }
  return result;
}

}  // namespace hexoderm
