// How cells are compared with each other, and what explains that one disagrees.

#include "hexoderm/solve/checks/cell_change.h"
#include "hexoderm/base/units.h"
#include "tests/support/matchers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

constexpr double kNeverOut = 1e9;
constexpr double kLimit = 4.5;

Eigen::MatrixXd someCovariance(Eigen::Index size, double sigma_g, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
  return sigma_g * sigma_g * (Eigen::MatrixXd::Identity(size, size) + root * root.transpose() / size);
}

/// Cells on a line that see the same two poses, each with errors of its own.
std::vector<CellView> views(std::size_t count, double sigma_g, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<CellView> result;
  for (std::size_t k = 0; k < count; ++k) {
    CellView view;
    view.cell = CellId(static_cast<std::uint32_t>(k + 1));
    view.poses = {0, 1};
    view.at_o = {0.03 * static_cast<double>(k), 0.01, 0};
    view.drift_o.setIdentity();
    view.covariance_g2 = someCovariance(6, sigma_g, random);
    const Eigen::MatrixXd root = view.covariance_g2.llt().matrixL();
    view.force_o_g = (Eigen::VectorXd(6) << 0, 0, 1, 1, 0, 0).finished() +
                     root * Eigen::VectorXd::NullaryExpr(6, [&] { return normal(random); });
    result.push_back(std::move(view));
  }
  return result;
}

/// A cell that sees two poses, and what the others foretell.
ViewComparison comparisonOf(const Eigen::Matrix3d& turn, const Eigen::Vector3d& offset_g, double sigma_g) {
  ViewComparison comparison;
  comparison.foretold_o_g = (Eigen::VectorXd(6) << 0, 0, 1, 1, 0, 0).finished();
  comparison.residual_g.resize(6);
  for (Eigen::Index k = 0; k < 6; k += 3) {
    const Eigen::Vector3d foretold = comparison.foretold_o_g.segment<3>(k);
    comparison.residual_g.segment<3>(k) = turn.transpose() * foretold + offset_g - foretold;
  }
  comparison.covariance_g2 = sigma_g * sigma_g * Eigen::MatrixXd::Identity(6, 6);
  return comparison;
}

CellView viewOfTwoPoses() {
  CellView view;
  view.poses = {0, 1};
  view.drift_o.setIdentity();
  return view;
}

TEST(ConsensusOfCells, ComparesACellWithWhatTheOthersAloneForetell) {
  std::mt19937 random(3);
  std::vector<CellView> cells = views(6, 0.01, random);
  const ViewComparison within = Consensus(cells, 2, kNeverOut).compare(2);
  constexpr double kNoWeight = 1e8;
  const Eigen::MatrixXd own = cells[2].covariance_g2;
  cells[2].covariance_g2 *= kNoWeight;
  const ViewComparison without = Consensus(cells, 2, kNeverOut).compare(2);
  EXPECT_LT((within.foretold_o_g - without.foretold_o_g).norm(), 1e-6);
  EXPECT_LT((within.residual_g - without.residual_g).norm(), 1e-6);
  EXPECT_LT((within.covariance_g2 - own - (without.covariance_g2 - kNoWeight * own)).norm(), 1e-6);
}

TEST(ConsensusOfCells, MisfitsAreChiSquaredWithThreeDegreesAPose) {
  std::mt19937 random(7);
  constexpr std::size_t kTrials = 300;
  constexpr std::size_t kCells = 5;
  double sum = 0;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    const std::vector<CellView> cells = views(kCells, 0.01, random);
    const Consensus consensus(cells, 2, kNeverOut);
    for (std::size_t k = 0; k < kCells; ++k) {
      sum += consensus.varianceFactor() * consensus.compare(k).misfit.chi_squared;
    }
  }
  // Six degrees, less what the prior of a swing grants beside none at all. Its mean errs by sqrt(12 / 1500).
  EXPECT_NEAR(sum / (kTrials * kCells), 6, 0.6);
}

TEST(ConsensusOfCells, VariancesGrowWithWhatTheConsensusShowsAndNeverShrink) {
  std::mt19937 random(13);
  std::vector<CellView> cells = views(60, 0.01, random);
  const Consensus as_stated(cells, 2, kLimit);
  EXPECT_GE(as_stated.varianceFactor(), 1);
  EXPECT_LT(as_stated.varianceFactor(), 1.3);
  for (CellView& cell : cells) cell.covariance_g2 /= 2;
  const Consensus understated(cells, 2, kLimit);
  EXPECT_NEAR(understated.varianceFactor(), 2, 0.5);
  double chi_squared = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) chi_squared += understated.compare(k).misfit.chi_squared;
  EXPECT_NEAR(chi_squared / 60, 6, 0.3);
  for (CellView& cell : cells) cell.covariance_g2 *= 8;
  EXPECT_EQ(Consensus(cells, 2, kLimit).varianceFactor(), 1);
}

TEST(CellChange, ATurnIsFoundExactlyHoweverLargeAndTheDriftRuledOut) {
  for (const double angle_deg : {0.5, 10.0, 90.0, 170.0}) {
    const Eigen::Vector3d turn = angle_deg * kDegree * Eigen::Vector3d(1, -2, 3).normalized();
    const ViewComparison comparison = comparisonOf(expSO3(turn), Eigen::Vector3d::Zero(), 1e-4);
    const TurnFit fit = fitTurn(comparison);
    EXPECT_THAT(expSO3(fit.turn_o), RotationNear(expSO3(turn), 1e-4)) << angle_deg;
    EXPECT_LT(fit.left.chi_squared, 1e-2);
    EXPECT_GT(fitDrift(viewOfTwoPoses(), comparison).left.chi_squared, 100);
  }
}

TEST(CellChange, ADriftIsFoundExactlyAndTheTurnRuledOutUnlessItIsAcrossBothDirections) {
  const Eigen::Vector3d drift(0.03, 0.02, -0.05);
  const ViewComparison comparison = comparisonOf(Eigen::Matrix3d::Identity(), drift, 1e-4);
  EXPECT_THAT(fitDrift(viewOfTwoPoses(), comparison).offset_g, VectorNear(drift, 1e-6));
  EXPECT_GT(fitTurn(comparison).left.chi_squared, 100);
  // Gravity was along z and x. A drift along y is what a turn by 60 mg / 1 g about (-1, 0, 1) does, to first order.
  const ViewComparison across = comparisonOf(Eigen::Matrix3d::Identity(), {0, 0.06, 0}, 0.01);
  const TurnFit fit = fitTurn(across);
  EXPECT_LT(fit.left.chi_squared, 0.2);
  EXPECT_NEAR(fit.turn_o.norm(), 0.06 * std::sqrt(2.0), 0.002);
  EXPECT_THAT(fit.turn_o.normalized().cwiseAbs(), VectorNear(Eigen::Vector3d(std::sqrt(0.5), 0, std::sqrt(0.5)), 0.05));
}

TEST(CellChange, WhatIsSaidToBeNoticedIsNoticedNineteenTimesInTwenty) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  constexpr double kSigma_g = 0.01;
  ViewComparison comparison = comparisonOf(Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), kSigma_g);
  const double noticed_rad = *noticedTurn(comparison, kLimit).any_axis_rad;
  // The axis that these two poses show least: a turn about x + z moves each reading by no more than sqrt(1/2).
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 0, 1).normalized();
  std::size_t found = 0;
  constexpr std::size_t kTrials = 2000;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    comparison = comparisonOf(expSO3(noticed_rad * axis), Eigen::Vector3d::Zero(), kSigma_g);
    for (double& x : comparison.residual_g) x += kSigma_g * normal(random);
    comparison.misfit = {comparison.residual_g.squaredNorm() / (kSigma_g * kSigma_g), 6};
    if (comparison.misfit.deviate() > kLimit) ++found;
  }
  EXPECT_NEAR(static_cast<double>(found) / kTrials, 0.95, 0.02);
}

}  // namespace
}  // namespace hexoderm
