#pragma once

#include "hexoderm/reconstruction/joint/joint_cost.h"
#include "hexoderm/util/error.h"

#include <algorithm>
#include <memory>

namespace hexoderm {

/// The inverse of a factorised JointSystem's matrix; see JointCovariance. May be read by several threads.
class JointInverse {
 public:
  JointInverse() = default;
  virtual ~JointInverse() = default;
  JointInverse(const JointInverse&) = delete;
  JointInverse& operator=(const JointInverse&) = delete;

  [[nodiscard]] virtual const Matrix6d& cell(std::size_t cell) const = 0;
  [[nodiscard]] virtual const Matrix6d& link(std::size_t link) const = 0;
  [[nodiscard]] virtual Matrix6d between(std::size_t a, std::size_t b) const = 0;
  /// The covariance of all cells, 6 N x 6 N with the origin's rows and columns zero, times B (6 N x m).
  [[nodiscard]] virtual Eigen::MatrixXd timesCells(Eigen::MatrixXd B) const = 0;
  [[nodiscard]] virtual Eigen::Matrix3d force(std::size_t pose) const = 0;
  [[nodiscard]] virtual Eigen::Matrix3d forces(std::size_t a, std::size_t b) const = 0;
  [[nodiscard]] virtual Eigen::Matrix3d acceleration(std::size_t pose) const = 0;  ///< where they are estimated
  [[nodiscard]] virtual double gapShareVariance() const = 0;                       ///< 0 if it is not estimated
  /// See JointCovariance::keepProblemInstead().
  virtual void keepProblemInstead(std::shared_ptr<const JointProblem> /*problem*/) const {}
};

/// The second-order model of jointCost() about a state (Gauss-Newton), factorised in one order of its unknowns or
/// another: which one costs less is a matter of how many cells and poses there are, and nothing but rounding depends on
/// it. Serves all problems with the same cells, links and model of accelerometers, one after the other, and keeps its
/// memory between them.
class JointSystem {
 public:
  JointSystem() = default;
  virtual ~JointSystem() = default;
  JointSystem(const JointSystem&) = delete;
  JointSystem& operator=(const JointSystem&) = delete;

  /// Models the cost about a candidate for the next state; the cost there, which may be NaN.
  virtual double linearize(const JointProblem& problem, const JointState& candidate) = 0;
  /// From now on the candidate's model counts.
  virtual void accept() = 0;
  /// With the diagonal raised by `damping` times itself. False, and no factor: not positive definite.
  virtual bool factorize(double damping) = 0;
  /// The step that takes the gradient away, by the latest factor; the latest model must have been accepted, or the
  /// factor made since. Returns by how much it promises to lower the cost.
  virtual double step(Eigen::VectorXd& cells, Eigen::VectorXd& border) const = 0;
  /// From the latest factor, which takes no further step(). While somebody keeps it, the next one is made in other
  /// memory.
  virtual std::shared_ptr<const JointInverse> inverse() = 0;
  /// Gives back the memory that only further solutions would need.
  virtual void releaseWorkspace() = 0;
};

/// Factorises the information matrix at an optimum with as little damping as it takes. Priors keep the matrix positive
/// definite; rounding may not, where hardly anything but priors speaks. `factorize`: bool of the damping. Throws
/// Error if no damping that changes little suffices.
template <class Factorize>
void factorizeWithLeastDamping(Factorize&& factorize) {
  constexpr double kLeast = 1e-12;
  constexpr double kLargest = 1e-3;
  double damping = 0;
  while (!factorize(damping)) {
    damping = std::max(kLeast, 10 * damping);
    if (damping > kLargest) throw Error("the information matrix is not positive definite");
  }
}

}  // namespace hexoderm
