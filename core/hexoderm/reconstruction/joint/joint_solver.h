#pragma once

#include "hexoderm/reconstruction/joint/joint_cost.h"

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

class JointInverse;  // joint_system.h
class JointSystem;

enum class JointTermination {
  Converged,
  Stopped,
  StepLimit,  ///< not converged: there is a lower cost nearby
};

/// The inverse of the information matrix at the optimum: how uncertain every unknown is, and how they depend on each
/// other. Keeps the factor, so that the covariance of any two cells can still be asked for. The rest is computed when
/// it is first asked for.
class JointCovariance {
 public:
  explicit JointCovariance(std::shared_ptr<const JointInverse> inverse);
  ~JointCovariance();
  JointCovariance(const JointCovariance&) = delete;
  JointCovariance& operator=(const JointCovariance&) = delete;

  /// 6 x 6 per cell: position in the patch frame, then rotation (R_true = R exp(e)); zero for the origin.
  [[nodiscard]] const Matrix6d& cell(std::size_t cell) const;
  /// Cross-covariance of a link's two cells, rows c, columns n.
  [[nodiscard]] const Matrix6d& link(std::size_t link) const;
  /// Cross-covariance of any two cells, rows a, columns b. Two triangular solves each.
  [[nodiscard]] Matrix6d between(std::size_t a, std::size_t b) const;
  /// The covariance of all cells, 6 N x 6 N in the order of cell() with the origin's rows and columns zero, times B
  /// (6 N x m). Takes a solution with the factor.
  [[nodiscard]] Eigen::MatrixXd timesCells(Eigen::MatrixXd B) const;
  /// Covariance of the specific force of a pose, patch frame, g^2.
  [[nodiscard]] Eigen::Matrix3d force(std::size_t pose) const;
  /// Cross-covariance of the specific forces of two poses, rows a, columns b: the sensors' errors are the same in all
  /// poses.
  [[nodiscard]] Eigen::Matrix3d forces(std::size_t a, std::size_t b) const;
  /// Covariance of the angular acceleration of a pose, patch frame, (rad/s^2)^2; only if they are estimated.
  [[nodiscard]] Eigen::Matrix3d acceleration(std::size_t pose) const;
  [[nodiscard]] double gapShareSigma() const;  ///< 0 if it is not estimated

  /// Computes what is to be asked for often, and gives back the factor, which is most of the memory: between() and
  /// timesCells() make it once more from the problem, the same to the last bit, when they are first called. `problem`:
  /// that of the solution, which must not change any more; it has to keep its model alive. After
  /// JointSolver::releaseWorkspace() the factor's memory serves for what is computed: nobody else may ask anything
  /// while the first call goes on.
  void keepProblemInstead(std::shared_ptr<const JointProblem> problem) const;

 private:
  std::shared_ptr<const JointInverse> inverse_;
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
  JointSolver();
  ~JointSolver();
  JointSolver(const JointSolver&) = delete;
  JointSolver& operator=(const JointSolver&) = delete;

  /// Levenberg-Marquardt on jointCost from `initial`: plain Gauss-Newton steps while they lower the cost, damped ones
  /// where they don't; first with softer links where they are far from closed, which stiffen in stages if that is not
  /// enough. Every step solves one linear system.
  JointSolution solve(const JointProblem& problem, const JointState& initial, const JointSolverOptions& options = {});
  /// At a given state, without a step. Throws Error as JointCovariance does.
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
