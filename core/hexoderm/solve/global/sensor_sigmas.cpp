#include "hexoderm/solve/global/sensor_sigmas.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

/// Variances in the order of SensorError, without what is shared, then those of the lot's offset and scale.
using Variances = Eigen::Matrix<double, 5, 1>;
using Information = Eigen::Matrix<double, 5, 5>;
constexpr Eigen::Index kShared = 3;
constexpr Eigen::Index kSharedScale = 4;
constexpr Eigen::Index kKinds = kSensorErrors;
/// The lot's errors: an offset of each axis, and the scale.
constexpr Eigen::Index kLotErrors = 4;
Eigen::Index groupOfLot(Eigen::Index error) { return error < 3 ? kShared : kSharedScale; }

constexpr double kMinVariance = 1e-12;         // far below what any reading shows
constexpr double kWeightOfModelSigmas = 1e-3;  // of one error, for the cell model's sigmas
/// With fewer degrees of freedom the range of a sigma spans more than a factor of three.
constexpr double kFewestErrors = 7;
/// A lot has three offsets and one scale.
constexpr double kFewestSharedOffsets = 2;
constexpr double kFewestSharedScales = 0.75;
constexpr double kTwoSided95 = 1.959964;

Eigen::Index groupOf(Eigen::Index parameter) { return static_cast<Eigen::Index>(kindOfParameter(parameter)); }

/// Which of the lot's errors adds to a parameter.
std::optional<Eigen::Index> lotErrorOf(Eigen::Index parameter) {
  switch (kindOfParameter(parameter)) {
    case SensorError::Offset:
      return (parameter % kSensorParameters) / 4;
    case SensorError::Scale:
      return kLotErrors - 1;
    default:
      return std::nullopt;
  }
}

/// The parameters are numbered by sensors; those of one kind are summed up.
Variances sumsByKind(const Eigen::VectorXd& values) {
  Variances sums = Variances::Zero();
  for (Eigen::Index k = 0; k < values.size(); ++k) sums[groupOf(k)] += values[k];
  return sums;
}

Information squaresByKind(const Eigen::MatrixXd& matrix) {
  Information sums = Information::Zero();
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      sums(groupOf(row), groupOf(column)) += matrix(row, column) * matrix(row, column);
    }
  }
  return sums;
}

/// Score and Fisher information of the variances. With P = (M^-1 + L)^-1 and p = P x for the most likely errors x:
/// score (p^T L_j p - tr P L_j) / 2 and information tr(P L_j P L_k) / 2, L_j being the derivative of L. The lot adds
/// U w U^T to L, of rank four over all patches, with U what its errors add to the sensors' and w their variances.
class Likelihood {
 public:
  Likelihood(std::span<const SensorEvidence> evidence, const Variances& variances) {
    std::array<Eigen::Matrix4d, kKinds> spread;  // A_j^T A_j, with A = P0 U, P0 without the shared part
    spread.fill(Eigen::Matrix4d::Zero());
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
      Eigen::MatrixXd A = Eigen::MatrixXd::Zero(prior.size(), kLotErrors);
      for (Eigen::Index k = 0; k < prior.size(); ++k) {
        const std::optional<Eigen::Index> error = lotErrorOf(k);
        if (!error) continue;
        A.col(*error) += weighed.precision.col(k);
        shared_weighted_[*error] += weighed.weighted[k];
      }
      for (Eigen::Index k = 0; k < prior.size(); ++k) {
        if (const std::optional<Eigen::Index> error = lotErrorOf(k)) shared_precision_.row(*error) += A.row(k);
        spread.at(static_cast<std::size_t>(groupOf(k))) += A.row(k).transpose() * A.row(k);
      }
      patches.push_back({std::move(weighed.precision), std::move(weighed.weighted), std::move(A)});
    }

    // P = P0 - A K A^T, K = (1/w + G)^-1, G = U^T A.
    const Eigen::Matrix4d& G = shared_precision_;
    Eigen::Vector4d w;
    for (Eigen::Index error = 0; error < kLotErrors; ++error) w[error] = variances[groupOfLot(error)];
    const Eigen::Matrix4d K =
        (Eigen::Matrix4d::Identity() + w.asDiagonal() * G).partialPivLu().solve(Eigen::Matrix4d(w.asDiagonal()));
    const Eigen::Matrix4d W = Eigen::Matrix4d::Identity() - K * G;  // P U = A W
    const Eigen::Vector4d shared = shared_weighted_ - G * K * shared_weighted_;
    const Eigen::Matrix4d of_shared = G * W;
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
      const Eigen::Matrix4d& T_j = spread.at(static_cast<std::size_t>(j));
      score_[j] += (K * T_j).trace() / 2;
      for (Eigen::Index k = 0; k < kKinds; ++k) {
        information_(j, k) += (K * T_j * K * spread.at(static_cast<std::size_t>(k))).trace() / 2;
      }
      const Eigen::Vector4d mixed = (W.transpose() * T_j * W).diagonal() / 2;
      for (Eigen::Index error = 0; error < kLotErrors; ++error) {
        information_(j, groupOfLot(error)) += mixed[error];
        information_(groupOfLot(error), j) += mixed[error];
      }
    }
    for (Eigen::Index a = 0; a < kLotErrors; ++a) {
      score_[groupOfLot(a)] += (shared[a] * shared[a] - of_shared(a, a)) / 2;
      for (Eigen::Index b = 0; b < kLotErrors; ++b) {
        information_(groupOfLot(a), groupOfLot(b)) += of_shared(a, b) * of_shared(a, b) / 2;
      }
    }
  }

  [[nodiscard]] const Variances& score() const { return score_; }
  [[nodiscard]] const Information& information() const { return information_; }
  /// G = U^T P0 U and U^T p0: the information about the lot's errors and that times their most likely values.
  [[nodiscard]] const Eigen::Matrix4d& sharedPrecision() const { return shared_precision_; }
  [[nodiscard]] const Eigen::Vector4d& sharedWeighted() const { return shared_weighted_; }

 private:
  Variances score_ = Variances::Zero();
  Information information_ = Information::Zero();
  Eigen::Matrix4d shared_precision_ = Eigen::Matrix4d::Zero();
  Eigen::Vector4d shared_weighted_ = Eigen::Vector4d::Zero();
};

Variances variancesOf(const Accelerometer& model) {
  constexpr double kMinShare = 0.01;  // of the own errors' variance, so that a shared part can be found
  const double own = std::pow(model.largestOffsetSigma_g(), 2);
  const double scale = std::pow(model.scale_sigma, 2);
  Variances variances;
  variances << own, scale, std::pow(model.cross_axis_sigma, 2),
      std::max(std::pow(model.offset_shared_sigma_g, 2), kMinShare * own),
      std::max(std::pow(model.scale_shared_sigma, 2), kMinShare * scale);
  constexpr double kMinStart = 1e-8;  // from exactly 0 nothing would move
  return variances.cwiseMax(kMinStart);
}

/// The model's word, as if so much of an error had been seen.
Variances modelScore(const Variances& model, const Variances& now) {
  return kWeightOfModelSigmas / 2 * (model - now).cwiseQuotient(now.cwiseAbs2());
}
Variances modelInformation(const Variances& now) { return kWeightOfModelSigmas / 2 * now.cwiseAbs2().cwiseInverse(); }

Variances mostLikely(std::span<const SensorEvidence> evidence, const Variances& model) {
  constexpr int kRounds = 200;
  constexpr double kLargestFactor = 4;
  constexpr double kSettled = 1e-6;
  constexpr double kNegligible = 1e-10;  // g^2: a hundredth of a mg
  Variances variances = model;
  for (int round = 0; round < kRounds; ++round) {
    const Likelihood likelihood(evidence, variances);
    Information information = likelihood.information();
    information.diagonal() += modelInformation(variances);
    // Scaled, because variances differ by orders of magnitude.
    const Information scaled = variances.asDiagonal() * information * variances.asDiagonal();
    const Variances score = likelihood.score() + modelScore(model, variances);
    const Variances step = scaled.ldlt().solve(variances.cwiseProduct(score));
    Variances next = variances;
    for (Eigen::Index k = 0; k < variances.size(); ++k) {
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
  // A single normal error, of which Wilson and Hilferty's share may be negative: one in 40 is larger than so many
  // sigmas, one in 40 smaller.
  const bool is_single = estimate.worth < kFewestSharedOffsets;
  estimate.low_95 = estimate.sigma / (is_single ? 2.2414 : std::sqrt(quantileShare(estimate.worth, kTwoSided95)));
  estimate.high_95 = estimate.sigma / (is_single ? 0.03134 : std::sqrt(quantileShare(estimate.worth, -kTwoSided95)));
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
Information errorsOf(const Information& information, const Variances& variances) {
  Information with_model = information;
  with_model.diagonal() += modelInformation(variances);
  const Information scaled = variances.asDiagonal() * with_model * variances.asDiagonal();
  return variances.asDiagonal() * Information(scaled.ldlt().solve(Information::Identity())) * variances.asDiagonal();
}

/// Nothing is granted of the lot's offset beforehand, and of its scale that it has the variance that was found.
std::optional<LotEstimate> lotOf(const Likelihood& likelihood, const Variances& variances) {
  Eigen::Matrix4d precision = likelihood.sharedPrecision();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(precision.topLeftCorner<3, 3>());
  if (eigen.eigenvalues().minCoeff() <= 1e-9 * eigen.eigenvalues().maxCoeff()) return std::nullopt;
  precision(3, 3) += 1 / variances[kSharedScale];
  const Eigen::Matrix4d covariance = precision.ldlt().solve(Eigen::Matrix4d::Identity());
  const Eigen::Vector4d errors = covariance * likelihood.sharedWeighted();
  const Eigen::Vector4d sigmas = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  return LotEstimate{errors.head<3>(), sigmas.head<3>(), 1 + errors[3], sigmas[3] / (1 + errors[3])};
}

}  // namespace

Accelerometer SensorSigmas::inModel(Accelerometer accelerometer) const {
  const double whole = accelerometer.ofUnknownLot().scale_sigma;
  double& own = accelerometer.scale_sigma = scale.forModel();
  double& shared = accelerometer.scale_shared_sigma = shared_scale.forModel();
  if (shared_scale.knowledge == SigmaKnowledge::AtMost) own = std::hypot(own, std::exchange(shared, 0));
  if (shared_scale.knowledge == SigmaKnowledge::Unknown) shared = std::sqrt(std::max(0.0, whole * whole - own * own));
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
  const Information errors = errorsOf(likelihood.information(), variances);
  const auto boundOf = [&](Eigen::Index which, double model_sigma) {
    return upperBound(evidence, variances, which, model_sigma * model_sigma);
  };
  const auto kind = [&](SensorError error, double model_sigma) {
    const auto at = static_cast<Eigen::Index>(error);
    if (worthOf(variances[at], errors(at, at)) >= kFewestErrors) return measured(variances[at], errors(at, at));
    return bounded(variances[at], errors(at, at), boundOf(at, model_sigma), model_sigma);
  };
  SensorSigmas sigmas;
  sigmas.scale = kind(SensorError::Scale, model.scale_sigma);
  sigmas.cross_axis = kind(SensorError::CrossAxis, model.cross_axis_sigma);
  const double scale_error = errors(kSharedScale, kSharedScale);
  if (worthOf(variances[kSharedScale], scale_error) >= kFewestSharedScales) {
    sigmas.shared_scale = measured(variances[kSharedScale], scale_error);
  } else {
    sigmas.shared_scale = bounded(variances[kSharedScale], scale_error, boundOf(kSharedScale, whole.scale_sigma),
                                  model.scale_shared_sigma);
  }

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
  if (sigmas.shared_offset_g.knowledge != SigmaKnowledge::Unknown) sigmas.lot = lotOf(likelihood, variances);
  // A chip's own scale and cross-axis errors are those of what it reads before its lot's scale.
  for (SigmaEstimate* own_error : {&sigmas.scale, &sigmas.cross_axis}) {
    if (!sigmas.lot || own_error->knowledge == SigmaKnowledge::Unknown) continue;
    for (double* figure : {&own_error->sigma, &own_error->low_95, &own_error->high_95}) *figure /= sigmas.lot->scale;
  }
  return sigmas;
}

}  // namespace hexoderm
