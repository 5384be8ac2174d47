#pragma once

// What the links of a robot are expected to see of gravity, how a patch is turned on a link, if it is on that link, and
// which links a patch may be on (the rule is in the room's README).

#include "hexoderm/mounting/parts/gravity_seen.h"
#include "hexoderm/mounting/parts/rigid_fit.h"
#include "hexoderm/robots/robot_model.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace hexoderm {

/// The up direction in the frame of every link in P poses of a robot on a base that stands, and how it changes with the
/// joints' zeros and the base's tilt:
///   h_l,p = R_w_l(q_p + z)^T g_w.
/// A zero z is what has to be added to the angle that a free joint reports, rad; a joint that mimics another one turns
/// with it, unless the angles name it. Joints that slide turn nothing.
class LinkGravity {
 public:
  /// `angles`: of the poses; `zeros`: rad, by index in RobotModel::joints(), or empty for none; `up_w`: unit.
  LinkGravity(const RobotModel& robot, std::span<const JointAngles> angles, const Eigen::Vector3d& up_w,
              std::span<const double> zeros = {});

  [[nodiscard]] std::size_t poses() const { return T_w_l_.size(); }
  [[nodiscard]] Eigen::Vector3d up(std::size_t link, std::size_t pose) const {
    return T_w_l_[pose][link].R.transpose() * up_w_;
  }
  [[nodiscard]] const Eigen::Vector3d& upOfBase() const { return up_w_; }
  /// The change of up() with that of the base's, of small changes d_w of up_w.
  [[nodiscard]] Eigen::Matrix3d byUp(std::size_t link, std::size_t pose) const {
    return T_w_l_[pose][link].R.transpose();
  }
  /// The free joints that turn the link, ascending by index.
  [[nodiscard]] const std::vector<std::size_t>& jointsTo(std::size_t link) const { return joints_to_[link]; }
  /// The change of up() with the zero of a free joint, per rad.
  [[nodiscard]] Eigen::Vector3d byZero(std::size_t link, std::size_t pose, std::size_t joint) const;

 private:
  /// A joint on the way to a link, and how far it turns with the free one that it follows.
  struct Step {
    std::size_t joint = 0;
    std::size_t follows = 0;
    double multiplier = 1;
  };

  const RobotModel& robot_;
  Eigen::Vector3d up_w_;
  std::vector<std::vector<SE3>> T_w_l_;      // [pose][link]
  std::vector<std::vector<Step>> steps_to_;  // [link]
  std::vector<std::vector<std::size_t>> joints_to_;
};

/// What a patch saw, made ready for being compared with what links see.
class SeenByPatch {
 public:
  /// `places`: for each pose of `seen` its index in LinkGravity.
  SeenByPatch(GravitySeen seen, std::vector<std::size_t> places);

  [[nodiscard]] const GravitySeen& seen() const { return seen_; }
  [[nodiscard]] std::size_t size() const { return seen_.size(); }
  [[nodiscard]] std::size_t placeOf(std::size_t k) const { return places_[k]; }
  [[nodiscard]] const std::vector<std::size_t>& places() const { return places_; }
  /// Across what was seen in its pose k.
  [[nodiscard]] const Eigen::Matrix<double, 2, 3>& across(std::size_t k) const { return across_[k]; }
  /// The direction `foretold` (patch frame, about unit) against what was seen in its pose k: its angle, as a vector
  /// across. Never small for opposite directions.
  [[nodiscard]] Eigen::Vector2d residual(std::size_t k, const Eigen::Vector3d& foretold) const;
  /// Rows of two for each pose, turned into ones with the covariance I.
  void whiten(Eigen::MatrixXd& rows) const { factor_.matrixL().solveInPlace(rows); }
  /// Half the logarithm of the covariance's determinant.
  [[nodiscard]] double logSpread() const { return factor_.matrixLLT().diagonal().array().log().sum(); }
  /// The inverse of the covariance, 1/rad^2.
  [[nodiscard]] Eigen::MatrixXd information() const {
    return factor_.solve(Eigen::MatrixXd::Identity(factor_.rows(), factor_.cols()));
  }

 private:
  GravitySeen seen_;
  std::vector<std::size_t> places_;
  std::vector<Eigen::Matrix<double, 2, 3>> across_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

/// How uncertain joints and base are, 1 sigma; 0 for exact.
struct RobotPriors {
  double zero_rad = 0;
  double tilt_rad = 0;
};

/// The best turn of a patch on a link, with the joints' zeros and the base's tilt free within their priors.
struct LinkTurn {
  Eigen::Matrix3d R_l_o = Eigen::Matrix3d::Identity();
  /// Of e in R_true = R exp(e), e in the patch's frame, rad^2; about 1 rad^2 for a turn that the poses leave open.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  GravityMisfit misfit;
  /// Logarithm of how probable what was seen is on this link, but for a constant that is the patch's.
  double log_evidence = 0;
};

/// Maximum likelihood (weighted Procrustes with the full covariance of the patch). The joints' zeros and the tilt are
/// small: they count to first order.
LinkTurn turnOn(const SeenByPatch& patch, const LinkGravity& robot, std::size_t link, const RobotPriors& priors);

/// What the patch would see without errors if it were on the link and turned so, with the errors that it has.
SeenByPatch expectedOf(const SeenByPatch& patch, const LinkGravity& robot, std::size_t link,
                       const Eigen::Matrix3d& R_l_o);

/// How links are tested, the same for all patches.
struct LinkTest {
  RobotPriors priors;
  double least_probable = 0;  ///< misfits less probable than this reject a link
  /// The links that are tested: of links that are fixed to each other only RobotModel::partOf().
  std::vector<std::size_t> parts;
};

struct TestedLink {
  std::size_t link = 0;
  LinkTurn turn;
};

/// Links that the poses of a patch can't tell apart.
struct TestedGroup {
  std::vector<TestedLink> links;  ///< those nearest to the base first
  std::size_t best = 0;           ///< index of the most probable
  bool fits = false;              ///< at least one of them is not rejected
};

/// How many joints that are not fixed carry a link, one on the other.
std::size_t jointsBelow(const RobotModel& robot, std::size_t link);

/// All groups, the most probable first. Needs at least one pose.
std::vector<TestedGroup> testLinks(const SeenByPatch& patch, const RobotModel& robot, const LinkGravity& gravity,
                                   const LinkTest& test);

}  // namespace hexoderm
