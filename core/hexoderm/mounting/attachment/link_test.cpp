#include "hexoderm/mounting/attachment/link_test.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace hexoderm {
namespace {

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
