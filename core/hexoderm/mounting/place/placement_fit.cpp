#include "hexoderm/mounting/place/placement_fit.h"

#include "hexoderm/base/units.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace hexoderm {
namespace {

/// Where a foot is so far off, the way to it says better than the smooth normal how the distance changes: beyond an
/// edge.
constexpr double kFarOff_m = 0.001;
constexpr double kOtherWay_rad = 20 * kDegree;
constexpr double kLongestStep_m = 0.02;

using Row6 = Eigen::Matrix<double, 1, 6>;

/// What an equation depends on: the motion of a patch, and the errors of one of its cells.
struct Term {
  std::size_t patch = 0;
  std::size_t cell = 0;
  Row6 by_motion = Row6::Zero();
  Row6 by_cell = Row6::Zero();
};
struct Equation {
  double r = 0;
  FitEquations::Kind kind{};
  std::array<Term, 2> terms{};
  std::size_t term_count = 1;
};

class EquationWriter {
 public:
  EquationWriter(const FitProblem& problem, const FitState& state) : problem_(problem), state_(state) {
    Eigen::Index columns = 0;
    for (const FitPatch& patch : problem.patches) {
      first_column_.push_back(columns);
      columns += patch.C.cols();
    }
    columns_ = columns;
  }

  FitEquations write() {
    collect();
    return assemble();
  }

  /// The residuals alone, for trying a step.
  std::vector<std::pair<double, FitEquations::Kind>> residuals() {
    collect();
    std::vector<std::pair<double, FitEquations::Kind>> r;
    r.reserve(equations_.size());
    for (const Equation& equation : equations_) r.emplace_back(equation.r, equation.kind);
    return r;
  }

 private:
  void collect() {
    if (problem_.feet != nullptr) {
      for (std::size_t p = 0; p < problem_.patches.size(); ++p) {
        for (std::size_t k = 0; k < problem_.patches[p].T_o_u.size(); ++k) addSurface(p, k);
      }
    }
    for (const FitPoint& point : problem_.points) addPoint(point);
    for (const FitDistance& distance : problem_.distances) addDistance(distance);
    for (std::size_t p = 0; p < problem_.patches.size(); ++p) addRotation(p);
  }

  [[nodiscard]] Eigen::Vector3d middleOf(std::size_t p) const { return state_[p] * problem_.patches[p].middle_o; }

  /// How a point x of the patch moves: by this times the unknowns.
  [[nodiscard]] Eigen::Matrix<double, 3, 6> motionAt(std::size_t p, const Eigen::Vector3d& x) const {
    Eigen::Matrix<double, 3, 6> M;
    M.leftCols<3>().setIdentity();
    M.rightCols<3>() = -skew(x - middleOf(p)) / problem_.patches[p].radius_m;
    return M;
  }

  void addSurface(std::size_t p, std::size_t k) {
    const FitPatch& patch = problem_.patches[p];
    const SE3 T_l_u = state_[p] * patch.T_o_u[k];
    const Eigen::Vector3d back = T_l_u * Eigen::Vector3d(0, 0, -problem_.back_m);
    const MeshFoot foot = problem_.feet->footOf(back);
    const Eigen::Vector3d& n = foot.normal;
    const Eigen::Vector3d off = back - foot.position;
    const double above_m = std::copysign(off.norm(), off.dot(n));
    Eigen::Vector3d way = n;
    if (std::abs(above_m) > kFarOff_m) {
      const Eigen::Vector3d straight = off / above_m;
      if (angleBetween(straight, n) > kOtherWay_rad) way = straight;
    }
    // The back moves with the patch and with the errors of the cell: dt + R_l_u (e x -h z).
    const Eigen::Matrix<double, 3, 6> back_by_motion = motionAt(p, back);
    Eigen::Matrix<double, 3, 6> back_by_cell;
    back_by_cell.leftCols<3>() = state_[p].R;
    back_by_cell.rightCols<3>() = problem_.back_m * T_l_u.R * skew(Eigen::Vector3d::UnitZ());
    Equation distance{.r = above_m, .kind = FitEquations::Kind::Surface};
    distance.terms[0] = {p, k, way.transpose() * back_by_motion, way.transpose() * back_by_cell};
    equations_.push_back(distance);

    // The normal as the cell sees it, as an angle: along its x and y.
    const Eigen::Vector3d n_u = T_l_u.R.transpose() * n;
    const double sine = n_u.head<2>().norm();
    const double angle = std::atan2(sine, n_u.z());
    const double stretch = sine > 1e-9 ? angle / sine : 1;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const Eigen::Vector3d a_u = Eigen::Vector3d::Unit(axis);
      const Eigen::Vector3d a = T_l_u.R * a_u;
      Equation tilt{.r = sine > 1e-9 || n_u.z() > 0 ? stretch * n_u[axis] : kPi * (axis == 0 ? 1 : 0),
                    .kind = FitEquations::Kind::Normal};
      const Eigen::RowVector3d by_foot = a.transpose() * foot.W;
      Term& term = tilt.terms[0];
      term = {p, k, by_foot * back_by_motion, by_foot * back_by_cell};
      term.by_motion.tail<3>() += a.cross(n).transpose() / patch.radius_m;
      term.by_cell.tail<3>() += a_u.cross(n_u).transpose();
      equations_.push_back(tilt);
    }
  }

  void addPoint(const FitPoint& point) {
    const Eigen::Vector3d x = state_[point.patch] * problem_.patches[point.patch].T_o_u[point.cell].t;
    const Eigen::Matrix<double, 3, 6> by_motion = motionAt(point.patch, x);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      Equation equation{.r = x[axis] - point.x_l[axis], .kind = FitEquations::Kind::Point};
      equation.terms[0] = {point.patch, point.cell, by_motion.row(axis), Row6::Zero()};
      equation.terms[0].by_cell.head<3>() = state_[point.patch].R.row(axis);
      equations_.push_back(equation);
      noise_.emplace_back(equations_.size() - 1, point.sigma_m * point.sigma_m);
    }
  }

  void addDistance(const FitDistance& distance) {
    const auto at = [&](std::size_t p, std::size_t k) -> Eigen::Vector3d {
      return state_[p] * problem_.patches[p].T_o_u[k].t;
    };
    const Eigen::Vector3d a = at(distance.patch_a, distance.cell_a);
    const Eigen::Vector3d b = at(distance.patch_b, distance.cell_b);
    const double length_m = (b - a).norm();
    const Eigen::Vector3d way = length_m > 1e-9 ? Eigen::Vector3d((b - a) / length_m) : Eigen::Vector3d::UnitX();
    Equation equation{.r = length_m - distance.distance_m, .kind = FitEquations::Kind::Distance};
    equation.term_count = 2;
    const auto term = [&](std::size_t p, std::size_t k, const Eigen::Vector3d& x, double sign) {
      Term of{p, k, sign * way.transpose() * motionAt(p, x), Row6::Zero()};
      of.by_cell.head<3>() = sign * way.transpose() * state_[p].R;
      return of;
    };
    equation.terms = {term(distance.patch_a, distance.cell_a, a, -1), term(distance.patch_b, distance.cell_b, b, 1)};
    equations_.push_back(equation);
    noise_.emplace_back(equations_.size() - 1, distance.sigma_m * distance.sigma_m);
  }

  void addRotation(std::size_t p) {
    const FitPatch& patch = problem_.patches[p];
    if (!patch.rotation) return;
    const Eigen::Vector3d error = logSO3(patch.rotation->R_l_o.transpose() * state_[p].R);
    rotation_rows_.emplace_back(equations_.size(), p);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      Equation equation{.r = error[axis], .kind = FitEquations::Kind::Rotation};
      equation.terms[0] = {p, patch.origin, Row6::Zero(), Row6::Zero()};
      // A turn in the link's frame is R^T w in the patch's.
      equation.terms[0].by_motion.tail<3>() = state_[p].R.col(axis).transpose() / patch.radius_m;
      equation.terms[0].by_cell[3 + axis] = 1;
      equations_.push_back(equation);
    }
  }

  FitEquations assemble() {
    const auto rows = static_cast<Eigen::Index>(equations_.size());
    FitEquations result;
    result.r.resize(rows);
    result.J = Eigen::MatrixXd::Zero(rows, problem_.unknowns());
    result.HC = Eigen::MatrixXd::Zero(rows, columns_);
    result.S = Eigen::MatrixXd::Zero(rows, rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Equation& equation = equations_[static_cast<std::size_t>(i)];
      result.r[i] = equation.r;
      result.kind.push_back(equation.kind);
      for (std::size_t t = 0; t < equation.term_count; ++t) {
        const Term& term = equation.terms[t];
        const FitPatch& patch = problem_.patches[term.patch];
        result.J.block<1, 6>(i, static_cast<Eigen::Index>(6 * term.patch)) += term.by_motion;
        result.HC.row(i).segment(first_column_[term.patch], patch.C.cols()) +=
            term.by_cell * patch.C.middleRows<6>(static_cast<Eigen::Index>(6 * term.cell));
      }
    }
    for (Eigen::Index i = 0; i < rows; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) {
        const Equation& equation = equations_[static_cast<std::size_t>(j)];
        double sum = 0;
        for (std::size_t t = 0; t < equation.term_count; ++t) {
          const Term& term = equation.terms[t];
          const Eigen::Index at = first_column_[term.patch] + static_cast<Eigen::Index>(6 * term.cell);
          sum += result.HC.row(i).segment<6>(at).dot(term.by_cell);
        }
        result.S(i, j) = result.S(j, i) = sum;
      }
    }
    addNoise(result);
    return result;
  }

  void addNoise(FitEquations& result) const {
    for (Eigen::Index i = 0; i < result.r.size(); ++i) {
      const FitEquations::Kind kind = result.kind[static_cast<std::size_t>(i)];
      if (kind == FitEquations::Kind::Surface) result.S(i, i) += problem_.surface_sigma_m * problem_.surface_sigma_m;
      if (kind == FitEquations::Kind::Normal) result.S(i, i) += problem_.normal_sigma_rad * problem_.normal_sigma_rad;
    }
    for (const auto& [row, variance] : noise_) {
      const auto i = static_cast<Eigen::Index>(row);
      result.S(i, i) += variance;
    }
    for (const auto& [row, patch] : rotation_rows_) {
      const auto i = static_cast<Eigen::Index>(row);
      result.S.block<3, 3>(i, i) += problem_.patches[patch].rotation->covariance;
    }
  }

  const FitProblem& problem_;
  const FitState& state_;
  std::vector<Eigen::Index> first_column_;
  Eigen::Index columns_ = 0;
  std::vector<Equation> equations_;
  std::vector<std::pair<std::size_t, double>> noise_;
  std::vector<std::pair<std::size_t, std::size_t>> rotation_rows_;
};

/// `kept` ascending, the origin among them.
FitPatch withCells(const FitPatch& patch, const std::vector<std::size_t>& kept) {
  const auto row = [](std::size_t cell) { return static_cast<Eigen::Index>(6 * cell); };
  FitPatch few = patch;
  few.T_o_u.clear();
  few.C.resize(row(kept.size()), row(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] == patch.origin) few.origin = i;
    few.T_o_u.push_back(patch.T_o_u[kept[i]]);
    for (std::size_t j = 0; j < kept.size(); ++j) {
      few.C.block<6, 6>(row(i), row(j)) = patch.C.block<6, 6>(row(kept[i]), row(kept[j]));
    }
  }
  return few;
}

Eigen::VectorXd residualsAt(const FitProblem& problem, const FitState& state) {
  const auto residuals = EquationWriter(problem, state).residuals();
  Eigen::VectorXd r(static_cast<Eigen::Index>(residuals.size()));
  for (std::size_t k = 0; k < residuals.size(); ++k) r[static_cast<Eigen::Index>(k)] = residuals[k].first;
  return r;
}

/// The projection onto what is neither `along` nor so flat that a step there is nothing but rounding and facets.
Eigen::MatrixXd acrossBoth(const Eigen::MatrixXd& A, const Eigen::VectorXd& along) {
  constexpr double kFlat_m = 0.01;
  Eigen::MatrixXd across = Eigen::MatrixXd::Identity(A.rows(), A.rows()) - along * along.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(across * A * across);
  across.setZero();
  for (Eigen::Index k = 0; k < A.rows(); ++k) {
    if (solver.eigenvalues()[k] * kFlat_m * kFlat_m < 1) continue;
    across += solver.eigenvectors().col(k) * solver.eigenvectors().col(k).transpose();
  }
  return across;
}

Eigen::MatrixXd informationAt(const FitProblem& problem, const FitEquations& equations, bool with_rotation) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < equations.r.size(); ++i) {
    if (with_rotation || equations.kind[static_cast<std::size_t>(i)] != FitEquations::Kind::Rotation) rows.push_back(i);
  }
  const Eigen::MatrixXd J = equations.J(rows, Eigen::all);
  const Eigen::MatrixXd S = equations.S(rows, rows);
  Eigen::MatrixXd information = J.transpose() * S.llt().solve(J);
  for (std::size_t p = 0; p < problem.patches.size(); ++p) {
    const auto at = static_cast<Eigen::Index>(6 * p);
    const double half_turn_m = kPi * problem.patches[p].radius_m;
    information.diagonal().segment<3>(at).array() += 1 / (problem.link_size_m * problem.link_size_m);
    information.diagonal().segment<3>(at + 3).array() += 1 / (half_turn_m * half_turn_m);
  }
  return information;
}

Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& information) {
  const Eigen::MatrixXd inverse =
      information.llt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
  return 0.5 * (inverse + inverse.transpose());
}

}  // namespace

FitProblem onlyCells(const FitProblem& problem, const std::vector<std::vector<std::size_t>>& cells) {
  FitProblem few = problem;
  std::vector<std::vector<std::size_t>> kept = cells;
  for (std::size_t p = 0; p < kept.size(); ++p) kept[p].push_back(problem.patches[p].origin);
  for (const FitPoint& point : problem.points) kept[point.patch].push_back(point.cell);
  for (const FitDistance& distance : problem.distances) {
    kept[distance.patch_a].push_back(distance.cell_a);
    kept[distance.patch_b].push_back(distance.cell_b);
  }
  for (std::size_t p = 0; p < kept.size(); ++p) {
    std::vector<std::size_t>& own = kept[p];
    std::ranges::sort(own);
    own.erase(std::unique(own.begin(), own.end()), own.end());
    few.patches[p] = withCells(problem.patches[p], own);
  }
  const auto newIndex = [&](std::size_t p, std::size_t cell) {
    return static_cast<std::size_t>(std::ranges::lower_bound(kept[p], cell) - kept[p].begin());
  };
  for (FitPoint& point : few.points) point.cell = newIndex(point.patch, point.cell);
  for (FitDistance& distance : few.distances) {
    distance.cell_a = newIndex(distance.patch_a, distance.cell_a);
    distance.cell_b = newIndex(distance.patch_b, distance.cell_b);
  }
  return few;
}

FitProblem onlyPatches(const FitProblem& problem, const std::vector<std::size_t>& patches) {
  FitProblem few = problem;
  few.patches.clear();
  few.points.clear();
  few.distances.clear();
  std::vector<std::optional<std::size_t>> new_index(problem.patches.size());
  for (const std::size_t p : patches) {
    new_index[p] = few.patches.size();
    few.patches.push_back(problem.patches[p]);
  }
  for (FitPoint point : problem.points) {
    if (!new_index[point.patch]) continue;
    point.patch = *new_index[point.patch];
    few.points.push_back(point);
  }
  for (FitDistance distance : problem.distances) {
    if (!new_index[distance.patch_a] || !new_index[distance.patch_b]) continue;
    distance.patch_a = *new_index[distance.patch_a];
    distance.patch_b = *new_index[distance.patch_b];
    few.distances.push_back(distance);
  }
  return few;
}

FitState moved(const FitProblem& problem, const FitState& state, const Eigen::VectorXd& step_m) {
  FitState next = state;
  for (std::size_t p = 0; p < state.size(); ++p) {
    const auto at = static_cast<Eigen::Index>(6 * p);
    const FitPatch& patch = problem.patches[p];
    const Eigen::Matrix3d turn = expSO3(Eigen::Vector3d(step_m.segment<3>(at + 3)) / patch.radius_m);
    const Eigen::Vector3d middle = state[p] * patch.middle_o;
    next[p].R = projectToSO3(turn * state[p].R);
    next[p].t = middle + step_m.segment<3>(at) - next[p].R * patch.middle_o;
  }
  return next;
}

Eigen::VectorXd stepBetween(const FitProblem& problem, const FitState& from, const FitState& to) {
  Eigen::VectorXd step_m(problem.unknowns());
  for (std::size_t p = 0; p < from.size(); ++p) {
    const auto at = static_cast<Eigen::Index>(6 * p);
    const FitPatch& patch = problem.patches[p];
    step_m.segment<3>(at) = to[p] * patch.middle_o - from[p] * patch.middle_o;
    step_m.segment<3>(at + 3) = patch.radius_m * logSO3(to[p].R * from[p].R.transpose());
  }
  return step_m;
}

double distanceBetween(const FitProblem& problem, const FitState& a, const FitState& b) {
  double sum = 0;
  double count = 0;
  for (std::size_t p = 0; p < a.size(); ++p) {
    for (const SE3& T_o_u : problem.patches[p].T_o_u) {
      sum += (a[p] * T_o_u.t - b[p] * T_o_u.t).squaredNorm();
      count += 1;
    }
    // A single cell, or a row of them, can be turned without moving its centres.
    const double turn_m = problem.patches[p].radius_m * rotationAngle(a[p].R.transpose() * b[p].R);
    sum += turn_m * turn_m / 4;
  }
  return std::sqrt(sum / count);
}

FitState wayFrom(const FitState& from, const FitState& to, double share) {
  FitState state;
  for (std::size_t p = 0; p < from.size(); ++p) {
    const SE3 T_to_from = to[p] * from[p].inverse();
    const Eigen::Vector3d w = logSO3(T_to_from.R);
    // The translation of a screw that turns by w is V(w) rho (K. M. Lynch, F. C. Park, "Modern Robotics", 3.3.3).
    const auto V = [](const Eigen::Vector3d& turn) -> Eigen::Matrix3d {
      const double angle = turn.norm();
      const Eigen::Matrix3d W = skew(turn);
      if (angle < 1e-4) return Eigen::Matrix3d::Identity() + W / 2;
      return Eigen::Matrix3d::Identity() + (1 - std::cos(angle)) / (angle * angle) * W +
             (angle - std::sin(angle)) / (angle * angle * angle) * W * W;
    };
    const Eigen::Vector3d rho = V(w).partialPivLu().solve(T_to_from.t);
    const Eigen::Vector3d part = share * w;
    state.push_back(SE3{expSO3(part), V(part) * (share * rho)} * from[p]);
  }
  return state;
}

FitEquations equationsAt(const FitProblem& problem, const FitState& state) {
  return EquationWriter(problem, state).write();
}

FitSolution refine(const FitProblem& problem, const FitState& start, int steps, const Eigen::VectorXd& along) {
  constexpr double kConverged_m = 1e-7;
  constexpr double kMinGain = 1e-7;
  constexpr double kMaxDamping = 1e8;
  FitState state = start;
  double damping = 1e-4;
  double chi_squared = 0;
  for (int k = 0;; ++k) {
    const FitEquations equations = equationsAt(problem, state);
    const Eigen::LLT<Eigen::MatrixXd> S(equations.S);
    chi_squared = equations.r.dot(S.solve(equations.r));
    if (k == steps) break;
    Eigen::MatrixXd A = equations.J.transpose() * S.solve(equations.J);
    Eigen::VectorXd g = equations.J.transpose() * S.solve(equations.r);
    const double scale = A.trace() / static_cast<double>(A.rows());
    if (along.size() > 0) {
      const Eigen::MatrixXd across = acrossBoth(A, along);
      A = across * A * across + scale * (Eigen::MatrixXd::Identity(A.rows(), A.rows()) - across);
      g = across * g;
    }
    bool better = false;
    double moved_m = 0;
    double gain = 0;
    for (; !better && damping < kMaxDamping; damping *= better ? 1 : 10) {
      Eigen::MatrixXd damped = A;
      damped.diagonal().array() += damping * scale;
      Eigen::VectorXd step_m = -damped.ldlt().solve(g);
      const double longest_m = step_m.cwiseAbs().maxCoeff();
      if (longest_m > kLongestStep_m) step_m *= kLongestStep_m / longest_m;
      const FitState next = moved(problem, state, step_m);
      const Eigen::VectorXd r = residualsAt(problem, next);
      const double tried = r.dot(S.solve(r));
      if (tried < chi_squared) {
        better = true;
        gain = chi_squared - tried;
        moved_m = step_m.norm();
        state = next;
      }
    }
    if (!better || moved_m < kConverged_m || gain < kMinGain * chi_squared) {
      if (better) {
        const FitEquations last = equationsAt(problem, state);
        chi_squared = last.r.dot(last.S.llt().solve(last.r));
      }
      break;
    }
    damping = std::max(1e-8, damping / 10);
  }
  return {std::move(state), chi_squared};
}

FitExtent noExtent(const FitProblem& problem) {
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(problem.unknowns(), problem.unknowns());
  return {none, none};
}

Eigen::MatrixXd covarianceAt(const FitProblem& problem, const FitEquations& equations, bool with_rotation) {
  return inverseOf(informationAt(problem, equations, with_rotation));
}

std::vector<CellOnLink> cellsOnLink(const FitProblem& problem, const FitState& state, const FitEquations& equations,
                                    const FitExtent& extent, std::size_t p) {
  const Eigen::MatrixXd P = inverseOf(informationAt(problem, equations, true) + extent.information);
  // The place's error is -P J^T S^-1 (H d + noise), so that it goes with the errors d of the cells.
  const Eigen::MatrixXd with_cells = -P * equations.J.transpose() * equations.S.llt().solve(equations.HC);
  Eigen::Index first = 0;
  for (std::size_t k = 0; k < p; ++k) first += problem.patches[k].C.cols();
  const FitPatch& patch = problem.patches[p];
  const auto at = static_cast<Eigen::Index>(6 * p);
  const Eigen::Vector3d middle = state[p] * patch.middle_o;

  std::vector<CellOnLink> cells;
  for (std::size_t k = 0; k < patch.T_o_u.size(); ++k) {
    CellOnLink& cell = cells.emplace_back();
    cell.T_l_u = state[p] * patch.T_o_u[k];
    Eigen::Matrix<double, 6, 6> by_motion = Eigen::Matrix<double, 6, 6>::Zero();
    by_motion.topLeftCorner<3, 3>().setIdentity();
    by_motion.topRightCorner<3, 3>() = -skew(cell.T_l_u.t - middle) / patch.radius_m;
    by_motion.bottomRightCorner<3, 3>() = cell.T_l_u.R.transpose() / patch.radius_m;
    Eigen::Matrix<double, 6, 6> by_cell = Eigen::Matrix<double, 6, 6>::Identity();
    by_cell.topLeftCorner<3, 3>() = state[p].R;
    const auto column = static_cast<Eigen::Index>(6 * k);
    const Eigen::Matrix<double, 6, 6> mixed =
        by_motion * with_cells.block<6, 6>(at, first + column) * by_cell.transpose();
    const Eigen::Matrix<double, 6, 6> covariance =
        by_motion * (P + extent.covariance).block<6, 6>(at, at) * by_motion.transpose() + mixed + mixed.transpose() +
        by_cell * patch.C.block<6, 6>(column, column) * by_cell.transpose();
    cell.cov_t_r = 0.5 * (covariance + covariance.transpose());
    if (problem.feet != nullptr) {
      const Eigen::Vector3d back = cell.T_l_u * Eigen::Vector3d(0, 0, -problem.back_m);
      const MeshFoot foot = problem.feet->footOf(back);
      const Eigen::Vector3d off = back - foot.position;
      cell.above_m = std::copysign(off.norm(), off.dot(foot.normal));
    }
  }
  return cells;
}

double roughMisfit(const FitProblem& problem, const FitState& state) {
  constexpr double kFar_m = 0.01;
  constexpr double kSteep_rad = 20 * kDegree;
  double sum = 0;
  for (const auto& [r, kind] : EquationWriter(problem, state).residuals()) {
    const bool is_angle = kind == FitEquations::Kind::Normal || kind == FitEquations::Kind::Rotation;
    const double size = r / (is_angle ? kSteep_rad : kFar_m);
    sum += size * size;
  }
  return sum;
}

double rmsOf(const FitEquations& equations) {
  double sum = 0;
  double count = 0;
  for (Eigen::Index i = 0; i < equations.r.size(); ++i) {
    const FitEquations::Kind kind = equations.kind[static_cast<std::size_t>(i)];
    if (kind == FitEquations::Kind::Normal || kind == FitEquations::Kind::Rotation) continue;
    sum += equations.r[i] * equations.r[i];
    count += 1;
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

}  // namespace hexoderm
