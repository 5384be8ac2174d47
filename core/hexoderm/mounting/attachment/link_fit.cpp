#include "hexoderm/mounting/attachment/link_fit.h"

#include "hexoderm/base/procrustes.h"
#include "hexoderm/base/se3.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace hexoderm {
namespace {

bool anyNames(std::span<const JointAngles> angles, const std::string& joint) {
  return std::ranges::any_of(angles, [&](const JointAngles& pose) { return pose.positions.contains(joint); });
}

using Eigen::Index;

constexpr int kMaxTurnSteps = 30;
constexpr int kMaxHalvings = 8;
constexpr double kTurnSettled_rad = 1e-10;

Index rowOf(std::size_t pose) { return static_cast<Index>(2 * pose); }

/// Unknowns: the turn (3), the joints' zeros and the base's tilt (2), the latter in units of their priors.
class TurnProblem {
 public:
  TurnProblem(const SeenByPatch& patch, const LinkGravity& robot, std::size_t link, const RobotPriors& priors)
      : patch_(patch) {
    const std::vector<std::size_t> joints = priors.zero_rad > 0 ? robot.jointsTo(link) : std::vector<std::size_t>();
    const auto zeros = static_cast<Index>(joints.size());
    const Index tilts = priors.tilt_rad > 0 ? 2 : 0;
    small_.setZero(zeros + tilts);
    for (std::size_t k = 0; k < patch.size(); ++k) {
      const std::size_t place = patch.placeOf(k);
      up_l_.push_back(robot.up(link, place));
      Eigen::Matrix3Xd by_small(3, zeros + tilts);
      for (Index j = 0; j < zeros; ++j) {
        by_small.col(j) = priors.zero_rad * robot.byZero(link, place, joints[static_cast<std::size_t>(j)]);
      }
      if (tilts > 0) {
        by_small.rightCols<2>() = priors.tilt_rad * robot.byUp(link, place) * acrossBasis(robot.upOfBase());
      }
      by_small_.push_back(std::move(by_small));
    }
    start();
  }

  LinkTurn solve() {
    double cost = costOf(R_, small_);
    Eigen::LLT<Eigen::MatrixXd> factor;
    for (int step = 0; step < kMaxTurnSteps; ++step) {
      linearize(small_);
      factor.compute(matrix_);
      Eigen::VectorXd move = -factor.solve(gradient_);
      double moved_cost = 0;
      for (int halving = 0; halving < kMaxHalvings; ++halving, move /= 2) {
        moved_cost = costOf(R_ * expSO3(move.head<3>()), small_ + move.tail(small_.size()));
        if (moved_cost <= cost) break;
      }
      if (moved_cost > cost) break;
      cost = moved_cost;
      R_ *= expSO3(move.head<3>());
      small_ += move.tail(small_.size());
      if (move.cwiseAbs().maxCoeff() < kTurnSettled_rad) break;
    }
    linearize(small_);
    factor.compute(matrix_);
    return describe(factor, cost);
  }

 private:
  void start() {
    Eigen::Matrix3Xd seen(3, static_cast<Index>(up_l_.size()));
    Eigen::Matrix3Xd expected(3, seen.cols());
    for (std::size_t k = 0; k < up_l_.size(); ++k) {
      seen.col(static_cast<Index>(k)) = patch_.seen().up[k];
      expected.col(static_cast<Index>(k)) = up_l_[k];
    }
    R_ = solveProcrustes(seen, expected).R_c_n;
  }

  [[nodiscard]] Eigen::Vector3d foretold(std::size_t k, const Eigen::Matrix3d& R, const Eigen::VectorXd& small) const {
    return R.transpose() * (up_l_[k] + by_small_[k] * small);
  }

  [[nodiscard]] double costOf(const Eigen::Matrix3d& R, const Eigen::VectorXd& small) const {
    Eigen::MatrixXd rows(rowOf(up_l_.size()), 1);
    for (std::size_t k = 0; k < up_l_.size(); ++k) {
      rows.block<2, 1>(rowOf(k), 0) = patch_.residual(k, foretold(k, R, small));
    }
    patch_.whiten(rows);
    return rows.squaredNorm() + small.squaredNorm();
  }

  /// About the turn and these zeros and tilt.
  void linearize(const Eigen::VectorXd& small) {
    const Index unknowns = 3 + small_.size();
    Eigen::MatrixXd rows(rowOf(up_l_.size()), unknowns + 1);
    for (std::size_t k = 0; k < up_l_.size(); ++k) {
      const Eigen::Vector3d f = foretold(k, R_, small);
      rows.block<2, 3>(rowOf(k), 0) = patch_.across(k) * skew(f);
      rows.block(rowOf(k), 3, 2, small_.size()) = patch_.across(k) * R_.transpose() * by_small_[k];
      rows.block<2, 1>(rowOf(k), unknowns) = patch_.residual(k, f);
    }
    patch_.whiten(rows);
    const auto by_unknowns = rows.leftCols(unknowns);
    matrix_ = by_unknowns.transpose() * by_unknowns;
    matrix_.diagonal().head<3>().array() += kOpenTurnInformation;
    matrix_.diagonal().tail(small_.size()).array() += 1;
    gradient_ = by_unknowns.transpose() * rows.col(unknowns);
    gradient_.tail(small_.size()) += small;
  }

  [[nodiscard]] LinkTurn describe(const Eigen::LLT<Eigen::MatrixXd>& factor, double cost) {
    LinkTurn turn;
    turn.R_l_o = R_;
    turn.log_evidence = -cost / 2 - Eigen::MatrixXd(factor.matrixL()).diagonal().array().log().sum();
    // The covariance is that without the tilt that was found. On a link that only turns about the vertical, turning the
    // patch and the way in which the base is tilted together changes nothing, and so that tilt says nothing of the
    // turn; to first order it would seem to, because its prior resists such a change.
    linearize(Eigen::VectorXd::Zero(small_.size()));
    const Eigen::LLT<Eigen::MatrixXd> untilted(matrix_);
    const Eigen::MatrixXd columns = Eigen::MatrixXd::Identity(matrix_.rows(), 3);
    turn.covariance = untilted.solve(columns).topRows<3>();
    turn.covariance = ((turn.covariance + turn.covariance.transpose()) / 2).eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(turn.covariance, Eigen::EigenvaluesOnly);
    const auto known = (solver.eigenvalues().array() < kOpenVariance_rad2).count();
    turn.misfit = {cost, static_cast<int>(std::max<Index>(0, rowOf(up_l_.size()) - known))};
    return turn;
  }

  const SeenByPatch& patch_;
  std::vector<Eigen::Vector3d> up_l_;
  std::vector<Eigen::Matrix3Xd> by_small_;
  Eigen::Matrix3d R_ = Eigen::Matrix3d::Identity();
  Eigen::VectorXd small_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd gradient_;
};

/// Chi-squared that a patch on one of two links would show against the other one, on average. Below this they are not
/// told apart.
constexpr double kUnnoticedMisfit = 1;

class LinkGroups {
 public:
  LinkGroups(const SeenByPatch& patch, const RobotModel& robot, const LinkGravity& gravity, const LinkTest& test)
      : patch_(patch), robot_(robot), gravity_(gravity), test_(test), group_of_(test.parts.size()) {
    for (const std::size_t link : test.parts) tested_.push_back({link, turnOn(patch, gravity, link, test.priors)});
    std::iota(group_of_.begin(), group_of_.end(), std::size_t{0});
  }

  std::vector<TestedGroup> find() {
    joinAlongJoints();
    joinThoseThatFit();
    std::vector<TestedGroup> groups;
    for (std::size_t k = 0; k < tested_.size(); ++k) {
      if (group_of_[k] == k) groups.push_back(groupOf(k));
    }
    std::ranges::sort(groups, [&](const TestedGroup& a, const TestedGroup& b) {
      const double of_a = evidenceOf(a);
      const double of_b = evidenceOf(b);
      return of_a != of_b ? of_a > of_b : orderOf(a.links.front()) < orderOf(b.links.front());
    });
    return groups;
  }

 private:
  /// Independent of the order of the file.
  [[nodiscard]] std::tuple<std::size_t, std::string> orderOf(const TestedLink& tested) const {
    return {jointsBelow(robot_, tested.link), robot_.links()[tested.link].name};
  }
  static double evidenceOf(const TestedGroup& group) { return group.links[group.best].turn.log_evidence; }

  [[nodiscard]] bool fits(std::size_t k) const { return tested_[k].turn.misfit.probability() >= test_.least_probable; }

  /// Whether a patch on the one of the two that fits better would look the same on the other one.
  [[nodiscard]] bool lookTheSame(std::size_t a, std::size_t b) const {
    if (tested_[a].turn.log_evidence < tested_[b].turn.log_evidence) std::swap(a, b);
    const SeenByPatch expected = expectedOf(patch_, gravity_, tested_[a].link, tested_[a].turn.R_l_o);
    return turnOn(expected, gravity_, tested_[b].link, test_.priors).misfit.chi_squared < kUnnoticedMisfit;
  }

  void join(std::size_t a, std::size_t b) {
    const std::size_t from = group_of_[b];
    const std::size_t to = group_of_[a];
    std::ranges::replace(group_of_, std::max(from, to), std::min(from, to));
  }

  /// Links with a joint between them that was not moved, or not so that gravity shows it.
  void joinAlongJoints() {
    for (std::size_t k = 0; k < tested_.size(); ++k) {
      const std::optional<std::size_t> joint = robot_.links()[tested_[k].link].joint;
      if (!joint) continue;
      const std::size_t carrier = robot_.partOf(robot_.joints()[*joint].parent);
      const auto at = std::ranges::find(test_.parts, carrier);
      if (at == test_.parts.end()) continue;
      const auto below = static_cast<std::size_t>(at - test_.parts.begin());
      if (lookTheSame(below, k)) join(below, k);
    }
  }

  /// Links that joints bring back to the same direction, like both ends of a parallelogram.
  void joinThoseThatFit() {
    for (std::size_t a = 0; a < tested_.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if (group_of_[a] != group_of_[b] && fits(a) && fits(b) && lookTheSame(a, b)) join(a, b);
      }
    }
  }

  [[nodiscard]] TestedGroup groupOf(std::size_t number) const {
    TestedGroup group;
    for (std::size_t k = 0; k < tested_.size(); ++k) {
      if (group_of_[k] != number) continue;
      group.links.push_back(tested_[k]);
      group.fits = group.fits || fits(k);
    }
    std::ranges::sort(group.links, {}, [&](const TestedLink& tested) { return orderOf(tested); });
    const auto best =
        std::ranges::max_element(group.links, {}, [](const TestedLink& tested) { return tested.turn.log_evidence; });
    group.best = static_cast<std::size_t>(best - group.links.begin());
    return group;
  }

  const SeenByPatch& patch_;
  const RobotModel& robot_;
  const LinkGravity& gravity_;
  const LinkTest& test_;
  std::vector<TestedLink> tested_;
  std::vector<std::size_t> group_of_;  // the first one of the group
};

}  // namespace

LinkGravity::LinkGravity(const RobotModel& robot, std::span<const JointAngles> angles, const Eigen::Vector3d& up_w,
                         std::span<const double> zeros)
    : robot_(robot), up_w_(up_w) {
  const std::vector<RobotJoint>& joints = robot.joints();
  for (JointAngles pose : angles) {
    for (std::size_t joint = 0; joint < zeros.size(); ++joint) {
      if (zeros[joint] != 0) pose.positions[joints[joint].name] += zeros[joint];
    }
    T_w_l_.push_back(robot.forward(pose));
  }
  for (std::size_t link = 0; link < robot.links().size(); ++link) {
    std::vector<Step>& steps = steps_to_.emplace_back();
    std::vector<std::size_t>& followed = joints_to_.emplace_back();
    for (auto joint = robot.links()[link].joint; joint; joint = robot.links()[joints[*joint].parent].joint) {
      if (!joints[*joint].turns()) continue;
      Step step{*joint, *joint, 1};
      bool is_known_itself = false;
      while (joints[step.follows].mimic && !is_known_itself) {
        is_known_itself = anyNames(angles, joints[step.follows].name);
        step.multiplier *= joints[step.follows].mimic->multiplier;
        step.follows = joints[step.follows].mimic->joint;
      }
      if (is_known_itself || !joints[step.follows].turns()) continue;
      steps.push_back(step);
      followed.push_back(step.follows);
    }
    std::ranges::sort(followed);
    followed.erase(std::unique(followed.begin(), followed.end()), followed.end());
  }
}

Eigen::Vector3d LinkGravity::byZero(std::size_t link, std::size_t pose, std::size_t joint) const {
  Eigen::Vector3d axis_w = Eigen::Vector3d::Zero();
  for (const Step& step : steps_to_[link]) {
    if (step.follows != joint) continue;
    const RobotJoint& turned = robot_.joints()[step.joint];
    axis_w += step.multiplier * (T_w_l_[pose][turned.child].R * turned.axis);
  }
  return T_w_l_[pose][link].R.transpose() * up_w_.cross(axis_w);
}

SeenByPatch::SeenByPatch(GravitySeen seen, std::vector<std::size_t> places)
    : seen_(std::move(seen)), places_(std::move(places)), factor_(seen_.covariance) {
  for (const Eigen::Vector3d& up : seen_.up) across_.emplace_back(acrossBasis(up).transpose());
}

Eigen::Vector2d SeenByPatch::residual(std::size_t k, const Eigen::Vector3d& foretold) const {
  const Eigen::Vector2d across = across_[k] * foretold;
  const double along = seen_.up[k].dot(foretold);
  const double size = across.norm();
  const double angle_rad = std::atan2(size, along);
  if (size > 1e-9) return across * (angle_rad / size);
  return along > 0 ? across : Eigen::Vector2d(angle_rad, 0);
}

LinkTurn turnOn(const SeenByPatch& patch, const LinkGravity& robot, std::size_t link, const RobotPriors& priors) {
  return TurnProblem(patch, robot, link, priors).solve();
}

SeenByPatch expectedOf(const SeenByPatch& patch, const LinkGravity& robot, std::size_t link,
                       const Eigen::Matrix3d& R_l_o) {
  GravitySeen expected = patch.seen();
  Eigen::MatrixXd carried = Eigen::MatrixXd::Zero(rowOf(patch.size()), rowOf(patch.size()));
  for (std::size_t k = 0; k < patch.size(); ++k) {
    const Eigen::Vector3d& seen = patch.seen().up[k];
    expected.up[k] = (R_l_o.transpose() * robot.up(link, patch.placeOf(k))).normalized();
    carried.block<2, 2>(rowOf(k), rowOf(k)) =
        acrossBasis(expected.up[k]).transpose() * shortestRotation(seen, expected.up[k]) * acrossBasis(seen);
  }
  expected.covariance = carried * patch.seen().covariance * carried.transpose();
  return {std::move(expected), patch.places()};
}

std::size_t jointsBelow(const RobotModel& robot, std::size_t link) {
  std::size_t count = 0;
  for (auto joint = robot.links()[link].joint; joint; joint = robot.links()[robot.joints()[*joint].parent].joint) {
    if (robot.joints()[*joint].type != JointType::Fixed) ++count;
  }
  return count;
}

std::vector<TestedGroup> testLinks(const SeenByPatch& patch, const RobotModel& robot, const LinkGravity& gravity,
                                   const LinkTest& test) {
  return LinkGroups(patch, robot, gravity, test).find();
}

}  // namespace hexoderm
