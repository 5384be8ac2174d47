#include "hexoderm/reconstruction/joint/joint_solver.h"

#include "hexoderm/reconstruction/sparse/block_cholesky.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace hexoderm {
namespace {

/// The block of the sparse matrix that a link adds to: two links may join the same two cells.
struct CouplePlan {
  std::vector<BlockCholesky::Couple> couples;
  struct Place {
    std::size_t couple = 0;
    bool transposed = false;
  };
  std::vector<Place> of_link;

  explicit CouplePlan(const JointProblem& problem) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;
    for (const JointLink& link : problem.links) {
      const auto key = std::minmax(link.c, link.n);
      const auto [place, is_new] = known.emplace(key, couples.size());
      if (is_new) couples.push_back({key.first, key.second});
      of_link.push_back({place->second, link.c != key.first});
    }
  }
};

/// The sparse block of the cells with its dense border: A x + E y = a, E^T x + F y = f.
class BorderedFactor {
 public:
  explicit BorderedFactor(const JointProblem& problem) : plan_(problem), factor_(problem.cellCount(), plan_.couples) {}

  /// With the diagonal raised by `damping` times itself.
  bool factorize(const NormalEquations& equations, double damping) {
    std::vector<Matrix6d> diagonal = equations.cells;
    if (damping > 0) {
      for (Matrix6d& block : diagonal) block.diagonal() *= 1 + damping;
    }
    std::vector<Matrix6d> couples(plan_.couples.size(), Matrix6d::Zero());
    for (std::size_t k = 0; k < equations.links.size(); ++k) {
      const CouplePlan::Place place = plan_.of_link[k];
      if (place.transposed) {
        couples[place.couple] += equations.links[k].transpose();
      } else {
        couples[place.couple] += equations.links[k];
      }
    }
    if (!factor_.factorize(diagonal, couples)) return false;
    lower_border_ = equations.border_cells;
    factor_.solveLower(lower_border_);
    Eigen::MatrixXd schur = equations.border;
    schur.diagonal() *= 1 + damping;
    if (schur.size() == 0) return true;  // neither a pose nor a gap share to estimate
    schur.selfadjointView<Eigen::Lower>().rankUpdate(lower_border_.transpose(), -1);
    schur_.compute(schur);
    return schur_.info() == Eigen::Success;
  }

  /// The step that takes the gradient away.
  void solve(const NormalEquations& equations, Eigen::VectorXd& cells, Eigen::VectorXd& border) const {
    Eigen::MatrixXd right = -equations.gradient_cells;
    factor_.solveLower(right);
    border = -equations.gradient_border - lower_border_.transpose() * right.col(0);
    if (border.size() > 0) schur_.solveInPlace(border);
    right.col(0) -= lower_border_ * border;
    factor_.solveUpper(right);
    cells = right.col(0);
  }

  /// A^-1 E S^-T, with S S^T = F - E^T A^-1 E: the border's part of the cells' covariance is its outer product.
  [[nodiscard]] Eigen::MatrixXd borderRoot() const {
    Eigen::MatrixXd root = lower_border_;
    if (root.cols() == 0) return root;
    schur_.matrixU().solveInPlace<Eigen::OnTheRight>(root);
    factor_.solveUpper(root);
    return root;
  }

  [[nodiscard]] const CouplePlan& plan() const { return plan_; }
  [[nodiscard]] const BlockCholesky& cells() const { return factor_; }
  [[nodiscard]] const Eigen::LLT<Eigen::MatrixXd>& schur() const { return schur_; }

 private:
  CouplePlan plan_;
  BlockCholesky factor_;
  Eigen::MatrixXd lower_border_;  // L^-1 E, with L L^T = A
  Eigen::LLT<Eigen::MatrixXd> schur_;
};

}  // namespace

/// The steps of solveJointly.
struct JointSolver {
  static JointState startingPoint(const JointProblem& problem, const JointState& initial,
                                  const JointSolverOptions& options);
  static JointSolution descend(const JointProblem& problem, const JointState& initial,
                               const JointSolverOptions& options);
};

struct JointCovariance::State {
  std::size_t origin;
  BorderLayout layout;
  bool estimates_gap_share;
  std::unique_ptr<const BorderedFactor> factor;
  Eigen::MatrixXd border_covariance;
  Eigen::MatrixXd border_root;
  std::vector<Matrix6d> cells;
  std::vector<Matrix6d> links;

  State(const JointProblem& problem, std::unique_ptr<const BorderedFactor> factor_at_optimum)
      : origin(problem.origin),
        layout(problem),
        estimates_gap_share(problem.gap.sigma.has_value()),
        factor(std::move(factor_at_optimum)) {
    border_root = factor->borderRoot();
    if (layout.size() > 0) {
      border_covariance = factor->schur().solve(Eigen::MatrixXd::Identity(layout.size(), layout.size()));
    }
    const BlockCholesky::SelectedInverse inverse = factor->cells().selectedInverse();
    cells.resize(problem.cellCount());
    for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
      cells[cell].setZero();
      if (cell == origin) continue;
      cells[cell] = inverse.diagonal[cell] + borderPart(cell, cell);
      cells[cell] = (cells[cell] + cells[cell].transpose()).eval() / 2;
    }
    links.assign(problem.links.size(), Matrix6d::Zero());
    for (std::size_t k = 0; k < links.size(); ++k) {
      const JointLink& link = problem.links[k];
      if (link.c == origin || link.n == origin) continue;
      const CouplePlan::Place place = factor->plan().of_link[k];
      links[k] = borderPart(link.c, link.n);
      if (place.transposed) {
        links[k] += inverse.couples[place.couple].transpose();
      } else {
        links[k] += inverse.couples[place.couple];
      }
    }
  }

  [[nodiscard]] Matrix6d borderPart(std::size_t a, std::size_t b) const {
    return border_root.middleRows<6>(static_cast<Eigen::Index>(6 * a)) *
           border_root.middleRows<6>(static_cast<Eigen::Index>(6 * b)).transpose();
  }
};

JointCovariance::JointCovariance(const JointProblem& problem, const NormalEquations& equations) {
  auto factor = std::make_unique<BorderedFactor>(problem);
  // Priors keep the matrix positive definite; rounding may not, where hardly anything but priors speaks.
  double damping = 0;
  while (!factor->factorize(equations, damping)) {
    constexpr double kLeast = 1e-12;
    constexpr double kLargest = 1e-3;
    damping = std::max(kLeast, 10 * damping);
    if (damping > kLargest) throw std::runtime_error("the information matrix is not positive definite");
  }
  state_ = std::make_unique<State>(problem, std::move(factor));
}
JointCovariance::JointCovariance(std::unique_ptr<State> state) : state_(std::move(state)) {}
JointCovariance::~JointCovariance() = default;

const Matrix6d& JointCovariance::cell(std::size_t cell) const { return state_->cells[cell]; }
const Matrix6d& JointCovariance::link(std::size_t link) const { return state_->links[link]; }

Matrix6d JointCovariance::between(std::size_t a, std::size_t b) const {
  if (a == state_->origin || b == state_->origin) return Matrix6d::Zero();
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(6 * state_->cells.size()), 6);
  unit.middleRows<6>(static_cast<Eigen::Index>(6 * b)).setIdentity();
  state_->factor->cells().solve(unit);
  return unit.middleRows<6>(static_cast<Eigen::Index>(6 * a)) + state_->borderPart(a, b);
}

Eigen::Matrix3d JointCovariance::force(std::size_t pose) const {
  const Eigen::Index at = state_->layout.force(pose);
  return state_->border_covariance.block<3, 3>(at, at);
}

Eigen::Matrix3d JointCovariance::acceleration(std::size_t pose) const {
  const Eigen::Index at = state_->layout.acceleration(pose);
  return state_->border_covariance.block<3, 3>(at, at);
}

double JointCovariance::gapShareSigma() const {
  if (!state_->estimates_gap_share) return 0;
  const Eigen::Index at = state_->layout.gapShare();
  return std::sqrt(state_->border_covariance(at, at));
}

JointSolution JointSolver::descend(const JointProblem& problem, const JointState& initial,
                                   const JointSolverOptions& options) {
  // Below this the cost is rounding: residuals of a millionth of a standard deviation.
  constexpr double kNoCost = 1e-14;
  constexpr double kFirstDamping = 1e-4;
  constexpr double kLargestDamping = 1e12;
  constexpr double kLittle = 1e-3;

  JointSolution solution;
  solution.state = initial;
  auto factor = std::make_unique<BorderedFactor>(problem);
  NormalEquations equations;
  NormalEquations next_equations;
  linearize(problem, solution.state, equations);
  solution.cost = equations.cost;
  solution.termination = JointTermination::StepLimit;
  Eigen::VectorXd cells;
  Eigen::VectorXd border;
  double damping = 0;
  bool factor_is_at_optimum = false;
  bool settled = false;  // the last step changed so little that its matrix still serves
  while (solution.iterations < options.max_iterations) {
    if (options.stop.stop_requested()) {
      solution.termination = JointTermination::Stopped;
      break;
    }
    ++solution.iterations;
    bool lowered = false;
    if (settled || factor->factorize(equations, damping)) {
      factor->solve(equations, cells, border);
      const double promised = -(equations.gradient_cells.dot(cells) + equations.gradient_border.dot(border)) / 2;
      JointState next = moved(problem, solution.state, cells, border);
      // Damped steps promise little even far from the optimum. The last undamped one is too small to be looked at
      // again.
      if (damping == 0 && promised <= options.cost_tolerance * equations.cost + kNoCost) {
        solution.state = std::move(next);
        solution.cost = equations.cost - promised;
        solution.termination = JointTermination::Converged;
        factor_is_at_optimum = true;
        break;
      }
      linearize(problem, next, next_equations);
      lowered = next_equations.cost <= equations.cost;  // false for NaN
      settled = lowered && damping == 0 && equations.cost - next_equations.cost <= kLittle * equations.cost;
      if (lowered) {
        solution.state = std::move(next);
        std::swap(equations, next_equations);
        solution.cost = equations.cost;
      }
    }
    if (damping > kLargestDamping) {
      solution.termination = JointTermination::Converged;
      break;
    }
    if (!lowered) {
      damping = std::max(kFirstDamping, 10 * damping);
    } else {
      damping = damping > 2 * kFirstDamping ? damping / 5 : 0;
    }
  }
  if (!options.covariance || solution.termination == JointTermination::Stopped) return solution;
  if (factor_is_at_optimum) {
    solution.covariance.reset(
        new JointCovariance(std::make_unique<JointCovariance::State>(problem, std::move(factor))));
  } else {
    solution.covariance = std::make_shared<JointCovariance>(problem, equations);
  }
  return solution;
}

/// If links are open by far more than they allow, as a tree leaves its loops, stiff links would have to be bent round
/// to close them. Soft ones, with the readings, first turn the cells to agree with gravity.
JointState JointSolver::startingPoint(const JointProblem& problem, const JointState& initial,
                                      const JointSolverOptions& options) {
  constexpr double kOpen = 6;  // mean square, in link sigmas; 3 is what closed links have
  constexpr double kSofter = 10;
  JointProblem soft = problem;
  soft.loss.threshold = std::numeric_limits<double>::infinity();
  if (closureCost(soft, initial) <= kOpen * static_cast<double>(problem.links.size())) return initial;
  soft.link_sigma_m *= kSofter;
  JointSolverOptions roughly = options;
  roughly.cost_tolerance = 1e-2;
  roughly.covariance = false;
  return descend(soft, initial, roughly).state;
}

JointSolution solveJointly(const JointProblem& problem, const JointState& initial, const JointSolverOptions& options) {
  return JointSolver::descend(problem, JointSolver::startingPoint(problem, initial, options), options);
}

}  // namespace hexoderm
