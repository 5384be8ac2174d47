#include "hexoderm/solve/global/shape_covariance.h"

#include "hexoderm/solve/global/global_solver.h"
#include "hexoderm/solve/reconstructor.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "tests/core/solve/global/joint_case.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

Eigen::Index rowsOf(std::size_t cell) { return static_cast<Eigen::Index>(6 * cell); }

/// What motions of the whole patch do to its cells, about the frame's origin.
Eigen::MatrixXd motionsOf(const std::vector<SE3>& cells) {
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(rowsOf(cells.size()), 6);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    G.block<3, 3>(rowsOf(k), 0).setIdentity();
    G.block<3, 3>(rowsOf(k), 3) = -skew(cells[k].t);
    G.block<3, 3>(rowsOf(k) + 3, 3) = cells[k].R.transpose();
  }
  return G;
}

/// S = I - G (G^T W G)^-1 G^T W, W of the centres.
Eigen::MatrixXd transformationOf(const std::vector<SE3>& cells) {
  const Eigen::MatrixXd G = motionsOf(cells);
  Eigen::MatrixXd WG = G;
  for (std::size_t k = 0; k < cells.size(); ++k) WG.middleRows<3>(rowsOf(k) + 3).setZero();
  return Eigen::MatrixXd::Identity(G.rows(), G.rows()) - G * (G.transpose() * WG).inverse() * WG.transpose();
}

/// The covariance of all cells of a solution relative to its origin.
Eigen::MatrixXd wholeOf(const GlobalSolution& solution) {
  const Eigen::Index rows = rowsOf(solution.state.cells.size());
  return solution.covariance->timesCells(Eigen::MatrixXd::Identity(rows, rows));
}

std::vector<Matrix6d> shapeOf(const GlobalSolution& solution) {
  return shapeCovariancesOf(
      solution.state.cells, [&](Eigen::MatrixXd B) { return solution.covariance->timesCells(std::move(B)); },
      [&](std::size_t cell) { return solution.covariance->cell(cell); });
}

GlobalCase x17Case(std::uint64_t seed) { return simulatedCase(test::skinOptions("x17", "", seed), 4, kFitGap); }

TEST(ShapeCovariance, IsTheSTransformedCovariance) {
  const GlobalCase example = x17Case(3);
  const GlobalSolution solution = GlobalSolver().solve(example.problem, example.truth);
  const Eigen::MatrixXd S = transformationOf(solution.state.cells);
  const Eigen::MatrixXd C_s = S * wholeOf(solution) * S.transpose();
  // Motions of the whole are taken out.
  Eigen::MatrixXd WG = motionsOf(solution.state.cells);
  for (std::size_t k = 0; k < solution.state.cells.size(); ++k) WG.middleRows<3>(rowsOf(k) + 3).setZero();
  EXPECT_LE((WG.transpose() * C_s).norm(), 1e-12);
  const std::vector<Matrix6d> shape = shapeOf(solution);
  for (std::size_t k = 0; k < shape.size(); ++k) {
    EXPECT_LE((shape[k] - C_s.block<6, 6>(rowsOf(k), rowsOf(k))).norm(), 1e-10) << k;
  }
}

// Another origin is another frame with another covariance; the shape's is the same, but for the priors' being
// linearised elsewhere.
TEST(ShapeCovariance, DoesNotDependOnTheOrigin) {
  const GlobalCase example = x17Case(5);
  const GlobalSolution one = GlobalSolver().solve(example.problem, example.truth);
  GlobalCase moved = example;
  moved.problem.origin = 14;
  const SE3 T = one.state.cells[14].inverse();
  GlobalState start = one.state;
  for (SE3& cell : start.cells) cell = T * cell;
  for (Eigen::Vector3d& force : start.force_o) force = T.R * force;
  for (Eigen::Vector3d& acceleration : start.acceleration_o) acceleration = T.R * acceleration;
  start.middle_o = T * start.middle_o;
  const GlobalSolution other = GlobalSolver().solve(moved.problem, start);
  const std::vector<Matrix6d> shape = shapeOf(one);
  const std::vector<Matrix6d> shape_there = shapeOf(other);
  Matrix6d turn = Matrix6d::Identity();  // positions are in the patch's frame
  turn.topLeftCorner<3, 3>() = T.R;
  for (std::size_t k = 0; k < shape.size(); ++k) {
    EXPECT_LE((turn * shape[k] * turn.transpose() - shape_there[k]).norm(), 2e-3 * shape[k].norm()) << k;
  }
  EXPECT_GT(shape[example.problem.origin].norm(), 0);
  EXPECT_EQ(one.covariance->cell(example.problem.origin).norm(), 0);
}

// Few cells: two that lie on one line, and one that has no shape.
TEST(ShapeCovariance, IsACovarianceForAnyNumberOfCells) {
  for (const char* patch : {"sheet:1x1", "sheet:1x2", "sheet:1x6", "ring3"}) {
    const auto result = reconstruct(*test::simulatedSession(test::skinOptions(patch, "plane"), 3).snapshot());
    for (const CellPlacement& cell : result->patches.front().cells) {
      ASSERT_TRUE(cell.shape_cov_t_r.has_value()) << patch;
      EXPECT_TRUE(cell.shape_cov_t_r->allFinite()) << patch;
      EXPECT_GE(cell.shape_cov_t_r->diagonal().minCoeff(), 0) << patch;
      const Uncertainty95 shape = *shapeUncertaintyOf(cell);
      EXPECT_LE(shape.position_m, 0.02) << patch;
      EXPECT_TRUE(result->patches.front().cells.size() > 1 || cell.shape_cov_t_r->norm() == 0);
    }
  }
}

}  // namespace
}  // namespace hexoderm
