#include "accelerometer_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hexoderm {
namespace {

/// A parameter with a sigma of 0 is known to be 0; a finite precision keeps the algebra the same for all.
constexpr double kLeastSigma = 1e-9;

Eigen::Vector4d regressor(const Eigen::Vector3d& v) { return {1, v.x(), v.y(), v.z()}; }

}  // namespace

double HuberLoss::cost(double squared) const {
  return squared <= threshold * threshold ? squared : 2 * threshold * std::sqrt(squared) - threshold * threshold;
}

double HuberLoss::weight(double squared) const {
  return squared <= threshold * threshold ? 1 : threshold / std::sqrt(squared);
}

AccelerometerPrior::AccelerometerPrior(const Accelerometer& accelerometer) {
  const auto precisionOf = [](double sigma) { return 1 / std::pow(std::max(sigma, kLeastSigma), 2); };
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Vector4d& precision = precision_[static_cast<std::size_t>(axis)];
    precision.setConstant(precisionOf(accelerometer.cross_axis_sigma));
    precision[0] = precisionOf(accelerometer.offset_sigma_g);
    precision[axis + 1] = precisionOf(accelerometer.scale_sigma);
  }
}

void fitAccelerometer(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                      std::span<const Eigen::Vector3d> v_g, const HuberLoss& loss, AccelerometerFit& fit) {
  // The losses are convex in the parameters, so reweighting converges; good readings need a single round.
  constexpr int kRounds = 50;
  constexpr double kConverged = 1e-12;
  const std::size_t count = readings.size();
  fit.residual_g.resize(count);
  fit.precision.resize(count);
  for (std::size_t k = 0; k < count; ++k) fit.precision[k] = 1 / readings[k].variance_g2;

  Eigen::Matrix<double, 4, 3> parameters = Eigen::Matrix<double, 4, 3>::Zero();
  std::vector<double> next_precision;
  double previous = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Matrix<double, 4, 3> right = Eigen::Matrix<double, 4, 3>::Zero();
    for (std::size_t k = 0; k < count; ++k) {
      const Eigen::Vector4d row = regressor(v_g[k]);
      const Eigen::Vector4d weighted = fit.precision[k] * row;
      normal.noalias() += weighted * row.transpose();
      right.noalias() += weighted * (readings[k].y_g - v_g[k]).transpose();
    }
    double cost = 0;
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::Matrix4d information = normal;
      information.diagonal() += prior.precision(axis);
      const Eigen::LLT<Eigen::Matrix4d> factor(information);
      parameters.col(axis) = factor.solve(right.col(axis));
      // information = F F^T, so F^-T is a root of its inverse.
      Eigen::Matrix4d& root = fit.covariance_root[static_cast<std::size_t>(axis)];
      root.setIdentity();
      factor.matrixU().solveInPlace(root);
      cost += parameters.col(axis).dot(prior.precision(axis).cwiseProduct(parameters.col(axis)));
    }
    fit.offset_g = parameters.row(0).transpose();
    fit.gain = Eigen::Matrix3d::Identity() + parameters.bottomRows<3>().transpose();

    bool reweighted = false;
    next_precision.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      fit.residual_g[k] = readings[k].y_g - fit.gain * v_g[k] - fit.offset_g;
      const double squared = fit.residual_g[k].squaredNorm() / readings[k].variance_g2;
      cost += loss.cost(squared);
      next_precision[k] = loss.weight(squared) / readings[k].variance_g2;
      reweighted = reweighted || std::abs(next_precision[k] - fit.precision[k]) > kConverged * next_precision[k];
    }
    fit.cost = cost / 2;
    if (!reweighted || std::abs(previous - cost) <= kConverged * cost) break;
    previous = cost;
    // The last round's stay, because the covariance is theirs: what is taken out of the information is then never more
    // than there is.
    if (round + 1 < kRounds) fit.precision.swap(next_precision);
  }
}

}  // namespace hexoderm
