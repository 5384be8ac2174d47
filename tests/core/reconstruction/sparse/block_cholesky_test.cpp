#include "hexoderm/reconstruction/sparse/block_cholesky.h"
#include "hexoderm/util/parallel.h"

#include <gmock/gmock.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>

namespace hexoderm {
namespace {

using Couples = std::vector<BlockCouple>;

/// Relative to the largest element.
MATCHER_P2(MatrixNear, expected, tolerance, "") {
  if (arg.rows() != expected.rows() || arg.cols() != expected.cols()) {
    *result_listener << arg.rows() << " x " << arg.cols();
    return false;
  }
  if (arg.size() == 0) return true;
  const double error = (arg - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
  *result_listener << "off by " << error;
  return arg.allFinite() && error <= tolerance;
}

struct Graph {
  std::string name;
  std::size_t size = 0;
  Couples couples;
};

void PrintTo(const Graph& graph, std::ostream* out) { *out << graph.name << " of " << graph.size; }

Graph chain(std::size_t size) {
  Graph graph{"Chain", size, {}};
  for (std::size_t k = 1; k < size; ++k) graph.couples.push_back({k - 1, k});
  return graph;
}

Graph ring(std::size_t size) {
  Graph graph = chain(size);
  graph.name = "Ring";
  graph.couples.push_back({0, size - 1});
  return graph;
}

/// `closed`: the rows are rings.
Graph lattice(std::size_t width, std::size_t height, bool closed = false) {
  Graph graph{closed ? "Tube" : "Lattice", width * height, {}};
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t cell = y * width + x;
      if (x + 1 < width) graph.couples.push_back({cell, cell + 1});
      if (closed && x + 1 == width) graph.couples.push_back({cell, y * width});
      if (y + 1 < height) graph.couples.push_back({cell + width, cell});
    }
  }
  return graph;
}

Graph randomGraph(std::size_t size, std::size_t couples, unsigned seed) {
  Graph graph{"Random" + std::to_string(couples), size, {}};
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = a + 1; b < size; ++b) graph.couples.push_back({a, b});
  }
  std::mt19937 random(seed);
  std::shuffle(graph.couples.begin(), graph.couples.end(), random);
  graph.couples.resize(std::min(couples, graph.couples.size()));
  return graph;
}

/// Two lattices, a chain and two cells alone.
Graph parts() {
  Graph graph{"Parts", 0, {}};
  for (const Graph& part : {lattice(4, 3), chain(1), chain(7), lattice(2, 5), chain(1)}) {
    for (const BlockCouple& c : part.couples) graph.couples.push_back({c.row + graph.size, c.column + graph.size});
    graph.size += part.size;
  }
  return graph;
}

/// Cells named at random, couples either way round.
Graph shuffled(Graph graph, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::size_t> name(graph.size);
  std::iota(name.begin(), name.end(), std::size_t{0});
  std::shuffle(name.begin(), name.end(), random);
  for (BlockCouple& c : graph.couples) {
    c = {name[c.row], name[c.column]};
    if (random() % 2 == 0) std::swap(c.row, c.column);
  }
  std::shuffle(graph.couples.begin(), graph.couples.end(), random);
  return graph;
}

/// A random positive definite matrix: a sum of squares per couple, as of a residual between two cells.
struct System {
  System(const Graph& of, unsigned seed) : graph(of), diagonal(of.size, 0.1 * Matrix6d::Identity()) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (const BlockCouple& c : graph.couples) {
      const Matrix6d J = Matrix6d::NullaryExpr([&] { return normal(random); });
      const Matrix6d K = Matrix6d::NullaryExpr([&] { return normal(random); });
      diagonal[c.row] += J.transpose() * J;
      diagonal[c.column] += K.transpose() * K;
      couples.push_back(J.transpose() * K);
    }
  }

  [[nodiscard]] Eigen::MatrixXd dense() const {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(6 * graph.size, 6 * graph.size);
    for (std::size_t k = 0; k < graph.size; ++k) A.block<6, 6>(6 * k, 6 * k) = diagonal[k];
    for (std::size_t k = 0; k < couples.size(); ++k) {
      const BlockCouple& c = graph.couples[k];
      A.block<6, 6>(6 * c.row, 6 * c.column) = couples[k];
      A.block<6, 6>(6 * c.column, 6 * c.row) = couples[k].transpose();
    }
    return A;
  }

  [[nodiscard]] Eigen::MatrixXd times(const Eigen::MatrixXd& X) const {
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(X.rows(), X.cols());
    for (std::size_t k = 0; k < graph.size; ++k) B.middleRows<6>(6 * k) += diagonal[k] * X.middleRows<6>(6 * k);
    for (std::size_t k = 0; k < couples.size(); ++k) {
      const BlockCouple& c = graph.couples[k];
      B.middleRows<6>(6 * c.row) += couples[k] * X.middleRows<6>(6 * c.column);
      B.middleRows<6>(6 * c.column) += couples[k].transpose() * X.middleRows<6>(6 * c.row);
    }
    return B;
  }

  Graph graph;
  std::vector<Matrix6d> diagonal;
  std::vector<Matrix6d> couples;
};

Eigen::MatrixXd someColumns(const System& system, Eigen::Index count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(6 * system.graph.size, count, [&] { return uniform(random); });
}

class BlockCholeskyGraphs : public ::testing::TestWithParam<Graph> {
 protected:
  System system_{shuffled(GetParam(), 11), 23};
  BlockCholesky cholesky_{system_.graph.size, system_.graph.couples};
};

TEST_P(BlockCholeskyGraphs, SolvesAsTheDenseFactorDoes) {
  ASSERT_TRUE(cholesky_.factorize(system_.diagonal, system_.couples));
  const Eigen::LLT<Eigen::MatrixXd> dense(system_.dense());
  for (const Eigen::Index count : {0, 1, 2, 13, 100}) {
    const Eigen::MatrixXd B = someColumns(system_, count);
    Eigen::MatrixXd X = B;
    cholesky_.solve(X);
    const Eigen::MatrixXd expected = X.size() > 0 ? Eigen::MatrixXd(dense.solve(B)) : B;
    EXPECT_THAT(X, MatrixNear(expected, 1e-9)) << count << " columns";
  }
}

TEST_P(BlockCholeskyGraphs, InvertsOnThePattern) {
  ASSERT_TRUE(cholesky_.factorize(system_.diagonal, system_.couples));
  const BlockCholesky::SelectedInverse inverse = cholesky_.selectedInverse();
  ASSERT_EQ(inverse.diagonal.size(), system_.graph.size);
  ASSERT_EQ(inverse.couples.size(), system_.couples.size());
  const Eigen::MatrixXd A = system_.dense();
  const Eigen::MatrixXd Z = A.llt().solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()));
  for (std::size_t k = 0; k < system_.graph.size; ++k) {
    EXPECT_THAT(inverse.diagonal[k], MatrixNear(Matrix6d(Z.block<6, 6>(6 * k, 6 * k)), 1e-9));
    EXPECT_EQ(inverse.diagonal[k], Matrix6d(inverse.diagonal[k].transpose()));
  }
  for (std::size_t k = 0; k < system_.couples.size(); ++k) {
    const BlockCouple& c = system_.graph.couples[k];
    EXPECT_THAT(inverse.couples[k], MatrixNear(Matrix6d(Z.block<6, 6>(6 * c.row, 6 * c.column)), 1e-9));
  }
}

TEST_P(BlockCholeskyGraphs, EliminationOrdersNameEachRowOnce) {
  const Graph& graph = system_.graph;
  for (std::vector<std::size_t> order : {minimumDegreeOrder(graph.size, graph.couples),
                                         minimumDegreeOrder(graph.size, graph.couples, Numbering::Backwards),
                                         dissectionOrder(graph.size, graph.couples)}) {
    ASSERT_EQ(order.size(), graph.size);
    std::sort(order.begin(), order.end());
    for (std::size_t k = 0; k < order.size(); ++k) EXPECT_EQ(order[k], k);
  }
}

INSTANTIATE_TEST_SUITE_P(BlockCholesky, BlockCholeskyGraphs,
                         ::testing::Values(Graph{"None", 0, {}}, Graph{"Single", 1, {}}, Graph{"Apart", 9, {}},
                                           chain(2), chain(40), ring(3), ring(41), lattice(9, 8), lattice(30, 2),
                                           lattice(12, 9, true), parts(), randomGraph(30, 25, 1),
                                           randomGraph(30, 60, 2), randomGraph(12, 66, 3)),
                         [](const ::testing::TestParamInfo<Graph>& tested) {
                           return tested.param.name + "Of" + std::to_string(tested.param.size);
                         });

TEST(BlockCholesky, SolvesVectorsAndColumnsOfALargerMatrix) {
  const System system(lattice(5, 4), 1);
  BlockCholesky cholesky(system.graph.size, system.graph.couples);
  ASSERT_TRUE(cholesky.factorize(system.diagonal, system.couples));
  const Eigen::MatrixXd B = someColumns(system, 5);
  const Eigen::MatrixXd expected = system.dense().llt().solve(B);
  Eigen::MatrixXd x = B.col(0);
  cholesky.solve(x);
  EXPECT_THAT(x, MatrixNear(Eigen::MatrixXd(expected.col(0)), 1e-9));
  Eigen::MatrixXd X = B;
  cholesky.solve(X);
  EXPECT_THAT(X, MatrixNear(expected, 1e-9));
}

TEST_P(BlockCholeskyGraphs, OneVectorIsSolvedAsAColumnIs) {
  for (const FrontKernels* kernels : {&portableFrontKernels(), vectorFrontKernels()}) {
    if (kernels == nullptr) continue;
    BlockCholesky cholesky(system_.graph.size, system_.graph.couples, *kernels);
    ASSERT_TRUE(cholesky.factorize(system_.diagonal, system_.couples));
    const Eigen::MatrixXd B = someColumns(system_, 2);
    const Eigen::VectorXd b = B.col(0);
    RightSides columns = cholesky.ordered(B);
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
  RightSides half = cholesky.ordered(B);
  cholesky.solveLower(half);
  const Eigen::MatrixXd product = half.matrix().transpose() * half.matrix();
  EXPECT_THAT(product, MatrixNear(Eigen::MatrixXd(B.transpose() * solution), 1e-9));
  const Eigen::MatrixXd gram = half.gram();
  EXPECT_THAT(Eigen::MatrixXd(gram.triangularView<Eigen::Lower>()),
              MatrixNear(Eigen::MatrixXd(product.triangularView<Eigen::Lower>()), 1e-13));
  cholesky.solveUpper(half);
  EXPECT_THAT(Eigen::MatrixXd(cholesky.inOwnOrder(half).matrix()), MatrixNear(solution, 1e-9));
}

TEST(BlockCholesky, ReadsOnlyTheLowerTrianglesOfTheDiagonal) {
  System system(lattice(4, 4), 2);
  const Eigen::MatrixXd B = someColumns(system, 2);
  const Eigen::MatrixXd expected = system.dense().llt().solve(B);
  for (Matrix6d& block : system.diagonal) {
    block.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  BlockCholesky cholesky(system.graph.size, system.graph.couples);
  ASSERT_TRUE(cholesky.factorize(system.diagonal, system.couples));
  Eigen::MatrixXd X = B;
  cholesky.solve(X);
  EXPECT_THAT(X, MatrixNear(expected, 1e-9));
}

TEST(BlockCholesky, FactorisesAnotherMatrixOfTheSamePattern) {
  const Graph graph = shuffled(lattice(8, 7), 3);
  BlockCholesky cholesky(graph.size, graph.couples);
  const Eigen::MatrixXd B = someColumns(System(graph, 1), 4);
  std::vector<Eigen::MatrixXd> solutions;
  for (const unsigned seed : {1U, 2U, 1U}) {
    const System system(graph, seed);
    ASSERT_TRUE(cholesky.factorize(system.diagonal, system.couples));
    solutions.push_back(B);
    cholesky.solve(solutions.back());
    EXPECT_THAT(solutions.back(), MatrixNear(Eigen::MatrixXd(system.dense().llt().solve(B)), 1e-9));
  }
  EXPECT_EQ(solutions[0], solutions[2]);
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

/// Largest difference in units of the larger matrix's largest element.
double differenceOf(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
}

TEST(BlockCholesky, KernelsWithVectorInstructionsGiveTheSame) {
  const FrontKernels* const vector = vectorFrontKernels();
  const FrontKernels& others = vector != nullptr ? *vector : portableFrontKernels();
  // The last has fronts of more than 400 rows.
  for (const Graph& graph : {chain(9), lattice(9, 8), lattice(12, 9, true), randomGraph(150, 900, 3)}) {
    SCOPED_TRACE(graph.name);
    const System system(shuffled(graph, 12), 5);
    BlockCholesky portable(graph.size, system.graph.couples, portableFrontKernels());
    BlockCholesky fast(graph.size, system.graph.couples, others);
    ASSERT_TRUE(portable.factorize(system.diagonal, system.couples));
    ASSERT_TRUE(fast.factorize(system.diagonal, system.couples));
    for (const Eigen::Index count : {1, 6, 19, 61}) {
      const Eigen::MatrixXd B = someColumns(system, count);
      RightSides x = portable.ordered(B);
      RightSides y = fast.ordered(B);
      portable.solveLower(x);
      fast.solveLower(y);
      EXPECT_LT(differenceOf(x.matrix(), y.matrix()), 1e-12) << count;
      EXPECT_LT(differenceOf(x.gram(portableFrontKernels()).triangularView<Eigen::Lower>(),
                             y.gram(others).triangularView<Eigen::Lower>()),
                1e-12)
          << count;
      portable.solveUpper(x);
      fast.solveUpper(y);
      EXPECT_LT(differenceOf(x.matrix(), y.matrix()), 1e-12) << count;
    }
    const BlockCholesky::SelectedInverse a = portable.selectedInverse();
    const BlockCholesky::SelectedInverse b = fast.selectedInverse();
    for (std::size_t k = 0; k < graph.size; ++k) EXPECT_LT(differenceOf(a.diagonal[k], b.diagonal[k]), 1e-12) << k;
    for (std::size_t k = 0; k < a.couples.size(); ++k) EXPECT_LT(differenceOf(a.couples[k], b.couples[k]), 1e-11) << k;
  }
}

TEST(BlockCholesky, WidePanelsAreRight) {
  // One supernode of 75 cells, and a ring about it.
  Graph graph = ring(200);
  for (std::size_t a = 0; a < 75; ++a) {
    for (std::size_t b = a + 1; b < 75; ++b) {
      if (b != a + 1) graph.couples.push_back({a, b});
    }
  }
  const System system(shuffled(graph, 6), 9);
  for (const FrontKernels* kernels : {&portableFrontKernels(), &frontKernels()}) {
    BlockCholesky cholesky(graph.size, system.graph.couples, *kernels);
    ASSERT_TRUE(cholesky.factorize(system.diagonal, system.couples));
    const Eigen::MatrixXd A = system.dense();
    const Eigen::MatrixXd Z = A.llt().solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()));
    const BlockCholesky::SelectedInverse inverse = cholesky.selectedInverse();
    for (std::size_t k = 0; k < graph.size; ++k) {
      EXPECT_THAT(inverse.diagonal[k], MatrixNear(Matrix6d(Z.block<6, 6>(6 * k, 6 * k)), 1e-10));
    }
    for (std::size_t k = 0; k < system.couples.size(); ++k) {
      const BlockCouple& c = system.graph.couples[k];
      EXPECT_THAT(inverse.couples[k], MatrixNear(Matrix6d(Z.block<6, 6>(6 * c.row, 6 * c.column)), 1e-8));
    }
    const Eigen::MatrixXd B = someColumns(system, 7);
    Eigen::MatrixXd X = B;
    cholesky.solve(X);
    EXPECT_THAT(system.times(X), MatrixNear(B, 1e-12));
  }
}

/// Sets the number of cores for as long as it lives.
class Cores {
 public:
  explicit Cores(std::size_t count) { setCores(count); }
  ~Cores() { setCores(before_); }
  Cores(const Cores&) = delete;
  Cores& operator=(const Cores&) = delete;

 private:
  std::size_t before_ = cores();
};

TEST(BlockCholesky, NoNumberDependsOnTheCores) {
  // Wide panels at the top, many subtrees below, and two parts.
  Graph graph = lattice(60, 60);
  for (std::size_t k = 0; k < 1200; ++k) graph.couples.push_back({graph.size + k, graph.size + k + 1});
  graph.size += 1201;
  const System system(graph, 9);
  const Eigen::MatrixXd B = someColumns(system, 19);
  BlockCholesky::SelectedInverse inverse;
  Eigen::MatrixXd solution;
  for (const std::size_t count : {1, 2, 3, 7}) {
    const Cores cores(count);
    BlockCholesky cholesky(graph.size, graph.couples);
    ASSERT_TRUE(cholesky.factorize(system.diagonal, system.couples));
    Eigen::MatrixXd X = B;
    cholesky.solve(X);
    BlockCholesky::SelectedInverse found = cholesky.selectedInverse();
    if (count == 1) {
      EXPECT_THAT(system.times(X), MatrixNear(B, 1e-9));
      solution = X;
      inverse = std::move(found);
      continue;
    }
    EXPECT_EQ(X, solution) << count << " cores";
    EXPECT_EQ(found.diagonal, inverse.diagonal) << count << " cores";
    EXPECT_EQ(found.couples, inverse.couples) << count << " cores";
  }
}

TEST(BlockCholesky, RefusesWhatIsNotPositiveDefiniteInAnySubtreeWithSeveralCores) {
  const Cores cores(4);
  const Graph graph = lattice(40, 40);
  System system(graph, 9);
  BlockCholesky cholesky(graph.size, graph.couples);
  for (std::size_t cell = 0; cell < graph.size; cell += 97) {
    const double before = std::exchange(system.diagonal[cell](0, 0), -1);
    EXPECT_FALSE(cholesky.factorize(system.diagonal, system.couples)) << "cell " << cell;
    system.diagonal[cell](0, 0) = before;
  }
  EXPECT_TRUE(cholesky.factorize(system.diagonal, system.couples));
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
