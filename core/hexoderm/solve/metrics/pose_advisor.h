#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <optional>
#include <string>
#include <vector>

namespace hexoderm {

/// The orientation that would help most, and by how much.
struct PoseAdvice {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< unit, in the frame of `seen`: the direction to point up
  double sigma_now_rad = 0;                       ///< predicted rms orientation error of an edge with the poses so far
  double sigma_then_rad = 0;                      ///< and with this pose
};

/// The direction that lowers the predicted error of an edge's rotation most, over directions spread evenly over the
/// sphere. The prediction is the global solver's own: what readings along these directions say about the attitude of a
/// cell whose offset, gains and cross-axis sensitivity are unknown, with the elastomer prior for what the poses leave
/// open. Without any pose: +z.
///
/// `seen`: unit up directions of the poses so far, all in one frame. `unreachable`: directions that the part can't be
/// brought to; nothing within 30 degrees of one is advised, unless nothing else is left.
PoseAdvice adviseNextPose(const CellModel& model, const std::vector<Eigen::Vector3d>& seen,
                          const std::vector<Eigen::Vector3d>& unreachable = {});

/// The up directions of the poses so far in the frame of the largest patch, for adviseNextPose(); none without a patch.
std::vector<Eigen::Vector3d> directionsSeen(const Reconstruction& reconstruction);

/// "Turn the part so that cell 7 faces the floor": the cell of the largest patch whose front points most exactly up or
/// down when `advice` is followed. Empty if there is no patch.
Message adviceText(const PoseAdvice& advice, const Reconstruction& reconstruction);

}  // namespace hexoderm
