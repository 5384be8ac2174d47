// How cells are compared with each other, and what is said to be noticed of that.

#include "hexoderm/solve/checks/cell_change.h"
#include "hexoderm/base/units.h"
#include "tests/support/matchers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

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

constexpr SharedDrift kDrift{0.005, 0.0025};

/// The cells of views(), each turned otherwise, whose offsets all drifted by as much.
std::vector<CellView> driftedViews(std::size_t count, const Eigen::Vector3d& drift_g, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<CellView> cells = views(count, 0.002, random);
  for (CellView& cell : cells) {
    cell.drift_o = expSO3({normal(random), normal(random), normal(random)});
    cell.force_o_g += (cell.drift_o * drift_g).replicate(2, 1);
  }
  return cells;
}

TEST(ConsensusOfCells, ComparesACellWithTheOthersWhetherItIsAmongThemOrNot) {
  std::mt19937 random(3);
  std::vector<CellView> cells = driftedViews(12, {0.01, 0, -0.01}, random);
  const Consensus with_it(cells, 2, kLimit, kDrift);
  ASSERT_EQ(with_it.size(), 12U);
  const ViewComparison one = with_it.compare(2);
  const Eigen::VectorXd shift = Eigen::VectorXd::Constant(6, 0.1);
  cells[2].force_o_g += shift;
  const Consensus without_it(cells, 2, kLimit, kDrift);
  ASSERT_FALSE(without_it.holds(2));
  ASSERT_EQ(without_it.size(), 11U);
  const ViewComparison other = without_it.compare(2);
  EXPECT_LT((one.residual_g + shift - other.residual_g).norm(), 1e-9);
  const Eigen::MatrixXd covariance_g2 = other.covariance_g2 / without_it.varianceFactor();
  EXPECT_LT((one.covariance_g2 / with_it.varianceFactor() - covariance_g2).norm(), 1e-6 * covariance_g2.norm());
}

TEST(ConsensusOfCells, ADriftThatAllShareIsFoundAndChangesNoCell) {
  std::mt19937 random(7);
  const Eigen::Vector3d drift_g(0.012, -0.004, 0.009);
  const std::vector<CellView> cells = driftedViews(40, drift_g, random);
  const Consensus consensus(cells, 2, kLimit, kDrift);
  EXPECT_EQ(consensus.size(), 40U);
  EXPECT_LT(consensus.varianceFactor(), 1.2);
  const auto found = consensus.commonDrift();
  ASSERT_TRUE(found);
  EXPECT_LT(found->sigma_g, 0.001);
  EXPECT_LT((found->offset_g - drift_g).norm(), 4 * found->sigma_g);
  const Consensus surprised(cells, 2, kLimit);
  EXPECT_GT(surprised.varianceFactor(), 2) << "what is not in the model goes to the variances";
  EXPECT_FALSE(Consensus(driftedViews(40, {0, 0, 0}, random), 2, kLimit, kDrift).commonDrift());
}

TEST(ConsensusOfCells, ADriftOfParallelSensorsIsTakenForAnotherForceAndDoesNoHarm) {
  std::mt19937 random(11);
  std::vector<CellView> cells = views(20, 0.002, random);
  for (CellView& cell : cells) cell.force_o_g += Eigen::Vector3d(0.05, 0, 0.05).replicate(2, 1);
  const Consensus consensus(cells, 2, kLimit, kDrift);
  EXPECT_EQ(consensus.size(), 20U);
  EXPECT_FALSE(consensus.commonDrift());
}

TEST(CellChange, WhereNoForceIsForetoldNoTurnIsSeen) {
  const ViewComparison nothing{Eigen::VectorXd::Constant(3, 1e-7), Eigen::Vector3d(0.01, 0, -0.02),
                               1e-4 * Eigen::Matrix3d::Identity(), Misfit{5, 3}};
  EXPECT_EQ(nothing.deviate(), nothing.misfit.deviate());
}

TEST(CellChange, WhatIsSaidToBeNoticedIsNoticedNineteenTimesInTwenty) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  constexpr double kSigma_g = 0.01;
  ViewComparison comparison;  // of a cell that sees two poses
  comparison.foretold_o_g = (Eigen::VectorXd(6) << 0, 0, 1, 1, 0, 0).finished();
  comparison.residual_g = Eigen::VectorXd::Zero(6);
  comparison.covariance_g2 = kSigma_g * kSigma_g * Eigen::MatrixXd::Identity(6, 6);
  const double noticed_rad = *noticedTurn(comparison, kLimit).any_axis_rad;
  // The axis that these two poses show least: a turn about x + z moves each reading by no more than sqrt(1/2).
  const Eigen::Matrix3d turn = expSO3(noticed_rad * Eigen::Vector3d(1, 0, 1).normalized());
  const Eigen::Matrix3Xd foretold = comparison.foretold_o_g.reshaped(3, 2);
  std::size_t found = 0;
  constexpr std::size_t kTrials = 2000;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    comparison.residual_g = (turn.transpose() * foretold - foretold).reshaped();
    for (double& x : comparison.residual_g) x += kSigma_g * normal(random);
    comparison.misfit = {comparison.residual_g.squaredNorm() / (kSigma_g * kSigma_g), 6};
    if (comparison.deviate() > kLimit) ++found;
  }
  EXPECT_NEAR(static_cast<double>(found) / kTrials, 0.95, 0.02);
}

}  // namespace
}  // namespace hexoderm
