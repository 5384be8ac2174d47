#include "hexoderm/solve/global/global_cost.h"

#include "hexoderm/solve/global/linearize_kernels.h"
#include "tests/core/solve/global/joint_case.h"
#include "tests/support/matchers.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/testing.h"

#include <Eigen/Eigenvalues>

namespace hexoderm {
namespace {

const GapShare kGaps[] = {kPivotGap, kArcGap, kFitGap};

/// All unknowns as one vector of steps: cells, then the border.
GlobalState stepped(const GlobalProblem& problem, const GlobalState& state, const Eigen::VectorXd& step) {
  const auto rows = static_cast<Eigen::Index>(6 * problem.cellCount());
  return moved(problem, state, step.head(rows), step.tail(step.size() - rows));
}

/// Steps by which the cost would rise by a like amount: one standard deviation of each unknown alone.
Eigen::VectorXd scaleOf(const Eigen::MatrixXd& H) { return H.diagonal().cwiseMax(1e-12).cwiseSqrt().cwiseInverse(); }

Eigen::VectorXd gradientOf(const NormalEquations& equations) {
  Eigen::VectorXd gradient(equations.gradient_cells.size() + equations.gradient_border.size());
  gradient << equations.gradient_cells, equations.gradient_border;
  return gradient;
}

/// The equations at a state, which are the same with vector instructions and without, per standard deviation of each
/// unknown alone.
NormalEquations linearized(const GlobalProblem& problem, const GlobalState& state) {
  NormalEquations portable;
  NormalEquations fast;
  linearize(problem, state, portable, portableLinearizeKernels());
  linearize(problem, state, fast, linearizeKernels());
  EXPECT_NEAR(portable.cost, jointCost(problem, state), 1e-12 * portable.cost);
  EXPECT_NEAR(fast.cost, portable.cost, 1e-12 * portable.cost);
  const Eigen::MatrixXd H = denseMatrix(problem, portable);
  const Eigen::VectorXd scale = scaleOf(H);
  const Eigen::MatrixXd difference = scale.asDiagonal() * (denseMatrix(problem, fast) - H) * scale.asDiagonal();
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-11);
  const Eigen::VectorXd gradient = gradientOf(portable).cwiseProduct(scale);
  EXPECT_LT((gradientOf(fast).cwiseProduct(scale) - gradient).cwiseAbs().maxCoeff(),
            1e-11 * std::max(1.0, gradient.cwiseAbs().maxCoeff()));
  return fast;
}

/// The largest difference between linearize()'s gradient and central differences, in units of the largest element (per
/// standard deviation).
double gradientError(const GlobalProblem& problem, const GlobalState& state) {
  const NormalEquations equations = linearized(problem, state);
  const Eigen::VectorXd gradient = gradientOf(equations);
  const Eigen::VectorXd scale = scaleOf(denseMatrix(problem, equations));
  double worst = 0;
  double largest = 0;
  for (Eigen::Index k = 0; k < gradient.size(); ++k) {
    if (k / 6 == static_cast<Eigen::Index>(problem.origin)) {
      EXPECT_EQ(gradient[k], 0) << "the origin does not move";
      continue;
    }
    // Fourth order, so that long steps stand above rounding.
    const double h = 3e-3 * scale[k];
    const auto costAt = [&](double step) {
      Eigen::VectorXd steps = Eigen::VectorXd::Zero(gradient.size());
      steps[k] = step;
      return jointCost(problem, stepped(problem, state, steps));
    };
    const double numeric = (8 * (costAt(h) - costAt(-h)) - (costAt(2 * h) - costAt(-2 * h))) / (12 * h);
    worst = std::max(worst, std::abs(gradient[k] - numeric) * scale[k]);
    largest = std::max(largest, std::abs(gradient[k]) * scale[k]);
  }
  return worst / largest;
}

std::size_t countBeyondThreshold(const GlobalProblem& problem, const GlobalState& state) {
  const AccelerometerPrior prior(problem.model->accelerometer);
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    SensorState sensor;
    fitCell(problem, prior, state, cell, sensor);
    for (std::size_t k = 0; k < problem.readings[cell].size(); ++k) {
      if (sensor.fit.precision[k] * problem.readings[cell][k].variance_g2 < 0.999) ++count;
    }
  }
  return count;
}

TEST(GlobalCost, GradientIsThatOfTheCostWithQuadraticAndWithRobustLosses) {
  for (const GapShare& gap : kGaps) {
    for (const bool accelerations : {false, true}) {
      GlobalCase quadratic = simulatedCase(test::skinOptions("x17"), 3, gap);
      GlobalCase robust = simulatedCase(test::skinOptions("ring8:closed"), 4, gap);
      quadratic.problem.accelerations = robust.problem.accelerations = accelerations;
      quadratic.problem.loss.threshold = std::numeric_limits<double>::infinity();
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const std::string what =
            nameOf(gap) + std::string(accelerations ? ", accelerations, seed " : ", seed ") + std::to_string(seed);
        const GlobalState near = perturbed(quadratic.problem, quadratic.truth, 0.1, 0.001, seed);
        EXPECT_LT(gradientError(quadratic.problem, near), 1e-7) << what;
        const GlobalState far = perturbed(robust.problem, robust.truth, 0.15, 0.003, seed);
        EXPECT_GT(countBeyondThreshold(robust.problem, far), 5) << what;
        EXPECT_LT(gradientError(robust.problem, far), 1e-6) << what;
      }
    }
  }
}

TEST(GlobalCost, GradientIsRightWhereLinksAreStraight) {
  // The arc's direction and angle have limits there, not values.
  for (const GapShare& gap : kGaps) {
    GlobalCase example = exactX17(builtInCellModel("hex-bma150"), gap.mean, 0, 0, 0, 1);
    example.problem.gap = gap;
    addExactReadings(example, {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()});
    GlobalState state = example.truth;
    for (std::size_t cell = 1; cell < state.cells.size(); ++cell) state.cells[cell].t += Eigen::Vector3d(1e-4, 0, 2e-4);
    for (Eigen::Vector3d& force : state.force_o) force += Eigen::Vector3d(0.01, 0.02, 0.01);
    EXPECT_LT(gradientError(example.problem, state), 1e-7) << nameOf(gap);
  }
}

TEST(GlobalCost, GradientIsRightWherePortsHaveHeight) {
  for (const GapShare& gap : kGaps) {
    GlobalCase example = exactX17(modelOfStepsAndFolds(), gap.mean, 0.5, 0.2, 0.03, 1);
    example.problem.gap = gap;
    addExactReadings(example, {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()});
    EXPECT_LT(gradientError(example.problem, perturbed(example.problem, example.truth, 0.1, 0.001, 1)), 1e-6)
        << nameOf(gap);
  }
}

TEST(GlobalCost, GradientIsRightWhereLinksAreOverturned) {
  for (const GapShare& gap : kGaps) {
    for (const Eigen::Vector3d& turn : {Eigen::Vector3d(2.4, 0.1, 0.2), Eigen::Vector3d(0.1, 2.4, 0.2),
                                        Eigen::Vector3d(0.3, -0.2, 2.4), Eigen::Vector3d(-0.3, 0.2, -2.3)}) {
      GlobalCase example = simulatedCase(test::skinOptions("x17"), 3, gap);
      example.problem.loss.threshold = std::numeric_limits<double>::infinity();
      GlobalState state = perturbed(example.problem, example.truth, 0.1, 0.001, 5);
      state.cells[7].R = state.cells[7].R * expSO3(turn);
      EXPECT_LT(gradientError(example.problem, state), 1e-6) << nameOf(gap) << ", " << turn.transpose();
    }
  }
}

TEST(GlobalCost, GradientIsRightWithATurnedAccelerometerAndMissingReadings) {
  GlobalCase example = simulatedCase(test::skinOptions("x17"), 4, kFitGap);
  CellModel model = *example.model;
  model.accelerometer.T_u_a.R = expSO3({0.4, -0.3, 1.1});
  example.problem.model = &model;
  example.problem.readings[2].clear();
  example.problem.readings[9].erase(example.problem.readings[9].begin() + 1);
  std::ranges::reverse(example.problem.readings[11]);
  example.problem.accelerations = true;
  const GlobalState state = perturbed(example.problem, example.truth, 0.1, 0.001, 5);
  EXPECT_LT(gradientError(example.problem, state), 1e-6);
  model.accelerometer.scale_sigma = 0;
  linearized(example.problem, state);
}

TEST(GlobalCost, TakesAnyNumberOfPoses) {
  for (const std::size_t poses : {7U, 63U, 66U}) {
    const GlobalCase example = simulatedCase(test::skinOptions("sheet:2x2"), poses, kFitGap);
    linearized(example.problem, perturbed(example.problem, example.truth, 0.01, 0.001, 5));
  }
}

TEST(GlobalCost, OfANumberThatIsNotFiniteIsNoneEither) {
  const GlobalCase example = simulatedCase(test::skinOptions("x17"), 3, kFitGap);
  for (const bool in_force : {false, true}) {
    GlobalState state = example.truth;
    (in_force ? state.force_o[1] : state.cells[6].t)[0] = std::numeric_limits<double>::quiet_NaN();
    NormalEquations equations;
    linearize(example.problem, state, equations);
    EXPECT_FALSE(std::isfinite(equations.cost)) << in_force;
  }
}

TEST(GlobalCost, MatrixIsPositiveSemiDefiniteAnywhere) {
  for (const char* patch : {"x17", "ring8:closed", "sheet:3x3"}) {
    for (const GapShare& gap : kGaps) {
      for (const std::size_t poses : {0U, 1U, 2U, 4U}) {
        GlobalCase example = simulatedCase(test::skinOptions(patch), poses, gap);
        for (const bool accelerations : {false, true}) {
          example.problem.accelerations = accelerations;
          for (const double away : {0.0, 0.1, 1.0}) {
            const NormalEquations equations =
                linearized(example.problem, perturbed(example.problem, example.truth, away, 0.01 * away, 7));
            for (const Matrix6d& block : equations.cells)
              EXPECT_LT((block - block.transpose()).norm(), 1e-9 * block.norm());
            const Eigen::MatrixXd H = denseMatrix(example.problem, equations);
            EXPECT_LT((H - H.transpose()).norm(), 1e-12 * H.norm());
            // Scaled to a diagonal of ones, so that metres and radians compare.
            const Eigen::VectorXd scale = scaleOf(H);
            const Eigen::MatrixXd scaled = scale.asDiagonal() * H * scale.asDiagonal();
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
            EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-10)
                << patch << ", " << nameOf(gap) << ", " << poses << " poses, perturbed by " << away;
          }
        }
      }
    }
  }
}

/// The largest relative difference between the Gauss-Newton matrix and second differences of the cost, per standard
/// deviations.
double hessianError(const GlobalProblem& problem, const GlobalState& state) {
  NormalEquations equations;
  linearize(problem, state, equations);
  const Eigen::MatrixXd H = denseMatrix(problem, equations);
  const Eigen::VectorXd scale = scaleOf(H);
  const auto costAt = [&](Eigen::Index i, double di, Eigen::Index j, double dj) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(H.rows());
    step[i] += di * scale[i];
    step[j] += dj * scale[j];
    return jointCost(problem, stepped(problem, state, step));
  };
  constexpr double kStep = 1e-2;
  double worst = 0;
  for (Eigen::Index i = 0; i < H.rows(); ++i) {
    if (i / 6 == static_cast<Eigen::Index>(problem.origin)) continue;
    for (Eigen::Index j = 0; j <= i; ++j) {
      if (j / 6 == static_cast<Eigen::Index>(problem.origin)) continue;
      const double numeric = (costAt(i, kStep, j, kStep) - costAt(i, kStep, j, -kStep) - costAt(i, -kStep, j, kStep) +
                              costAt(i, -kStep, j, -kStep)) /
                             (4 * kStep * kStep);
      worst = std::max(worst, std::abs(numeric - H(i, j) * scale[i] * scale[j]));
    }
  }
  return worst;
}

void expectHessian(GlobalCase example, const GapShare& gap, double cost_tolerance) {
  example.problem.gap = gap;
  addExactReadings(example, {{0.2, 0.1, 1}, {1, 0.3, -0.1}, {0.1, -1, 0.4}});
  EXPECT_NEAR(jointCost(example.problem, example.truth), 0, cost_tolerance);
  EXPECT_LT(hessianError(example.problem, example.truth), 1e-5) << nameOf(gap);
}

TEST(GlobalCost, MatrixIsTheHessianWhereNothingIsLeftOver) {
  // All residuals are zero: flat cells for the elastomer, mean gap share, no angular acceleration, perfect sensors.
  for (const GapShare& gap : kGaps) {
    for (const bool accelerations : {false, true}) {
      for (const CellModel& model : {independentChips(), builtInCellModel("hex-bma150")}) {
        GlobalCase example = exactX17(model, gap.mean, 0, 0, 0, 1);
        // The first arm and a cell of the second are enough.
        example.truth.cells.resize(6);
        example.problem.links.resize(5);
        example.problem.accelerations = accelerations;
        example.problem.origin = 2;
        expectHessian(example, gap, 1e-20);
      }
    }
  }
}

TEST(GlobalCost, MatrixIsTheHessianOfABentSkinWithoutElastomer) {
  CellModel model = builtInCellModel("hex-bma150");
  model.bend_sigma_rad = model.twist_sigma_rad = model.yaw_sigma_rad = 1e6;
  for (const GapShare& gap : kGaps) expectHessian(exactRing(model, gap.mean), gap, 1e-9);
}

/// What one cell's readings alone add to the matrix, of all unknowns and with the cell's own place free.
Eigen::MatrixXd informationOfReadings(const GlobalProblem& problem, const GlobalState& state, std::size_t cell) {
  GlobalProblem alone = problem;
  alone.links.clear();
  alone.origin = cell == 0 ? 1 : 0;
  for (std::size_t other = 0; other < alone.readings.size(); ++other) {
    if (other != cell) alone.readings[other].clear();
  }
  return denseMatrix(alone, linearized(alone, state));
}

TEST(GlobalCost, MatrixWithMountingHasATurnOfEveryChipEliminated) {
  GlobalCase example = simulatedCase(test::skinOptions("ring8:closed", "", 3), 3, kFitGap);
  GlobalProblem& problem = example.problem;
  problem.accelerations = true;
  problem.readings[4].clear();
  const GlobalState state = perturbed(problem, example.truth, 0.02, 0.0005, 7);
  const NormalEquations straight = linearized(problem, state);
  Eigen::MatrixXd expected = denseMatrix(problem, straight);
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    const Eigen::MatrixXd of_cell = informationOfReadings(problem, state, cell);
    const auto turn = static_cast<Eigen::Index>(6 * cell + 3);
    Eigen::MatrixXd rows = of_cell.middleRows<3>(turn);
    Eigen::Matrix3d information = rows.middleCols<3>(turn);
    information.diagonal().array() += std::pow(example.model->mounting_sigma_rad, -2);
    if (cell == problem.origin) rows.middleCols<6>(turn - 3).setZero();
    expected -= rows.transpose() * information.ldlt().solve(rows);
  }
  problem.with_mounting = true;
  const NormalEquations askew = linearized(problem, state);
  const Eigen::VectorXd scale = scaleOf(expected);
  const Eigen::MatrixXd error = scale.asDiagonal() * (denseMatrix(problem, askew) - expected) * scale.asDiagonal();
  EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(askew.cost, straight.cost);
  EXPECT_EQ(gradientOf(askew), gradientOf(straight));
}

TEST(GlobalCost, ExactLinksAndReadingsCostOnlyWhatTheElastomerPriorAsks) {
  CellModel model = builtInCellModel("hex-bma150");
  model.bend_sigma_rad = 0.5;
  model.twist_sigma_rad = model.yaw_sigma_rad = 1e6;
  for (const GapShare& gap : {kPivotGap, kArcGap}) {
    GlobalCase example = exactRing(model, gap.mean);
    example.problem.gap = gap;
    addExactReadings(example, {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()});
    EXPECT_NEAR(closureCost(example.problem, example.truth), 0, 1e-18);
    const double deviation = 45 * kDegree / 0.5;
    EXPECT_NEAR(jointCost(example.problem, example.truth), 8 * deviation * deviation / 2, 1e-9);
  }
}

}  // namespace
}  // namespace hexoderm
