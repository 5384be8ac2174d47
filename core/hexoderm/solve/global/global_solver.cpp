#include "hexoderm/solve/global/global_solver.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace hexoderm {
namespace {

/// By how much less the cost need not be. The cost is the logarithm of a probability: a hundredth of it moves the
/// estimate by a tenth of its standard deviation at most, in one direction of all. Of a small cost it is a share.
double negligible(double cost) {
  constexpr double kNats = 0.01;
  constexpr double kShare = 1e-6;
  return std::min(kNats, kShare * cost);
}
/// A refused step that promised no more than so many times that has shown that the valley is crooked at its bottom.
constexpr double kTimesNegligible = 10;

}  // namespace

std::shared_ptr<const GlobalCovariance> GlobalSolver::covarianceAt(const GlobalProblem& problem,
                                                                   const GlobalState& state) {
  system_.linearize(problem, state);
  system_.accept();
  factorizeWithLeastDamping([&](double least) { return system_.factorize(least); });
  auto covariance = system_.inverse();
  releaseWorkspace();
  return covariance;
}

bool GlobalSolver::descend(const GlobalProblem& problem, Refusal refusal, End end, const GlobalSolverOptions& options,
                           GlobalSolution& solution) {
  // Below this the cost is rounding: residuals of a millionth of a standard deviation.
  constexpr double kNoCost = 1e-14;
  constexpr double kFirstDamping = 1e-4;
  constexpr double kLargestDamping = 1e12;
  constexpr double kLittle = 1e-3;

  solution.cost = system_.linearize(problem, solution.state);
  system_.accept();
  solution.termination = GlobalTermination::StepLimit;
  Eigen::VectorXd cells;
  Eigen::VectorXd border;
  double damping = 0;
  double promised_undamped = std::numeric_limits<double>::infinity();
  bool factor_is_at_optimum = false;
  bool settled = false;  // the last step changed so little that its matrix still serves
  bool crooked = false;  // steps that promise hardly anything have been refused
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    if (options.stop.stop_requested()) {
      solution.termination = GlobalTermination::Stopped;
      break;
    }
    ++solution.iterations;
    bool lowered = false;
    if (settled || system_.factorize(damping)) {
      const double promised = system_.step(cells, border);
      if (damping == 0) promised_undamped = promised;
      GlobalState next = moved(problem, solution.state, cells, border);
      const double little = crooked ? negligible(solution.cost) : 0;
      // Damped steps promise little even far from the optimum. The last undamped one is too small to be looked at
      // again.
      if (damping == 0 && promised <= std::max(options.cost_tolerance * solution.cost + kNoCost, little)) {
        solution.state = std::move(next);
        solution.cost -= promised;
        solution.termination = GlobalTermination::Converged;
        factor_is_at_optimum = true;
        break;
      }
      const double next_cost = system_.linearize(problem, next);
      lowered = next_cost <= solution.cost;  // false for NaN
      settled = lowered && damping == 0 && solution.cost - next_cost <= kLittle * solution.cost;
      const bool foretold =
          lowered && damping == 0 && next_cost - (solution.cost - promised) <= options.cost_tolerance * next_cost;
      if (lowered) {
        solution.state = std::move(next);
        system_.accept();
        solution.cost = next_cost;
        if (foretold && end == End::WhereForetold) {
          solution.termination = GlobalTermination::Converged;
          break;
        }
      } else if (damping == 0) {
        if (refusal == Refusal::Ends && !(promised <= kLittle * solution.cost)) return false;
        crooked = crooked || promised <= kTimesNegligible * negligible(solution.cost);
      }
    }
    if (damping > kLargestDamping) {
      // No way leads down: the cost's rounding hides the rest, unless the model promised more than that.
      if (promised_undamped <= negligible(solution.cost) + kNoCost) solution.termination = GlobalTermination::Converged;
      break;
    }
    if (!lowered) {
      damping = std::max(kFirstDamping, 10 * damping);
    } else {
      damping = damping > 2 * kFirstDamping ? damping / 5 : 0;
    }
  }
  if (!options.covariance || solution.termination == GlobalTermination::Stopped) return true;
  if (!factor_is_at_optimum) factorizeWithLeastDamping([&](double least) { return system_.factorize(least); });
  solution.covariance = system_.inverse();
  return true;
}

/// If links are open by far more than they allow, as a tree leaves its loops, stiff links would have to be bent round
/// to close them. Soft ones, with the readings, first turn the cells to agree with gravity. Where two poses leave turns
/// that only the links hold, that is not enough: stiff links refuse the first large step, and damped ones creep along a
/// crooked valley, or end beside the optimum. Links that stiffen by and by, with a quadratic loss up to the last,
/// leave a state from which the steps are few. The same goes for links that looked closed and refuse all the same.
GlobalSolution GlobalSolver::solve(const GlobalProblem& problem, const GlobalState& initial,
                                   const GlobalSolverOptions& options) {
  constexpr double kOpen = 6;  // mean square, in link sigmas; 3 is what closed links have
  constexpr double kSoftest = 10;
  constexpr double kStiffening[] = {3, 1};
  const auto softened = [&] {
    GlobalProblem soft = problem;
    soft.loss.threshold = std::numeric_limits<double>::infinity();
    return soft;
  };
  GlobalSolution solution;
  solution.state = initial;
  const bool open = closureCost(softened(), initial) > kOpen * static_cast<double>(problem.links.size());
  const auto descendSoftly = [&](double times, End end, GlobalSolution& from) {
    GlobalSolverOptions roughly = options;
    roughly.cost_tolerance = 1e-2;
    roughly.covariance = false;
    GlobalProblem soft = softened();
    soft.link_sigma_m = times * problem.link_sigma_m;
    descend(soft, Refusal::Damps, end, roughly, from);
  };
  if (open) descendSoftly(kSoftest, End::WhereForetold, solution);
  if (descend(problem, Refusal::Ends, End::AtOptimum, options, solution)) return solution;
  GlobalSolution staged = solution;
  // Every stage has to end at its optimum here: what it leaves, stiffer links would refuse.
  if (!open) descendSoftly(kSoftest, End::AtOptimum, staged);
  for (const double times : kStiffening) descendSoftly(times, End::AtOptimum, staged);
  solution.iterations = staged.iterations;
  // With gross errors among the readings a quadratic loss may lead away.
  if (jointCost(problem, staged.state) < solution.cost) solution.state = std::move(staged.state);
  descend(problem, Refusal::Damps, End::AtOptimum, options, solution);
  return solution;
}

}  // namespace hexoderm
