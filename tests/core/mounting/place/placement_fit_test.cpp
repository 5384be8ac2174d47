#include "hexoderm/mounting/place/placement_fit.h"

#include "hexoderm/base/units.h"
#include "tests/core/mounting/place/laid_patches.h"

namespace hexoderm {
namespace {

FitPatch anyPatch(std::mt19937_64& random, std::size_t cells) {
  FitPatch patch;
  for (std::size_t k = 0; k < cells; ++k) {
    patch.T_o_u.push_back(k == 0 ? SE3{} : SE3{expSO3(0.3 * drawVector(random)), 0.05 * drawVector(random)});
    patch.middle_o += patch.T_o_u.back().t / static_cast<double>(cells);
  }
  patch.radius_m = 0.06;
  const auto size = static_cast<Eigen::Index>(6 * cells);
  const Eigen::MatrixXd A = 0.001 * Eigen::MatrixXd::Random(size, size);
  patch.C = A * A.transpose();
  patch.rotation = KnownRotation{expSO3(drawVector(random)), 1e-4 * Eigen::Matrix3d::Identity()};
  return patch;
}

/// The mean of the squared deviates of the cells' places, per degree of freedom.
double neesOfCells(bool joint) {
  constexpr int kSeeds = 200;
  double sum = 0;
  double count = 0;
  std::mt19937_64 random(joint ? 5 : 6);
  for (int seed = 0; seed < kSeeds; ++seed) {
    FitProblem problem;
    FitPatch patch = anyPatch(random, 5);
    const SE3 truth{expSO3(drawVector(random)), drawVector(random)};
    // The errors of the shape, of all cells together or of each by itself.
    Eigen::VectorXd normal(30);
    for (Eigen::Index k = 0; k < 10; ++k) normal.segment<3>(3 * k) = drawVector(random);
    if (!joint) patch.C = Eigen::MatrixXd(patch.C.diagonal().asDiagonal());
    const Eigen::VectorXd d =
        Eigen::MatrixXd((patch.C + 1e-18 * Eigen::MatrixXd::Identity(30, 30)).llt().matrixL()) * normal;
    std::vector<SE3> T_l_u;
    for (std::size_t k = 0; k < 5; ++k) {
      const auto at = static_cast<Eigen::Index>(6 * k);
      const SE3& cell = patch.T_o_u[k];
      T_l_u.push_back(truth * SE3{cell.R * expSO3(d.segment<3>(at + 3)), cell.t + d.segment<3>(at)});
      problem.points.push_back({0, k, T_l_u.back().t + 0.001 * drawVector(random), 0.001});
    }
    problem.points.resize(4);
    patch.rotation =
        KnownRotation{T_l_u[0].R * expSO3(0.01 * drawVector(random)).transpose(), 1e-4 * Eigen::Matrix3d::Identity()};
    problem.patches = {patch};
    const FitSolution solution = refine(problem, {truth}, 20);
    for (const std::size_t k : {0U, 4U}) {
      const CellOnLink cell =
          cellsOnLink(problem, solution.state, equationsAt(problem, solution.state), noExtent(problem), 0)[k];
      Eigen::Matrix<double, 6, 1> e;
      e << T_l_u[k].t - cell.T_l_u.t, logSO3(cell.T_l_u.R.transpose() * T_l_u[k].R);
      const Eigen::Matrix<double, 6, 6> C = cell.cov_t_r;
      sum += e.dot(C.ldlt().solve(e));
      count += 6;
    }
  }
  return sum / count;
}

TEST(PlacementFit, ErrorsOfCellsInTheLinkAreAsLargeAsStated) {
  EXPECT_NEAR(neesOfCells(true), 1, 0.15);
  EXPECT_NEAR(neesOfCells(false), 1, 0.15);
}

}  // namespace
}  // namespace hexoderm
