#include "hexoderm/solve/checks/cell_change.h"

#include "hexoderm/base/procrustes.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace hexoderm {
namespace {

/// The cross-axis sensitivities among the unknowns of a cell.
constexpr std::array<int, 6> kCrossAxis = {5, 6, 8, 10, 12, 13};

/// 1 sigma of the specific force in a pose. Nothing beside a reading, and the algebra is sound in poses of one or none.
constexpr double kAnyForce_g = 10;

Eigen::Index index3(std::size_t k) { return 3 * static_cast<Eigen::Index>(k); }
Eigen::Index indexShared(std::size_t k) { return kShared * static_cast<Eigen::Index>(k); }

constexpr double kTurnPrior_rad = 1;
constexpr double kDriftPrior_g = 1;

Eigen::Matrix3Xd columns(const Eigen::VectorXd& stacked) { return stacked.reshaped(3, stacked.size() / 3); }

/// Derivative of the forces exp(-e) v that a cell turned by e sees, at e = 0; three rows per pose.
Eigen::MatrixXd turnJacobian(const Eigen::VectorXd& force_o_g) {
  Eigen::MatrixXd J(force_o_g.size(), 3);
  for (Eigen::Index k = 0; k < force_o_g.size(); k += 3) J.middleRows<3>(k) = skew(force_o_g.segment<3>(k));
  return J;
}

/// Least squares in units of a covariance.
class Whitener {
 public:
  explicit Whitener(const Eigen::MatrixXd& covariance) : factor_(covariance) {}
  [[nodiscard]] Eigen::MatrixXd operator()(const Eigen::MatrixXd& values) const {
    return factor_.matrixL().solve(values);
  }

 private:
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

/// Deviation of the length of a vector with such a covariance.
double sigmaAlong(const Eigen::Vector3d& v, const Eigen::Matrix3d& covariance) {
  if (v.norm() == 0) return std::sqrt(covariance.trace() / 3);
  const Eigen::Vector3d along = v.normalized();
  return std::sqrt(along.dot(covariance * along));
}

/// Gauss-Newton from the rotation R of what the cell should see.
struct TurnSearch {
  const ViewComparison& comparison;
  Whitener whiten;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  double cost = 0;

  [[nodiscard]] Eigen::VectorXd seen() const { return (R * columns(comparison.foretold_o_g)).reshaped(); }
  [[nodiscard]] Eigen::VectorXd misses() const {
    return whiten(comparison.foretold_o_g + comparison.residual_g - seen());
  }
  [[nodiscard]] double costOf(const Eigen::Matrix3d& rotation) {
    R = rotation;
    return misses().squaredNorm() + logSO3(R).squaredNorm() / (kTurnPrior_rad * kTurnPrior_rad);
  }
  [[nodiscard]] Eigen::Matrix3d information() const {
    const Eigen::MatrixXd J = whiten(turnJacobian(seen()));
    return J.transpose() * J + Eigen::Matrix3d::Identity() / (kTurnPrior_rad * kTurnPrior_rad);
  }

  void run(const Eigen::Matrix3d& start) {
    constexpr int kSteps = 30;
    constexpr int kHalvings = 20;
    constexpr double kConverged = 1e-10;
    cost = costOf(start);
    for (int k = 0; k < kSteps; ++k) {
      const Eigen::MatrixXd J = whiten(turnJacobian(seen()));
      // R = exp(-turn), so the turn's part of the gradient is -log R.
      const Eigen::Vector3d right = J.transpose() * misses() + logSO3(R) / (kTurnPrior_rad * kTurnPrior_rad);
      Eigen::Vector3d step = information().llt().solve(right);
      const Eigen::Matrix3d from = R;
      const double before = cost;
      bool lowered = false;
      for (int halving = 0; !lowered && halving < kHalvings; ++halving, step /= 2) {
        cost = costOf(expSO3(-step) * from);
        lowered = cost < before;
      }
      if (!lowered) {
        cost = costOf(from);
        return;
      }
      if (step.norm() < kConverged) return;
    }
  }
};

/// Above the deviate `limit` with so many degrees of freedom: the chi-squared of Wilson and Hilferty's transformation.
double chiSquaredAt(double limit, double degrees) {
  const double spread = 2 / (9 * degrees);
  return degrees * std::pow(std::max(0.0, 1 - spread + limit * std::sqrt(spread)), 3);
}

/// By how much a chi-squared must be shifted (its noncentrality) to be beyond the deviate `limit` with 95 %.
double foundFrom(double limit, double degrees) {
  constexpr double k95Percent = 1.645;
  const double bound = chiSquaredAt(limit, degrees);
  double shift = std::max(0.0, bound - degrees);
  constexpr int kRounds = 50;
  for (int k = 0; k < kRounds; ++k) shift = bound - degrees + k95Percent * std::sqrt(2 * (degrees + 2 * shift));
  return shift;
}

}  // namespace

CellJacobian readingJacobian(const Eigen::Matrix3d& gain, const Eigen::Vector3d& v) {
  CellJacobian J = CellJacobian::Zero();
  J.leftCols<3>() = gain * skew(v);
  for (int axis = 0; axis < 3; ++axis) {
    J(axis, 3 + 4 * axis) = 1;
    J.block<1, 3>(axis, 4 + 4 * axis) = v.transpose();
  }
  return J;
}

Eigen::Matrix3d elastomerInformation(const CellModel& model, std::span<const PortNumber> ports) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
  for (const PortNumber port : ports) {
    const Eigen::Matrix3d axes = linkAxes(model.port(port));
    const Eigen::Vector3d sigma(model.twist_sigma_rad, model.bend_sigma_rad, model.yaw_sigma_rad);
    for (int k = 0; k < 3; ++k) {
      if (sigma[k] > 0) information += axes.col(k) * axes.col(k).transpose() / (sigma[k] * sigma[k]);
    }
  }
  const Eigen::Matrix3d& R_u_a = model.accelerometer.T_u_a.R;
  return R_u_a.transpose() * information * R_u_a;
}

AccelerometerPrior priorOfChips(const CellModel& model, const PatchReconstruction& patch) {
  if (!patch.lot) return AccelerometerPrior(model.accelerometer.ofUnknownLot());
  return AccelerometerPrior(SensorLot{patch.lot->offset_g, patch.lot->scale}.chips(model.accelerometer));
}

double unknownOfLot_g(const PatchReconstruction& patch) {
  constexpr double kMost_g = 1;  // of a file
  return patch.lot ? std::min(kMost_g, patch.lot->offset_sigma_g.maxCoeff()) : 0;
}

CellErrors priorInformation(const AccelerometerPrior& sensor, const Eigen::Matrix3d& attitude) {
  CellErrors information = CellErrors::Zero();
  information.topLeftCorner<3, 3>() = attitude;
  for (int axis = 0; axis < 3; ++axis) information.diagonal().segment<4>(3 + 4 * axis) = sensor.precision(axis);
  return information;
}

CellErrors errorsOfCell(const CellErrors& priors, std::span<const PlacingReading> readings, const Eigen::Matrix3d& gain,
                        CellEstimate estimate) {
  CellErrors normal = CellErrors::Zero();
  CellErrors scattered = CellErrors::Zero();
  for (const PlacingReading& reading : readings) {
    const CellJacobian J = readingJacobian(gain, reading.v_g);
    const CellErrors share = J.transpose() * J / reading.variance_g2;
    normal += share;
    scattered += reading.scatter_g2 / reading.variance_g2 * share;
  }
  if (estimate != CellEstimate::Tree) {
    // The error is -A^-1 L x + A^-1 J^T W n, of true unknowns x with covariance L^-1 and readings' noise n.
    CellErrors of_noise = (priors + normal).inverse();
    CellErrors of_truth = of_noise * priors;
    if (estimate == CellEstimate::GlobalNoCrossAxis) {
      for (const int k : kCrossAxis) {
        of_noise.row(k).setZero();
        of_truth.row(k) = CellErrors::Identity().row(k);
      }
    }
    return of_truth * priors.ldlt().solve(of_truth.transpose()) + of_noise * scattered * of_noise.transpose();
  }
  const Eigen::Matrix3d attitude = (normal + priors).topLeftCorner<3, 3>().inverse();
  const CellErrors sensor = priors.diagonal().cwiseInverse().asDiagonal();
  CellErrors carried = CellErrors::Identity();
  carried.topLeftCorner<3, 3>().setZero();
  carried.topRightCorner<3, 12>() = -attitude * normal.topRightCorner<3, 12>();
  CellErrors covariance = carried * sensor * carried.transpose();
  covariance.topLeftCorner<3, 3>() += attitude;
  return covariance;
}

SharedJacobian sharedJacobian(const Eigen::Vector3d& at_o, const Eigen::Matrix3d& drift_o) {
  SharedJacobian X;
  X << Eigen::Matrix3d::Identity(), -skew(at_o), drift_o;
  return X;
}

Eigen::MatrixXd sharedPrior(std::size_t poses, const SharedDrift& drift) {
  constexpr double kLeast_g2 = 1e-10;  // a model may know of no drift
  const auto count = static_cast<double>(poses);
  const double of_session_g2 = drift.of_session_g * drift.of_session_g;
  const double of_poses_g2 = std::max(drift.of_poses_g * drift.of_poses_g, kLeast_g2);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(indexShared(poses), indexShared(poses));
  for (std::size_t a = 0; a < poses; ++a) {
    auto own = information.diagonal().segment<kShared>(indexShared(a));
    own.segment<3>(0).setConstant(1 / (kAnyForce_g * kAnyForce_g));
    own.segment<3>(3).setConstant(1 / (kAngularAccelerationSigma * kAngularAccelerationSigma));
    own.segment<3>(6).setConstant(1 / of_poses_g2);
    // The inverse of variances of_poses + of_session, and covariances of_session between the poses.
    for (std::size_t b = 0; b < poses; ++b) {
      information.block<3, 3>(indexShared(a) + 6, indexShared(b) + 6).diagonal().array() -=
          of_session_g2 / (of_poses_g2 * (of_poses_g2 + count * of_session_g2));
    }
  }
  return information;
}

double ViewComparison::deviate() const {
  const Whitener whiten(covariance_g2);
  const Eigen::Vector3d pull = whiten(turnJacobian(foretold_o_g)).transpose() * whiten(residual_g);
  // Axes that the poses don't show count neither in the chi-squared nor in its degrees.
  const Eigen::Matrix3d shown = turnInformation();
  const Eigen::Matrix3d covariance =
      (shown + Eigen::Matrix3d::Identity() / (kTurnPrior_rad * kTurnPrior_rad)).inverse();
  const Misfit by_turn{pull.dot(covariance * pull), (covariance * shown).trace()};
  if (by_turn.degrees < 1) return misfit.deviate();  // no pose shows a turn
  return std::max(misfit.deviate(), by_turn.deviate());
}

Eigen::Matrix3d ViewComparison::turnInformation() const {
  const Eigen::MatrixXd J = Whitener(covariance_g2)(turnJacobian(foretold_o_g));
  return J.transpose() * J;
}

Consensus::Consensus(std::span<const CellView> views, std::size_t poses, double limit, const SharedDrift& drift)
    : views_(views), limit_(limit), holds_(views.size(), true), information_(sharedPrior(poses, drift)) {
  weighted_ = Eigen::VectorXd::Zero(information_.rows());
  for (const CellView& view : views) count(view, 1);
  solve();
  exclude();
  readmit();
  findVarianceFactor();
}

std::size_t Consensus::size() const { return static_cast<std::size_t>(std::ranges::count(holds_, true)); }

void Consensus::count(const CellView& view, double sign) {
  const SharedJacobian X = sharedJacobian(view.at_o, view.drift_o);
  const Eigen::LLT<Eigen::MatrixXd> factor(view.covariance_g2);
  const Eigen::MatrixXd precision =
      factor.solve(Eigen::MatrixXd::Identity(view.covariance_g2.rows(), view.covariance_g2.cols()));
  const Eigen::VectorXd pulls = factor.solve(view.force_o_g);
  for (std::size_t a = 0; a < view.poses.size(); ++a) {
    weighted_.segment<kShared>(indexShared(view.poses[a])) += sign * X.transpose() * pulls.segment<3>(index3(a));
    for (std::size_t b = 0; b < view.poses.size(); ++b) {
      information_.block<kShared, kShared>(indexShared(view.poses[a]), indexShared(view.poses[b])) +=
          sign * X.transpose() * precision.block<3, 3>(index3(a), index3(b)) * X;
    }
  }
}

void Consensus::solve() {
  const Eigen::LLT<Eigen::MatrixXd> factor(information_);
  covariance_ = factor.solve(Eigen::MatrixXd::Identity(information_.rows(), information_.cols()));
  shared_ = factor.solve(weighted_);
}

ViewComparison Consensus::compare(std::size_t view_index) const {
  const CellView& view = views_[view_index];
  const SharedJacobian X = sharedJacobian(view.at_o, view.drift_o);
  ViewComparison comparison;
  Eigen::VectorXd drift(view.force_o_g.size());
  comparison.foretold_o_g.resize(view.force_o_g.size());
  Eigen::MatrixXd carried(view.force_o_g.size(),
                          view.force_o_g.size());  // the covariance of what is shared, as the cell sees it
  for (std::size_t a = 0; a < view.poses.size(); ++a) {
    const SharedByCells shared = shared_.segment<kShared>(indexShared(view.poses[a]));
    drift.segment<3>(index3(a)) = view.drift_o * shared.tail<3>();
    comparison.foretold_o_g.segment<3>(index3(a)) = X.leftCols<6>() * shared.head<6>();
    for (std::size_t b = 0; b < view.poses.size(); ++b) {
      carried.block<3, 3>(index3(a), index3(b)) =
          X * covariance_.block<kShared, kShared>(indexShared(view.poses[a]), indexShared(view.poses[b])) *
          X.transpose();
    }
  }
  comparison.residual_g = view.force_o_g - drift - comparison.foretold_o_g;
  comparison.covariance_g2 = view.covariance_g2 + carried;
  if (holds_[view_index]) {
    // Without the cell's own part in the motions: Z W^-1 r, with covariance Z W^-1 Z, where Z is the cell's covariance,
    // r the residual against the motions of all, and W = Z - carried the covariance of r.
    const Eigen::MatrixXd own = view.covariance_g2 - carried;
    const Eigen::LDLT<Eigen::MatrixXd> factor(own);
    comparison.residual_g = view.covariance_g2 * factor.solve(comparison.residual_g);
    comparison.foretold_o_g = view.force_o_g - drift - comparison.residual_g;
    const Eigen::MatrixXd spread = view.covariance_g2 * factor.solve(view.covariance_g2);
    comparison.covariance_g2 = (spread + spread.transpose()) / 2;
  }
  comparison.covariance_g2 *= variance_factor_;
  const double chi_squared = comparison.residual_g.dot(comparison.covariance_g2.llt().solve(comparison.residual_g));
  comparison.misfit = {chi_squared, static_cast<double>(comparison.residual_g.size())};
  return comparison;
}

std::optional<Consensus::CommonDrift> Consensus::commonDrift() const {
  constexpr double kBeyondDoubt = 3;  // standard deviations
  const Eigen::Index poses = shared_.size() / kShared;
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(3, shared_.size());
  for (Eigen::Index k = 0; k < poses; ++k) {
    mean.middleCols<3>(kShared * k + 6).diagonal().setConstant(1 / static_cast<double>(poses));
  }
  const Eigen::Vector3d offset_g = mean * shared_;
  const Eigen::Matrix3d covariance = variance_factor_ * mean * covariance_ * mean.transpose();
  if (Misfit{offset_g.dot(covariance.inverse() * offset_g), 3}.deviate() < kBeyondDoubt) return std::nullopt;
  return CommonDrift{offset_g, sigmaAlong(offset_g, covariance)};
}

void Consensus::exclude() {
  constexpr double kAsBad = 0.7;  // share of the worst deviate: far from it, others are bad because of the worst
  while (size() > 1) {
    std::vector<double> deviates(views_.size(), 0);
    for (std::size_t k = 0; k < views_.size(); ++k) {
      if (holds_[k]) deviates[k] = compare(k).deviate();
    }
    const auto worst = std::ranges::max_element(deviates);
    if (*worst <= limit_) return;
    const double bad = std::max(limit_, kAsBad * *worst);
    // Where many are as bad, they may be so because of each other.
    const auto bad_ones =
        static_cast<std::size_t>(std::ranges::count_if(deviates, [bad](double d) { return d > bad; }));
    const bool are_few = 4 * bad_ones <= size();
    for (std::size_t k = 0; k < views_.size(); ++k) {
      const bool is_worst = static_cast<std::ptrdiff_t>(k) == worst - deviates.begin();
      if (!is_worst && !(are_few && deviates[k] > bad)) continue;
      holds_[k] = false;
      count(views_[k], -1);
    }
    solve();
  }
}

void Consensus::readmit() {
  std::vector<std::size_t> back;
  for (std::size_t k = 0; k < views_.size(); ++k) {
    if (!holds_[k] && compare(k).deviate() <= limit_) back.push_back(k);
  }
  for (const std::size_t k : back) {
    holds_[k] = true;
    count(views_[k], 1);
  }
  solve();
}

void Consensus::findVarianceFactor() {
  constexpr std::size_t kFewestCells = 5;  // fewer say little about all
  if (size() < kFewestCells) return;
  Misfit all;
  for (std::size_t k = 0; k < views_.size(); ++k) {
    if (!holds_[k]) continue;
    const Misfit misfit = compare(k).misfit;
    all.chi_squared += misfit.chi_squared;
    all.degrees += misfit.degrees;
  }
  if (all.degrees > 0) variance_factor_ = std::max(1.0, all.chi_squared / all.degrees);
}

TurnFit fitTurn(const ViewComparison& comparison) {
  const Eigen::VectorXd seen = comparison.foretold_o_g + comparison.residual_g;
  const Whitener whiten(comparison.covariance_g2);
  const Eigen::Vector3d first = comparison.foretold_o_g.head<3>();
  const Eigen::Matrix3d shortest = shortestRotation(first.normalized(), seen.head<3>().normalized());
  const Eigen::Matrix3d best = solveProcrustes(columns(comparison.foretold_o_g), columns(seen)).R_c_n;
  TurnSearch found{comparison, whiten};
  found.cost = -1;
  for (const Eigen::Matrix3d& start : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), shortest, best}) {
    TurnSearch search{comparison, whiten};
    search.run(start);
    if (found.cost < 0 || search.cost < found.cost) {
      found.R = search.R;
      found.cost = search.cost;
    }
  }
  const Eigen::Matrix3d covariance = found.information().inverse();
  TurnFit fit;
  fit.turn_o = -logSO3(found.R);
  fit.sigma_rad = sigmaAlong(fit.turn_o, covariance);
  fit.blind_sigma_rad = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues().maxCoeff());
  fit.left = {found.misses().squaredNorm(), std::max(0.0, static_cast<double>(seen.size()) - 3)};
  return fit;
}

DriftFit fitDrift(const CellView& view, const ViewComparison& comparison) {
  const Whitener whiten(comparison.covariance_g2);
  const Eigen::MatrixXd J = whiten(view.drift_o.replicate(static_cast<Eigen::Index>(view.poses.size()), 1));
  const Eigen::VectorXd residual = whiten(comparison.residual_g);
  const Eigen::Matrix3d information = J.transpose() * J + Eigen::Matrix3d::Identity() / (kDriftPrior_g * kDriftPrior_g);
  DriftFit fit;
  fit.offset_g = information.llt().solve(J.transpose() * residual);
  fit.sigma_g = sigmaAlong(fit.offset_g, information.inverse());
  fit.left = {(residual - J * fit.offset_g).squaredNorm(), std::max(0.0, static_cast<double>(residual.size()) - 3)};
  return fit;
}

NoticedTurn noticedTurn(const ViewComparison& comparison, double limit) {
  constexpr double kSmall_rad = 60 * kDegree;  // the readings' change is as good as linear in a smaller turn
  const Eigen::Vector3d information =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(comparison.turnInformation()).eigenvalues();  // ascending
  const double shift = foundFrom(limit, comparison.residual_g.size() > 3 ? 3 : 2);  // one pose shows two angles
  const auto angle = [&](double shown) -> std::optional<double> {
    if (!(shown > 0)) return std::nullopt;
    const double angle_rad = std::sqrt(shift / shown);
    return angle_rad < kSmall_rad ? std::optional(angle_rad) : std::nullopt;
  };
  return {angle(information[0]), angle(information[1])};
}

}  // namespace hexoderm
