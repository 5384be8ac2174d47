#include "hexoderm/mounting/attachment/robot_estimate.h"

#include "hexoderm/base/covariance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

/// A zero whose variance the poses make smaller by this factor is called shown.
constexpr double kShownShare = 0.5;
/// Sigmas, and sigmas of the prior, at which a zero or a tilt is worth saying.
constexpr double kNoteworthy = 3;

}  // namespace

RobotEstimate estimateOf(const RobotFit& fit, std::vector<PatchId> patches, const std::vector<PoseId>& poses,
                         const RobotModel& robot, const LinksOptions& options) {
  RobotEstimate estimate;
  estimate.patches = std::move(patches);
  const auto zero_at = static_cast<Eigen::Index>(3 * estimate.patches.size());
  for (std::size_t j = 0; j < fit.joints.size(); ++j) {
    JointZero& zero = estimate.zeros.emplace_back();
    const auto at = zero_at + static_cast<Eigen::Index>(j);
    zero.joint = robot.joints()[fit.joints[j]].name;
    if (!options.joint_zeros) continue;
    zero.zero_rad = fit.zeros[j];
    zero.prior_sigma_rad = fit.zero_sigma_rad;
    zero.sigma_rad = std::sqrt(std::max(0.0, fit.covariance(at, at)));
    zero.shown = fit.covariance(at, at) < kShownShare * fit.zero_sigma_rad * fit.zero_sigma_rad;
  }
  estimate.up_w = fit.up_w;
  estimate.up_covariance = fit.covariance.bottomRightCorner<3, 3>();
  estimate.tilt_rad = angleBetween(fit.up_w, options.up_w.normalized());
  estimate.tilt_sigma_rad = largestDeviation(estimate.up_covariance);
  estimate.chi_squared = fit.misfit.chi_squared;
  estimate.freedom = fit.misfit.freedom;
  estimate.probability = fit.misfit.probability();
  for (const RobotFit::PoseTurn& turn : fit.pose_turns) {
    estimate.residuals.push_back({poses[turn.place], robot.joints()[turn.joint].name, turn.turn_rad, turn.sigma_rad});
  }
  for (Eigen::Index row = 0; row < fit.covariance.rows(); ++row) {
    for (Eigen::Index column = 0; column < fit.covariance.cols(); ++column) {
      estimate.covariance.push_back(fit.covariance(row, column));
    }
  }
  return estimate;
}

std::vector<Message> findingsOf(const RobotEstimate& estimate, const LinksOptions& options) {
  std::vector<Message> findings;
  for (const JointZero& zero : estimate.zeros) {
    const double size = std::abs(zero.zero_rad);
    if (!zero.shown || size < kNoteworthy * zero.sigma_rad || size < kNoteworthy * options.zero_sigma_rad) continue;
    findings.push_back(
        message("The zero of joint {} seems to be off: {} has to be added to the angle that it reports (1 sigma: {}).",
                zero.joint, Degrees{zero.zero_rad}, Degrees{zero.sigma_rad}));
  }
  if (estimate.tilt_rad > kNoteworthy * std::max(estimate.tilt_sigma_rad, options.tilt_sigma_rad)) {
    findings.push_back(message("The robot's base seems to be tilted by {} (1 sigma: {}).", Degrees{estimate.tilt_rad},
                               Degrees{estimate.tilt_sigma_rad}));
  }
  if (estimate.probability < options.false_alarm) {
    findings.push_back(
        message("Taken together, the patches fit the joint angles badly: a chi-squared of {} at {} degrees of freedom.",
                Number{estimate.chi_squared, 1}, estimate.freedom));
  }
  return findings;
}

}  // namespace hexoderm
