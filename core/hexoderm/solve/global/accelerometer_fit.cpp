#include "hexoderm/solve/global/accelerometer_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

/// A parameter with a sigma of 0 is known to be 0; a finite precision keeps the algebra the same for all.
constexpr double kMinSigma = 1e-9;

Eigen::Vector4d regressor(const Eigen::Vector3d& v) { return {1, v.x(), v.y(), v.z()}; }

using Vector12d = Eigen::Matrix<double, 12, 1>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;

/// The errors of one accelerometer: (b_i, D_i) of axis i in column i.
using Errors = Eigen::Matrix<double, 4, 3>;

class Fitter {
 public:
  Fitter(const AccelerometerPrior& prior, std::span<const CellReading> readings, std::span<const Eigen::Vector3d> v_g,
         const HuberLoss& loss, AccelerometerFit& fit)
      : prior_(prior), readings_(readings), v_g_(v_g), loss_(loss), fit_(fit) {
    fit.residual_g.resize(readings.size());
    fit.precision.resize(readings.size());
  }

  void run() {
    for (std::size_t k = 0; k < readings_.size(); ++k) fit_.precision[k] = 1 / readings_[k].variance_g2;
    if (!evaluate(solveWeighted())) return;
    descend();
    findCovariance();
  }

 private:
  [[nodiscard]] Eigen::Matrix4d information() const {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    for (std::size_t k = 0; k < v_g_.size(); ++k) {
      const Eigen::Vector4d row = regressor(v_g_[k]);
      sum.noalias() += fit_.precision[k] * row * row.transpose();
    }
    return sum;
  }

  Errors solveWeighted() {
    findCovariance();
    Errors right = Errors::Zero();
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      right.noalias() += fit_.precision[k] * regressor(v_g_[k]) * (readings_[k].y_g - v_g_[k]).transpose();
    }
    Errors errors;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Matrix4d& root = fit_.covariance_root[static_cast<std::size_t>(axis)];
      errors.col(axis).noalias() = root * (root.transpose() * right.col(axis));
    }
    return errors;
  }

  void findCovariance() {
    const Eigen::Matrix4d normal = information();
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::Matrix4d with_prior = normal;
      with_prior.diagonal() += prior_.precision(axis);
      fit_.covariance_root[static_cast<std::size_t>(axis)] = rootOfInverse(with_prior);
    }
  }

  /// Everything in the fit but the covariance. Is any reading beyond the loss's threshold?
  bool evaluate(const Errors& errors) {
    errors_ = errors;
    fit_.offset_g = errors.row(0).transpose();
    fit_.gain = Eigen::Matrix3d::Identity() + errors.bottomRows<3>().transpose();
    double twice = 0;
    for (int axis = 0; axis < 3; ++axis) {
      twice += errors.col(axis).dot(prior_.precision(axis).cwiseProduct(errors.col(axis)));
    }
    bool beyond = false;
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      fit_.residual_g[k] = readings_[k].y_g - fit_.gain * v_g_[k] - fit_.offset_g;
      const double squared = fit_.residual_g[k].squaredNorm() / readings_[k].variance_g2;
      const double weight = loss_.weight(squared);
      beyond = beyond || weight < 1;
      twice += loss_.cost(squared);
      fit_.precision[k] = weight / readings_[k].variance_g2;
    }
    fit_.cost = twice / 2;
    return beyond;
  }

  /// Newton's method from the quadratic solution; the cost is convex. Plain reweighting would need thousands of rounds
  /// where few poses leave the errors nearly free.
  void descend() {
    constexpr int kSteps = 50;
    constexpr int kHalvings = 30;
    constexpr double kConverged = 1e-16;
    for (int k = 0; k < kSteps; ++k) {
      Vector12d gradient;
      const Vector12d step = newtonStep(gradient);
      if (-gradient.dot(step) <= kConverged * fit_.cost) return;
      const Errors from = errors_;
      const double cost = fit_.cost;
      double share = 1;
      bool lowered = false;
      for (int halving = 0; !lowered && halving < kHalvings; ++halving, share /= 2) {
        evaluate(from + share * step.reshaped(4, 3));
        lowered = fit_.cost < cost;
      }
      if (!lowered) {
        evaluate(from);
        return;
      }
    }
  }

  [[nodiscard]] Vector12d newtonStep(Vector12d& gradient) const {
    const Eigen::Matrix4d normal = information();
    Matrix12d hessian = Matrix12d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      gradient.segment<4>(4 * axis) = prior_.precision(axis).cwiseProduct(errors_.col(axis));
      hessian.block<4, 4>(4 * axis, 4 * axis) = normal;
      hessian.diagonal().segment<4>(4 * axis) += prior_.precision(axis);
    }
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      const Eigen::Vector4d row = regressor(v_g_[k]);
      const Eigen::Vector3d& residual = fit_.residual_g[k];
      const double precision = fit_.precision[k];
      for (int axis = 0; axis < 3; ++axis) gradient.segment<4>(4 * axis) -= precision * residual[axis] * row;
      if (loss_.weight(residual.squaredNorm() / readings_[k].variance_g2) == 1) continue;
      // Beyond the threshold the loss has no curvature along the residual.
      const Eigen::Matrix4d square = precision / residual.squaredNorm() * row * row.transpose();
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) hessian.block<4, 4>(4 * a, 4 * b) -= residual[a] * residual[b] * square;
      }
    }
    return -hessian.ldlt().solve(gradient);
  }

  const AccelerometerPrior& prior_;
  std::span<const CellReading> readings_;
  std::span<const Eigen::Vector3d> v_g_;
  const HuberLoss& loss_;
  AccelerometerFit& fit_;
  Errors errors_;
};

}  // namespace

double HuberLoss::cost(double squared) const {
  return squared <= threshold * threshold ? squared : 2 * threshold * std::sqrt(squared) - threshold * threshold;
}

double HuberLoss::weight(double squared) const {
  return squared <= threshold * threshold ? 1 : threshold / std::sqrt(squared);
}

Eigen::Matrix4d rootOfInverse(const Eigen::Matrix4d& matrix) {
  // The matrix is F F^T, so F^-T is a root of its inverse. Eigen's own triangular solution takes several times as long.
  const Eigen::Matrix4d F = matrix.llt().matrixL();
  Eigen::Matrix4d root = Eigen::Matrix4d::Zero();
  for (int j = 0; j < 4; ++j) {
    root(j, j) = 1 / F(j, j);
    for (int i = j - 1; i >= 0; --i) {
      for (int k = i; k < j; ++k) root(i, j) -= F(j, k) * root(i, k);
      root(i, j) *= root(j, j);
    }
  }
  return root;
}

AccelerometerPrior::AccelerometerPrior(const Accelerometer& accelerometer, const Eigen::Vector3d& more_g2) {
  const auto precisionOf = [](double sigma) { return 1 / std::pow(std::max(sigma, kMinSigma), 2); };
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Vector4d& precision = precision_[static_cast<std::size_t>(axis)];
    precision.setConstant(precisionOf(accelerometer.cross_axis_sigma));
    precision[0] = precisionOf(std::hypot(accelerometer.offset_sigma_g[axis], std::sqrt(more_g2[axis])));
    precision[axis + 1] = precisionOf(accelerometer.scale_sigma);
  }
}

void fitAccelerometer(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                      std::span<const Eigen::Vector3d> v_g, const HuberLoss& loss, AccelerometerFit& fit) {
  Fitter(prior, readings, v_g, loss, fit).run();
}

}  // namespace hexoderm
