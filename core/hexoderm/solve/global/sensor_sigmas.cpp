#include "hexoderm/solve/global/sensor_sigmas.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace hexoderm {
namespace {

/// Variances in the order of SensorError, offsets without their shared part, then the shared part.
using Variances = Eigen::Vector4d;
constexpr Eigen::Index kShared = 3;
constexpr Eigen::Index kKinds = kSensorErrors;

constexpr double kMinVariance = 1e-12;         // far below what any reading shows
constexpr double kWeightOfModelSigmas = 1e-3;  // of one error, for the cell model's sigmas
/// With fewer degrees of freedom the range of a sigma spans more than a factor of three.
constexpr double kFewestErrors = 7;
/// A lot has three offsets.
constexpr double kFewestSharedOffsets = 2;
constexpr double kTwoSided95 = 1.959964;

Eigen::Index groupOf(Eigen::Index parameter) { return static_cast<Eigen::Index>(kindOfParameter(parameter)); }

/// The parameters are numbered by sensors; those of one kind are summed up.
Eigen::Vector4d sumsByKind(const Eigen::VectorXd& values) {
  Eigen::Vector4d sums = Eigen::Vector4d::Zero();
  for (Eigen::Index k = 0; k < values.size(); ++k) sums[groupOf(k)] += values[k];
  return sums;
}

Eigen::Matrix4d squaresByKind(const Eigen::MatrixXd& matrix) {
  Eigen::Matrix4d sums = Eigen::Matrix4d::Zero();
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      sums(groupOf(row), groupOf(column)) += matrix(row, column) * matrix(row, column);
    }
  }
  return sums;
}

/// Score and Fisher information of the variances. With P = (M^-1 + L)^-1 and p = P x for the most likely errors x:
/// score (p^T L_j p - tr P L_j) / 2 and information tr(P L_j P L_k) / 2, L_j being the derivative of L. The shared
/// offset adds U w U^T to L, of rank three over all patches, with U the sum of all sensors' offsets.
class Likelihood {
 public:
  Likelihood(std::span<const SensorEvidence> evidence, const Variances& variances) {
    std::array<Eigen::Matrix3d, kKinds> spread;  // A_j^T A_j, with A = P0 U, P0 without the shared part
    spread.fill(Eigen::Matrix3d::Zero());
    struct Patch {
      Eigen::MatrixXd precision;
      Eigen::VectorXd weighted;
      Eigen::MatrixXd A;
    };
    std::vector<Patch> patches;
    for (const SensorEvidence& patch : evidence) {
      Eigen::VectorXd prior(patch.weighted.size());
      for (Eigen::Index k = 0; k < prior.size(); ++k) prior[k] = variances[groupOf(k)];
      WeighedEvidence weighed = weigh(patch, prior);
      Eigen::MatrixXd A = Eigen::MatrixXd::Zero(prior.size(), 3);
      for (Eigen::Index k = 0; k < prior.size(); ++k) {
        if (kindOfParameter(k) != SensorError::Offset) continue;
        const Eigen::Index axis = (k % kSensorParameters) / 4;
        A.col(axis) += weighed.precision.col(k);
        shared_weighted_[axis] += weighed.weighted[k];
      }
      for (Eigen::Index k = 0; k < prior.size(); ++k) {
        if (kindOfParameter(k) == SensorError::Offset) shared_precision_.row((k % kSensorParameters) / 4) += A.row(k);
        spread.at(static_cast<std::size_t>(groupOf(k))) += A.row(k).transpose() * A.row(k);
      }
      patches.push_back({std::move(weighed.precision), std::move(weighed.weighted), std::move(A)});
    }

    // P = P0 - A K A^T, K = (1/w + G)^-1, G = U^T A.
    const double w = variances[kShared];
    const Eigen::Matrix3d& G = shared_precision_;
    const Eigen::Matrix3d K = w * (Eigen::Matrix3d::Identity() + w * G).inverse();
    const Eigen::Matrix3d W = Eigen::Matrix3d::Identity() - K * G;  // P U = A W
    const Eigen::Vector3d shared = shared_weighted_ - G * K * shared_weighted_;
    const Eigen::Matrix3d of_shared = G * W;
    for (const Patch& patch : patches) {
      const Eigen::VectorXd weighted = patch.weighted - patch.A * (K * shared_weighted_);
      score_ += (sumsByKind(weighted.cwiseAbs2()) - sumsByKind(patch.precision.diagonal())) / 2;
      // The square of P's blocks of one patch, without what is shared, and twice its product with that.
      const Eigen::MatrixXd common = patch.A * K * patch.A.transpose();
      information_ += squaresByKind(patch.precision) / 2;
      for (Eigen::Index column = 0; column < common.cols(); ++column) {
        for (Eigen::Index row = 0; row < common.rows(); ++row) {
          information_(groupOf(row), groupOf(column)) -= patch.precision(row, column) * common(row, column);
        }
      }
    }
    for (Eigen::Index j = 0; j < kKinds; ++j) {
      const Eigen::Matrix3d& T_j = spread.at(static_cast<std::size_t>(j));
      score_[j] += (K * T_j).trace() / 2;
      for (Eigen::Index k = 0; k < kKinds; ++k) {
        information_(j, k) += (K * T_j * K * spread.at(static_cast<std::size_t>(k))).trace() / 2;
      }
      information_(j, kShared) = information_(kShared, j) = (W.transpose() * T_j * W).trace() / 2;
    }
    score_[kShared] = (shared.squaredNorm() - of_shared.trace()) / 2;
    information_(kShared, kShared) = of_shared.cwiseAbs2().sum() / 2;
  }

  [[nodiscard]] const Eigen::Vector4d& score() const { return score_; }
  [[nodiscard]] const Eigen::Matrix4d& information() const { return information_; }
  /// G = U^T P0 U and U^T p0: the information about the lot's offset and that times its most likely value.
  [[nodiscard]] const Eigen::Matrix3d& sharedPrecision() const { return shared_precision_; }
  [[nodiscard]] const Eigen::Vector3d& sharedWeighted() const { return shared_weighted_; }

 private:
  Eigen::Vector4d score_ = Eigen::Vector4d::Zero();
  Eigen::Matrix4d information_ = Eigen::Matrix4d::Zero();
  Eigen::Matrix3d shared_precision_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d shared_weighted_ = Eigen::Vector3d::Zero();
};

Variances variancesOf(const Accelerometer& model) {
  constexpr double kMinShare = 0.01;  // of the offsets' variance, so that a shared part can be found
  const double own = std::pow(model.largestOffsetSigma_g(), 2);
  const double shared = std::max(std::pow(model.offset_shared_sigma_g, 2), kMinShare * own);
  Variances variances(own, std::pow(model.scale_sigma, 2), std::pow(model.cross_axis_sigma, 2), shared);
  constexpr double kMinStart = 1e-8;  // from exactly 0 nothing would move
  return variances.cwiseMax(kMinStart);
}

/// The model's word, as if so much of an error had been seen.
Eigen::Vector4d modelScore(const Variances& model, const Variances& now) {
  return kWeightOfModelSigmas / 2 * (model - now).cwiseQuotient(now.cwiseAbs2());
}
Eigen::Vector4d modelInformation(const Variances& now) {
  return kWeightOfModelSigmas / 2 * now.cwiseAbs2().cwiseInverse();
}

Variances mostLikely(std::span<const SensorEvidence> evidence, const Variances& model) {
  constexpr int kRounds = 200;
  constexpr double kLargestFactor = 4;
  constexpr double kSettled = 1e-6;
  constexpr double kNegligible = 1e-10;  // g^2: a hundredth of a mg
  Variances variances = model;
  for (int round = 0; round < kRounds; ++round) {
    const Likelihood likelihood(evidence, variances);
    Eigen::Matrix4d information = likelihood.information();
    information.diagonal() += modelInformation(variances);
    // Scaled, because variances differ by orders of magnitude.
    const Eigen::Matrix4d scaled = variances.asDiagonal() * information * variances.asDiagonal();
    const Eigen::Vector4d score = likelihood.score() + modelScore(model, variances);
    const Eigen::Vector4d step = scaled.ldlt().solve(variances.cwiseProduct(score));
    Variances next = variances;
    for (Eigen::Index k = 0; k < 4; ++k) {
      const double factor = std::isfinite(step[k]) ? 1 + step[k] : 1;
      next[k] = std::max(kMinVariance, variances[k] * std::clamp(factor, 1 / kLargestFactor, kLargestFactor));
    }
    const bool settled = ((next - variances).array().abs() <= kSettled * (variances.array() + kNegligible)).all();
    variances = next;
    if (settled) break;
  }
  return variances;
}

/// Quantile of a chi-squared over its degrees of freedom (Wilson and Hilferty), `deviate` standard deviations up.
double quantileShare(double degrees, double deviate) {
  const double spread = 2 / (9 * degrees);
  return std::pow(1 - spread + deviate * std::sqrt(spread), 3);
}

/// Degrees of freedom of a chi-squared with that relative spread.
double worthOf(double variance, double variance_error) {
  return variance_error > 0 ? 2 * variance * variance / variance_error : 0;
}

/// Measured, with its range; `variance_error` is the variance of `variance`.
SigmaEstimate measured(double variance, double variance_error) {
  SigmaEstimate estimate;
  estimate.knowledge = SigmaKnowledge::Measured;
  estimate.worth = worthOf(variance, variance_error);
  estimate.sigma = std::sqrt(variance);
  estimate.low_95 = estimate.sigma / std::sqrt(quantileShare(estimate.worth, kTwoSided95));
  estimate.high_95 = estimate.sigma / std::sqrt(quantileShare(estimate.worth, -kTwoSided95));
  return estimate;
}

/// The variance above the most likely one at which the likelihood has fallen as far as at a normal estimate's 95 %
/// limit, the other variances being the most likely ones; the score is integrated. Absent if that is above `most`.
std::optional<double> upperBound(std::span<const SensorEvidence> evidence, const Variances& variances,
                                 Eigen::Index which, double most) {
  constexpr double kFall = kTwoSided95 * kTwoSided95 / 2;
  constexpr double kFactor = 1.15;
  constexpr double kMin = 1e-8;  // a tenth of a mg
  Variances at = variances;
  double fallen = 0;
  double score = 0;
  while (fallen < kFall) {
    const double next = std::max(kMin, kFactor * at[which]);
    if (next > most) return std::nullopt;
    const double step = next - at[which];
    at[which] = next;
    const double next_score = Likelihood(evidence, at).score()[which];
    fallen -= step * (score + next_score) / 2;
    score = next_score;
  }
  return at[which];
}

/// Not measured: bounded by `bound`, or unknown.
SigmaEstimate bounded(double variance, double variance_error, std::optional<double> bound, double model_sigma) {
  SigmaEstimate estimate;
  estimate.worth = worthOf(variance, variance_error);
  estimate.knowledge = bound ? SigmaKnowledge::AtMost : SigmaKnowledge::Unknown;
  estimate.sigma = bound ? std::sqrt(variance) : model_sigma;
  estimate.high_95 = bound ? std::sqrt(*bound) : 0;
  return estimate;
}

/// The inverse of the Fisher information; very large where there is none.
Eigen::Matrix4d errorsOf(const Eigen::Matrix4d& information, const Variances& variances) {
  Eigen::Matrix4d with_model = information;
  with_model.diagonal() += modelInformation(variances);
  const Eigen::Matrix4d scaled = variances.asDiagonal() * with_model * variances.asDiagonal();
  return variances.asDiagonal() * Eigen::Matrix4d(scaled.ldlt().solve(Eigen::Matrix4d::Identity())) *
         variances.asDiagonal();
}

std::optional<SharedOffset> lotOf(const Likelihood& likelihood) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(likelihood.sharedPrecision());
  if (eigen.eigenvalues().minCoeff() <= 1e-9 * eigen.eigenvalues().maxCoeff()) return std::nullopt;
  const Eigen::Matrix3d covariance = likelihood.sharedPrecision().inverse();
  return SharedOffset{covariance * likelihood.sharedWeighted(), covariance.diagonal().cwiseSqrt()};
}

}  // namespace

Accelerometer SensorSigmas::inModel(Accelerometer accelerometer) const {
  if (scale.knowledge != SigmaKnowledge::Unknown) {
    // One lot does not tell its part of the scales from the chips' own, so all of it counts as theirs.
    accelerometer.scale_sigma = scale.forModel();
    accelerometer.scale_shared_sigma = 0;
  }
  accelerometer.cross_axis_sigma = cross_axis.forModel();
  const double whole_g = offset_g.forModel();
  double& shared_g = accelerometer.offset_shared_sigma_g;
  if (shared_offset_g.knowledge == SigmaKnowledge::Measured) shared_g = shared_offset_g.sigma;
  if (shared_offset_g.knowledge == SigmaKnowledge::AtMost) shared_g = 0;
  shared_g = std::min(shared_g, whole_g);
  accelerometer.offset_sigma_g.setConstant(std::sqrt(whole_g * whole_g - shared_g * shared_g));
  return accelerometer;
}

SensorSigmas estimateSensorSigmas(std::span<const SensorEvidence> evidence, const Accelerometer& model) {
  const Accelerometer whole = model.ofUnknownLot();
  const double whole_offset_g = whole.largestOffsetSigma_g();
  const Variances variances = mostLikely(evidence, variancesOf(model));
  const Likelihood likelihood(evidence, variances);
  const Eigen::Matrix4d errors = errorsOf(likelihood.information(), variances);
  const auto boundOf = [&](Eigen::Index which, double model_sigma) {
    return upperBound(evidence, variances, which, model_sigma * model_sigma);
  };
  const auto kind = [&](SensorError error, double model_sigma) {
    const auto at = static_cast<Eigen::Index>(error);
    if (worthOf(variances[at], errors(at, at)) >= kFewestErrors) return measured(variances[at], errors(at, at));
    return bounded(variances[at], errors(at, at), boundOf(at, model_sigma), model_sigma);
  };
  SensorSigmas sigmas;
  sigmas.scale = kind(SensorError::Scale, whole.scale_sigma);
  sigmas.cross_axis = kind(SensorError::CrossAxis, model.cross_axis_sigma);

  const auto own = static_cast<Eigen::Index>(SensorError::Offset);
  const double offset = variances[own] + variances[kShared];
  const double offset_error = errors(own, own) + 2 * errors(own, kShared) + errors(kShared, kShared);
  const double shared_error = errors(kShared, kShared);
  // Where a lot's offset is most of it, there are no more than three numbers to know its spread from.
  const bool sees_lot = worthOf(variances[kShared], shared_error) >= kFewestSharedOffsets;
  const std::optional<double> shared_bound =
      sees_lot ? std::nullopt : boundOf(kShared, std::max(whole_offset_g, std::sqrt(offset)));
  if (worthOf(offset, offset_error) >= (sees_lot ? kFewestSharedOffsets : kFewestErrors)) {
    sigmas.offset_g = measured(offset, offset_error);
  } else {
    std::optional<double> bound = boundOf(own, whole_offset_g);
    if (bound) bound = *bound + (shared_bound ? *shared_bound : variances[kShared]);
    if (bound && *bound > std::pow(whole_offset_g, 2)) bound.reset();
    sigmas.offset_g = bounded(offset, offset_error, bound, whole_offset_g);
  }
  const bool knows_offset = sigmas.offset_g.knowledge != SigmaKnowledge::Unknown;
  if (sees_lot && knows_offset) {
    sigmas.shared_offset_g = measured(variances[kShared], shared_error);
  } else {
    sigmas.shared_offset_g = bounded(variances[kShared], shared_error, knows_offset ? shared_bound : std::nullopt,
                                     model.offset_shared_sigma_g);
  }
  if (sigmas.shared_offset_g.knowledge != SigmaKnowledge::Unknown) sigmas.lot = lotOf(likelihood);
  return sigmas;
}

}  // namespace hexoderm
