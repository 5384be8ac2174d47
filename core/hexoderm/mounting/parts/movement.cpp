#include "hexoderm/mounting/parts/movement.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hexoderm {
namespace {

constexpr int kAxesAround = 120;

using Eigen::Index;

/// What is seen of turns between the two bodies, with the constant turn between them taken out: r = J w_p in every
/// pose.
class TurnsOfBodies {
 public:
  /// `stretch`: of the covariances.
  TurnsOfBodies(const GravitySeen& a, const GravitySeen& b, const Eigen::Matrix3d& R_a_b, double stretch)
      : up_a_(a.up) {
    const auto rows = static_cast<Index>(2 * a.size());
    Eigen::MatrixXd turn_b = Eigen::MatrixXd::Zero(rows, rows);
    Eigen::MatrixXd common(rows, 3);
    residual_.resize(rows);
    for (std::size_t k = 0; k < a.size(); ++k) {
      const auto at = static_cast<Index>(2 * k);
      const Eigen::Matrix<double, 2, 3> across = acrossBasis(a.up[k]).transpose();
      residual_.segment<2>(at) = -across * (R_a_b * b.up[k]);
      turn_b.block<2, 2>(at, at) = across * R_a_b * acrossBasis(b.up[k]);
      common.middleRows<2>(at) = -across * skew(a.up[k]);
    }
    // How the bodies are turned against each other all the time is not known: to within a radian.
    Eigen::MatrixXd S = stretch * (a.covariance + turn_b * b.covariance * turn_b.transpose());
    S.noalias() += common * common.transpose();
    factor_.compute(S);
    factor_.matrixL().solveInPlace(residual_);
  }

  struct About {
    double log_odds = 0;
    double information = 0;  ///< 1/rad^2, of turns that are independent from pose to pose
  };
  [[nodiscard]] About about(const Eigen::Vector3d& axis_a) const {
    const auto poses = static_cast<Index>(up_a_.size());
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(2 * poses, poses);
    for (Index k = 0; k < poses; ++k) {
      const Eigen::Vector3d& up = up_a_[static_cast<std::size_t>(k)];
      columns.block<2, 1>(2 * k, k) = acrossBasis(up).transpose() * axis_a.cross(up);
    }
    factor_.matrixL().solveInPlace(columns);
    const Eigen::MatrixXd information = columns.transpose() * columns;
    const Eigen::VectorXd seen = columns.transpose() * residual_;
    Eigen::MatrixXd posterior = information;
    posterior.diagonal().array() += 1 / (kTypicalTurn_rad * kTypicalTurn_rad);
    const Eigen::LLT<Eigen::MatrixXd> factor(posterior);
    const double log_determinant = 2 * factor.matrixLLT().diagonal().array().log().sum() +
                                   2 * static_cast<double>(poses) * std::log(kTypicalTurn_rad);
    return {(log_determinant - seen.dot(factor.solve(seen))) / 2, information.trace()};
  }

 private:
  std::vector<Eigen::Vector3d> up_a_;
  Eigen::VectorXd residual_;  // whitened
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace

MovementTest testMovement(const GravitySeen& a, const GravitySeen& b) {
  const CommonPoses common = commonPoses(a, b);
  const std::array<GravitySeen, 2> both = {onlyPoses(a, common.in_a), onlyPoses(b, common.in_b)};
  MovementTest test;
  test.fit = fitRigid(both);
  test.noticeable_rad = kPi;
  if (both[0].size() < 2) return test;
  test.on_one_line = lieOnOneLine(both[0].up) || lieOnOneLine(both[1].up);
  // Swings that bring about more than a usual hand's speak for no joint that turned by tens of degrees: noise counts as
  // large as one rigid body would show it. Of three poses a joint's turns can look like noise.
  constexpr int kShowsNoise = 5;  // degrees of freedom of four poses
  const GravityMisfit& misfit = test.fit.misfit;
  const double stretch = misfit.freedom >= kShowsNoise ? std::max(1.0, misfit.chi_squared / misfit.freedom) : 1;
  const TurnsOfBodies turns(both[0], both[1], test.fit.R[1], stretch);
  std::vector<Eigen::Vector3d> axes = axesAllAround(kAxesAround);
  double least_odds = std::numeric_limits<double>::infinity();
  double least_information = std::numeric_limits<double>::infinity();
  std::vector<double> log_odds;
  for (const Eigen::Vector3d& axis : axes) {
    const TurnsOfBodies::About about = turns.about(axis);
    log_odds.push_back(about.log_odds);
    least_information = std::min(least_information, about.information);
    least_odds = std::min(least_odds, about.log_odds);
  }
  double joint = 0;  // how probable a joint is against none, times the least odds, in the mean over its axis
  for (const double odds : log_odds) joint += std::exp(least_odds - odds) / static_cast<double>(log_odds.size());
  test.log_odds = least_odds - std::log(joint);
  constexpr double kShows = 3;
  test.noticeable_rad = std::min(kPi, kShows / std::sqrt(std::max(least_information, 1e-12)));
  return test;
}

}  // namespace hexoderm
