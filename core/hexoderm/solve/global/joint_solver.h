#pragma once

#include "hexoderm/solve/global/joint_system.h"

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace hexoderm {

/// What is eliminated first in every step. Optimum and covariance are the same but for rounding.
enum class JointOrder {
  CellsFirst,  ///< time grows with the cube of the poses, nearly linearly with the cells
  PosesFirst,  ///< time grows with the cube of the cells, linearly with the poses; without angular accelerations only
};
JointOrder cheaperOrder(const JointProblem& problem);

struct JointSolverOptions {
  int max_iterations = 100;  ///< of every stage
  /// A step that promises to lower the cost by less than this share of it is the last. Where steps that promise less
  /// than a tenth of a nat, and 1e-5 of the cost, raise it, the last is one that promises less than a tenth of that.
  double cost_tolerance = 1e-8;
  bool covariance = true;           ///< compute JointSolution::covariance
  std::optional<JointOrder> order;  ///< absent: cheaperOrder()
  std::stop_token stop;             ///< checked before every step; the state so far is the result, without covariance
};

enum class JointTermination {
  Converged,
  Stopped,
  StepLimit,  ///< not converged: there is a lower cost nearby
};

struct JointSolution {
  JointState state;
  double cost = 0;
  int iterations = 0;  ///< steps of all stages, refused ones too
  JointTermination termination = JointTermination::Converged;
  std::shared_ptr<const JointCovariance> covariance;  ///< null if it was not asked for or is not due
};

/// Solves one problem after another with the same cells and links, and keeps its memory from one to the next. Memory
/// that a covariance still has is not taken from it.
class JointSolver {
 public:
  /// Levenberg-Marquardt on jointCost from `initial`: plain Gauss-Newton steps while they lower the cost, damped ones
  /// where they don't; first with softer links where they are far from closed, which stiffen in stages if that is not
  /// enough. Every step solves one linear system.
  JointSolution solve(const JointProblem& problem, const JointState& initial, const JointSolverOptions& options = {});
  /// At a given state, without a step. Throws Error if its information matrix is not positive definite.
  std::shared_ptr<const JointCovariance> covarianceAt(const JointProblem& problem, const JointState& state);
  /// Gives back the memory that only further solutions would need.
  void releaseWorkspace();

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
  bool descend(const JointProblem& problem, Refusal refusal, End end, const JointSolverOptions& options,
               JointSolution& solution);
  JointSystem& systemFor(JointOrder order);

  JointOrder order_{};  ///< of the system
  std::unique_ptr<JointSystem> system_;
};

/// One solution by a JointSolver of its own.
JointSolution solveJointly(const JointProblem& problem, const JointState& initial,
                           const JointSolverOptions& options = {});

}  // namespace hexoderm
