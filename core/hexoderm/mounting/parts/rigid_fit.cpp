#include "hexoderm/mounting/parts/rigid_fit.h"

#include "hexoderm/base/procrustes.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <map>

namespace hexoderm {
namespace {

using Eigen::Index;

constexpr int kMaxRigidSteps = 30;
constexpr double kRigidSettled_rad = 1e-10;

class RigidProblem {
 public:
  explicit RigidProblem(std::span<const GravitySeen> bodies) : bodies_(bodies) {
    for (const GravitySeen& body : bodies_) {
      std::vector<std::size_t>& latents = latent_of_.emplace_back();
      for (const PoseId pose : body.poses) {
        latents.push_back(latents_.emplace(pose, latents_.size()).first->second);
        if (latents.back() == poses_.size()) poses_.push_back(pose);
      }
      observations_ += static_cast<Index>(2 * body.size());
      const Eigen::LLT<Eigen::MatrixXd> factor(body.covariance);
      information_.push_back(factor.solve(Eigen::MatrixXd::Identity(body.covariance.rows(), body.covariance.cols())));
      log_spread_ += factor.matrixLLT().diagonal().array().log().sum();
    }
    start();
  }

  RigidFit solve() {
    Eigen::LLT<Eigen::MatrixXd> factor;
    for (int step = 0; step < kMaxRigidSteps; ++step) {
      linearize();
      factor.compute(matrix_);
      const Eigen::VectorXd move = -factor.solve(gradient_);
      apply(move);
      if (move.cwiseAbs().maxCoeff() < kRigidSettled_rad) break;
    }
    linearize();
    factor.compute(matrix_);
    RigidFit fit = describe(factor.solve(Eigen::MatrixXd::Identity(matrix_.rows(), matrix_.cols())));
    fit.log_evidence = -chi_squared_ / 2 - log_spread_ - factor.matrixLLT().diagonal().array().log().sum();
    return fit;
  }

 private:
  [[nodiscard]] Index latentAt(std::size_t latent) const { return static_cast<Index>(2 * latent); }
  /// Of a body but the first.
  [[nodiscard]] Index turnAt(std::size_t body) const { return static_cast<Index>(2 * poses_.size() + 3 * (body - 1)); }
  [[nodiscard]] Index unknowns() const { return static_cast<Index>(2 * poses_.size() + 3 * (bodies_.size() - 1)); }

  /// Body by body, each turned onto what those before it saw.
  void start() {
    g_.assign(poses_.size(), Eigen::Vector3d::Zero());
    std::vector<bool> known(poses_.size(), false);
    R_.assign(bodies_.size(), Eigen::Matrix3d::Identity());
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      Eigen::Matrix3Xd own(3, 0);
      Eigen::Matrix3Xd others(3, 0);
      for (std::size_t k = 0; k < bodies_[body].size(); ++k) {
        if (!known[latent_of_[body][k]]) continue;
        own.conservativeResize(3, own.cols() + 1);
        others.conservativeResize(3, own.cols());
        own.rightCols<1>() = bodies_[body].up[k];
        others.rightCols<1>() = g_[latent_of_[body][k]];
      }
      if (body > 0) R_[body] = solveProcrustes(own, others).R_c_n;
      for (std::size_t k = 0; k < bodies_[body].size(); ++k) {
        const std::size_t latent = latent_of_[body][k];
        if (known[latent]) continue;
        known[latent] = true;
        g_[latent] = R_[body] * bodies_[body].up[k];
      }
    }
  }

  /// Residuals of a body, across what it saw, e = across^T R^T g, and their derivatives by its directions and its turn.
  struct Rows {
    Eigen::VectorXd e;
    std::vector<Eigen::Matrix2d> by_latent;
    Eigen::MatrixXd by_turn;
  };
  [[nodiscard]] Rows rowsOf(std::size_t body) const {
    const GravitySeen& seen = bodies_[body];
    Rows rows{Eigen::VectorXd(latentAt(seen.size())), {}, Eigen::MatrixXd(latentAt(seen.size()), 3)};
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const Eigen::Vector3d& g = g_[latent_of_[body][k]];
      const Eigen::Matrix<double, 2, 3> across = acrossBasis(seen.up[k]).transpose();
      const Eigen::Vector3d foretold = R_[body].transpose() * g;
      rows.e.segment<2>(latentAt(k)) = across * foretold;
      rows.by_latent.emplace_back(across * R_[body].transpose() * acrossBasis(g));
      rows.by_turn.middleRows<2>(latentAt(k)) = across * skew(foretold);
    }
    return rows;
  }

  void linearize() {
    matrix_.setZero(unknowns(), unknowns());
    gradient_.setZero(unknowns());
    chi_squared_ = 0;
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      const Rows rows = rowsOf(body);
      const Eigen::MatrixXd& W = information_[body];
      const Eigen::VectorXd We = W * rows.e;
      chi_squared_ += rows.e.dot(We);
      const Eigen::MatrixXd W_turn = W * rows.by_turn;
      for (std::size_t a = 0; a < rows.by_latent.size(); ++a) {
        const Index at_a = latentAt(latent_of_[body][a]);
        gradient_.segment<2>(at_a) += rows.by_latent[a].transpose() * We.segment<2>(latentAt(a));
        for (std::size_t b = 0; b < rows.by_latent.size(); ++b) {
          matrix_.block<2, 2>(at_a, latentAt(latent_of_[body][b])) +=
              rows.by_latent[a].transpose() * W.block<2, 2>(latentAt(a), latentAt(b)) * rows.by_latent[b];
        }
        if (body == 0) continue;
        const Eigen::Matrix<double, 2, 3> mixed = rows.by_latent[a].transpose() * W_turn.middleRows<2>(latentAt(a));
        matrix_.block<2, 3>(at_a, turnAt(body)) += mixed;
        matrix_.block<3, 2>(turnAt(body), at_a) += mixed.transpose();
      }
      if (body == 0) continue;
      gradient_.segment<3>(turnAt(body)) += rows.by_turn.transpose() * We;
      matrix_.block<3, 3>(turnAt(body), turnAt(body)) +=
          rows.by_turn.transpose() * W_turn + kOpenTurnInformation * Eigen::Matrix3d::Identity();
    }
  }

  void apply(const Eigen::VectorXd& move) {
    for (std::size_t k = 0; k < g_.size(); ++k) {
      g_[k] = (g_[k] + acrossBasis(g_[k]) * move.segment<2>(latentAt(k))).normalized();
    }
    for (std::size_t body = 1; body < bodies_.size(); ++body) R_[body] *= expSO3(move.segment<3>(turnAt(body)));
  }

  [[nodiscard]] RigidFit describe(const Eigen::MatrixXd& covariance) const {
    RigidFit fit;
    fit.R = R_;
    const auto turns = static_cast<Index>(3 * bodies_.size());
    fit.covariance.setZero(turns, turns);
    fit.covariance.bottomRightCorner(turns - 3, turns - 3) = covariance.bottomRightCorner(turns - 3, turns - 3);
    Index used_up = static_cast<Index>(2 * poses_.size());
    for (std::size_t body = 1; body < bodies_.size(); ++body) {
      const auto at = static_cast<Index>(3 * body);
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(fit.covariance.block<3, 3>(at, at),
                                                                  Eigen::EigenvaluesOnly);
      used_up += (solver.eigenvalues().array() < kOpenVariance_rad2).count();
    }
    fit.misfit = {chi_squared_, static_cast<int>(std::max<Index>(0, observations_ - used_up))};
    fit.gravity.poses = poses_;
    fit.gravity.up = g_;
    fit.gravity.covariance = covariance.topLeftCorner(latentAt(poses_.size()), latentAt(poses_.size()));
    return fit;
  }

  std::span<const GravitySeen> bodies_;
  std::map<PoseId, std::size_t> latents_;
  std::vector<std::vector<std::size_t>> latent_of_;
  std::vector<PoseId> poses_;
  std::vector<Eigen::MatrixXd> information_;
  Index observations_ = 0;
  double log_spread_ = 0;  // of the covariances: half the logarithms of their determinants
  std::vector<Eigen::Vector3d> g_;
  std::vector<Eigen::Matrix3d> R_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd gradient_;
  double chi_squared_ = 0;
};

constexpr int kAxesAround = 120;

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

double GravityMisfit::probability() const {
  if (freedom <= 0) return 1;
  return boost::math::cdf(
      boost::math::complement(boost::math::chi_squared(static_cast<double>(freedom)), std::max(0.0, chi_squared)));
}

RigidFit fitRigid(std::span<const GravitySeen> bodies) { return RigidProblem(bodies).solve(); }

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
