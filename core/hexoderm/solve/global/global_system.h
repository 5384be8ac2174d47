#pragma once

#include "hexoderm/base/error.h"
#include "hexoderm/solve/global/global_cost.h"

#include <algorithm>
#include <memory>

namespace hexoderm {

/// The inverse of the information matrix at the optimum: how uncertain every unknown is, and how they depend on each
/// other. Keeps the factor, so that the covariance of any two cells can still be asked for. The rest is computed when
/// it is first asked for. May be read by several threads.
class GlobalCovariance {
 public:
  virtual ~GlobalCovariance() = default;

  /// 6 x 6 per cell: position in the patch frame, then rotation (R_true = R exp(e)); zero for the origin.
  [[nodiscard]] virtual const Matrix6d& cell(std::size_t cell) const = 0;
  /// Cross-covariance of a link's two cells, rows c, columns n.
  [[nodiscard]] virtual const Matrix6d& link(std::size_t link) const = 0;
  /// Cross-covariance of any two cells, rows a, columns b. Two triangular solves each.
  [[nodiscard]] virtual Matrix6d between(std::size_t a, std::size_t b) const = 0;
  /// The covariance of all cells, 6 N x 6 N in the order of cell() with the origin's rows and columns zero, times B
  /// (6 N x m). Takes a solution with the factor.
  [[nodiscard]] virtual Eigen::MatrixXd timesCells(Eigen::MatrixXd B) const = 0;
  /// Covariance of the specific force of a pose, patch frame, g^2.
  [[nodiscard]] virtual Eigen::Matrix3d force(std::size_t pose) const = 0;
  /// Cross-covariance of the specific forces of two poses, rows a, columns b: the sensors' errors are the same in all
  /// poses.
  [[nodiscard]] virtual Eigen::Matrix3d forces(std::size_t a, std::size_t b) const = 0;
  /// Covariance of the angular acceleration of a pose, patch frame, (rad/s^2)^2; only if they are estimated.
  [[nodiscard]] virtual Eigen::Matrix3d acceleration(std::size_t pose) const = 0;
  [[nodiscard]] virtual double gapShareSigma() const = 0;  ///< 0 if it is not estimated

  /// Computes what is to be asked for often, and gives back the factor, which is most of the memory: between() and
  /// timesCells() make it once more from the problem, the same to the last bit, when they are first called. `problem`:
  /// that of the solution, which must not change any more; it has to keep its model alive. After
  /// GlobalSolver::releaseWorkspace() the factor's memory serves for what is computed: nobody else may ask anything
  /// while the first call goes on.
  virtual void keepProblemInstead(std::shared_ptr<const GlobalProblem> /*problem*/) const {}
};

/// The second-order model of jointCost() about a state (Gauss-Newton), factorised in one order of its unknowns or
/// another: which one costs less is a matter of how many cells and poses there are, and nothing but rounding depends on
/// it. Serves all problems with the same cells, links and model of accelerometers, one after the other, and keeps its
/// memory between them.
class GlobalSystem {
 public:
  virtual ~GlobalSystem() = default;

  /// Models the cost about a candidate for the next state; the cost there, which may be NaN.
  virtual double linearize(const GlobalProblem& problem, const GlobalState& candidate) = 0;
  /// From now on the candidate's model counts.
  virtual void accept() = 0;
  /// With the diagonal raised by `damping` times itself. False, and no factor: not positive definite.
  virtual bool factorize(double damping) = 0;
  /// The step that takes the gradient away, by the latest factor; the latest model must have been accepted, or the
  /// factor made since. Returns by how much it promises to lower the cost.
  virtual double step(Eigen::VectorXd& cells, Eigen::VectorXd& border) const = 0;
  /// From the latest factor, which takes no further step(). While somebody keeps it, the next one is made in other
  /// memory.
  virtual std::shared_ptr<const GlobalCovariance> inverse() = 0;
  /// Gives back the memory that only further solutions would need.
  virtual void releaseWorkspace() = 0;
};

/// Factorises the information matrix at an optimum with as little damping as it takes. Priors keep the matrix positive
/// definite; rounding may not, where hardly anything but priors speaks. `factorize`: bool of the damping. Throws
/// Error if no damping that changes little suffices.
template <class Factorize>
void factorizeWithLeastDamping(Factorize&& factorize) {
  constexpr double kMin = 1e-12;
  constexpr double kLargest = 1e-3;
  double damping = 0;
  while (!factorize(damping)) {
    damping = std::max(kMin, 10 * damping);
    if (damping > kLargest) throw Error("the information matrix is not positive definite");
  }
}

}  // namespace hexoderm
