#include "hexoderm/solve/global/linearize_kernels.h"

#include "tests/core/solve/global/joint_case.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <string>

namespace hexoderm {
namespace {

/// The largest difference between two linearizations, per standard deviations of each unknown alone.
double differenceBetween(const GlobalProblem& problem, const NormalEquations& a, const NormalEquations& b) {
  const Eigen::MatrixXd H = denseMatrix(problem, a);
  const Eigen::VectorXd scale = H.diagonal().cwiseMax(1e-12).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd difference = scale.asDiagonal() * (denseMatrix(problem, b) - H) * scale.asDiagonal();
  Eigen::VectorXd gradient(scale.size());
  gradient << b.gradient_cells - a.gradient_cells, b.gradient_border - a.gradient_border;
  Eigen::VectorXd whole(scale.size());
  whole << a.gradient_cells, a.gradient_border;
  const double of_gradient = gradient.cwiseProduct(scale).cwiseAbs().maxCoeff() /
                             std::max(1.0, whole.cwiseProduct(scale).cwiseAbs().maxCoeff());
  return std::max({difference.cwiseAbs().maxCoeff(), of_gradient, std::abs(a.cost - b.cost) / a.cost});
}

void expectTheSame(const GlobalProblem& problem, const GlobalState& state, const std::string& what) {
  NormalEquations portable;
  NormalEquations fast;
  linearize(problem, state, portable, portableLinearizeKernels());
  linearize(problem, state, fast, linearizeKernels());
  EXPECT_NEAR(portable.cost, jointCost(problem, state), 1e-12 * portable.cost) << what;
  EXPECT_LT(differenceBetween(problem, portable, fast), 1e-12) << what;
}

TEST(LinearizeKernels, GiveTheSameOnAnyMachine) {
  for (const char* patch : {"x17", "ring8:closed", "sheet:3x3"}) {
    for (const GapShare& gap : {kPivotGap, kArcGap, kFitGap}) {
      for (const std::size_t poses : {0U, 1U, 2U, 4U, 7U}) {
        GlobalCase example = simulatedCase(test::skinOptions(patch), poses, gap);
        for (const bool accelerations : {false, true}) {
          example.problem.accelerations = accelerations;
          for (const double threshold : {3.0, std::numeric_limits<double>::infinity()}) {
            example.problem.loss.threshold = threshold;
            for (const double away : {0.0, 0.01, 0.3}) {
              const GlobalState state = perturbed(example.problem, example.truth, away, 0.01 * away, 7);
              expectTheSame(example.problem, state,
                            std::string(patch) + ", " + nameOf(gap) + ", " + std::to_string(poses) +
                                " poses, accelerations " + std::to_string(accelerations) + ", threshold " +
                                std::to_string(threshold) + ", away " + std::to_string(away));
            }
          }
        }
      }
    }
  }
}

TEST(LinearizeKernels, TakeMissingReadingsTurnedSensorsAndAnyOrigin) {
  GlobalCase example = simulatedCase(test::skinOptions("x17"), 4, kFitGap);
  CellModel model = *example.model;
  model.accelerometer.T_u_a.R = expSO3({0.4, -0.3, 1.1});
  model.accelerometer.scale_sigma = 0;
  example.problem.model = &model;
  example.problem.accelerations = true;
  example.problem.origin = 5;
  example.problem.readings[2].clear();
  example.problem.readings[9].erase(example.problem.readings[9].begin() + 1);
  std::ranges::reverse(example.problem.readings[11]);
  expectTheSame(example.problem, perturbed(example.problem, example.truth, 0.1, 0.001, 5), "missing");
}

TEST(LinearizeKernels, TakeOverturnedLinksAndGrossErrors) {
  GlobalCase example = simulatedCase(test::skinOptions("x17"), 5, kFitGap);
  example.problem.readings[3][2].y_g = {1.5, -1.5, 0.4};
  example.problem.readings[16][0].y_g = {-1, 0.2, 1};
  GlobalState state = example.truth;
  state.cells[7].R = state.cells[7].R * expSO3({0.1, 3.0, 0.2});
  expectTheSame(example.problem, state, "gross");
}

TEST(LinearizeKernels, TakeAnyNumberOfPoses) {
  for (const std::size_t poses : {63U, 66U}) {
    GlobalCase example = simulatedCase(test::skinOptions("sheet:2x2"), poses, kFitGap);
    expectTheSame(example.problem, perturbed(example.problem, example.truth, 0.01, 0.001, 5), std::to_string(poses));
  }
}

TEST(LinearizeKernels, ANumberThatIsNotFiniteStaysOne) {
  GlobalCase example = simulatedCase(test::skinOptions("x17"), 3, kFitGap);
  for (const bool in_force : {false, true}) {
    GlobalState state = example.truth;
    (in_force ? state.force_o[1] : state.cells[6].t)[0] = std::numeric_limits<double>::quiet_NaN();
    NormalEquations equations;
    linearize(example.problem, state, equations);
    EXPECT_FALSE(std::isfinite(equations.cost)) << in_force;
  }
}

}  // namespace
}  // namespace hexoderm
