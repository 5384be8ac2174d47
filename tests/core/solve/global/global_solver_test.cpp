#include "hexoderm/solve/global/global_solver.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/procrustes.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/core/solve/global/joint_case.h"
#include "tests/support/matchers.h"
#include "tests/support/options.h"
#include "tests/support/pin_jointed_skin.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace hexoderm {
namespace {

/// Largest deviations from the truth, aligned as in compareToTruth().
struct Deviation {
  double position_m = 0;
  double orientation_rad = 0;
};
Deviation deviationOf(const GlobalState& estimate, const GlobalState& truth) {
  std::vector<Eigen::Vector3d> true_t;
  std::vector<Eigen::Vector3d> t;
  std::vector<Eigen::Matrix3d> turns;
  for (std::size_t cell = 0; cell < truth.cells.size(); ++cell) {
    true_t.push_back(truth.cells[cell].t);
    t.push_back(estimate.cells[cell].t);
    turns.push_back(truth.cells[cell].R * estimate.cells[cell].R.transpose());
  }
  const SE3 T = alignPoints(true_t, t);
  const Eigen::Matrix3d turn = chordalMean(turns);
  Deviation worst;
  for (std::size_t cell = 0; cell < truth.cells.size(); ++cell) {
    worst.position_m = std::max(worst.position_m, (T * t[cell] - true_t[cell]).norm());
    worst.orientation_rad =
        std::max(worst.orientation_rad, rotationAngle(turn * estimate.cells[cell].R * truth.cells[cell].R.transpose()));
  }
  return worst;
}

TEST(GlobalSolver, ExactDataWithoutPriorsComeBackExactly) {
  CellModel model = independentChips(0);
  model.accelerometer.scale_sigma = model.accelerometer.cross_axis_sigma = 0;
  model.bend_sigma_rad = model.twist_sigma_rad = model.yaw_sigma_rad = 1e6;
  for (const GapShare& gap : {kPivotGap, kArcGap}) {
    for (const std::size_t poses : {2U, 3U, 6U}) {
      for (const bool closed : {false, true}) {
        GlobalCase example =
            closed ? exactRing(model, gap.mean) : exactX17(model, gap.mean, 0.4, 0.15, 0.05, 10 + poses);
        example.problem.gap = gap;
        example.problem.origin = 3;
        addExactReadings(example, orthogonalUps(poses));
        const GlobalSolution solution =
            GlobalSolver().solve(example.problem, perturbed(example.problem, example.truth, 0.05, 0.001, poses));
        const Deviation deviation = deviationOf(solution.state, example.truth);
        const std::string what = std::string(closed ? "ring, " : "x17, ") + nameOf(gap) + ", " + std::to_string(poses);
        EXPECT_LE(deviation.orientation_rad, 1e-6 * kDegree) << what;
        EXPECT_LE(deviation.position_m, 1e-9) << what;
        EXPECT_EQ(solution.termination, GlobalTermination::Converged) << what;
      }
    }
  }
}

/// The covariance by the dense way: the origin's rows taken out, the rest inverted.
Eigen::MatrixXd denseCovariance(const GlobalProblem& problem, const NormalEquations& equations) {
  Eigen::MatrixXd H = denseMatrix(problem, equations);
  // Scaled, so that inverting does not suffer from metres beside radians.
  const Eigen::VectorXd scale = H.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * H * scale.asDiagonal();
  Eigen::MatrixXd C =
      scale.asDiagonal() * scaled.ldlt().solve(Eigen::MatrixXd::Identity(H.rows(), H.rows())) * scale.asDiagonal();
  const auto at = static_cast<Eigen::Index>(6 * problem.origin);
  C.middleRows<6>(at).setZero();
  C.middleCols<6>(at).setZero();
  return C;
}

/// X17 as it lies on the paper's cylinder, its links and readings exact.
GlobalCase exactX17OnCylinder(double share) {
  GlobalCase example = simulatedCase(SimulatedSkinOptions::ideal(), 0, kPivotGap);
  std::vector<SE3>& cells = example.truth.cells;
  const std::vector<SE3> laid = cells;
  // A link's source comes before its target, so this goes from the middle outwards.
  for (const GlobalLink& link : example.problem.links) {
    cells[link.n] = placeByLink(cells[link.c], link, laid[link.c].R.transpose() * laid[link.n].R, share);
  }
  const SE3 T_origin = cells[example.problem.origin].inverse();
  for (SE3& cell : cells) cell = T_origin * cell;
  example.truth.middle_o = middleOf(cells);
  example.truth.gap_share = share;
  return example;
}

TEST(GlobalSolver, DefaultPriorsHardlyPullExactData) {
  // The elastomer's priors pull towards a flat skin by variance x angle / sigma^2, however exact the readings are: they
  // are believed to 3 mg, and with three poses offsets are known by their prior alone.
  const CellModel model = builtInCellModel("hex-bma150");
  const auto bent = [&](double twist_rad, double yaw_rad) {
    return [&model, twist_rad, yaw_rad](double share) {
      return exactX17(model, share, 20 * kDegree, twist_rad, yaw_rad, 3);
    };
  };
  struct Shape {
    const char* name;
    std::function<GlobalCase(double share)> make;
    double limits_deg[3];  // 3 orthogonal poses, 4, 6
  };
  const Shape shapes[] = {
      {"flat", [&](double share) { return exactX17(model, share, 0, 0, 0, 3); }, {1e-6, 1e-6, 1e-6}},
      {"closed ring", [&](double share) { return exactRing(model, share); }, {1e-4, 1e-4, 1e-4}},
      {"on the cylinder", exactX17OnCylinder, {0.04, 0.01, 0.01}},
      {"bent 20 deg", bent(0, 0), {0.02, 0.005, 0.005}},
      {"twisted 3 deg too", bent(3 * kDegree, 0), {0.03, 0.01, 0.01}},
      {"yawed 0.5 deg too", bent(3 * kDegree, 0.5 * kDegree), {0.2, 0.04, 0.03}},
  };
  constexpr std::size_t kPoses[] = {3, 4, 6};
  for (const GapShare& gap : {kPivotGap, kArcGap, kFitGap}) {
    for (const Shape& shape : shapes) {
      for (std::size_t k = 0; k < 3; ++k) {
        GlobalCase example = shape.make(gap.mean);
        example.problem.gap = gap;
        addExactReadings(example, orthogonalUps(kPoses[k]));
        const GlobalSolution solution = GlobalSolver().solve(example.problem, example.truth);
        const Deviation deviation = deviationOf(solution.state, example.truth);
        const std::string what =
            std::string(shape.name) + ", " + nameOf(gap) + ", " + std::to_string(kPoses[k]) + " poses";
        EXPECT_LE(toDegrees(deviation.orientation_rad), shape.limits_deg[k]) << what;
        EXPECT_LE(deviation.position_m, 1e-4) << what;
        RecordProperty(what, std::to_string(toDegrees(deviation.orientation_rad)) + " deg, " +
                                 std::to_string(toMillimetres(deviation.position_m)) + " mm");
      }
    }
  }
}

TEST(GlobalCovariance, IsTheInverseOfTheNormalEquations) {
  for (const char* patch : {"x17", "ring8:closed", "sheet:3x4"}) {
    for (const GapShare& gap : {kFitGap, kArcGap}) {
      for (const bool accelerations : {false, true}) {
        GlobalCase example = simulatedCase(test::skinOptions(patch), 3, gap);
        example.problem.accelerations = accelerations;
        const CellModel of_no_lot = independentChips();
        if (!accelerations) example.problem.model = &of_no_lot;
        // Two links between the same cells add up.
        GlobalLink again = example.problem.links[1];
        std::swap(again.c, again.n);
        std::swap(again.p_c, again.p_n);
        again.R_nom.transposeInPlace();
        example.problem.links.push_back(again);
        NormalEquations equations;
        linearize(example.problem, example.truth, equations);
        const Eigen::MatrixXd C = denseCovariance(example.problem, equations);
        const auto known = GlobalSolver().covarianceAt(example.problem, example.truth);
        const GlobalCovariance& covariance = *known;
        const auto blockOf = [&](std::size_t a, std::size_t b) -> Matrix6d {
          return C.block<6, 6>(static_cast<Eigen::Index>(6 * a), static_cast<Eigen::Index>(6 * b));
        };
        const std::size_t count = example.problem.cellCount();
        const auto expectNear = [&](const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected,
                                    const std::string& what) {
          EXPECT_LE((actual - expected).norm(), 1e-9 * expected.norm()) << patch << ", " << nameOf(gap) << ", " << what;
        };
        for (std::size_t a = 0; a < count; ++a) {
          expectNear(covariance.cell(a), blockOf(a, a), "cell " + std::to_string(a));
          for (std::size_t b = 0; b < count; ++b) {
            // Relative to what correlation 1 would be: a nearly independent pair's block is small.
            const double full = std::sqrt(blockOf(a, a).norm() * blockOf(b, b).norm());
            EXPECT_LE((covariance.between(a, b) - blockOf(a, b)).norm(), 1e-9 * full)
                << patch << ", cells " << a << " and " << b;
          }
        }
        const auto rows = static_cast<Eigen::Index>(6 * count);
        expectNear(covariance.timesCells(Eigen::MatrixXd::Identity(rows, rows)), C.topLeftCorner(rows, rows), "all");
        for (std::size_t k = 0; k < example.problem.links.size(); ++k) {
          const GlobalLink& link = example.problem.links[k];
          expectNear(covariance.link(k), blockOf(link.c, link.n), "link " + std::to_string(k));
        }
        const BorderLayout layout(example.problem);
        const auto border = static_cast<Eigen::Index>(6 * count);
        for (std::size_t pose = 0; pose < example.problem.poses; ++pose) {
          const auto forcesOf = [&](std::size_t a, std::size_t b) -> Eigen::Matrix3d {
            return C.block<3, 3>(border + layout.force(a), border + layout.force(b));
          };
          for (std::size_t other = 0; other < example.problem.poses; ++other) {
            const double full = std::sqrt(forcesOf(pose, pose).norm() * forcesOf(other, other).norm());
            EXPECT_LE((covariance.forces(pose, other) - forcesOf(pose, other)).norm(), 1e-9 * full)
                << patch << ", poses " << pose << " and " << other;
          }
          if (!accelerations) continue;
          const Eigen::Index at = border + layout.acceleration(pose);
          expectNear(covariance.acceleration(pose), C.block<3, 3>(at, at), "pose " + std::to_string(pose));
        }
        if (example.problem.estimatesLot()) {
          const Eigen::Vector4d variances = C.diagonal().segment<4>(border + layout.lot());
          expectNear(covariance.lotSigmas().cwiseAbs2(), variances, "lot");
        }
        const Eigen::Index share = border + layout.gapShare();
        EXPECT_NEAR(covariance.gapShareSigma(), gap.sigma ? std::sqrt(C(share, share)) : 0, 1e-9);
      }
    }
  }
}

TEST(PlacementCovariance, RelativeCovariancesAgreeWithTheStatedOnes) {
  const auto result =
      reconstruct(*test::simulatedSession(test::skinOptions("sheet:4x4", "cylinder:r=0.06"), 3).snapshot());
  const PatchReconstruction& patch = result->patches.front();
  ASSERT_NE(patch.covariance, nullptr);
  for (const CellPlacement& a : patch.cells) {
    const Matrix6d from_origin = patch.covariance->relative(patch.origin, a.cell);
    EXPECT_LE((from_origin - *a.cov_t_r).norm(), 1e-9 * a.cov_t_r->norm()) << "cell " << a.cell;
    for (const CellPlacement& b : patch.cells) {
      const Matrix6d C = patch.covariance->relative(a.cell, b.cell);
      EXPECT_LE((C - C.transpose()).norm(), 1e-9 * C.norm());
      // T_b_a = T_a_b^-1: its errors are -R_b_a e_t + [t_b_a]x e_r and -R_a_b e_r.
      const SE3 T_a_b = a.T_o_u.inverse() * b.T_o_u;
      const SE3 T_b_a = T_a_b.inverse();
      Matrix6d swap = Matrix6d::Zero();
      swap.topLeftCorner<3, 3>() = -T_b_a.R;
      swap.topRightCorner<3, 3>() = skew(T_b_a.t);
      swap.bottomRightCorner<3, 3>() = -T_a_b.R;
      const Matrix6d swapped = patch.covariance->relative(b.cell, a.cell);
      EXPECT_LE((swap * C * swap.transpose() - swapped).norm(), 1e-8 * swapped.norm())
          << "cells " << a.cell << " and " << b.cell;
    }
  }
  EXPECT_THROW(static_cast<void>(patch.covariance->relative(patch.origin, CellId(999))), InvalidArgument);
}

/// Finite, symmetric, positive semi-definite covariances of finite placements.
void expectSane(const GlobalProblem& problem, const GlobalSolution& solution, const std::string& what) {
  EXPECT_TRUE(std::isfinite(solution.cost)) << what;
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    const SE3& T = solution.state.cells[cell];
    EXPECT_TRUE(T.t.allFinite() && T.R.allFinite()) << what << ", cell " << cell;
    EXPECT_LT((T.R * T.R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12) << what;
    const Matrix6d& C = solution.covariance->cell(cell);
    ASSERT_TRUE(C.allFinite()) << what << ", cell " << cell;
    EXPECT_LE((C - C.transpose()).norm(), 1e-12 * C.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(C, Eigen::EigenvaluesOnly);
    EXPECT_GE(solver.eigenvalues().minCoeff(), -1e-12 * C.norm()) << what << ", cell " << cell;
  }
  for (std::size_t k = 0; k < problem.links.size(); ++k) EXPECT_TRUE(solution.covariance->link(k).allFinite()) << what;
  for (std::size_t pose = 0; pose < problem.poses; ++pose) {
    EXPECT_TRUE(solution.covariance->forces(pose, pose).allFinite()) << what << ", pose " << pose;
    EXPECT_NEAR(solution.state.force_o[pose].norm(), 1, 0.05) << what;
  }
  EXPECT_TRUE(std::isfinite(solution.covariance->gapShareSigma())) << what;
}

/// Standard deviation of the cell's rotation about its worst axis.
double worstTurn(const GlobalSolution& solution, std::size_t cell) {
  const Eigen::Matrix3d C = solution.covariance->cell(cell).bottomRightCorner<3, 3>();
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(C).eigenvalues().maxCoeff());
}

TEST(GlobalSolver, PosesThatSayLittleLeaveLargeUncertainties) {
  const Eigen::Vector3d up(0.3, 0.2, 0.9);
  struct Poses {
    const char* name;
    std::vector<Eigen::Vector3d> ups;
    double least_turn;
    double most_turn;
  };
  const Poses all[] = {{"no poses", {}, 59.9 * kDegree, 60.1 * kDegree},
                       {"one pose", {up}, 2 * kDegree, 60 * kDegree},
                       {"parallel", {up, up}, 2 * kDegree, 60 * kDegree},
                       {"opposite", {up, -up}, 2 * kDegree, 60 * kDegree},
                       {"three", {up, {1, 0, -0.3}, {0.1, -1, 0}}, 0, 2 * kDegree}};
  const CellModel model = builtInCellModel("hex-bma150");
  for (const GapShare& gap : {kPivotGap, kArcGap, kFitGap}) {
    for (const Poses& poses : all) {
      for (const bool closed : {false, true}) {
        for (const bool accelerations : {false, true}) {
          GlobalCase example = closed ? exactRing(model, gap.mean) : exactX17(model, gap.mean, 0.3, 0.05, 0.02, 3);
          example.problem.gap = gap;
          example.problem.accelerations = accelerations;
          addExactReadings(example, poses.ups);
          const GlobalSolution solution =
              GlobalSolver().solve(example.problem, perturbed(example.problem, example.truth, 0.1, 0.001, 9));
          const std::string what = std::string(poses.name) + ", " + nameOf(gap) + (closed ? ", ring" : ", x17");
          expectSane(example.problem, solution, what);
          if (closed) continue;
          EXPECT_GT(worstTurn(solution, 4), poses.least_turn) << what;
          EXPECT_LT(worstTurn(solution, 4), poses.most_turn) << what;
        }
      }
    }
  }
}

TEST(GlobalSolver, APoseThatNoCellReadsAnyMoreStaysUnknown) {
  // This happens when the only cell that was measured in a pose is left out.
  GlobalCase example = simulatedCase(test::skinOptions("x17"), 4, kFitGap);
  GlobalCase fewer = simulatedCase(test::skinOptions("x17"), 3, kFitGap);
  for (auto& readings : example.problem.readings) readings.pop_back();
  const GlobalSolution solution = GlobalSolver().solve(example.problem, example.truth);
  expectSane(example.problem, solution, "pose without readings");
  // Its length is still about 1 g; its direction is anyone's guess.
  EXPECT_GT(solution.covariance->forces(3, 3).trace(), 100);
  const GlobalSolution without = GlobalSolver().solve(fewer.problem, fewer.truth);
  EXPECT_NEAR(solution.cost, without.cost, 1e-9 * without.cost);
  EXPECT_LT(deviationOf(solution.state, without.state).position_m, 1e-9);
}

TEST(GlobalSolver, TheStartDoesNotMatter) {
  GlobalCase example = simulatedCase(test::skinOptions("sheet:5x5", "cylinder:r=0.06"), 3, kFitGap);
  const GlobalSolution near = GlobalSolver().solve(example.problem, example.truth);
  // The way is long if most links are beyond the loss's threshold.
  const auto patient = test::with(&GlobalSolverOptions::max_iterations, 300);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const GlobalSolution far =
        GlobalSolver().solve(example.problem, perturbed(example.problem, example.truth, 0.2, 0.005, seed), patient);
    EXPECT_NEAR(far.cost, near.cost, 1e-7 * near.cost) << "seed " << seed;
    EXPECT_LT(deviationOf(far.state, near.state).position_m, 1e-6) << "seed " << seed;
    EXPECT_EQ(far.termination, GlobalTermination::Converged) << "seed " << seed;
  }
}

TEST(GlobalSolver, StopsWhereItIsWhenAsked) {
  const GlobalCase example = simulatedCase(test::skinOptions("x17"), 3, kFitGap);
  std::stop_source source;
  source.request_stop();
  const GlobalState start = perturbed(example.problem, example.truth, 0.1, 0.001, 3);
  const GlobalSolution solution =
      GlobalSolver().solve(example.problem, start, test::with(&GlobalSolverOptions::stop, source.get_token()));
  EXPECT_EQ(solution.termination, GlobalTermination::Stopped);
  EXPECT_EQ(solution.iterations, 0);
  EXPECT_EQ(solution.state.cells[4].t, start.cells[4].t);
  EXPECT_EQ(solution.covariance, nullptr) << "nobody waits for it";
  EXPECT_EQ(
      GlobalSolver().solve(example.problem, start, test::with(&GlobalSolverOptions::max_iterations, 1)).termination,
      GlobalTermination::StepLimit);
}

}  // namespace
}  // namespace hexoderm
