// The factor and the inverse with several cores.

#include "hexoderm/base/parallel.h"
#include "hexoderm/solve/sparse/block_cholesky.h"
#include "tests/core/solve/sparse/block_systems.h"
#include "tests/support/testing.h"

#include <cstddef>

namespace hexoderm {
namespace {

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

}  // namespace
}  // namespace hexoderm
