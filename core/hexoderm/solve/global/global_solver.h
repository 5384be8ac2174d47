#pragma once

#include "hexoderm/solve/global/global_system.h"

#include <memory>
#include <stop_token>

namespace hexoderm {

struct GlobalSolverOptions {
  int max_iterations = 100;  ///< of every stage
  /// A step that promises to lower the cost by less than this share of it is the last. Where steps that promise less
  /// than a tenth of a nat, and 1e-5 of the cost, raise it, the last is one that promises less than a tenth of that.
  double cost_tolerance = 1e-8;
  bool covariance = true;  ///< compute GlobalSolution::covariance
  std::stop_token stop;    ///< checked before every step; the state so far is the result, without covariance
};

enum class GlobalTermination {
  Converged,
  Stopped,
  StepLimit,  ///< not converged: there is a lower cost nearby
};

struct GlobalSolution {
  GlobalState state;
  double cost = 0;
  int iterations = 0;  ///< steps of all stages, refused ones too
  GlobalTermination termination = GlobalTermination::Converged;
  std::shared_ptr<const GlobalCovariance> covariance;  ///< null if it was not asked for or is not due
};

/// Solves one problem after another with the same cells and links, and keeps its memory from one to the next. Memory
/// that a covariance still has is not taken from it.
class GlobalSolver {
 public:
  /// Levenberg-Marquardt on jointCost from `initial`: plain Gauss-Newton steps while they lower the cost, damped ones
  /// where they don't; first with softer links where they are far from closed, which stiffen in stages if that is not
  /// enough. Every step solves one linear system.
  GlobalSolution solve(const GlobalProblem& problem, const GlobalState& initial,
                       const GlobalSolverOptions& options = {});
  /// At a given state, without a step. Throws Error if its information matrix is not positive definite.
  std::shared_ptr<const GlobalCovariance> covarianceAt(const GlobalProblem& problem, const GlobalState& state);
  /// Gives back the memory that only further solutions would need.
  void releaseWorkspace() { system_ = {}; }

 private:
  enum class Refusal {
    Damps,  ///< a step that does not lower the cost is tried again, damped
    Ends,   ///< ... ends the descent where it stands, if the step promised much
  };
  enum class End {
    AtOptimum,
    WhereForetold,  ///< as soon as a step has lowered the cost by what it promised, but for the tolerance
  };
  /// False: ended by a refusal, without covariance.
  bool descend(const GlobalProblem& problem, Refusal refusal, End end, const GlobalSolverOptions& options,
               GlobalSolution& solution);

  GlobalSystem system_;
};

}  // namespace hexoderm
