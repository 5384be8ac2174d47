#include "hexoderm/solve/global/global_system.h"

#include "hexoderm/base/parallel.h"
#include "hexoderm/solve/global/elimination_plan.h"
#include "hexoderm/solve/sparse/block_cholesky.h"

#include <Eigen/Cholesky>
#include <cassert>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::size_t kAtOnce = 512;

std::shared_ptr<const EliminationPlan> planOf(const GlobalProblem& problem) {
  return problem.elimination ? problem.elimination : planElimination(problem);
}

/// The covariances of all cells from their blocks of the sparse matrix's inverse.
std::vector<Matrix6d> withBorder(std::vector<Matrix6d> cells, const RightHandSides& border_root, std::size_t origin) {
  inRanges(cells.size(), kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      const Matrix6d sum = cells[cell] + border_root.product(cell, cell);
      cells[cell] = (sum + sum.transpose()) / 2;
    }
  });
  cells[origin].setZero();
  return cells;
}

}  // namespace

/// The sparse block of the cells with its dense border: A x + E y = a, E^T x + F y = f.
class BorderedFactor {
 public:
  explicit BorderedFactor(std::shared_ptr<const EliminationPlan> plan)
      : plan_(std::move(plan)), factor_(plan_->pattern) {}

  /// With the diagonal raised by `damping` times itself. Of the equations no more than the gradient counts afterwards.
  bool factorize(NormalEquations& equations, double damping) {
    takeBorder(equations);
    return factorizeCells(equations, damping) && factorizeBorder(equations.border, damping);
  }
  /// The same of equations that are not needed again: what comes next gets their memory.
  bool factorizeLast(NormalEquations equations, double damping) {
    takeBorder(equations);
    equations.border_cells.resize(0, 0);
    if (!factorizeCells(equations, damping)) return false;
    equations.cells = LargeVector<Matrix6d>();  // "= {}" would keep the memory
    equations.links = LargeVector<Matrix6d>();
    return factorizeBorder(equations.border, damping);
  }

  /// The step that takes the gradient away.
  void solve(const NormalEquations& equations, Eigen::VectorXd& cells, Eigen::VectorXd& border) const {
    assert(!finished_);
    Eigen::VectorXd right = factor_.orderedVector(-equations.gradient_cells);
    factor_.solveLower(right);
    border = -equations.gradient_border - border_.matrix().transpose() * right;
    if (border.size() > 0) schur_.solveInPlace(border);
    right -= border_.matrix() * border;
    factor_.solveUpper(right);
    cells = factor_.vectorInOwnOrder(right);
  }

  /// After the last solve(): what is asked of the inverse takes the border in another form.
  void finish() {
    if (finished_) return;
    finished_ = true;
    auto matrix = border_.matrix();
    if (matrix.cols() > 0) schur_.matrixU().solveInPlace<Eigen::OnTheRight>(matrix);
    factor_.solveUpper(border_);
    border_ = factor_.inOwnOrder(std::move(border_));
  }
  /// A^-1 E S^-T, with S S^T = F - E^T A^-1 E: the border's part of the cells' covariance is its outer product. Needs
  /// finish().
  [[nodiscard]] const RightHandSides& borderRoot() const {
    assert(finished_);
    return border_;
  }
  /// The cells' factor, to be used up.
  [[nodiscard]] BlockCholesky&& takeCells() { return std::move(factor_); }

  [[nodiscard]] const std::shared_ptr<const EliminationPlan>& plan() const { return plan_; }
  [[nodiscard]] const BlockCholesky& cells() const { return factor_; }
  [[nodiscard]] const Eigen::LLT<Eigen::MatrixXd>& schur() const { return schur_; }

 private:
  void takeBorder(const NormalEquations& equations) {
    border_ = {};  // before there is another
    border_ = factor_.ordered(equations.border_cells);
    finished_ = false;
  }

  bool factorizeCells(NormalEquations& equations, double damping) {
    if (damping > 0) {
      for (Matrix6d& block : equations.cells) block.diagonal() *= 1 + damping;
    }
    LargeVector<Matrix6d> sums;
    return factor_.factorize(equations.cells, plan_->couplesOf(equations.links, sums));
  }

  bool factorizeBorder(Eigen::MatrixXd schur, double damping) {
    factor_.solveLower(border_);
    schur.diagonal() *= 1 + damping;
    if (schur.size() == 0) return true;  // neither a pose nor a gap share to estimate
    schur.triangularView<Eigen::Lower>() -= border_.gram();
    schur_.compute(schur);
    return schur_.info() == Eigen::Success;
  }

  std::shared_ptr<const EliminationPlan> plan_;
  BlockCholesky factor_;
  RightHandSides border_;  // L^-1 E, with L L^T = A, until finish()
  bool finished_ = false;  // border_ is the root
  Eigen::LLT<Eigen::MatrixXd> schur_;
};

GlobalCovariance::GlobalCovariance(const GlobalProblem& problem, std::shared_ptr<BorderedFactor> factor,
                                   FactorOrigin made)
    : origin_(problem.origin),
      cells_(problem.cellCount()),
      layout_(problem),
      estimates_gap_share_(problem.gap.sigma.has_value()),
      link_ends_(problem.links.size()),
      plan_(factor->plan()),
      made_(std::move(made)),
      factor_(std::move(factor)) {
  for (std::size_t k = 0; k < link_ends_.size(); ++k) link_ends_[k] = {problem.links[k].c, problem.links[k].n};
}

Matrix6d GlobalCovariance::between(std::size_t a, std::size_t b) const {
  if (a == origin_ || b == origin_) return Matrix6d::Zero();
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(6 * cells_), 6);
  unit.middleRows<6>(static_cast<Eigen::Index>(6 * b)).setIdentity();
  const std::shared_ptr<const BorderedFactor> factor = finishedFactor();
  factor->cells().solve(unit);
  return unit.middleRows<6>(static_cast<Eigen::Index>(6 * a)) + factor->borderRoot().product(a, b);
}

Eigen::MatrixXd GlobalCovariance::timesCells(Eigen::MatrixXd product) const {
  const auto origin_rows = [this](Eigen::MatrixXd& rows) {
    return rows.middleRows<6>(static_cast<Eigen::Index>(6 * origin_));
  };
  origin_rows(product).setZero();
  const std::shared_ptr<const BorderedFactor> factor = finishedFactor();
  const auto border_root = factor->borderRoot().matrix();
  const Eigen::MatrixXd by_border = border_root.transpose() * product;
  factor->cells().solve(product);
  product.noalias() += border_root * by_border;
  origin_rows(product).setZero();
  return product;
}

Eigen::Matrix3d GlobalCovariance::forces(std::size_t a, std::size_t b) const {
  return border().block<3, 3>(layout_.force(a), layout_.force(b));
}

Eigen::Matrix3d GlobalCovariance::acceleration(std::size_t pose) const {
  const Eigen::Index at = layout_.acceleration(pose);
  return border().block<3, 3>(at, at);
}

Eigen::Vector4d GlobalCovariance::lotSigmas() const {
  return border().diagonal().segment<kLotUnknowns>(layout_.lot()).cwiseSqrt();
}

double GlobalCovariance::gapShareSigma() const {
  return estimates_gap_share_ ? std::sqrt(border()(layout_.gapShare(), layout_.gapShare())) : 0;
}

void GlobalCovariance::keepProblemInstead(std::shared_ptr<const GlobalProblem> problem) const {
  border();
  std::call_once(computed_, [&] { parts_ = compute(givenUpFactor(problem)); });
  const std::lock_guard lock(factor_mutex_);
  problem_ = std::move(problem);
  factor_.reset();
}

std::shared_ptr<BorderedFactor> GlobalCovariance::factor() const {
  const std::lock_guard lock(factor_mutex_);
  return knownFactor();
}

std::shared_ptr<BorderedFactor> GlobalCovariance::finishedFactor() const {
  const std::lock_guard lock(factor_mutex_);
  knownFactor()->finish();
  return factor_;
}

std::shared_ptr<BorderedFactor> GlobalCovariance::givenUpFactor(
    const std::shared_ptr<const GlobalProblem>& problem) const {
  const std::lock_guard lock(factor_mutex_);
  knownFactor()->finish();
  problem_ = problem;
  return std::move(factor_);
}

const std::shared_ptr<BorderedFactor>& GlobalCovariance::knownFactor() const {
  if (factor_ == nullptr) {
    NormalEquations equations;
    linearize(*problem_, made_.state, equations);
    auto again = std::make_shared<BorderedFactor>(plan_);
    if (!again->factorizeLast(std::move(equations), made_.damping)) {
      throw std::logic_error("a factor that was made can't be made");
    }
    factor_ = std::move(again);
  }
  return factor_;
}

const Eigen::MatrixXd& GlobalCovariance::border() const {
  std::call_once(border_computed_, [this] {
    if (layout_.size() > 0) {
      border_ = factor()->schur().solve(Eigen::MatrixXd::Identity(layout_.size(), layout_.size()));
    }
  });
  return border_;
}

const GlobalCovariance::Parts& GlobalCovariance::parts() const {
  std::call_once(computed_, [this] { parts_ = compute(finishedFactor()); });
  return parts_;
}

GlobalCovariance::Parts GlobalCovariance::compute(std::shared_ptr<BorderedFactor> factor) const {
  BlockCholesky::SelectedInverse inverse =
      factor.use_count() == 1 ? factor->takeCells().selectedInverse() : factor->cells().selectedInverse();
  const RightHandSides& border_root = factor->borderRoot();
  Parts parts;
  parts.cells = withBorder(std::move(inverse.diagonal), border_root, origin_);
  parts.links.resize(link_ends_.size());
  inRanges(link_ends_.size(), kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const auto& [c, n] = link_ends_[k];
      if (c == origin_ || n == origin_) {
        parts.links[k].setZero();
        continue;
      }
      const EliminationPlan::Place place = plan_->of_link[k];
      parts.links[k] = border_root.product(c, n);
      if (place.transposed) {
        parts.links[k] += inverse.couples[place.couple].transpose();
      } else {
        parts.links[k] += inverse.couples[place.couple];
      }
    }
  });
  return parts;
}

double GlobalSystem::linearize(const GlobalProblem& problem, const GlobalState& candidate) {
  problem_ = &problem;
  hexoderm::linearize(problem, candidate, equations_);
  of_state_ = false;
  candidate_ = candidate;
  return equations_.cost;
}

void GlobalSystem::accept() {
  std::swap(state_, candidate_);
  of_state_ = true;
}

bool GlobalSystem::factorize(double damping) {
  if (!of_state_) hexoderm::linearize(*problem_, state_, equations_);
  of_state_ = false;
  if (factor_ == nullptr) {
    factor_ = std::make_shared<BorderedFactor>(planOf(*problem_));
  } else if (factor_.use_count() > 1) {
    factor_ = std::make_shared<BorderedFactor>(factor_->plan());
  }
  made_ = {state_, damping};
  return factor_->factorize(equations_, damping);
}

double GlobalSystem::step(Eigen::VectorXd& cells, Eigen::VectorXd& border) const {
  factor_->solve(equations_, cells, border);
  return -(equations_.gradient_cells.dot(cells) + equations_.gradient_border.dot(border)) / 2;
}

std::shared_ptr<const GlobalCovariance> GlobalSystem::inverse() {
  return std::make_shared<GlobalCovariance>(*problem_, factor_, made_);
}

std::vector<Matrix6d> cellCovariancesAt(const GlobalProblem& problem, const GlobalState& state) {
  BorderedFactor factor(planOf(problem));
  factorizeWithLeastDamping([&](double damping) {
    NormalEquations equations;
    linearize(problem, state, equations);
    return factor.factorizeLast(std::move(equations), damping);
  });
  factor.finish();
  return withBorder(factor.takeCells().inverseDiagonal(), factor.borderRoot(), problem.origin);
}

}  // namespace hexoderm
