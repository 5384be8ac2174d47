#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <optional>
#include <string_view>
#include <vector>

namespace hexoderm {

/// Whether two parts are joined by one revolute joint, as far as gravity says.
enum class HingeKnowledge {
  Found,         ///< one axis explains all poses, and where it is is known
  NoAxis,        ///< no axis does: there is more between the parts than one revolute joint
  NotDetermined  ///< the poses leave open whether there is one, or where
};
std::string_view hingeKnowledgeName(HingeKnowledge knowledge);  ///< "found", "no_axis", "not_determined"

/// The axis as one of the two parts sees it.
struct HingeAxis {
  Eigen::Vector3d u = Eigen::Vector3d::UnitZ();          ///< unit, in the part's frame
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of u, rad^2; of rank 2, across u. About 1 rad: open
  double sigma_rad = 0;                                  ///< of u's direction, the worst way
};

/// How far the joint was turned in a pose.
struct HingeAngle {
  PoseId pose;
  /// Of part b against part a about u, relative to the reference pose, rad in (-pi, pi]; absent where gravity lay along
  /// the axis, which shows no turn about it.
  std::optional<double> angle_rad;
  double sigma_rad = 0;  ///< 0 in the reference pose and where there is no angle
};

/// A revolute joint between two parts a and b: u_a . g_a,p = u_b . g_b,p in every pose p, whatever its angle (the angle
/// between a joint's axis and gravity is the same from both sides). That are P equations for the four unknowns of two
/// unit vectors, so five poses are the least that can contradict it.
///
/// Where the joint is, nothing says: gravity is the same everywhere. P. Mittendorfer and G. Cheng, "Open-loop
/// self-calibration of articulated robots with artificial skins", ICRA 2012; T. Seel, J. Raisch and T. Schauer,
/// "IMU-based joint angle measurement for gait analysis", Sensors 14, 2014 (joint axes from what both sides measure).
struct Hinge {
  HingeKnowledge knowledge = HingeKnowledge::NotDetermined;
  HingeAxis a;
  HingeAxis b;
  Eigen::Matrix3d R_a_b = Eigen::Matrix3d::Identity();  ///< b into a in the reference pose; maps u_b onto u_a
  std::optional<PoseId> reference;                      ///< absent with fewer than five poses
  std::vector<HingeAngle> angles;                       ///< per pose that both parts have
  double chi_squared = 0;
  int freedom = 0;
  double probability = 1;   ///< of a misfit at least as large by chance
  Message why;              ///< one sentence on what is known and what isn't
  Message what_would_tell;  ///< empty where nothing is left open
};

/// Whether two patches, or two parts, turn against each other, as far as gravity says.
enum class Movement {
  Together,  ///< one rotation between them explains all poses, and a joint between them that was moved would have shown
  Apart,     ///< no one rotation explains them: they turned against each other
  CantTell   ///< one rotation explains them, but a joint that was moved need not have shown
};
std::string_view movementName(Movement movement);  ///< "together", "apart", "cant_tell"

/// What counts as moving together.
struct PartsOptions {
  /// Probability with which any of the tests calls something apart that isn't.
  double false_alarm = 1e-3;
  /// "Together" takes so large a ratio of the probabilities of what was seen: of one rigid part, to two with a joint.
  double least_odds = 20;
  /// How far the middle of a patch may be from that of its part, 1 sigma an axis, m. Patches that a hand turns while
  /// they are read feel another force at every place.
  double lever_m = 0.1;
  /// The same from a joint between two parts.
  double joint_lever_m = 0.15;
  /// Poses beyond so many are not compared; those are taken that differ most.
  std::size_t most_poses = 40;
  /// Patches beyond so many, the smallest, are not compared.
  std::size_t most_patches = 60;

  /// Throws InvalidArgument naming the option.
  void validate() const;
};

/// A patch in the frame of its part, which is the frame of the part's first patch: turned by R_part_o; where it lies,
/// gravity doesn't say.
struct PatchOfPart {
  PatchId patch;
  CellId origin;
  Eigen::Matrix3d R_part_o = Eigen::Matrix3d::Identity();
  /// Of e in R_true = R exp(e), e in the patch's frame, rad^2. Zero for the first patch.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Patches that move together.
struct Part {
  std::vector<PatchOfPart> patches;  ///< the one with the most cells first
  double chi_squared = 0;            ///< of one rotation per patch in all poses
  int freedom = 0;
  /// Gravity in the part's frame, of all its patches; sigma_rad: the worst way.
  std::vector<GravityDirection> gravity;
};

/// What two patches by themselves say about each other.
struct PatchPair {
  PatchId a;
  PatchId b;
  std::size_t poses = 0;                                 ///< that both have
  Eigen::Matrix3d R_a_b = Eigen::Matrix3d::Identity();   ///< the rotation that explains them best
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< as PatchOfPart::covariance, in b's frame
  double chi_squared = 0;
  int freedom = 0;
  double probability = 1;     ///< of a misfit at least as large if they move together
  double log10_odds = 0;      ///< of one rigid part against a joint that was moved
  double noticeable_rad = 0;  ///< turns from pose to pose, rms, that would have shown about any axis
  /// Together: they are in one part; apart: their parts are apart; else can't be told.
  Movement movement = Movement::CantTell;
};

/// What two parts say about each other.
struct PartRelation {
  std::size_t a = 0;  ///< index into PartsResult::parts
  std::size_t b = 0;
  Movement movement = Movement::CantTell;  ///< never Together: they would be one part
  double probability = 1;
  double log10_odds = 0;
  double noticeable_rad = 0;
  Message why;
  Message what_would_tell;     ///< empty where nothing is left open
  std::optional<Hinge> hinge;  ///< where they are apart
};

/// Which patches move together, and how.
struct PartsResult {
  std::vector<Part> parts;  ///< the one with the most cells first
  std::vector<PatchPair> pairs;
  std::vector<PartRelation> relations;  ///< of any two parts
  std::vector<PatchId> not_compared;    ///< no pose, or too many patches
  Message summary;                      ///< one sentence or two
};

/// Which patches of a skin move together, from gravity alone: g_a,p = R_a_b g_b,p in all poses for two patches of one
/// rigid part. Groups of patches that gravity can't tell from a rigid part are parts; between parts that turned against
/// each other the axis of one revolute joint is looked for (Hinge). The rule is in
/// core/hexoderm/mounting/parts/README.md.
///
/// `reconstruction`: a fresh result of the global solver. Throws InvalidArgument for another one, which does not hold
/// the covariance of gravity.
PartsResult findParts(const Reconstruction& reconstruction, const PartsOptions& options = {});

}  // namespace hexoderm
