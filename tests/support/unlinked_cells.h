#pragma once

#include "hexoderm/session/session.h"
#include "tests/support/neighbor_lists.h"

#include <cstdint>
#include <memory>

namespace hexoderm {

/// A session of cells that report no neighbours, each of which reads every pose exactly. From no simulator.
inline Session unlinkedCells(std::uint32_t count, std::size_t poses) {
  Session session(test::modelOfMany(), test::listOfCells(count));
  for (std::size_t pose = 0; pose < poses; ++pose) {
    auto capture = std::make_shared<PoseCapture>();
    capture->id = session.nextPoseId();
    const Eigen::Vector3d up_u = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(pose % 3));
    for (std::uint32_t id = 1; id <= count; ++id) {
      capture->samples.push_back({CellId(id), up_u, Eigen::Matrix3d::Zero(), 100});
    }
    session.addPose({capture, false});
  }
  return session;
}

}  // namespace hexoderm
