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

FitProblem anyProblem(std::mt19937_64& random) {
  FitProblem problem;
  problem.patches = {anyPatch(random, 4), anyPatch(random, 3)};
  problem.points = {{0, 2, drawVector(random), 0.001}, {1, 1, drawVector(random), 0.002}};
  problem.distances = {{0, 1, 1, 2, 0.3, 0.001}};
  return problem;
}

FitState nearRotations(const FitProblem& problem, std::mt19937_64& random) {
  FitState state;
  for (const FitPatch& patch : problem.patches) {
    state.push_back({patch.rotation->R_l_o * expSO3(1e-4 * drawVector(random)), 0.2 * drawVector(random)});
  }
  return state;
}

/// J by differences.
Eigen::MatrixXd differences(const FitProblem& problem, const FitState& state, double step_m) {
  Eigen::MatrixXd J(equationsAt(problem, state).r.size(), problem.unknowns());
  for (Eigen::Index k = 0; k < J.cols(); ++k) {
    const Eigen::VectorXd step = step_m * Eigen::VectorXd::Unit(J.cols(), k);
    J.col(k) =
        (equationsAt(problem, moved(problem, state, step)).r - equationsAt(problem, moved(problem, state, -step)).r) /
        (2 * step_m);
  }
  return J;
}

TEST(PlacementFit, DerivativesOfPointsDistancesAndRotationsAreThoseOfDifferences) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const FitProblem problem = anyProblem(random);
    const FitState state = nearRotations(problem, random);
    const Eigen::MatrixXd J = equationsAt(problem, state).J;
    EXPECT_LT((J - differences(problem, state, 1e-6)).norm(), 2e-3 * J.norm());
  }
}

// On a cylinder of many sides, over steps that are longer than these.
TEST(PlacementFit, DerivativesOnASurfaceAreThoseOfDifferences) {
  const TriangleMesh mesh = meshOfCylinder(0.05, 0.4);
  const MeshFeet feet(mesh);
  const LaidPatch laid = layPatch(mesh, {rotationFromRpy({0, 0, kPi / 2}), {0.06, 0, 0}});
  FitProblem problem;
  std::mt19937_64 random(1);
  FitPatch patch = anyPatch(random, 1);
  patch.T_o_u = laid.patch.T_o_u;
  patch.C = Eigen::MatrixXd::Identity(102, 102) * 1e-6;
  patch.rotation.reset();
  problem.patches = {patch};
  problem.feet = &feet;
  problem.back_m = builtInCellModel("hex-bma150").thickness_m;
  problem.surface_sigma_m = 0.001;
  problem.normal_sigma_rad = 0.05;
  const FitState state = {laid.T_l_o};
  const FitEquations equations = equationsAt(problem, state);
  // The mould of the simulation lays the cells on it.
  EXPECT_LT(equations.r.cwiseAbs().maxCoeff(), 1e-6);
  const Eigen::MatrixXd J = equations.J;
  const Eigen::MatrixXd expected = differences(problem, state, 0.004);
  for (Eigen::Index k = 0; k < J.cols(); ++k) {
    EXPECT_LT((J.col(k) - expected.col(k)).norm(), 0.08 * J.norm()) << k;
  }
}

TEST(PlacementFit, AWayBeginsAndEndsWhereItIsTold) {
  std::mt19937_64 random(2);
  const FitProblem problem = anyProblem(random);
  const FitState a = nearRotations(problem, random);
  FitState b = nearRotations(problem, random);
  b[1].R = a[1].R;  // a screw without a turn
  EXPECT_LT(distanceBetween(problem, wayFrom(a, b, 0), a), 1e-12);
  EXPECT_LT(distanceBetween(problem, wayFrom(a, b, 1), b), 1e-12);
  const FitState half = wayFrom(a, b, 0.5);
  EXPECT_LT(distanceBetween(problem, wayFrom(a, half, 2), b), 1e-9);
  EXPECT_LT(distanceBetween(problem, moved(problem, a, stepBetween(problem, a, b)), b), 1e-9);
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
