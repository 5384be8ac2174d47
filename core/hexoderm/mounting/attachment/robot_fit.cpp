#include "hexoderm/mounting/attachment/robot_fit.h"

#include "hexoderm/base/se3.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

using Eigen::Index;

constexpr int kMaxRobotSteps = 30;
constexpr int kMaxRobotHalvings = 8;
constexpr double kRobotSettled_rad = 1e-10;
constexpr int kMaxScales = 50;
constexpr double kScaleSettled = 1e-3;
/// Degrees of freedom of Student's t of the zeros, and of the tilt: the fewer, the easier are large ones believed.
constexpr double kScaleFreedom = 1;

/// The scale of the variances of normal unknowns with a variance of `prior` each, from their estimates: one step of
/// expectation and maximisation. Never below 1.
double nextScale(const Eigen::VectorXd& estimates, const Eigen::VectorXd& variances, double prior) {
  const double squares = (estimates.squaredNorm() + variances.sum()) / prior;
  return std::max(1.0, (kScaleFreedom + squares) / (kScaleFreedom + static_cast<double>(estimates.size())));
}

class RobotProblem {
 public:
  RobotProblem(std::span<const PatchOnKnownLink> patches, const RobotModel& robot, std::span<const JointAngles> angles,
               const Eigen::Vector3d& up_w, const RobotPriors& priors)
      : patches_(patches),
        robot_(robot),
        angles_(angles),
        up_0_(up_w.normalized()),
        tilt_basis_(acrossBasis(up_0_)),
        priors_(priors) {
    const LinkGravity gravity(robot, angles, up_0_);
    for (const PatchOnKnownLink& patch : patches) {
      state_.R.push_back(patch.R_l_o);
      const std::vector<std::size_t>& joints = gravity.jointsTo(patch.link);
      joints_.insert(joints_.end(), joints.begin(), joints.end());
    }
    std::ranges::sort(joints_);
    joints_.erase(std::unique(joints_.begin(), joints_.end()), joints_.end());
    state_.zeros.setZero(static_cast<Index>(joints_.size()));
    state_.tilt.setZero();
  }

  RobotFit solve() {
    for (int round = 0; round < kMaxScales; ++round) {
      maximise();
      const double zero_scale =
          priors_.zero_rad > 0 && !joints_.empty()
              ? nextScale(state_.zeros, variances(zeroAt(), state_.zeros.size()), priors_.zero_rad * priors_.zero_rad)
              : 1;
      const double tilt_scale =
          priors_.tilt_rad > 0 ? nextScale(state_.tilt, variances(tiltAt(), 2), priors_.tilt_rad * priors_.tilt_rad)
                               : 1;
      const double change = std::abs(zero_scale / zero_scale_ - 1) + std::abs(tilt_scale / tilt_scale_ - 1);
      zero_scale_ = zero_scale;
      tilt_scale_ = tilt_scale;
      if (change < kScaleSettled) break;
    }
    maximise();
    return describe();
  }

 private:
  struct State {
    std::vector<Eigen::Matrix3d> R;
    Eigen::VectorXd zeros;
    Eigen::Vector2d tilt;
  };

  [[nodiscard]] static Index turnAt(std::size_t patch) { return static_cast<Index>(3 * patch); }
  [[nodiscard]] Index zeroAt() const { return static_cast<Index>(3 * patches_.size()); }
  [[nodiscard]] Index tiltAt() const { return zeroAt() + static_cast<Index>(joints_.size()); }
  [[nodiscard]] Index unknowns() const { return tiltAt() + 2; }
  /// What is exact gets so much information that it stays where it is.
  static double informationOf(double sigma_rad, double scale) {
    constexpr double kExact_rad = 1e-9;
    return 1 / (scale * std::pow(std::max(sigma_rad, kExact_rad), 2));
  }
  [[nodiscard]] double zeroInformation() const { return informationOf(priors_.zero_rad, zero_scale_); }
  [[nodiscard]] double tiltInformation() const { return informationOf(priors_.tilt_rad, tilt_scale_); }

  [[nodiscard]] Eigen::Vector3d upOf(const State& state) const {
    return (up_0_ + tilt_basis_ * state.tilt).normalized();
  }
  [[nodiscard]] LinkGravity gravityOf(const State& state) const {
    std::vector<double> zeros(robot_.joints().size(), 0.0);
    for (std::size_t j = 0; j < joints_.size(); ++j) zeros[joints_[j]] = state.zeros[static_cast<Index>(j)];
    return {robot_, angles_, upOf(state), zeros};
  }
  /// Of a patch, across what it saw.
  [[nodiscard]] Eigen::VectorXd residuals(std::size_t patch, const State& state, const LinkGravity& gravity) const {
    const SeenByPatch& seen = *patches_[patch].patch;
    Eigen::VectorXd rows(static_cast<Index>(2 * seen.size()));
    for (std::size_t k = 0; k < seen.size(); ++k) {
      rows.segment<2>(static_cast<Index>(2 * k)) =
          seen.residual(k, state.R[patch].transpose() * gravity.up(patches_[patch].link, seen.placeOf(k)));
    }
    return rows;
  }

  [[nodiscard]] double costOf(const State& state) const {
    const LinkGravity gravity = gravityOf(state);
    double cost = zeroInformation() * state.zeros.squaredNorm() + tiltInformation() * state.tilt.squaredNorm();
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      Eigen::MatrixXd rows = residuals(k, state, gravity);
      patches_[k].patch->whiten(rows);
      cost += rows.squaredNorm();
    }
    return cost;
  }

  /// Derivatives of a patch's residuals by all unknowns.
  [[nodiscard]] Eigen::MatrixXd derivatives(std::size_t patch, const State& state, const LinkGravity& gravity) const {
    const SeenByPatch& seen = *patches_[patch].patch;
    const std::size_t link = patches_[patch].link;
    const std::vector<std::size_t>& turning = gravity.jointsTo(link);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Index>(2 * seen.size()), unknowns());
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const auto at = static_cast<Index>(2 * k);
      const std::size_t place = seen.placeOf(k);
      const Eigen::Matrix<double, 2, 3> by_up_l = seen.across(k) * state.R[patch].transpose();
      rows.block<2, 3>(at, turnAt(patch)) = seen.across(k) * skew(state.R[patch].transpose() * gravity.up(link, place));
      for (std::size_t j = 0; j < joints_.size(); ++j) {
        if (!std::ranges::binary_search(turning, joints_[j])) continue;
        rows.block<2, 1>(at, zeroAt() + static_cast<Index>(j)) = by_up_l * gravity.byZero(link, place, joints_[j]);
      }
      rows.block<2, 2>(at, tiltAt()) = by_up_l * gravity.byUp(link, place) * tilt_basis_;
    }
    return rows;
  }

  void linearize() {
    const LinkGravity gravity = gravityOf(state_);
    matrix_.setZero(unknowns(), unknowns());
    gradient_.setZero(unknowns());
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      Eigen::MatrixXd rows = derivatives(k, state_, gravity);
      Eigen::MatrixXd left = residuals(k, state_, gravity);
      patches_[k].patch->whiten(rows);
      patches_[k].patch->whiten(left);
      matrix_ += rows.transpose() * rows;
      gradient_ += rows.transpose() * left;
    }
    matrix_.diagonal().head(zeroAt()).array() += kOpenTurnInformation;
    matrix_.diagonal().segment(zeroAt(), state_.zeros.size()).array() += zeroInformation();
    matrix_.diagonal().tail<2>().array() += tiltInformation();
    gradient_.segment(zeroAt(), state_.zeros.size()) += zeroInformation() * state_.zeros;
    gradient_.tail<2>() += tiltInformation() * state_.tilt;
    factor_.compute(matrix_);
  }

  [[nodiscard]] State moved(const Eigen::VectorXd& move) const {
    State state = state_;
    for (std::size_t k = 0; k < patches_.size(); ++k) state.R[k] *= expSO3(move.segment<3>(turnAt(k)));
    state.zeros += move.segment(zeroAt(), state.zeros.size());
    state.tilt += move.tail<2>();
    return state;
  }

  void maximise() {
    double cost = costOf(state_);
    for (int step = 0; step < kMaxRobotSteps; ++step) {
      linearize();
      Eigen::VectorXd move = -factor_.solve(gradient_);
      State next = moved(move);
      double next_cost = costOf(next);
      for (int halving = 0; next_cost > cost && halving < kMaxRobotHalvings; ++halving) {
        move /= 2;
        next = moved(move);
        next_cost = costOf(next);
      }
      if (next_cost > cost) break;
      state_ = std::move(next);
      cost = next_cost;
      if (move.cwiseAbs().maxCoeff() < kRobotSettled_rad) break;
    }
    linearize();
    cost_ = cost;
  }

  [[nodiscard]] Eigen::VectorXd variances(Index at, Index size) const {
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(unknowns(), size);
    columns.middleRows(at, size).setIdentity();
    return factor_.solve(columns).middleRows(at, size).diagonal();
  }

  [[nodiscard]] RobotFit describe() const {
    RobotFit fit;
    fit.R_l_o = state_.R;
    fit.joints = joints_;
    fit.zeros.assign(state_.zeros.begin(), state_.zeros.end());
    fit.zero_sigma_rad = priors_.zero_rad * std::sqrt(zero_scale_);
    fit.up_w = upOf(state_);
    Eigen::MatrixXd stated = Eigen::MatrixXd::Identity(unknowns() + 1, unknowns());
    stated.bottomRightCorner<3, 2>() = tilt_basis_;
    const Eigen::MatrixXd covariance =
        stated * factor_.solve(Eigen::MatrixXd::Identity(unknowns(), unknowns())) * stated.transpose();
    fit.covariance = (covariance + covariance.transpose()) / 2;
    Index rows = 0;
    Index known = 0;
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      rows += static_cast<Index>(2 * patches_[k].patch->size());
      const Eigen::Matrix3d C = fit.covariance.block<3, 3>(turnAt(k), turnAt(k));
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(C, Eigen::EigenvaluesOnly);
      known += (solver.eigenvalues().array() < kOpenVariance_rad2).count();
    }
    fit.log_evidence = -cost_ / 2 - Eigen::MatrixXd(factor_.matrixL()).diagonal().array().log().sum() +
                       static_cast<double>(joints_.size()) * std::log(zeroInformation()) / 2 +
                       std::log(tiltInformation());
    for (const PatchOnKnownLink& patch : patches_) fit.log_evidence -= patch.patch->logSpread();
    fit.misfit = {cost_, static_cast<int>(std::max<Index>(0, rows - known))};
    describePoses(fit);
    return fit;
  }

  void describePoses(RobotFit& fit) const {
    const LinkGravity gravity = gravityOf(state_);
    const auto places = static_cast<Index>(angles_.size());
    const auto joints = static_cast<Index>(joints_.size());
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(places, joints);
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(places, joints);
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      const SeenByPatch& seen = *patches_[k].patch;
      const Eigen::MatrixXd W = seen.information();
      const Eigen::VectorXd weighed = W * residuals(k, state_, gravity);
      const Eigen::MatrixXd by_zeros = derivatives(k, state_, gravity).middleCols(zeroAt(), joints);
      for (std::size_t p = 0; p < seen.size(); ++p) {
        const auto at = static_cast<Index>(2 * p);
        const auto place = static_cast<Index>(seen.placeOf(p));
        for (Index j = 0; j < joints; ++j) {
          const Eigen::Vector2d by_turn = by_zeros.block<2, 1>(at, j);
          pull(place, j) += by_turn.dot(weighed.segment<2>(at));
          information(place, j) += by_turn.dot(W.block<2, 2>(at, at) * by_turn);
        }
      }
    }
    // Where a joint turns less than this of what is seen, its axis lies along gravity.
    constexpr double kMinInformation = 1;
    for (Index place = 0; place < places; ++place) {
      for (Index j = 0; j < joints; ++j) {
        if (information(place, j) < kMinInformation) continue;
        fit.pose_turns.push_back({static_cast<std::size_t>(place), joints_[static_cast<std::size_t>(j)],
                                  -pull(place, j) / information(place, j), 1 / std::sqrt(information(place, j))});
      }
    }
  }

  std::span<const PatchOnKnownLink> patches_;
  const RobotModel& robot_;
  std::span<const JointAngles> angles_;
  Eigen::Vector3d up_0_;
  Eigen::Matrix<double, 3, 2> tilt_basis_;
  RobotPriors priors_;
  std::vector<std::size_t> joints_;
  State state_;
  double zero_scale_ = 1;
  double tilt_scale_ = 1;
  double cost_ = 0;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd gradient_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace

RobotFit fitRobot(std::span<const PatchOnKnownLink> patches, const RobotModel& robot,
                  std::span<const JointAngles> angles, const Eigen::Vector3d& up_w, const RobotPriors& priors) {
  return RobotProblem(patches, robot, angles, up_w, priors).solve();
}

}  // namespace hexoderm
