
#include "hexoderm/base/covariance.h"
#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "hexoderm/mounting/parts/rigid_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hexoderm {
namespace {

using Eigen::Index;
using Across = Eigen::Matrix<double, 3, 2>;

Index pairAt(std::size_t pose) { return static_cast<Index>(2 * pose); }

Eigen::Vector3d movedAcross(const Eigen::Vector3d& u, const Eigen::Vector2d& by) {
  return (u + acrossBasis(u) * by).normalized();
}

/// An axis from both sides, and how badly u_a . g_a,p = u_b . g_b,p fails, in standard deviations squared.
struct AxisCandidate {
  Eigen::Vector3d u_a = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d u_b = Eigen::Vector3d::UnitZ();
  double chi_squared = std::numeric_limits<double>::infinity();
};

/// The axis by the constraint alone: P differences with four unknowns.
class AxisSearch {
 public:
  AxisSearch(const GravitySeen& a, const GravitySeen& b) : a_(a), b_(b) {}

  /// Different local optima, best first.
  [[nodiscard]] std::vector<AxisCandidate> run() const {
    constexpr int kStarts = 48;
    constexpr double kSame_rad = 0.03;
    std::vector<AxisCandidate> found;
    for (const Eigen::Vector3d& start : axesAllAround(kStarts)) {  // (u_a, u_b) and (-u_a, -u_b) are one axis
      const AxisCandidate candidate = descend(startAt(start));
      const bool is_new = std::ranges::none_of(found, [&](const AxisCandidate& other) {
        const double sign = other.u_b.dot(candidate.u_b) < 0 ? -1 : 1;
        return angleBetween(other.u_b, sign * candidate.u_b) < kSame_rad &&
               angleBetween(other.u_a, sign * candidate.u_a) < kSame_rad;
      });
      if (is_new) found.push_back(candidate);
    }
    std::ranges::sort(found, {}, &AxisCandidate::chi_squared);
    return found;
  }

 private:
  /// u_a by least squares for a given u_b.
  [[nodiscard]] AxisCandidate startAt(const Eigen::Vector3d& u_b) const {
    Eigen::Matrix3d normal = 1e-3 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < a_.size(); ++k) {
      normal += a_.up[k] * a_.up[k].transpose();
      right += a_.up[k] * u_b.dot(b_.up[k]);
    }
    const Eigen::Vector3d u_a = normal.ldlt().solve(right);
    return {u_a.norm() > 1e-6 ? Eigen::Vector3d(u_a.normalized()) : Eigen::Vector3d(0, 0, 1), u_b};
  }

  struct Linearized {
    Eigen::Matrix4d matrix;
    Eigen::Vector4d gradient;
    double chi_squared = 0;
  };
  [[nodiscard]] Linearized linearize(const AxisCandidate& at) const {
    const std::size_t poses = a_.size();
    Eigen::VectorXd difference(static_cast<Index>(poses));
    Eigen::MatrixXd J(static_cast<Index>(poses), 4);
    Eigen::MatrixXd by_a = Eigen::MatrixXd::Zero(static_cast<Index>(poses), pairAt(poses));
    Eigen::MatrixXd by_b = by_a;
    for (std::size_t k = 0; k < poses; ++k) {
      const auto row = static_cast<Index>(k);
      difference[row] = at.u_a.dot(a_.up[k]) - at.u_b.dot(b_.up[k]);
      J.block<1, 2>(row, 0) = a_.up[k].transpose() * acrossBasis(at.u_a);
      J.block<1, 2>(row, 2) = -b_.up[k].transpose() * acrossBasis(at.u_b);
      by_a.block<1, 2>(row, pairAt(k)) = at.u_a.transpose() * acrossBasis(a_.up[k]);
      by_b.block<1, 2>(row, pairAt(k)) = at.u_b.transpose() * acrossBasis(b_.up[k]);
    }
    Eigen::MatrixXd spread = by_a * a_.covariance * by_a.transpose() + by_b * b_.covariance * by_b.transpose();
    spread.diagonal().array() += kMinDifferenceVariance;
    const Eigen::LLT<Eigen::MatrixXd> factor(spread);
    factor.matrixL().solveInPlace(difference);
    factor.matrixL().solveInPlace(J);
    return {J.transpose() * J, J.transpose() * difference, difference.squaredNorm()};
  }

  [[nodiscard]] AxisCandidate descend(AxisCandidate at) const {
    constexpr int kMaxMoves = 40;
    Linearized here = linearize(at);
    double damping = 1e-3;
    for (int step = 0; step < kMaxMoves && damping < 1e6; ++step) {
      Eigen::Matrix4d damped = here.matrix;
      damped.diagonal().array() += damping * (here.matrix.diagonal().maxCoeff() + 1);
      const Eigen::Vector4d move = -damped.ldlt().solve(here.gradient);
      const AxisCandidate next{movedAcross(at.u_a, move.head<2>()), movedAcross(at.u_b, move.tail<2>())};
      const Linearized there = linearize(next);
      if (there.chi_squared > here.chi_squared) {
        damping *= 10;
        continue;
      }
      const bool settled = here.chi_squared - there.chi_squared < 1e-6 && move.norm() < 1e-4;
      at = next;
      here = there;
      damping = std::max(1e-9, damping / 10);
      if (settled) break;
    }
    at.chi_squared = here.chi_squared;
    return at;
  }

  static constexpr double kMinDifferenceVariance = 1e-12;
  const GravitySeen& a_;
  const GravitySeen& b_;
};

/// R_p = exp(u theta_p) R_0 maps b into a, with theta 0 in the reference pose; g_p: the true directions in a.
struct HingeState {
  Eigen::Vector3d u = Eigen::Vector3d::UnitZ();
  Eigen::Matrix3d R_0 = Eigen::Matrix3d::Identity();
  std::vector<double> angle;
  std::vector<Eigen::Vector3d> g;
};

class HingeProblem {
 public:
  HingeProblem(const GravitySeen& a, const GravitySeen& b, const AxisCandidate& axis)
      : a_(a), b_(b), W_a_(inverseOf(a.covariance)), W_b_(inverseOf(b.covariance)) {
    start(axis);
  }

  void solve() {
    constexpr int kMaxMoves = 60;
    linearize(state_);
    double damping = 0;
    for (int step = 0; step < kMaxMoves && damping < 1e8; ++step) {
      Eigen::MatrixXd damped = matrix_;
      damped.diagonal() *= 1 + damping;
      const Eigen::VectorXd move = -damped.llt().solve(gradient_);
      const HingeState next = moved(move);
      const double before = chi_squared_;
      linearize(next);
      if (!(chi_squared_ <= before + 1e-9)) {
        linearize(state_);
        damping = std::max(1e-4, 10 * damping);
        continue;
      }
      state_ = next;
      damping = damping > 1e-4 ? damping / 10 : 0;
      if (move.cwiseAbs().maxCoeff() < 1e-9) break;
    }
    covariance_ = inverseOf(matrix_);
  }

  [[nodiscard]] const HingeState& state() const { return state_; }
  [[nodiscard]] std::size_t reference() const { return reference_; }
  [[nodiscard]] double chiSquared() const { return chi_squared_; }
  [[nodiscard]] Eigen::Matrix2d axisCovariance() const { return covariance_.block<2, 2>(axisAt(), axisAt()); }
  /// Of u_b = R_0^T u.
  [[nodiscard]] Eigen::Matrix3d axisCovarianceB() const {
    const Eigen::Matrix3d R_b_a = state_.R_0.transpose();
    Eigen::Matrix<double, 3, 5> J;  // by the turn, then by the axis
    J << skew(R_b_a * state_.u), R_b_a * acrossBasis(state_.u);
    return J * covariance_.block<5, 5>(turnAt(), turnAt()) * J.transpose();
  }
  [[nodiscard]] double angleSigma(std::size_t pose) const {
    if (pose == reference_) return 0;
    return std::sqrt(covariance_(angleAt(pose), angleAt(pose)));
  }
  /// Gravity is far enough from the axis in a pose for its angle to mean something.
  [[nodiscard]] bool showsAngle(std::size_t pose) const {
    constexpr double kKnown_rad = 0.25;
    return pose == reference_ || angleSigma(pose) < kKnown_rad;
  }

 private:
  static Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& matrix) {
    return matrix.llt().solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
  }

  // Order of the unknowns: directions, turn R_0, axis, angles but the reference's.
  [[nodiscard]] Index turnAt() const { return pairAt(a_.size()); }
  [[nodiscard]] Index axisAt() const { return turnAt() + 3; }
  [[nodiscard]] Index angleAt(std::size_t pose) const {
    return axisAt() + 2 + static_cast<Index>(pose) - (pose > reference_ ? 1 : 0);
  }
  [[nodiscard]] Index unknowns() const { return axisAt() + 2 + static_cast<Index>(a_.size()) - 1; }

  void start(const AxisCandidate& axis) {
    const auto leverOf = [&](std::size_t pose) {
      return std::min(axis.u_a.cross(a_.up[pose]).norm(), axis.u_b.cross(b_.up[pose]).norm());
    };
    for (std::size_t k = 0; k < a_.size(); ++k) {
      if (leverOf(k) > leverOf(reference_)) reference_ = k;
    }
    state_.u = axis.u_a;
    state_.g = a_.up;
    const Eigen::Matrix3d R_ab = shortestRotation(axis.u_b, axis.u_a);
    const auto angleOf = [&](std::size_t pose) {
      const Eigen::Vector3d from = R_ab * b_.up[pose];
      const Eigen::Vector3d to = a_.up[pose];
      return std::atan2(axis.u_a.dot(from.cross(to)), from.dot(to) - axis.u_a.dot(from) * axis.u_a.dot(to));
    };
    const double at_reference = angleOf(reference_);
    state_.R_0 = expSO3(at_reference * axis.u_a) * R_ab;
    for (std::size_t k = 0; k < a_.size(); ++k) {
      state_.angle.push_back(k == reference_ ? 0 : std::remainder(angleOf(k) - at_reference, 2 * kPi));
    }
  }

  void linearize(const HingeState& at) {
    const auto rows = pairAt(a_.size());
    Eigen::VectorXd e_a(rows);
    Eigen::VectorXd e_b(rows);
    Eigen::MatrixXd J_a = Eigen::MatrixXd::Zero(rows, unknowns());
    Eigen::MatrixXd J_b = Eigen::MatrixXd::Zero(rows, unknowns());
    const Across across_u = acrossBasis(at.u);
    for (std::size_t k = 0; k < a_.size(); ++k) {
      const Index row = pairAt(k);
      const Eigen::Matrix3d turn = expSO3(at.angle[k] * at.u);
      const Eigen::Matrix3d R_b_a = (turn * at.R_0).transpose();
      const Across across_g = acrossBasis(at.g[k]);
      const Eigen::Matrix<double, 2, 3> across_a = acrossBasis(a_.up[k]).transpose();
      const Eigen::Matrix<double, 2, 3> across_b = acrossBasis(b_.up[k]).transpose();
      e_a.segment<2>(row) = across_a * at.g[k];
      e_b.segment<2>(row) = across_b * R_b_a * at.g[k];
      J_a.block<2, 2>(row, row) = across_a * across_g;
      J_b.block<2, 2>(row, row) = across_b * R_b_a * across_g;
      J_b.block<2, 3>(row, turnAt()) = across_b * skew(R_b_a * at.g[k]);
      // u turns by d = u x (across_u v); exp(u theta) becomes exp(u theta) exp((E^T - I) d).
      const Eigen::Matrix3d E_t = turn.transpose();
      J_b.block<2, 2>(row, axisAt()) = across_b * at.R_0.transpose() * skew(E_t * at.g[k]) *
                                       (E_t - Eigen::Matrix3d::Identity()) * skew(at.u) * across_u;
      if (k != reference_) J_b.block<2, 1>(row, angleAt(k)) = -across_b * R_b_a * at.u.cross(at.g[k]);
    }
    const Eigen::MatrixXd WJ_a = W_a_ * J_a;
    const Eigen::MatrixXd WJ_b = W_b_ * J_b;
    matrix_ = J_a.transpose() * WJ_a + J_b.transpose() * WJ_b;
    // What the poses leave open is known to within a radian.
    matrix_.diagonal().tail(unknowns() - turnAt()).array() += 1;
    gradient_ = WJ_a.transpose() * e_a + WJ_b.transpose() * e_b;
    chi_squared_ = e_a.dot(W_a_ * e_a) + e_b.dot(W_b_ * e_b);
  }

  [[nodiscard]] HingeState moved(const Eigen::VectorXd& move) const {
    HingeState next = state_;
    for (std::size_t k = 0; k < a_.size(); ++k) {
      next.g[k] = movedAcross(state_.g[k], move.segment<2>(pairAt(k)));
      if (k != reference_) next.angle[k] = std::remainder(state_.angle[k] + move[angleAt(k)], 2 * kPi);
    }
    next.u = movedAcross(state_.u, move.segment<2>(axisAt()));
    next.R_0 = state_.R_0 * expSO3(move.segment<3>(turnAt()));
    return next;
  }

  const GravitySeen& a_;
  const GravitySeen& b_;
  Eigen::MatrixXd W_a_;
  Eigen::MatrixXd W_b_;
  std::size_t reference_ = 0;
  HingeState state_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd gradient_;
  double chi_squared_ = 0;
  Eigen::MatrixXd covariance_;
};

/// Whether another axis explains the poses about as well.
bool isAmbiguous(const std::vector<AxisCandidate>& candidates) {
  constexpr double kClearly = 16;
  return candidates.size() > 1 && candidates[1].chi_squared - candidates[0].chi_squared < kClearly;
}

/// A part that kept its direction to gravity shows the angle of the axis to it and no more. Noise makes its directions
/// differ, and many poses of noise would look like knowledge.
void openAlongOneLine(const GravitySeen& seen, HingeAxis& axis) {
  if (lieOnOneLine(seen.up)) {
    const Across across = acrossBasis(axis.u);
    axis.covariance += across * across.transpose();  // 1 rad
  }
  axis.sigma_rad = largestDeviation(axis.covariance);
}

void judgeHinge(Hinge& hinge, bool ambiguous, double least_probable) {
  if (hinge.freedom > 0 && hinge.probability < least_probable) {
    hinge.knowledge = HingeKnowledge::NoAxis;
    hinge.why = message(
        "No single axis explains how the two parts turned against each other: there is more between "
        "them than one revolute joint, or a part moved while a pose was taken.");
    hinge.what_would_tell = message("Move one joint only, and take at least five poses with it.");
    return;
  }
  const bool is_known = std::max(hinge.a.sigma_rad, hinge.b.sigma_rad) <= kKnownAxis_rad;
  if (is_known && !ambiguous) {
    hinge.knowledge = HingeKnowledge::Found;
    hinge.why = message("One axis explains all {} poses; it is known to {} in the one part and to {} in the other.",
                        hinge.angles.size(), Degrees{hinge.a.sigma_rad}, Degrees{hinge.b.sigma_rad});
    return;
  }
  hinge.knowledge = HingeKnowledge::NotDetermined;
  hinge.what_would_tell = message(
      "Take another pose with the joint between them turned elsewhere and its axis pointing in a new direction.");
  if (is_known) {
    hinge.why = message("The poses can be explained by several axes.");
  } else if (std::min(hinge.a.sigma_rad, hinge.b.sigma_rad) <= kKnownAxis_rad) {
    hinge.why = message(
        "The axis is known in one of the two parts only: in the other one, gravity came from "
        "nearly one direction in all poses.");
  } else {
    hinge.why = message("The poses leave open where the axis is.");
  }
}

}  // namespace

std::string_view hingeKnowledgeName(HingeKnowledge knowledge) {
  constexpr EnumNames<HingeKnowledge> kNames = {{"found", "no_axis", "not_determined"}};
  return kNames.of(knowledge);
}

Hinge fitHinge(const GravitySeen& all_a, const GravitySeen& all_b, double least_probable) {
  const CommonPoses common = commonPoses(all_a, all_b);
  const GravitySeen a = onlyPoses(all_a, common.in_a);
  const GravitySeen b = onlyPoses(all_b, common.in_b);
  Hinge hinge;
  if (a.size() < kPosesForHinge) {
    hinge.a.sigma_rad = hinge.b.sigma_rad = kPi / 2;
    hinge.why =
        message("An axis between two parts takes at least {} poses, and there are {}.", kPosesForHinge, a.size());
    hinge.what_would_tell = message("Take more poses, each with the joint turned elsewhere.");
    return hinge;
  }
  const std::vector<AxisCandidate> candidates = AxisSearch(a, b).run();
  HingeProblem problem(a, b, candidates.front());
  problem.solve();
  const HingeState& state = problem.state();
  const Across across = acrossBasis(state.u);
  hinge.a.u = state.u;
  hinge.a.covariance = across * problem.axisCovariance() * across.transpose();
  hinge.b.u = state.R_0.transpose() * state.u;
  hinge.b.covariance = problem.axisCovarianceB();
  openAlongOneLine(a, hinge.a);
  openAlongOneLine(b, hinge.b);
  hinge.R_a_b = state.R_0;
  hinge.reference = a.poses[problem.reference()];
  for (std::size_t k = 0; k < a.size(); ++k) {
    HingeAngle angle{a.poses[k], std::nullopt, 0};
    if (problem.showsAngle(k)) {
      angle.angle_rad = state.angle[k];
      angle.sigma_rad = problem.angleSigma(k);
    }
    hinge.angles.push_back(angle);
  }
  const GravityMisfit misfit{problem.chiSquared(), static_cast<int>(a.size()) - 4};
  hinge.chi_squared = misfit.chi_squared;
  hinge.freedom = misfit.freedom;
  hinge.probability = misfit.probability();
  judgeHinge(hinge, isAmbiguous(candidates), least_probable);
  return hinge;
}

}  // namespace hexoderm
