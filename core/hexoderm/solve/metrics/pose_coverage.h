#pragma once

#include "hexoderm/base/units.h"
#include "hexoderm/session/session.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <memory>
#include <optional>
#include <span>
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

/// At least two directions (unit) are known, and all lie along one line, within 15 degrees of it (rms): how cells are
/// turned about that line is not known.
bool lieAlongOneLine(std::span<const Eigen::Vector3d> directions);

/// "Turn the part so that cell 7 faces the floor": the cell of the largest patch whose front points most exactly up or
/// down when `advice` is followed. Empty if there is no patch.
Message adviceText(const PoseAdvice& advice, const Reconstruction& reconstruction);

// The directions of gravity that a session has seen, and the missing one, for the operator who captures poses. All
// directions are up directions (where the accelerometers' specific force points), unit vectors in the frame of the
// largest patch.

/// The half of the sphere around +z of the patch frame, where up is where the origin cell faces, and the other half.
enum class Hemisphere { Front, Back };

/// A direction drawn on one of two discs of radius 1, with x to the right and y upwards. Lambert's azimuthal equal-area
/// projection: equal areas of the sphere are equal areas of the disc, so that a gap looks as large as it is. The back
/// is drawn as seen from behind: what leaves the front disc on its right enters the back disc on its left.
struct DiscPoint {
  Hemisphere side = Hemisphere::Front;
  Vector2d at = Vector2d::Zero();
};
/// `up_o` is a unit vector. On the rim it is Front.
DiscPoint onDisc(const Eigen::Vector3d& up_o);
/// Radius of the circle at this angle from the disc's middle, up to 90 degrees.
double discRadius(double angle_rad);

/// The direction that a cell's front faces.
enum class Facing { Ceiling, Floor, Wall };
/// Which way the front of a cell faces.
struct CellFacing {
  CellId cell;
  Facing facing = Facing::Ceiling;
};
/// Within 45 degrees of up or down, else a wall.
Facing facingOf(const CellPlacement& cell, const Eigen::Vector3d& up_o);
/// The cell whose front points most exactly up or down, and so describes an orientation most clearly; of equal ones the
/// one with the smallest ID. The patch must have a cell.
CellFacing clearestFacing(const PatchReconstruction& patch, const Eigen::Vector3d& up_o);

/// One pose on the discs.
struct SeenDirection {
  PoseId pose;
  Message label;
  bool enabled = true;
  Eigen::Vector3d up_o = Eigen::Vector3d::UnitZ();
  DiscPoint at;
};

/// The direction that the poses tell least about, where its value is below the class threshold and the assessment says
/// that another direction would help.
struct MissingDirection {
  Eigen::Vector3d up_o = Eigen::Vector3d::UnitZ();  ///< either sign would do
  CellFacing facing;                                ///< how it is said; ceiling stands for the floor as well
  int which = 3;                                    ///< 1 to 3: the first singular value below the threshold
  double value = 0;
};

/// The directions of gravity that the poses have seen.
struct PoseCoverage {
  std::vector<SeenDirection> seen;                            ///< in the order of the poses
  std::vector<PoseId> unplaced;                               ///< poses whose direction is not known
  std::size_t enabled = 0;                                    ///< number of enabled poses in `seen`
  Eigen::Vector3d singular_values = Eigen::Vector3d::Zero();  ///< of sum g g^T over the enabled, descending
  double threshold = 0.5;                                     ///< for a class, as the result's options have it
  EdgeQuality quality = EdgeQuality::Undefined;  ///< class of an edge whose cells were measured in all of them
  std::optional<MissingDirection> missing;       ///< none if all three reach the threshold, or none would help
};

/// Whether one more pose with this direction up would bring the value that is missing to its threshold; false if none
/// is missing.
bool fillsMissing(const PoseCoverage& coverage, const Eigen::Vector3d& up_o);

/// Coverage of the largest patch; empty without one. A result holds no direction for poses that were disabled:
/// `captures`, where given, are looked through for theirs (see currentUp).
PoseCoverage coverageOf(const Reconstruction& reconstruction,
                        std::span<const std::shared_ptr<const PoseCapture>> captures = {});

/// The present up direction, from live readings (accelerometer's axes, g): the mean over the cells of the largest patch
/// of R_o_u times the reading, freed from the estimated offset and scale; cells without readings of their own count a
/// quarter, and cells far from the rest are left out. Nothing if no cell reads 0.5 to 1.5 g, or if the cells contradict
/// each other (a part that is shaken, a patch whose shape is not known yet): if the mean of their unit vectors is
/// shorter than 0.7.
std::optional<Eigen::Vector3d> currentUp(const Reconstruction& reconstruction, std::span<const CellSample> readings);
/// The present up direction, from a pose's means.
std::optional<Eigen::Vector3d> currentUp(const Reconstruction& reconstruction, std::span<const GravitySample> means);

/// The contribution of the advised pose, depending on the poses so far.
enum class PoseGain {
  First,            ///< there is none yet: any will do
  SecondDirection,  ///< tells how cells are turned about the one line of gravity that was seen
  OutOfPlane,       ///< out of the plane of the two directions seen: reveals the sensors' offsets
  Opposite,         ///< about opposite to an earlier one: tells offsets from scales
  Further,          ///< averages out what is left
};

/// The next pose in the operator's terms.
struct NextPose {
  Eigen::Vector3d up_o = Eigen::Vector3d::UnitZ();
  DiscPoint at;
  CellFacing target;  ///< "so that cell 7 faces the floor"
  /// The smallest turn, about a horizontal axis, from where the part is, or from the last pose; none if neither is
  /// known.
  std::optional<double> turn_rad;
  PoseGain gain = PoseGain::First;
  std::optional<PoseId> opposite_of;  ///< for Opposite
  double sigma_now_rad = 0;           ///< see PoseAdvice
  double sigma_then_rad = 0;
  bool worthwhile = true;  ///< Assessment::wantsPose()
  Goal goal;               ///< of the result
  bool is_good = false;    ///< the result is good as it is, though a pose may make it better still

  /// Whether the pose is needed: it is neither the first, which may be any, nor beyond the ones that are enough.
  [[nodiscard]] bool isWanted() const { return gain != PoseGain::First && worthwhile; }
};
/// A hand misses by some degrees: a part that is less than this from the next pose is there.
inline constexpr double kThere_rad = 15 * kDegree;
/// Nothing without a patch. `current_up_o`: unit, see currentUp.
std::optional<NextPose> describeNextPose(const PoseAdvice& advice, const Reconstruction& reconstruction,
                                         const std::optional<Eigen::Vector3d>& current_up_o = {});

/// A short label of a pose by what the origin cell, in whose frame `up_o` is, faces: "facing ceiling", "facing floor",
/// "facing wall, +y up", "tilted up, -x up", "tilted down, ...".
Message poseLabel(const Eigen::Vector3d& up_o);
/// A label for a capture, from the reading of the largest patch's origin alone: `reconstruction` may be one without any
/// pose. Empty if there is no patch or the origin read no gravity.
Message poseLabel(const Reconstruction& reconstruction, const PoseCapture& capture);

}  // namespace hexoderm
