#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/pose_coverage.h"

#include "hexoderm/solve/global/rigidity.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

/// Predicted uncertainty of an edge's rotation with these up directions: rms over the three axes, radians. The
/// elastomer prior is taken alike in all directions, because the cells of a patch face many ways.
double predictedSigma(const CellModel& model, const Eigen::Matrix3Xd& directions) {
  // Averaging does not remove a hand's tremor, which is not white.
  constexpr double kTremor_g = 0.003;
  const double prior_sq = (model.bend_sigma_rad * model.bend_sigma_rad + model.twist_sigma_rad * model.twist_sigma_rad +
                           model.yaw_sigma_rad * model.yaw_sigma_rad) /
                          3;
  std::vector<CellReading> readings;
  std::vector<Eigen::Vector3d> forces;
  for (Eigen::Index k = 0; k < directions.cols(); ++k) {
    forces.emplace_back(directions.col(k));
    readings.push_back({static_cast<std::size_t>(k), directions.col(k), kTremor_g * kTremor_g});
  }
  AccelerometerFit fit;
  fitAccelerometer(AccelerometerPrior(model.accelerometer.ofUnknownLot()), readings, forces, {}, fit);
  // An edge joins two cells that err alike.
  const Eigen::Matrix3d information = attitudeInformation(fit, forces) / 2 + Eigen::Matrix3d::Identity() / prior_sq;
  return std::sqrt(information.inverse().trace() / 3);
}

/// Share of the directions that lies off their main line: the second singular value of eq. (17), as the solver has it.
double secondDirection(const Eigen::Matrix3Xd& directions) {
  if (directions.cols() == 0) return 0;
  return Eigen::JacobiSVD<Eigen::Matrix3d>(directions * directions.transpose()).singularValues().y();
}
constexpr double kDefined = 0.5;
constexpr double kClearlyDefined = 0.9;

/// Points spread evenly over the sphere (a Fibonacci lattice).
std::vector<Eigen::Vector3d> sphereCandidates() {
  constexpr int kCount = 400;
  const double golden = kPi * (3 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> candidates;
  for (int k = 0; k < kCount; ++k) {
    const double z = 1 - (2 * k + 1.0) / kCount;
    const double r = std::sqrt(1 - z * z);
    candidates.emplace_back(r * std::cos(golden * k), r * std::sin(golden * k), z);
  }
  return candidates;
}

}  // namespace

PoseAdvice adviseNextPose(const CellModel& model, const std::vector<Eigen::Vector3d>& seen,
                          const std::vector<Eigen::Vector3d>& unreachable) {
  constexpr double kOutOfReach = 30 * kDegree;
  const auto count = static_cast<Eigen::Index>(seen.size());
  Eigen::Matrix3Xd directions(3, count + 1);
  for (Eigen::Index k = 0; k < count; ++k) directions.col(k) = seen[static_cast<std::size_t>(k)];
  directions.col(count) = Eigen::Vector3d::UnitZ();

  PoseAdvice advice;
  advice.sigma_now_rad = predictedSigma(model, directions.leftCols(count));
  advice.sigma_then_rad = predictedSigma(model, directions);
  if (seen.empty() && unreachable.empty()) return advice;
  bool found = false;
  const bool one_line = !seen.empty() && secondDirection(directions.leftCols(count)) < kDefined;
  for (const Eigen::Vector3d& candidate : sphereCandidates()) {
    const bool out_of_reach = std::ranges::any_of(unreachable, [&](const Eigen::Vector3d& direction) {
      return angleBetween(candidate, direction) < kOutOfReach;
    });
    if (out_of_reach) continue;
    directions.col(count) = candidate;
    // To first order two poses 45 degrees apart suffer least from offsets, but leave the turn about their middle to a
    // single small angle: as long as all directions lie on one line, one that leaves this line comes first.
    if (one_line && secondDirection(directions) < kClearlyDefined) continue;
    const double sigma = predictedSigma(model, directions);
    if (found && sigma >= advice.sigma_then_rad) continue;
    found = true;
    advice.sigma_then_rad = sigma;
    advice.up = candidate;
  }
  return advice;
}

std::vector<Eigen::Vector3d> directionsSeen(const Reconstruction& reconstruction) {
  std::vector<Eigen::Vector3d> seen;
  const PatchReconstruction* largest = largestPatch(reconstruction);
  if (largest == nullptr) return seen;
  for (const GravityDirection& gravity : largest->gravity) seen.push_back(gravity.g_o);
  return seen;
}

Message adviceText(const PoseAdvice& advice, const Reconstruction& reconstruction) {
  const PatchReconstruction* patch = largestPatch(reconstruction);
  if (patch == nullptr) return {};
  const CellFacing target = clearestFacing(*patch, advice.up);
  // On a nearly flat patch no cell may face up or down: then its edge does, and the wall is what it faces.
  return target.facing == Facing::Ceiling ? message("Turn the part so that cell {} faces the ceiling.", target.cell)
         : target.facing == Facing::Floor
             ? message("Turn the part so that cell {} faces the floor.", target.cell)
             : message("Turn the part so that cell {} faces a wall, its side towards the ceiling.", target.cell);
}

}  // namespace hexoderm
