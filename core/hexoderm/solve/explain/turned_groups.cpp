#include "hexoderm/base/median.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/explain/explainer.h"
#include "hexoderm/solve/faults/sensor_turn.h"
#include "hexoderm/solve/faults/turn_map.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <span>
#include <utility>

namespace hexoderm {
namespace {

/// A link between two cells that measure.
struct ComparedLink {
  std::size_t source = 0;  ///< cells of the graph
  std::size_t target = 0;
  Eigen::Matrix3d R_nom = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< twist, bend and yaw in the source's frame
  /// As the cells read, and as they would if one of them read everything with the other sign.
  struct Seen {
    Eigen::Matrix3d R_c_n = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    double misfit = 0;  ///< squared, of the readings with this rotation
  };
  Seen same;
  Seen reflected;
};

double squaredMisfit(const EdgeRotation& edge, Eigen::Index poses) {
  constexpr double kGranted = 2;  // times what is expected
  const double expected = std::max(edge.expected_residual_rad, 1e-6);
  const double ratio = edge.residual_rad * edge.residual_rad / (expected * expected);
  return static_cast<double>(std::max<Eigen::Index>(0, 2 * poses - 3)) * std::max(0.0, ratio - kGranted);
}

/// A squared misfit beyond which a link is no skin link, whatever else it is.
constexpr double kLargestMisfit = 30;
/// What each link on the border of a group must gain at least.
constexpr double kCostOfBorder = 2;

/// Of every link whether its source and its target belong to the group: 2 * source + target.
using MisfitsOfLink = std::array<double, 4>;

/// The links of one patch, and which of its cells belong to a group.
class GroupSearch {
 public:
  GroupSearch(const SkinLinks& skin, std::size_t patch)
      : skin_(skin), cells_(skin.graph().patches()[patch]), patch_(patch) {}

  struct Group {
    SensorTurn turn;
    std::vector<bool> has;  ///< per cell of the patch
    std::size_t size = 0;
    double misfit = 0;  ///< squared, of all links
    std::size_t border = 0;
    bool is_open = false;  ///< the others may as well be the turned ones
  };

  [[nodiscard]] std::optional<Group> find() {
    compareLinks();
    const std::vector<std::size_t> bad = implausible();
    if (bad.empty()) return std::nullopt;
    headings_ = flatHeadings(skin_, patch_);
    for (ComparedLink& link : links_) compareReflected(link);
    double misfit = 0;
    for (const ComparedLink& link : links_) misfit += misfitOf(link, SensorTurn{}, false, false);
    std::optional<Group> best;
    for (const SensorTurn& turn : likelyTurns(bad)) {
      constexpr double kCostOfReflection = 6;  // seen from two directions, a turn may look like one
      Group group = groupOf(turn);
      if (turn.sign < 0) group.misfit += kCostOfReflection;
      if (!best || group.misfit < best->misfit) best = std::move(group);
    }
    if (!best) return std::nullopt;
    if (best->size == cells_.size()) return std::nullopt;  // nothing tells them from the model
    chooseSide(*best);
    return misfit - best->misfit >= kLeastGain && isOneGroup(*best) ? best : std::nullopt;
  }

 private:
  static constexpr double kLeastGain = 20;

  [[nodiscard]] std::size_t placeOf(std::size_t cell) const { return skin_.graph().cells()[cell].place; }

  void compareLinks() {
    const SkinGraph& graph = skin_.graph();
    std::array<std::vector<double>, 3> angles;
    at_.assign(cells_.size(), {});
    for (const std::size_t cell : cells_) {
      for (const std::size_t k : graph.linksAt(cell)) {
        const GraphLink& link = graph.links()[k];
        if (link.muted() || link.source != cell || !skin_.readings().measured(link)) continue;
        const EdgeRotation& edge = skin_.edges()[k];
        at_[placeOf(link.source)].push_back(links_.size());
        at_[placeOf(link.target)].push_back(links_.size());
        of_graph_.push_back(k);
        const auto poses = static_cast<Eigen::Index>(skin_.readings().posesOf(link).size());
        links_.push_back({placeOf(link.source),
                          placeOf(link.target),
                          nominalAlignment(skin_.sourcePort(link), skin_.targetPort(link)),
                          linkAxes(skin_.sourcePort(link)),
                          {edge.R_c_n, edge.covariance, squaredMisfit(edge, poses)},
                          {}});
        angles[0].push_back(std::abs(edge.angles.twist_rad));
        angles[1].push_back(std::abs(edge.angles.bend_rad));
        angles[2].push_back(std::abs(edge.angles.yaw_rad));
      }
    }
    if (links_.empty()) return;
    const CellModel& model = skin_.model();
    const Eigen::Vector3d of_model(model.twist_sigma_rad, model.bend_sigma_rad, model.yaw_sigma_rad);
    const Eigen::Vector3d seen(median(angles[0]), median(angles[1]), median(angles[2]));
    // Of a flat skin a link that bends by 60 degrees is none.
    sigma_ = (2 * seen).cwiseMax(of_model.cwiseProduct(Eigen::Vector3d(0.5, 0.3, 1))).cwiseMin(1.5 * of_model);
  }

  void compareReflected(ComparedLink& link) const {
    const std::size_t index = of_graph_[static_cast<std::size_t>(&link - links_.data())];
    const GraphLink& of_graph = skin_.graph().links()[index];
    EdgeReadings readings = skin_.readings().readingsOf(of_graph);
    readings.n_g *= -1;
    const EdgeRotation edge = estimateEdgeRotation(skin_.model(), skin_.sourcePort(of_graph),
                                                   skin_.targetPort(of_graph), readings, skin_.options());
    link.reflected = {edge.R_c_n, edge.covariance, squaredMisfit(edge, readings.n_g.cols())};
  }

  /// Squared misfit of a link if the given ends belong to the group.
  [[nodiscard]] double misfitOf(const ComparedLink& link, const SensorTurn& turn, bool source, bool target) const {
    const ComparedLink::Seen& seen = seenOf(link, turn, source != target);
    if (seen.misfit >= kLargestMisfit) return kLargestMisfit;
    const Eigen::Vector3d off = anglesOf(link, turn, source, target);
    const Eigen::Matrix3d axes = source ? Eigen::Matrix3d(turn.R * link.axes) : link.axes;
    Eigen::Matrix3d covariance = axes.transpose() * seen.covariance * axes;
    covariance.diagonal() += sigma_.cwiseAbs2();
    return std::min(kLargestMisfit, seen.misfit + off.dot(covariance.ldlt().solve(off)));
  }

  [[nodiscard]] static const ComparedLink::Seen& seenOf(const ComparedLink& link, const SensorTurn& turn, bool border) {
    return border && turn.sign < 0 ? link.reflected : link.same;
  }

  /// Twist, bend and yaw of the link likewise.
  [[nodiscard]] static Eigen::Vector3d anglesOf(const ComparedLink& link, const SensorTurn& turn, bool source,
                                                bool target) {
    Eigen::Matrix3d R_c_n = seenOf(link, turn, source != target).R_c_n;
    if (source) R_c_n = (turn.R.transpose() * R_c_n).eval();
    if (target) R_c_n = (R_c_n * turn.R).eval();
    return link.axes.transpose() * logSO3(R_c_n * link.R_nom.transpose());
  }

  [[nodiscard]] MisfitsOfLink misfitsOf(const ComparedLink& link, const SensorTurn& turn) const {
    return {misfitOf(link, turn, false, false), misfitOf(link, turn, false, true) + kCostOfBorder,
            misfitOf(link, turn, true, false) + kCostOfBorder, misfitOf(link, turn, true, true)};
  }

  /// Of those links of which there are many, some.
  [[nodiscard]] std::vector<std::size_t> implausible() const {
    constexpr std::size_t kEnough = 200;
    std::vector<std::size_t> bad;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      if (misfitOf(links_[k], SensorTurn{}, false, false) >= kLargestMisfit / 2) bad.push_back(k);
    }
    const std::size_t step = bad.size() / kEnough + 1;
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < bad.size(); k += step) some.push_back(bad[k]);
    return some;
  }

  /// Those that explain most of the bad links, each by itself.
  [[nodiscard]] std::vector<SensorTurn> likelyTurns(std::span<const std::size_t> bad) const {
    constexpr std::size_t kMost = 6;
    std::vector<std::pair<double, SensorTurn>> turns;
    for (const SensorTurn& turn : possibleSensorTurns()) {
      double gain = 0;
      for (const std::size_t k : bad) {
        const MisfitsOfLink misfits = misfitsOf(links_[k], turn);
        gain += misfits[0] - *std::ranges::min_element(misfits);
      }
      if (gain >= kLeastGain) turns.emplace_back(gain, turn);
    }
    std::ranges::stable_sort(turns, std::greater<>(), &std::pair<double, SensorTurn>::first);
    std::vector<SensorTurn> likely;
    for (std::size_t k = 0; k < std::min(kMost, turns.size()); ++k) likely.push_back(turns[k].second);
    return likely;
  }

  [[nodiscard]] Group groupOf(const SensorTurn& turn) const {
    std::vector<MisfitsOfLink> misfits;
    misfits.reserve(links_.size());
    for (const ComparedLink& link : links_) misfits.push_back(misfitsOf(link, turn));
    Group outside = grow(turn, misfits, false);
    Group inside = grow(turn, misfits, true);
    return inside.misfit < outside.misfit ? inside : outside;
  }

  /// The most probable group if the first cell belongs to it, or if it does not: cells are decided one after the other,
  /// those first of which the decided ones say most, and then each once more by all its neighbours.
  [[nodiscard]] Group grow(const SensorTurn& turn, std::span<const MisfitsOfLink> misfits, bool first) const {
    Group group{turn, std::vector<bool>(cells_.size(), false), 0, 0, 0, false};
    std::vector<bool> decided(cells_.size(), false);
    std::vector<std::array<double, 2>> pull(cells_.size(), {0, 0});
    std::priority_queue<std::pair<double, std::size_t>> next;
    for (std::size_t start = 0; start < cells_.size(); ++start) {
      if (decided[start]) continue;  // more than once only where links have no readings
      pull[start][first ? 0 : 1] += kLargestMisfit;
      next.emplace(kLargestMisfit, start);
      while (!next.empty()) {
        const auto [clear, place] = next.top();
        next.pop();
        if (decided[place]) continue;
        decided[place] = true;
        group.has[place] = pull[place][1] < pull[place][0];
        for (const std::size_t k : at_[place]) {
          const bool is_source = links_[k].source == place;
          const std::size_t other = is_source ? links_[k].target : links_[k].source;
          if (decided[other]) continue;
          for (const std::size_t label : {0U, 1U}) {
            const std::size_t own = group.has[place] ? 1 : 0;
            pull[other].at(label) += misfits[k].at(is_source ? 2 * own + label : 2 * label + own);
          }
          next.emplace(std::abs(pull[other][0] - pull[other][1]), other);
        }
      }
    }
    settle(group, misfits);
    return group;
  }

  void settle(Group& group, std::span<const MisfitsOfLink> misfits) const {
    constexpr int kRounds = 5;
    const auto misfitIf = [&](std::size_t k, bool source, bool target) {
      return misfits[k].at((source ? 2U : 0U) + (target ? 1U : 0U));
    };
    bool has_changed = true;
    for (int round = 0; round < kRounds && has_changed; ++round) {
      has_changed = false;
      for (std::size_t place = 0; place < cells_.size(); ++place) {
        double gain = 0;
        for (const std::size_t k : at_[place]) {
          const bool source = group.has[links_[k].source];
          const bool target = group.has[links_[k].target];
          const bool is_source = links_[k].source == place;
          gain += misfitIf(k, source, target) - misfitIf(k, is_source != source, is_source == target);
        }
        if (gain <= 0) continue;
        group.has[place] = !group.has[place];
        has_changed = true;
      }
    }
    sumUp(group, misfits);
  }

  void sumUp(Group& group, std::span<const MisfitsOfLink> misfits) const {
    group.misfit = 0;
    group.border = 0;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const bool source = group.has[links_[k].source];
      const bool target = group.has[links_[k].target];
      group.misfit += misfits[k].at((source ? 2U : 0U) + (target ? 1U : 0U));
      if (source != target) ++group.border;
    }
    group.size = static_cast<std::size_t>(std::ranges::count(group.has, true));
  }

  /// Turned the other way, the others explain the links as well where the turn leaves links within a side plausible.
  /// Then the group is the smaller side, or of sides of about one size that with which the patch is a surface, and
  /// bends outwards.
  void chooseSide(Group& group) const {
    constexpr double kClearlyFewer = 1.0 / 3;
    const double alike = 10 + 3 * static_cast<double>(links_.size());
    Group others = group;
    others.turn = group.turn.inverse();
    others.has.flip();
    std::vector<MisfitsOfLink> misfits;
    misfits.reserve(links_.size());
    for (const ComparedLink& link : links_) misfits.push_back(misfitsOf(link, others.turn));
    sumUp(others, misfits);
    if (others.misfit > group.misfit + alike) return;
    if (others.size < group.size) std::swap(others, group);
    if (static_cast<double>(group.size) <= kClearlyFewer * static_cast<double>(cells_.size())) return;
    constexpr double kUnlike = 5;
    constexpr double kClearlyBent = 4;  // deviations
    const TurnMap map = mapOf(group);
    const TurnMap of_others = mapOf(others);
    const double outwards = skin_.snapshot().side == SkinSide::Concave ? -1 : 1;
    const auto isBent = [&](const TurnMap& of) { return std::abs(of.bend_rad) > kClearlyBent * of.bend_sigma_rad; };
    if (std::max(map.deviate, of_others.deviate) > kUnlike && std::abs(map.deviate - of_others.deviate) > kUnlike) {
      if (of_others.deviate < map.deviate) group = std::move(others);
    } else if (isBent(map) && isBent(of_others) && map.bend_rad * of_others.bend_rad < 0) {
      if (of_others.bend_rad * outwards > 0) group = std::move(others);
    } else {
      group.is_open = true;
    }
  }

  /// The links as they are once the group's readings are turned back.
  [[nodiscard]] TurnMap mapOf(const Group& group) const {
    std::vector<DirectedTurn> turns;
    turns.reserve(links_.size());
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const ComparedLink& link = links_[k];
      const GraphLink& of_graph = skin_.graph().links()[of_graph_[k]];
      turns.push_back({anglesOf(link, group.turn, group.has[link.source], group.has[link.target]),
                       headings_[link.source] + headingOf(skin_.sourcePort(of_graph))});
    }
    return fitTurnMap(turns);
  }

  [[nodiscard]] bool isOneGroup(const Group& group) const {
    constexpr std::size_t kFewest = 2;
    if (std::min(group.size, cells_.size() - group.size) < kFewest) return false;
    if (group.border < 2 && !isClearFromOneLink(group)) return false;
    const bool has_neighbors = std::ranges::any_of(
        links_, [&](const ComparedLink& link) { return group.has[link.source] && group.has[link.target]; });
    if (!has_neighbors && group.size < 3) return false;
    // What the turn leaves must be links of a skin.
    constexpr double kUsual = kLargestMisfit / 3;
    double misfit = 0;
    double touching = 0;
    for (const ComparedLink& link : links_) {
      const bool source = group.has[link.source];
      const bool target = group.has[link.target];
      if (source == target) continue;
      misfit += misfitOf(link, group.turn, source, target);
      ++touching;
    }
    return misfit <= kUsual * touching;
  }

  /// A single link between both sides may be a cable, or have a wrong port number: few of these look like half a turn
  /// about an axis in the surface, and none like a reflection.
  [[nodiscard]] bool isClearFromOneLink(const Group& group) const {
    if (group.turn.sign > 0) return group.turn.isHalfTurn() && !group.turn.isAboutZ();
    return std::ranges::all_of(links_, [&](const ComparedLink& link) {
      return group.has[link.source] == group.has[link.target] || link.same.misfit >= kLargestMisfit;
    });
  }

  const SkinLinks& skin_;
  std::span<const std::size_t> cells_;  ///< of the patch
  std::size_t patch_;
  std::vector<double> headings_;                     ///< flatHeadings()
  std::vector<ComparedLink> links_;                  ///< cells by their place in the patch
  std::vector<std::size_t> of_graph_;                ///< per link
  std::vector<std::vector<std::size_t>> at_;         ///< per cell, indices into links_
  Eigen::Vector3d sigma_ = Eigen::Vector3d::Zero();  ///< scatter of twist, bend and yaw
};

class TurnedGroups {
 public:
  [[nodiscard]] std::optional<Explanation> operator()(const Estimate& estimate) {
    if (std::exchange(revision_, estimate.linkRevision()) == estimate.linkRevision()) return std::nullopt;
    const SkinLinks& skin = estimate.skin();
    Explanation found;
    for (std::size_t patch = 0; patch < skin.graph().patches().size(); ++patch) {
      const std::vector<std::size_t>& cells = skin.graph().patches()[patch];
      if (cells.size() < 3) continue;
      if (const auto group = GroupSearch(skin, patch).find()) add(skin, cells, *group, found);
    }
    return found.empty() ? std::nullopt : std::optional(std::move(found));
  }

 private:
  static void add(const SkinLinks& skin, std::span<const std::size_t> cells, const GroupSearch::Group& group,
                  Explanation& found) {
    std::vector<CellId> ids;
    const Eigen::Matrix3d back = group.turn.matrix().transpose();
    for (std::size_t place = 0; place < cells.size(); ++place) {
      if (!group.has[place]) continue;
      ids.push_back(skin.graph().cells()[cells[place]].id);
      for (const std::size_t pose : skin.table().usablePoses(cells[place])) {
        const Eigen::Vector3d& read_g = skin.table().at(cells[place], pose).mean_g;
        found.corrections.push_back({cells[place], pose, read_g - back * read_g, 0});
      }
    }
    Finding finding = makeFinding(
        FindingCode::TurnedGroup,
        group.is_open
            ? message("{} of the {} cells read as if they were {} against the others: either these or the others are "
                      "mounted otherwise, and readings alone leave open which. These are taken as turned.",
                      ids.size(), cells.size(), turnText(group.turn))
            : message("{} of the {} cells read as if they were {} against the others: they are mounted otherwise, or "
                      "of another batch. Their readings are turned back.",
                      ids.size(), cells.size(), turnText(group.turn)),
        ids);
    if (group.is_open) finding.severity = Severity::Error;
    found.findings.push_back(std::move(finding));
  }

  std::size_t revision_ = 0;  // of the links
};

}  // namespace

Explainer makeTurnedGroupExplainer() { return {Estimate::Stage::Links, TurnedGroups()}; }

}  // namespace hexoderm
