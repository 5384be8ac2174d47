#pragma once

#include "hexoderm/base/error.h"
#include "hexoderm/solve/global/global_cost.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace hexoderm {

class BorderedFactor;

/// The inverse of the information matrix at the optimum: how uncertain every unknown is, and how they depend on each
/// other. Keeps the factor, so that the covariance of any two cells can still be asked for. The rest is computed when
/// it is first asked for: of several solutions in a row only the last one's is. May be read by several threads.
class GlobalCovariance {
 public:
  /// Where and how the factor was made, to make it once more.
  struct FactorOrigin {
    GlobalState state;
    double damping = 0;
  };
  GlobalCovariance(const GlobalProblem& problem, std::shared_ptr<BorderedFactor> factor, FactorOrigin made);

  /// 6 x 6 per cell: position in the patch frame, then rotation (R_true = R exp(e)); zero for the origin.
  [[nodiscard]] const Matrix6d& cell(std::size_t cell) const { return parts().cells[cell]; }
  /// Cross-covariance of a link's two cells, rows c, columns n.
  [[nodiscard]] const Matrix6d& link(std::size_t link) const { return parts().links[link]; }
  /// Cross-covariance of any two cells, rows a, columns b. Two triangular solves each.
  [[nodiscard]] Matrix6d between(std::size_t a, std::size_t b) const;
  /// The covariance of all cells, 6 N x 6 N in the order of cell() with the origin's rows and columns zero, times B
  /// (6 N x m). Takes a solution with the factor.
  [[nodiscard]] Eigen::MatrixXd timesCells(Eigen::MatrixXd B) const;
  /// Covariance of the specific forces of two poses, patch frame, g^2, rows a, columns b: the sensors' errors are the
  /// same in all poses.
  [[nodiscard]] Eigen::Matrix3d forces(std::size_t a, std::size_t b) const;
  /// Covariance of the angular acceleration of a pose, patch frame, (rad/s^2)^2; only if they are estimated.
  [[nodiscard]] Eigen::Matrix3d acceleration(std::size_t pose) const;
  [[nodiscard]] Eigen::Vector4d lotSigmas() const;  ///< of BorderLayout::lot(); only if it is estimated
  [[nodiscard]] double gapShareSigma() const;       ///< 0 if it is not estimated

  /// Computes what is to be asked for often, and gives back the factor, which is most of the memory: between() and
  /// timesCells() make it once more from the problem, the same to the last bit, when they are first called. `problem`:
  /// that of the solution, which must not change any more; it has to keep its model alive. After
  /// GlobalSolver::releaseWorkspace() the factor's memory serves for what is computed: nobody else may ask anything
  /// while the first call goes on.
  void keepProblemInstead(std::shared_ptr<const GlobalProblem> problem) const;

 private:
  struct Parts {
    std::vector<Matrix6d> cells;
    std::vector<Matrix6d> links;
  };

  [[nodiscard]] std::shared_ptr<BorderedFactor> factor() const;
  [[nodiscard]] std::shared_ptr<BorderedFactor> finishedFactor() const;
  /// The finished factor, which is made from the problem when it is needed again.
  [[nodiscard]] std::shared_ptr<BorderedFactor> givenUpFactor(
      const std::shared_ptr<const GlobalProblem>& problem) const;
  /// Under the lock.
  const std::shared_ptr<BorderedFactor>& knownFactor() const;
  const Eigen::MatrixXd& border() const;
  [[nodiscard]] const Parts& parts() const;
  /// A factor that nobody else has is used up.
  [[nodiscard]] Parts compute(std::shared_ptr<BorderedFactor> factor) const;

  std::size_t origin_;
  std::size_t cells_;
  BorderLayout layout_;
  bool estimates_gap_share_;
  std::vector<std::pair<std::size_t, std::size_t>> link_ends_;
  std::shared_ptr<const EliminationPlan> plan_;
  FactorOrigin made_;
  mutable std::mutex factor_mutex_;
  mutable std::shared_ptr<const GlobalProblem> problem_;  ///< where there may be no factor
  mutable std::shared_ptr<BorderedFactor> factor_;        ///< null: to be made from the problem
  mutable std::once_flag computed_;
  mutable Parts parts_;
  mutable std::once_flag border_computed_;
  mutable Eigen::MatrixXd border_;
};

/// The second-order model of jointCost() about a state (Gauss-Newton), factorised: sensors and cells are eliminated
/// first, as a sparse matrix with 6 x 6 blocks for the cells, and a dense one of the unknowns of all poses, the lot and
/// the gap share is left. Serves all problems with the same cells, links and model of accelerometers, one after the
/// other, and keeps its memory between them. Equations are large, so there are those of one state at a time: where a
/// candidate is refused, those of the state before are made once more.
class GlobalSystem {
 public:
  /// Models the cost about a candidate for the next state; the cost there, which may be NaN.
  double linearize(const GlobalProblem& problem, const GlobalState& candidate);
  /// From now on the candidate's model counts.
  void accept();
  /// With the diagonal raised by `damping` times itself. False, and no factor: not positive definite.
  bool factorize(double damping);
  /// The step that takes the gradient away, by the latest factor; the latest model must have been accepted, or the
  /// factor made since. Returns by how much it promises to lower the cost.
  double step(Eigen::VectorXd& cells, Eigen::VectorXd& border) const;
  /// From the latest factor, which takes no further step(). While somebody keeps it, the next one is made in other
  /// memory.
  std::shared_ptr<const GlobalCovariance> inverse();

 private:
  const GlobalProblem* problem_ = nullptr;  ///< the latest
  std::shared_ptr<BorderedFactor> factor_;
  GlobalCovariance::FactorOrigin made_;
  NormalEquations equations_;
  bool of_state_ = false;  ///< the equations are whole, and those of the state
  GlobalState state_;
  GlobalState candidate_;
};

/// The covariances of all cells at a given state (GlobalCovariance::cell()), by the least memory that they take. Throws
/// Error if its information matrix is not positive definite, which priors prevent.
std::vector<Matrix6d> cellCovariancesAt(const GlobalProblem& problem, const GlobalState& state);

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
