#pragma once

#include "hexoderm/base/joint_angles.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hexoderm {

/// What is known beforehand about robot and skin.
struct LinksOptions {
  /// The direction that points up in the frame w of the robot's base, which stands still in all poses. Need not be
  /// unit.
  Eigen::Vector3d up_w = Eigen::Vector3d::UnitZ();
  /// Probability with which any patch is said not to be on the link that it is on.
  double false_alarm = 1e-3;
  /// Whether joints may be off their zeros; else what they report is taken as exact.
  bool joint_zeros = true;
  /// Of a joint's zero, 1 sigma: 0.5 degrees. Larger ones are found where the poses show them.
  double zero_sigma_rad = 0;
  /// Of the base's tilt against up_w, 1 sigma about each level axis: 1 degree. 0: exact.
  double tilt_sigma_rad = 0;
  /// How far the middle of a patch may be from the point about which the robot trembles, 1 sigma an axis, m: a body
  /// that is turned while it is sampled feels another force at every place. 0: the robot holds still, or what shakes it
  /// averages out.
  double lever_m = 0;
  /// The same where links are tested, which should not fail by a robot that sways.
  double test_lever_m = 0.1;
  /// Poses beyond so many are not compared; those are taken that differ most.
  std::size_t most_poses = 40;
  /// The operator's choice: the link of the patch that a cell belongs to.
  std::map<CellId, std::string> chosen;

  LinksOptions();
  /// Throws InvalidArgument naming the option.
  void validate() const;
};

/// How a patch is turned on a link, if it is on that link: x_l = R_l_o x_o + an unknown place.
struct PatchTurn {
  std::string link;
  Eigen::Matrix3d R_l_o = Eigen::Matrix3d::Identity();
  /// Of e in R_true = R exp(e), e in the patch's frame, rad^2; about 1 rad^2 about an axis that is left open.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// Links on which a patch may be and which these poses can't tell apart: they are fixed to each other, or no joint
/// between them was moved so that gravity shows it.
struct LinkCandidate {
  std::vector<PatchTurn> links;  ///< those nearest to the base first
  double chi_squared = 0;        ///< of the one that fits best
  int freedom = 0;
  double probability = 1;  ///< of a misfit at least as large by chance, joints and tilt being four times as uncertain
  double log10_odds = 0;   ///< of the candidate against the best one: 0 for that, negative for others
};

/// What is left over in a pose.
struct LinkResidual {
  PoseId pose;
  double angle_rad = 0;  ///< between the direction seen and the one expected
  double sigma_rad = 0;  ///< of the direction seen, the worst way
};

/// What is known of the link of a patch.
struct PatchLinks {
  PatchId patch;
  CellId origin;
  std::size_t poses = 0;                  ///< that were compared
  std::vector<LinkCandidate> candidates;  ///< that fit, the best first; empty if none does
  /// Where none fits, or the operator chose one that doesn't: the candidate that comes nearest.
  std::optional<LinkCandidate> nearest;
  /// The link that the patch is taken to be on: the operator's choice; or the only candidate, if its links are fixed to
  /// each other or slide (the first of them). Absent where it is open, or none fits.
  std::optional<PatchTurn> placed;
  bool chosen = false;  ///< by the operator
  /// Where a turn is left open: the axis about which it is, unit, in the link's frame.
  std::optional<Eigen::Vector3d> open_axis_l;
  std::vector<LinkResidual> residuals;  ///< where the patch is placed
  Message why;                          ///< one sentence on what is known and what isn't
  Message what_would_tell;              ///< empty where nothing is left open
};

/// What has to be added to the angle that a joint reports.
struct JointZero {
  std::string joint;
  double zero_rad = 0;
  double sigma_rad = 0;
  double prior_sigma_rad = 0;  ///< how large zeros are on this robot, as far as its joints show: at least the option
  /// The poses show it. Else it is the prior that is stated: the joint turns nothing that is seen, or nothing tells its
  /// zero from the base's tilt or from how a patch is turned.
  bool shown = false;
};

/// By how much one joint would have to be turned otherwise in one pose to explain what is left over there.
struct JointResidual {
  PoseId pose;
  std::string joint;
  double turn_rad = 0;
  double sigma_rad = 0;
};

/// All patches that are placed, joints and base together.
struct RobotEstimate {
  std::vector<PatchId> patches;  ///< that are placed, in the order of LinksResult::patches
  std::vector<JointZero> zeros;  ///< of the free joints that turn any of them, in the order of the robot
  Eigen::Vector3d up_w = Eigen::Vector3d::UnitZ();
  Eigen::Matrix3d up_covariance = Eigen::Matrix3d::Zero();  ///< rad^2, of rank 2, across up_w
  double tilt_rad = 0;                                      ///< between up_w and the option
  double tilt_sigma_rad = 0;                                ///< of up_w, the worst way
  double chi_squared = 0;
  int freedom = 0;
  double probability = 1;
  std::vector<JointResidual> residuals;
  /// Of all unknowns together, row by row: e of each patch (PatchTurn::covariance), then the zeros, then up_w.
  std::vector<double> covariance;
  /// The number of values that are estimated.
  [[nodiscard]] std::size_t unknowns() const { return 3 * patches.size() + zeros.size() + 3; }
};

/// On which links the patches are.
struct LinksResult {
  std::vector<PatchLinks> patches;     ///< in the order of the reconstruction; those that were compared
  std::vector<PatchId> not_compared;   ///< saw gravity in no pose whose joint angles are known
  std::vector<PoseId> poses;           ///< that were compared, ascending
  std::optional<RobotEstimate> robot;  ///< where any patch is placed
  std::vector<Message> findings;       ///< what is doubtful, a sentence or two each
  Message summary;                     ///< one sentence or two
};

/// On which link of a robot each patch of a skin is, and how it is turned there. For patch k on link l, in pose p:
///   g_k,p = R_l_o^T R_w_l(q_p + z)^T g_w,
/// with the joints' zeros z and the base's up direction g_w. Where on the link the patch is, gravity doesn't say. The
/// rule is in core/hexoderm/mounting/attachment/README.md.
///
/// `angles`: of the poses of the session. Poses that lack the angle of a joint which others have are left out, and
/// links beyond a joint that no pose has: findings name them.
///
/// `reconstruction`: a fresh result of the global solver. Throws InvalidArgument for another one, which does not hold
/// the covariance of gravity; for a choice of a cell or a link that is not there; and for angles that
/// RobotModel::forward() refuses.
LinksResult findLinks(const Reconstruction& reconstruction, const RobotModel& robot,
                      const std::map<PoseId, JointAngles>& angles, const LinksOptions& options = {});

}  // namespace hexoderm
