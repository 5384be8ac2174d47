#include "hexoderm/solve/sparse/block_cholesky.h"
#include "tests/core/solve/sparse/block_systems.h"
#include "tests/support/testing.h"

#include <Eigen/Cholesky>
#include <numeric>

namespace hexoderm {
namespace {

/// Without vector instructions, and as fast as this computer can.
std::array<const FrontKernels*, 2> bothKernels() { return {&portableFrontKernels(), &frontKernels()}; }

class BlockCholeskyGraphs : public ::testing::TestWithParam<Graph> {
 protected:
  BlockCholeskyGraphs() {
    // Only the lower triangles are read.
    for (Matrix6d& block : diagonal_) {
      block.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }

  System system_{shuffled(GetParam(), 11), 23};
  std::vector<Matrix6d> diagonal_ = system_.diagonal;
};

TEST_P(BlockCholeskyGraphs, SolvesAsTheDenseFactorDoes) {
  const Eigen::LLT<Eigen::MatrixXd> dense(system_.dense());
  for (const FrontKernels* kernels : bothKernels()) {
    BlockCholesky cholesky(system_.graph.size, system_.graph.couples, *kernels);
    ASSERT_TRUE(cholesky.factorize(diagonal_, system_.couples));
    for (const Eigen::Index count : {0, 1, 2, 13, 100}) {
      const Eigen::MatrixXd B = someColumns(system_, count);
      Eigen::MatrixXd X = B;
      cholesky.solve(X);
      const Eigen::MatrixXd expected = X.size() > 0 ? Eigen::MatrixXd(dense.solve(B)) : B;
      EXPECT_THAT(X, MatrixNear(expected, 1e-9)) << count << " columns";
    }
  }
}

TEST_P(BlockCholeskyGraphs, InvertsOnThePattern) {
  const Eigen::MatrixXd A = system_.dense();
  const Eigen::MatrixXd Z = A.llt().solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()));
  for (const FrontKernels* kernels : bothKernels()) {
    BlockCholesky cholesky(system_.graph.size, system_.graph.couples, *kernels);
    ASSERT_TRUE(cholesky.factorize(diagonal_, system_.couples));
    const BlockCholesky::SelectedInverse inverse = cholesky.selectedInverse();
    EXPECT_TRUE(cholesky.factorized());
    EXPECT_EQ(std::move(cholesky).inverseDiagonal(), inverse.diagonal);
    EXPECT_FALSE(cholesky.factorized());
    EXPECT_TRUE(cholesky.factorize(diagonal_, system_.couples));
    ASSERT_EQ(inverse.diagonal.size(), system_.graph.size);
    for (std::size_t k = 0; k < system_.graph.size; ++k) {
      EXPECT_THAT(inverse.diagonal[k], MatrixNear(Matrix6d(Z.block<6, 6>(6 * k, 6 * k)), 1e-9));
      EXPECT_EQ(inverse.diagonal[k], Matrix6d(inverse.diagonal[k].transpose()));
    }
    ASSERT_EQ(inverse.couples.size(), system_.couples.size());
    for (std::size_t k = 0; k < system_.couples.size(); ++k) {
      const BlockCouple& c = system_.graph.couples[k];
      EXPECT_THAT(inverse.couples[k], MatrixNear(Matrix6d(Z.block<6, 6>(6 * c.row, 6 * c.column)), 1e-8));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BlockCholesky, BlockCholeskyGraphs,
                         ::testing::Values(Graph{"None", 0, {}}, Graph{"Single", 1, {}}, Graph{"Apart", 9, {}},
                                           chain(2), chain(40), ring(3), ring(41), lattice(9, 8), lattice(30, 2),
                                           lattice(12, 9, true), parts(), randomGraph(30, 25, 1),
                                           randomGraph(30, 60, 2), randomGraph(12, 66, 3),
                                           // One supernode too large for a subtree, and one with a ring about it.
                                           randomGraph(60, 60 * 59 / 2, 6), cliqueInARing(75, 200)),
                         [](const ::testing::TestParamInfo<Graph>& tested) {
                           return tested.param.name + "Of" + std::to_string(tested.param.size);
                         });

TEST_P(BlockCholeskyGraphs, OneVectorIsSolvedAsAColumnIs) {
  for (const FrontKernels* kernels : bothKernels()) {
    BlockCholesky cholesky(system_.graph.size, system_.graph.couples, *kernels);
    ASSERT_TRUE(cholesky.factorize(diagonal_, system_.couples));
    const Eigen::MatrixXd B = someColumns(system_, 2);
    const Eigen::VectorXd b = B.col(0);
    RightHandSides columns = cholesky.ordered(B);
    Eigen::VectorXd vector = cholesky.orderedVector(b);
    EXPECT_EQ(vector, Eigen::VectorXd(columns.matrix().col(0)));
    cholesky.solveLower(columns);
    cholesky.solveLower(vector);
    EXPECT_THAT(vector, MatrixNear(Eigen::VectorXd(columns.matrix().col(0)), 1e-12));
    cholesky.solveUpper(columns);
    cholesky.solveUpper(vector);
    EXPECT_THAT(vector, MatrixNear(Eigen::VectorXd(columns.matrix().col(0)), 1e-12));
    Eigen::MatrixXd solved = B;
    cholesky.solve(solved);
    EXPECT_THAT(cholesky.vectorInOwnOrder(vector), MatrixNear(Eigen::VectorXd(solved.col(0)), 1e-12));
  }
}

TEST(BlockCholesky, HalvesOfASolutionGiveProductsWithTheInverse) {
  const System system(lattice(5, 4), 1);
  BlockCholesky cholesky(system.graph.size, system.graph.couples);
  ASSERT_TRUE(cholesky.factorize(system.diagonal, system.couples));
  const Eigen::MatrixXd B = someColumns(system, 5);
  const Eigen::MatrixXd solution = system.dense().llt().solve(B);
  RightHandSides half = cholesky.ordered(B);
  cholesky.solveLower(half);
  const Eigen::MatrixXd product = half.matrix().transpose() * half.matrix();
  EXPECT_THAT(product, MatrixNear(Eigen::MatrixXd(B.transpose() * solution), 1e-9));
  for (const FrontKernels* kernels : bothKernels()) {
    const Eigen::MatrixXd gram = half.gram(*kernels);
    EXPECT_THAT(Eigen::MatrixXd(gram.triangularView<Eigen::Lower>()),
                MatrixNear(Eigen::MatrixXd(product.triangularView<Eigen::Lower>()), 1e-13));
  }
  cholesky.solveUpper(half);
  EXPECT_THAT(Eigen::MatrixXd(cholesky.inOwnOrder(half).matrix()), MatrixNear(solution, 1e-9));
}

TEST(BlockCholesky, RefusesWhatIsNotPositiveDefiniteAndRecovers) {
  const System good(lattice(6, 6), 4);
  BlockCholesky cholesky(good.graph.size, good.graph.couples);
  EXPECT_FALSE(cholesky.factorized());
  for (const std::size_t cell : {0, 14, 35}) {
    System bad = good;
    bad.diagonal[cell](5, 5) = -1e-3;
    EXPECT_FALSE(cholesky.factorize(bad.diagonal, bad.couples));
    EXPECT_FALSE(cholesky.factorized());
    bad.diagonal[cell].setZero();
    EXPECT_FALSE(cholesky.factorize(bad.diagonal, bad.couples));
  }
  // Every diagonal block is positive definite, the whole is not.
  System bad = good;
  bad.couples[20] *= 100;
  EXPECT_FALSE(cholesky.factorize(bad.diagonal, bad.couples));
  EXPECT_TRUE(cholesky.factorize(good.diagonal, good.couples));
  EXPECT_TRUE(cholesky.factorized());
}

TEST(BlockCholesky, RefusesWhatIsNotFinite) {
  const System good(lattice(6, 6), 6);
  BlockCholesky cholesky(good.graph.size, good.graph.couples);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    for (std::size_t k = 0; k < good.diagonal.size(); ++k) {
      System bad = good;
      bad.diagonal[k](3, 3) = value;
      EXPECT_FALSE(cholesky.factorize(bad.diagonal, bad.couples)) << value << " in cell " << k;
      bad = good;
      bad.diagonal[k](4, 1) = value;
      EXPECT_FALSE(cholesky.factorize(bad.diagonal, bad.couples)) << value << " in cell " << k;
    }
    for (std::size_t k = 0; k < good.couples.size(); ++k) {
      System bad = good;
      bad.couples[k](0, 5) = value;
      EXPECT_FALSE(cholesky.factorize(bad.diagonal, bad.couples)) << value << " in couple " << k;
    }
  }
}

TEST(BlockCholesky, StaysSparseAndAccurateOnASheet) {
  const System system(shuffled(lattice(60, 50), 7), 8);
  BlockCholesky cholesky(system.graph.size, system.graph.couples);
  ASSERT_TRUE(cholesky.factorize(system.diagonal, system.couples));
  EXPECT_LT(cholesky.factorEntries(), 36 * 20 * system.graph.size);
  const Eigen::MatrixXd B = someColumns(system, 13);
  Eigen::MatrixXd X = B;
  cholesky.solve(X);
  EXPECT_THAT(system.times(X), MatrixNear(B, 1e-11));

  const BlockCholesky::SelectedInverse inverse = cholesky.selectedInverse();
  for (std::size_t k = 0; k < system.couples.size(); k += 997) {
    const BlockCouple& c = system.graph.couples[k];
    Eigen::MatrixXd Z = Eigen::MatrixXd::Zero(B.rows(), 6);
    Z.middleRows<6>(6 * c.column).setIdentity();
    cholesky.solve(Z);
    EXPECT_THAT(inverse.diagonal[c.column], MatrixNear(Matrix6d(Z.middleRows<6>(6 * c.column)), 1e-9));
    EXPECT_THAT(inverse.couples[k], MatrixNear(Matrix6d(Z.middleRows<6>(6 * c.row)), 1e-9));
  }
}

TEST(BlockCholesky, DissectsWideSheetsWithLessWorkThanMinimumDegree) {
  // With minimum degree alone the factor has 8.5 million entries.
  const Graph graph = shuffled(lattice(100, 100), 9);
  EXPECT_LT(BlockCholesky(graph.size, graph.couples).factorEntries(), 8'200'000U);
}

TEST(BlockCholesky, LongChainsTakeLinearMemory) {
  const System system(shuffled(chain(20'000), 10), 12);
  BlockCholesky cholesky(system.graph.size, system.graph.couples);
  EXPECT_LE(cholesky.factorEntries(), 36 * 2 * system.graph.size);
  ASSERT_TRUE(cholesky.factorize(system.diagonal, system.couples));
  const Eigen::MatrixXd B = someColumns(system, 1);
  Eigen::MatrixXd X = B;
  cholesky.solve(X);
  EXPECT_THAT(system.times(X), MatrixNear(B, 1e-10));
}

}  // namespace
}  // namespace hexoderm
