#include "hexoderm/solve/checks/consensus.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace hexoderm {
namespace {

/// 1 sigma of the specific force in a pose. Nothing beside a reading, and the algebra is sound in poses of one or none.
constexpr double kAnyForce_g = 10;

Eigen::Index index3(std::size_t k) { return 3 * static_cast<Eigen::Index>(k); }
Eigen::Index index6(std::size_t k) { return 6 * static_cast<Eigen::Index>(k); }

}  // namespace

Consensus::Consensus(std::span<const CellView> views, std::size_t poses, double limit)
    : views_(views), limit_(limit), holds_(views.size(), true) {
  const Eigen::Index unknowns = index6(poses);
  information_ = Eigen::MatrixXd::Zero(unknowns, unknowns);
  weighted_ = Eigen::VectorXd::Zero(unknowns);
  for (std::size_t pose = 0; pose < poses; ++pose) {
    information_.diagonal().segment<3>(index6(pose)).setConstant(1 / (kAnyForce_g * kAnyForce_g));
    information_.diagonal()
        .segment<3>(index6(pose) + 3)
        .setConstant(1 / (kAngularAccelerationSigma * kAngularAccelerationSigma));
  }
  for (const CellView& view : views) count(view, 1);
  solve();
  exclude();
  readmit();
  findVarianceFactor();
}

std::size_t Consensus::size() const { return static_cast<std::size_t>(std::ranges::count(holds_, true)); }

void Consensus::count(const CellView& view, double sign) {
  const PartMotionJacobian X = motionJacobian(view.at_o);
  const Eigen::LLT<Eigen::MatrixXd> factor(view.covariance_g2);
  const Eigen::MatrixXd precision =
      factor.solve(Eigen::MatrixXd::Identity(view.covariance_g2.rows(), view.covariance_g2.cols()));
  const Eigen::VectorXd pulls = factor.solve(view.force_o_g);
  for (std::size_t a = 0; a < view.poses.size(); ++a) {
    weighted_.segment<6>(index6(view.poses[a])) += sign * X.transpose() * pulls.segment<3>(index3(a));
    for (std::size_t b = 0; b < view.poses.size(); ++b) {
      information_.block<6, 6>(index6(view.poses[a]), index6(view.poses[b])) +=
          sign * X.transpose() * precision.block<3, 3>(index3(a), index3(b)) * X;
    }
  }
}

void Consensus::solve() {
  const Eigen::LLT<Eigen::MatrixXd> factor(information_);
  covariance_ = factor.solve(Eigen::MatrixXd::Identity(information_.rows(), information_.cols()));
  motion_ = factor.solve(weighted_);
}

ViewComparison Consensus::compare(std::size_t view_index) const {
  const CellView& view = views_[view_index];
  const PartMotionJacobian X = motionJacobian(view.at_o);
  ViewComparison comparison;
  comparison.foretold_o_g.resize(view.force_o_g.size());
  Eigen::MatrixXd carried(view.force_o_g.size(),
                          view.force_o_g.size());  // the motions' covariance, as the cell sees it
  for (std::size_t a = 0; a < view.poses.size(); ++a) {
    comparison.foretold_o_g.segment<3>(index3(a)) = X * motion_.segment<6>(index6(view.poses[a]));
    for (std::size_t b = 0; b < view.poses.size(); ++b) {
      carried.block<3, 3>(index3(a), index3(b)) =
          X * covariance_.block<6, 6>(index6(view.poses[a]), index6(view.poses[b])) * X.transpose();
    }
  }
  comparison.residual_g = view.force_o_g - comparison.foretold_o_g;
  comparison.covariance_g2 = view.covariance_g2 + carried;
  if (holds_[view_index]) {
    // Without the cell's own part in the motions: Z W^-1 r, with covariance Z W^-1 Z, where Z is the cell's covariance,
    // r the residual against the motions of all, and W = Z - carried the covariance of r.
    const Eigen::MatrixXd own = view.covariance_g2 - carried;
    const Eigen::LDLT<Eigen::MatrixXd> factor(own);
    comparison.residual_g = view.covariance_g2 * factor.solve(comparison.residual_g);
    comparison.foretold_o_g = view.force_o_g - comparison.residual_g;
    const Eigen::MatrixXd spread = view.covariance_g2 * factor.solve(view.covariance_g2);
    comparison.covariance_g2 = (spread + spread.transpose()) / 2;
  }
  comparison.covariance_g2 *= variance_factor_;
  const double chi_squared = comparison.residual_g.dot(comparison.covariance_g2.llt().solve(comparison.residual_g));
  comparison.misfit = {chi_squared, static_cast<double>(comparison.residual_g.size())};
  return comparison;
}

void Consensus::exclude() {
  constexpr double kAsBad = 0.7;  // share of the worst deviate: far from it, others are bad because of the worst
  while (size() > 1) {
    std::vector<double> deviates(views_.size(), 0);
    for (std::size_t k = 0; k < views_.size(); ++k) {
      if (holds_[k]) deviates[k] = compare(k).misfit.deviate();
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
    if (!holds_[k] && compare(k).misfit.deviate() <= limit_) back.push_back(k);
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

}  // namespace hexoderm
