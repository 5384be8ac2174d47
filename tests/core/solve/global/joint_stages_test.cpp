// The way from the tree's placements to the joint optimum where two poses leave turns that only the links hold: it
// takes few steps, and ends at the optimum.

#include "hexoderm/solve/estimate/patch_solver.h"
#include "hexoderm/solve/global/global_refinement.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/changed_session.h"
#include "tests/support/estimated_links.h"
#include "tests/support/independent_chips.h"
#include "tests/support/options.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/slow_build.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

constexpr int kSide = test::kSlowBuild ? 12 : 35;
const auto kSeeds = test::kSlowBuild ? std::vector{2, 101} : std::vector{2, 5, 6, 101, 102};

/// A skin on a cylinder, of every size the same part of the way around, and a session of it.
struct SimulatedSession {
  SimulatedSession(int side, std::size_t poses, int seed, const CellModel& model = builtInCellModel("hex-bma150"))
      : skin(model,
             test::skinOptions("sheet:" + std::to_string(side) + "x" + std::to_string(side + 1),
                               "cylinder:r=" + std::to_string(0.25 * side / 35), static_cast<std::uint64_t>(seed))),
        session(simulateSession(skin, poses)) {}
  SimulatedSkin skin;
  Session session;
};

/// The same as its joint estimate finds it: the problem, and the tree's placements to start from.
class TreeStart : SimulatedSession {
 public:
  using SimulatedSession::SimulatedSession;
  [[nodiscard]] const GlobalProblem& problem() const { return refinement_.problem(); }
  [[nodiscard]] const GlobalState& state() const { return refinement_.solution().state; }
  /// The same with the true placements.
  [[nodiscard]] GlobalState truth() const {
    GlobalState truth = state();
    for (std::size_t k = 0; k < truth.cells.size(); ++k) {
      truth.cells[k] = skin.truth()[problem().origin].T_b_u.inverse() * skin.truth()[k].T_b_u;
    }
    return truth;
  }

 private:
  [[nodiscard]] std::vector<SE3> placements() const {
    std::vector<SE3> placements;
    for (const TreePlacement& placement : patch_.treePlacements()) placements.push_back(placement.T_o_u);
    return placements;
  }

  test::EstimatedLinks estimated_{session};
  SkinLinks& links_ = estimated_.links;
  std::vector<double> weights_ = linkWeights(links_);
  PatchSolver patch_{links_, weights_, 0};
  GlobalRefinement refinement_{links_.model(), links_.graph(),  links_.table(), estimated_.options,
                               patch_.cells(), patch_.origin(), placements()};
};

/// The cost where a strict solve from the true placements ends, which close the links: no stages are needed.
double strictCost(const TreeStart& start) {
  const auto strict = test::with(&GlobalSolverOptions::cost_tolerance, 1e-12, &GlobalSolverOptions::max_iterations, 300,
                                 &GlobalSolverOptions::covariance, false);
  return GlobalSolver().solve(start.problem(), start.truth(), strict).cost;
}

void expectFewSteps(int side, std::size_t poses, int seed, int most) {
  const TreeStart start(side, poses, seed);
  const GlobalSolution solution =
      GlobalSolver().solve(start.problem(), start.state(), test::with(&GlobalSolverOptions::covariance, false));
  EXPECT_EQ(solution.termination, GlobalTermination::Converged) << "seed " << seed;
  EXPECT_LE(solution.iterations, most) << "seed " << seed;
  EXPECT_LE(solution.cost, strictCost(start) * (1 + 1e-6)) << "seed " << seed;
}

TEST(GlobalStages, FewStepsLeadToTheOptimum) {
  for (const int seed : kSeeds) expectFewSteps(kSide, 2, seed, 20);
  for (const int seed : kSeeds) expectFewSteps(kSide, 3, seed, 10);
  // Links that look closed and refuse the first step.
  for (const int seed : {5, 6, 7}) expectFewSteps(12, 3, seed, 10);
}

TEST(GlobalStages, GrossErrorsDoNotLeadTheStagesAway) {
  // Of a lot, whose offset two directions hardly tell from gravity's, such readings would have to be out first.
  const TreeStart start(kSide, 2, 101, independentChips());
  GlobalProblem problem = start.problem();
  for (std::size_t cell = 7; cell < problem.cellCount(); cell += 50) problem.readings[cell][1].y_g *= -1;
  // Readings that are wrong, but not yet freed, leave a long valley to the last digits: what counts is where it ends.
  const auto options = test::with(&GlobalSolverOptions::covariance, false, &GlobalSolverOptions::max_iterations, 300);
  const GlobalSolution solution = GlobalSolver().solve(problem, start.state(), options);
  const double reference = GlobalSolver().solve(problem, start.truth(), options).cost;
  EXPECT_EQ(solution.termination, GlobalTermination::Converged);
  EXPECT_LE(solution.cost, reference * (1 + 1e-6));
}

/// In a solve such readings are found and left out, after which few steps are left.
TEST(GlobalStages, ASolveWithGrossErrorsConverges) {
  for (const std::size_t poses : {2U, 3U}) {
    for (const int seed : kSeeds) {
      const SimulatedSession simulated(kSide, poses, seed);
      const Session session = changed(simulated.session, [](std::size_t pose, GravitySample& sample) {
        if (pose == 1 && sample.cell.value() % 50 == 8) sample.mean_g.y() *= -1;
      });
      const auto result = reconstruct(*session.snapshot());
      EXPECT_THAT(result->findings, Not(Contains(Field(&Finding::code, FindingCode::NotConverged))))
          << poses << " poses, seed " << seed;
      EXPECT_THAT(result->findings, Not(IsEmpty())) << poses << " poses, seed " << seed;
    }
  }
}

}  // namespace
}  // namespace hexoderm
