
#include "hexoderm/base/units.h"
#include "hexoderm/mounting/place/placement_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace hexoderm {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Of a motion by 1 m, less turn (times the patch's radius) than this is none.
constexpr double kNoTurn = 0.15;
/// An axis that passes the patch's middle nearer than so many of the patch's radii, or runs along so little of the
/// motion, is that of a turn on the spot, or of a turn alone.
constexpr double kOnTheSpot = 0.35;
constexpr double kNoPitch = 0.2;

/// The orthonormal directions of a space of columns, chosen one after the other: each as near as possible to what
/// `rows` make of it lying along one of `wanted`, or along any.
std::vector<Vector6> alignedDirections(const Eigen::MatrixXd& space, Eigen::Index first_row,
                                       const std::vector<Eigen::Vector3d>& wanted) {
  std::vector<Vector6> directions;
  Eigen::MatrixXd left = space;
  while (left.cols() > 0) {
    const Eigen::MatrixXd part = left.middleRows<3>(first_row);
    Eigen::VectorXd best = Eigen::VectorXd::Unit(left.cols(), 0);
    double most = 0;
    for (const Eigen::Vector3d& way : wanted) {
      const Eigen::VectorXd projection = part.transpose() * way;
      if (projection.norm() <= most + 1e-9) continue;
      most = projection.norm();
      best = projection / most;
    }
    directions.emplace_back(left * best);
    const Eigen::MatrixXd across = Eigen::MatrixXd::Identity(left.cols(), left.cols()) - best * best.transpose();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(left * across, Eigen::ComputeThinU);
    left = svd.matrixU().leftCols(left.cols() - 1).eval();
  }
  return directions;
}

/// The space of open directions as slides first, then what turns.
std::vector<Vector6> slidesAndTurns(const Eigen::MatrixXd& open, const Eigen::Vector3d& normal) {
  if (open.cols() == 0) return {};
  const Eigen::MatrixXd turning = open.bottomRows<3>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(turning, Eigen::ComputeFullV);
  Eigen::Index turns = 0;
  while (turns < svd.singularValues().size() && svd.singularValues()[turns] > kNoTurn) ++turns;
  const Eigen::MatrixXd in_order = open * svd.matrixV();
  const std::vector<Eigen::Vector3d> axes = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                             Eigen::Vector3d::UnitZ()};
  std::vector<Vector6> directions = alignedDirections(in_order.rightCols(open.cols() - turns), 0, axes);
  const std::vector<Vector6> turned = alignedDirections(in_order.leftCols(turns), 3, {normal});
  directions.insert(directions.end(), turned.begin(), turned.end());
  return directions;
}

/// Forwards is where the largest component of the axis is positive.
bool isBackwards(const Eigen::Vector3d& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0;
}

/// `direction`: shift of the patch's middle and turn times its radius, of unit length.
FreeDirection freeDirectionOf(Vector6 direction, const Eigen::Vector3d& middle, double radius_m) {
  const bool slides = direction.tail<3>().norm() <= kNoTurn;
  if (isBackwards(slides ? direction.head<3>() : direction.tail<3>())) direction = -direction;
  FreeDirection free;
  const Eigen::Vector3d shift = direction.head<3>();
  free.turn_rad = direction.tail<3>() / radius_m;
  free.shift_m = shift - free.turn_rad.cross(middle);
  if (slides) {
    free.kind = FreeDirection::Kind::Slide;
    free.axis = shift.normalized();
    free.through_m = middle;
    return free;
  }
  free.axis = free.turn_rad.normalized();
  free.through_m = middle + free.turn_rad.cross(shift) / free.turn_rad.squaredNorm();
  const double along = std::abs(shift.dot(free.axis));
  free.kind = along <= kNoPitch ? FreeDirection::Kind::Turn : FreeDirection::Kind::Screw;
  return free;
}

double fromMiddle(const FreeDirection& free, const Eigen::Vector3d& middle) {
  return (middle - free.through_m - (middle - free.through_m).dot(free.axis) * free.axis).norm();
}

Message wayText(const FreeDirection& free, const Eigen::Vector3d& middle, double radius_m) {
  const Message axis = axisText(free.axis);
  const double away_m = fromMiddle(free, middle);
  switch (free.kind) {
    case FreeDirection::Kind::Slide:
      return message("slide along {}", axis);
    case FreeDirection::Kind::Screw:
      return message("slide and turn at once, as a screw about {}", axis);
    case FreeDirection::Kind::Turn:
      break;
  }
  if (away_m <= kOnTheSpot * radius_m) return message("turn on the spot, about {}", axis);
  return message("turn around an axis along {}, {} from its middle", axis, Millimetres{away_m, 0});
}

Message inWords(const FreeDirection& free, const Eigen::Vector3d& middle, double radius_m) {
  const Message way = wayText(free, middle, radius_m);
  if (free.held_by_rotation) {
    return message("Nothing but its known rotation keeps it from being free to {}: to {} (1 sigma).", way,
                   Millimetres{free.sigma_m, 1});
  }
  if (free.all_the_way) return message("It is free to {}, all the way round.", way);
  if (free.kind == FreeDirection::Kind::Turn) {
    return message("It is free to {}, by {} one way and {} the other.", way, Degrees{free.forward_rad, 0},
                   Degrees{free.backward_rad, 0});
  }
  return message("It is free to {}, by {} forwards and {} backwards.", way, Millimetres{free.forward_m, 0},
                 Millimetres{free.backward_m, 0});
}

/// Follows a direction both ways. Returns the mean square of the motion within two deviations of the misfit, as if all
/// places there were as probable.
double follow(const FitProblem& problem, const FitState& from, const Eigen::VectorXd& along, double most_chi_squared,
              std::size_t patch, FreeDirection& free) {
  const UnobservableDirection there = followUnobservableDirection(problem, from, along, most_chi_squared, patch);
  const UnobservableDirection back = there.all_the_way
                                         ? UnobservableDirection{}
                                         : followUnobservableDirection(problem, from, -along, most_chi_squared, patch);
  free.forward_m = there.reach_m;
  free.forward_rad = there.turn_rad;
  free.backward_m = back.reach_m;
  free.backward_rad = back.turn_rad;
  free.all_the_way = there.all_the_way;
  for (auto state = back.states.rbegin(); state != back.states.rend(); ++state) free.way.push_back((*state)[patch]);
  free.way.push_back(from[patch]);
  for (const FitState& state : there.states) free.way.push_back(state[patch]);
  const double f = there.near_reach_m;
  const double b = back.near_reach_m;
  return (f * f - f * b + b * b) / 3;
}

/// A direction of a patch that may be open.
struct PossiblyOpen {
  Vector6 direction;
  bool is_weak = false;  ///< it is open only if following it says so
};
std::vector<PossiblyOpen> possiblyOpen(const Eigen::MatrixXd& P, double free_m, const Eigen::Vector3d& normal) {
  constexpr double kWeak = 0.25;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(P);
  std::vector<PossiblyOpen> directions;
  Eigen::Index sure = 0;
  while (sure < 6 && solver.eigenvalues()[sure] <= free_m * free_m) ++sure;
  for (const Vector6& direction : slidesAndTurns(solver.eigenvectors().rightCols(6 - sure), normal)) {
    directions.push_back({direction, false});
  }
  for (Eigen::Index k = 0; k < sure; ++k) {
    if (solver.eigenvalues()[k] <= std::pow(kWeak * free_m, 2)) continue;
    directions.push_back({solver.eigenvectors().col(k), true});
  }
  return directions;
}

}  // namespace

Message axisText(const Eigen::Vector3d& axis) {
  constexpr double kAlong_rad = 6 * kDegree;
  constexpr std::array<const char*, 3> kNames = {"x", "y", "z"};
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double angle = angleBetween(axis, Eigen::Vector3d::Unit(k));
    if (std::min(angle, kPi - angle) < kAlong_rad) {
      return message("the link's {} axis", kNames[static_cast<std::size_t>(k)]);
    }
  }
  return message("the direction ({}, {}, {}) of the link", Number{axis.x(), 2}, Number{axis.y(), 2},
                 Number{axis.z(), 2});
}

std::vector<FreeDirection> freeDirections(const FitProblem& problem, const FitSolution& solution,
                                          const FitEquations& equations, std::size_t p, double free_m,
                                          double most_chi_squared, FitExtent& extent) {
  const FitPatch& patch = problem.patches[p];
  const auto at = static_cast<Eigen::Index>(6 * p);
  const Eigen::MatrixXd without = covarianceAt(problem, equations, false);
  const Eigen::MatrixXd with = covarianceAt(problem, equations);
  const Eigen::Vector3d middle = solution.state[p] * patch.middle_o;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const SE3& T_o_u : patch.T_o_u) normal += solution.state[p].R * T_o_u.R.col(2);

  std::vector<FreeDirection> directions;
  for (const PossiblyOpen& open : possiblyOpen(without.block<6, 6>(at, at), free_m, normal.normalized())) {
    FreeDirection free = freeDirectionOf(open.direction, middle, patch.radius_m);
    Eigen::VectorXd forwards = Eigen::VectorXd::Zero(problem.unknowns());
    forwards.segment<3>(at) = free.shift_m + free.turn_rad.cross(middle);
    forwards.segment<3>(at + 3) = free.turn_rad * patch.radius_m;
    const Eigen::VectorXd together = with * forwards;  // how the other patches go with it
    const double variance_m2 = forwards.dot(together);
    free.sigma_m = std::sqrt(variance_m2);
    free.held_by_rotation = !open.is_weak && free.sigma_m <= free_m;
    if (!free.held_by_rotation) {
      const double square_m2 = follow(problem, solution.state, together.normalized(), most_chi_squared, p, free);
      if (open.is_weak && square_m2 <= free_m * free_m) continue;
      if (square_m2 > variance_m2) {
        extent.covariance += (square_m2 - variance_m2) / (variance_m2 * variance_m2) * together * together.transpose();
      } else if (!free.all_the_way && square_m2 > 0) {
        extent.information += (1 / square_m2 - 1 / variance_m2) * forwards * forwards.transpose();
      }
      if (!free.all_the_way && square_m2 > 0) free.sigma_m = std::sqrt(square_m2);
    }
    free.words = inWords(free, middle, patch.radius_m);
    directions.push_back(std::move(free));
  }
  return directions;
}

}  // namespace hexoderm
