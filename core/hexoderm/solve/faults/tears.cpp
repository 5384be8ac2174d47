#include "hexoderm/solve/faults/tears.h"

#include "hexoderm/base/median.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/faults/suspects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace hexoderm {
namespace {

using OfAngles = std::array<double, 3>;  // twist, bend and yaw

OfAngles anglesOf(const EdgeRotation& edge) {
  return {edge.angles.twist_rad, edge.angles.bend_rad, edge.angles.yaw_rad};
}

enum class TearSide { Neither, Source, Target };

constexpr double kOdd = 4;  // deviations beyond which a link is odd

/// Per cell: which end of the link is nearer by links that are not odd.
std::vector<TearSide> sidesOf(const SkinGraph& graph, const GraphLink& link, std::span<const double> deviations) {
  std::vector<TearSide> side(graph.cells().size(), TearSide::Neither);
  side[link.source] = TearSide::Source;
  side[link.target] = TearSide::Target;
  std::vector<std::size_t> queue = {link.source, link.target};
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (const std::size_t k : graph.linksAt(queue[next])) {
      const std::size_t other = graph.links()[k].other(queue[next]);
      if (graph.links()[k].muted() || deviations[k] > kOdd || side[other] != TearSide::Neither) continue;
      side[other] = side[queue[next]];
      queue.push_back(other);
    }
  }
  return side;
}

/// What a link says for a tear, and against it where it is negative.
double scoreOf(double deviation) {
  constexpr double kAsLikelyTorn = 2;  // deviations
  return std::pow(std::min(deviation, 2 * kOdd), 2) - kAsLikelyTorn * kAsLikelyTorn;
}

/// Moves cells to the other side where their links speak for that. A link of the tear that is not odd lets in cells
/// from beyond.
void settle(const SkinGraph& graph, std::span<const double> deviations, std::vector<TearSide>& side) {
  constexpr int kTimes = 6;
  for (int time = 0; time < kTimes; ++time) {
    for (std::size_t cell = 0; cell < side.size(); ++cell) {
      if (side[cell] == TearSide::Neither) continue;
      double for_its_side = 0;
      bool is_joined = false;  // to the other side
      for (const std::size_t k : graph.linksAt(cell)) {
        const TearSide other = side[graph.links()[k].other(cell)];
        if (graph.links()[k].muted() || other == TearSide::Neither) continue;
        is_joined = is_joined || (other != side[cell] && deviations[k] <= kOdd);
        for_its_side += other == side[cell] ? -scoreOf(deviations[k]) : scoreOf(deviations[k]);
      }
      if (is_joined && for_its_side < 0)
        side[cell] = side[cell] == TearSide::Source ? TearSide::Target : TearSide::Source;
    }
  }
}

bool isBesideTear(const SkinGraph& graph, std::span<const TearSide> side, std::size_t cell) {
  return std::ranges::any_of(graph.linksAt(cell), [&](std::size_t k) {
    const TearSide other = side[graph.links()[k].other(cell)];
    return !graph.links()[k].muted() && other != TearSide::Neither && other != side[cell];
  });
}

/// Gives a side to cells beside a tear that nothing but odd links joins to the others: the one that they speak less
/// against.
void addTornOff(const SkinGraph& graph, std::span<const double> deviations, std::vector<TearSide>& side) {
  const std::vector<TearSide> before = side;
  for (std::size_t cell = 0; cell < side.size(); ++cell) {
    if (before[cell] != TearSide::Neither) continue;
    double against_source = 0;
    double against_target = 0;
    bool is_beside = false;
    for (const std::size_t k : graph.linksAt(cell)) {
      const std::size_t other = graph.links()[k].other(cell);
      if (graph.links()[k].muted() || before[other] == TearSide::Neither) continue;
      (before[other] == TearSide::Source ? against_source : against_target) += scoreOf(deviations[k]);
      is_beside = is_beside || isBesideTear(graph, before, other);
    }
    if (is_beside) side[cell] = against_source > against_target ? TearSide::Target : TearSide::Source;
  }
}

/// Of these links those that whoever walks along them, no further than a link away from them, comes to from the first.
std::vector<std::size_t> sideBySide(const SkinGraph& graph, std::size_t first, std::span<const std::size_t> links) {
  std::vector<bool> is_beside(graph.cells().size(), false);
  for (const std::size_t k : links) {
    for (const std::size_t cell : {graph.links()[k].source, graph.links()[k].target}) {
      is_beside[cell] = true;
      for (const std::size_t beside : graph.linksAt(cell)) is_beside[graph.links()[beside].other(cell)] = true;
    }
  }
  std::vector<std::size_t> queue = {graph.links()[first].source};
  is_beside[queue.front()] = false;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (const std::size_t k : graph.linksAt(queue[next])) {
      const std::size_t other = graph.links()[k].other(queue[next]);
      if (!is_beside[other]) continue;
      is_beside[other] = false;
      queue.push_back(other);
    }
  }
  std::vector<std::size_t> reached;
  std::ranges::copy_if(links, std::back_inserter(reached),
                       [&](std::size_t k) { return !is_beside[graph.links()[k].source]; });
  return reached;
}

/// The link that a finding is about.
std::optional<std::size_t> linkOf(const SkinGraph& graph, const Finding& finding) {
  if (finding.cells.size() != 2 || finding.ports.size() != 2) return std::nullopt;
  return graph.indexOf({finding.cells[0], finding.ports[0]}, {finding.cells[1], finding.ports[1]});
}

}  // namespace

std::vector<double> linkDeviations(const SkinLinks& skin) {
  constexpr double kLeastScatter = 3 * kDegree;
  constexpr double kOfNormal = 1.4826;  // standard deviation over median absolute deviation
  const SkinGraph& graph = skin.graph();
  const auto isJudged = [&](std::size_t k) {
    return !graph.links()[k].muted() && skin.readings().measured(graph.links()[k]);
  };
  std::vector<std::vector<std::size_t>> of_patches(graph.patches().size());
  for (std::size_t k = 0; k < graph.links().size(); ++k) {
    if (isJudged(k)) of_patches[graph.cells()[graph.links()[k].source].patch.value()].push_back(k);
  }
  const SuspectSearch search(skin);
  std::vector<double> deviations(graph.links().size(), 0);
  for (const std::vector<std::size_t>& links : of_patches) {
    if (links.empty()) continue;
    for (std::size_t angle = 0; angle < OfAngles{}.size(); ++angle) {
      std::vector<double> values;
      for (const std::size_t k : links) values.push_back(anglesOf(skin.edges()[k])[angle]);
      const double middle = median(values);
      std::vector<double> off;
      for (const double value : values) off.push_back(std::abs(value - middle));
      const double scatter = std::max(kLeastScatter, kOfNormal * median(off));
      for (std::size_t k = 0; k < links.size(); ++k) {
        double& deviation = deviations[links[k]];
        deviation = std::max(deviation, off[k] / std::hypot(scatter, skin.edges()[links[k]].deviation_rad));
      }
    }
    for (const std::size_t k : links) deviations[k] = std::max(deviations[k], search.misfitOf(k));
  }
  return deviations;
}

std::vector<std::size_t> tearThrough(const SkinLinks& skin, std::size_t link, std::span<const double> deviations) {
  constexpr double kMeanScore = 8;
  const SkinGraph& graph = skin.graph();
  std::vector<TearSide> side = sidesOf(graph, graph.links()[link], deviations);
  settle(graph, deviations, side);
  addTornOff(graph, deviations, side);
  std::vector<std::size_t> between;
  for (std::size_t k = 0; k < graph.links().size(); ++k) {
    const TearSide source = side[graph.links()[k].source];
    const TearSide target = side[graph.links()[k].target];
    const bool has_sides = source != TearSide::Neither && target != TearSide::Neither;
    if (!graph.links()[k].muted() && has_sides && source != target) between.push_back(k);
  }
  if (std::ranges::count(between, link) == 0) return {};
  std::vector<std::size_t> links = sideBySide(graph, link, between);
  double score = 0;  // of the others
  for (const std::size_t k : links) score += k == link ? 0 : scoreOf(deviations[k]);
  const auto cells = static_cast<std::size_t>(
      std::min(std::ranges::count(side, TearSide::Source), std::ranges::count(side, TearSide::Target)));
  const bool is_tear =
      links.size() > 1 && cells > links.size() && score >= kMeanScore * static_cast<double>(links.size() - 1);
  return is_tear ? links : std::vector<std::size_t>();
}

Finding describeTear(const SkinLinks& skin, std::vector<std::size_t> links) {
  const SkinGraph& graph = skin.graph();
  std::vector<CellId> cells;
  std::vector<PortNumber> ports;
  for (const std::size_t k : links) {
    for (const LinkEnd& end : {graph.sourceEnd(graph.links()[k]), graph.targetEnd(graph.links()[k])}) {
      cells.push_back(end.cell);
      ports.push_back(end.port);
    }
  }
  const auto textOf = [&](std::size_t k) {
    return linkText(graph.sourceEnd(graph.links()[k]), graph.targetEnd(graph.links()[k]));
  };
  return makeFinding(
      FindingCode::TornSkin,
      message("{} links that lie side by side fit no skin, from the {} to the {}: the skin is torn along "
              "them, or a joint or cables lie between its two sides. The links are not used.",
              links.size(), textOf(links.front()), textOf(links.back())),
      std::move(cells), std::move(ports));
}

void foldTears(const SkinLinks& skin, Explanation& explanation) {
  constexpr std::size_t kTries = 8;  // links of no tear: where there are many, no part of the skin is sound
  std::vector<std::size_t> bad;
  for (const auto& [why, links] : explanation.links) bad.insert(bad.end(), links.begin(), links.end());
  if (bad.size() < 2 || explanation.links.contains(FindingCode::TornSkin)) return;
  std::vector<double> deviations = linkDeviations(skin);
  for (const std::size_t link : bad) deviations[link] = std::max(deviations[link], 2 * kOdd);
  std::vector<std::vector<std::size_t>> tears;
  std::set<std::size_t> torn;
  std::size_t tries = 0;
  for (const std::size_t link : bad) {
    if (torn.contains(link)) continue;
    if (tries++ == kTries) break;
    const std::vector<std::size_t> tear = tearThrough(skin, link, deviations);
    if (tear.empty() || std::ranges::any_of(tear, [&](std::size_t k) { return torn.contains(k); })) continue;
    torn.insert(tear.begin(), tear.end());
    tears.push_back(tear);
  }
  for (auto& [why, links] : explanation.links) std::erase_if(links, [&](std::size_t k) { return torn.contains(k); });
  std::erase_if(explanation.links, [](const auto& of_code) { return of_code.second.empty(); });
  std::erase_if(explanation.findings, [&](const Finding& finding) {
    const auto link = linkOf(skin.graph(), finding);
    return link && torn.contains(*link);
  });
  for (const std::vector<std::size_t>& tear : tears) {
    explanation.findings.push_back(describeTear(skin, tear));
    auto& links = explanation.links[FindingCode::TornSkin];
    links.insert(links.end(), tear.begin(), tear.end());
  }
}

}  // namespace hexoderm
