#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

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

/// A tetrahedron's directions are the first set that tells the sensors' offsets apart.
inline constexpr std::size_t kGoodPoseCount = 4;
/// A result that is not good after so many poses does not lack poses.
inline constexpr std::size_t kMostPosesByItself = 12;
/// The one who brings the part from one pose to the next.
enum class TurnedBy {
  Hand,    ///< a person, or a robot that somebody moves
  Device,  ///< the device, when it is asked to (TurnTo)
};
/// The rule for when there are enough poses. By hand: kGoodPoseCount poses are enabled and the result is usable or
/// good. If it is not good by then, it is limited by the links or has a finding, and hardly becomes so by further poses
/// (a simulated ring of eight: 4.0 mm at the worst cell with 4 poses and with 12). A pose costs a device that turns
/// itself nothing, so it goes on until the result is good, or until kMostPosesByItself poses are enabled.
bool enoughPoses(const Reconstruction& reconstruction, TurnedBy turned_by = TurnedBy::Hand);

/// "Turn the part so that cell 7 faces the floor": the cell of the largest patch whose front points most exactly up or
/// down when `advice` is followed. Empty if there is no patch.
Message adviceInWords(const PoseAdvice& advice, const Reconstruction& reconstruction);

}  // namespace hexoderm
