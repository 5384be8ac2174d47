#include "tests/benchmarks/reproduce/trials.h"

#include "hexoderm/base/text.h"
#include "hexoderm/solve/reconstructor.h"

#include <algorithm>
#include <iostream>
#include <set>

namespace hexoderm::cli {
namespace {

constexpr std::size_t kFullRun = 200;  ///< from so many seeds on, rare events are counted in
constexpr std::size_t kFullSessions = 500;

struct Case {
  std::string name;
  std::size_t poses = 3;
  std::optional<SkinFault> sensor;
  std::optional<LinkFaultKind> link;
  CellId cell;                      ///< 0: healthy
  std::optional<double> bar_found;  ///< percent, at least
  std::optional<double> bar_false;  ///< percent of links, at most
};

/// The link of a cell that leads away from the middle; of a leaf its only one.
std::pair<LinkEnd, LinkEnd> outwardLink(const std::vector<NeighborReport>& links, CellId cell) {
  std::pair<LinkEnd, LinkEnd> ends;
  for (const NeighborReport& link : links) {
    if (link.cell < ends.second.cell) continue;
    ends = {{cell, link.port}, {link.cell, *link.cell_port}};
  }
  return ends;
}

using CellPair = std::pair<CellId, CellId>;

void judge(Tally& tally, const Case& what, const std::optional<CellPair>& bad_link, bool is_leaf,
           const Reconstruction& result) {
  bool link_named = false;
  for (const PatchReconstruction& patch : result.patches) {
    for (const LinkEstimate& link : patch.links) {
      const bool is_bad =
          bad_link && std::minmax(link.source.cell, link.target.cell) == std::minmax(bad_link->first, bad_link->second);
      if (is_bad) {
        link_named = link_named || link.muted_by;
      } else {
        tally.count("false links", link.muted_by.has_value());
      }
    }
  }
  std::set<CellId> blamed;
  for (const Finding& finding : result.findings) {
    if (finding.severity != Severity::Info && finding.cells.size() == 1) blamed.insert(finding.cells.front());
  }
  const bool cell_named = blamed.contains(what.cell);
  // At a leaf, a turned link and a broken sensor look alike.
  const bool either = is_leaf && (link_named || cell_named);
  if (what.link) tally.count("found", link_named || either);
  if (what.sensor) tally.count("found", cell_named || either);
  const bool cell_may_be_named = what.sensor || is_leaf;
  tally.add("false cells", blamed.size() - (cell_may_be_named && cell_named ? 1 : 0),
            result.cellCount() - (cell_may_be_named ? 1 : 0));
}

void runTrial(Tally& tally, const Case& what, std::size_t seed) {
  SkinCase skin_case = {.patch = "x17", .surface = "cylinder:r=0.0501", .poses = what.poses};
  std::optional<CellPair> bad_link;
  bool is_leaf = false;
  if (what.cell.value() != 0) {
    const std::vector<NeighborReport> links = linksOf(makeSkin(skin_case, seed), what.cell);
    const auto [end, other] = outwardLink(links, what.cell);
    is_leaf = links.size() == 1;
    if (what.link) skin_case.link_faults.push_back({*what.link, end});
    if (what.sensor) skin_case.faults.push_back({*what.sensor, what.cell});
    // A leaf's broken sensor excuses its link.
    if (what.link || is_leaf) bad_link = CellPair(end.cell, other.cell);
  }
  SimulatedSkin skin = makeSkin(skin_case, seed);
  judge(tally, what, bad_link, is_leaf, *reconstruct(*measure(skin, skin_case).snapshot()));
}

std::vector<Case> cases() {
  const CellId middle(2);
  const CellId inner(3);
  const CellId leaf(17);
  constexpr auto kJoint = LinkFaultKind::Joint;
  constexpr auto kPort = LinkFaultKind::WrongPort;
  constexpr double kFalse = 0.2;
  return {{"joint turned by 20 deg, middle (cell 2)", 4, {}, kJoint, middle, 90, kFalse},
          {"wrong port, cell 3", 3, {}, kPort, inner, 99, {}},
          {"wrong port, leaf 17", 3, {}, kPort, leaf, 99, {}},
          {"stuck sensor, cell 3", 3, SkinFault::Stuck, {}, inner, 99, {}},
          {"stuck sensor, leaf 17", 3, SkinFault::Stuck, {}, leaf, 99, {}},
          {"one axis dead, cell 3", 3, SkinFault::DeadAxis, {}, inner, 99, {}},
          {"one axis dead, leaf 17", 3, SkinFault::DeadAxis, {}, leaf, 99, {}},
          {"one axis stuck, cell 3", 3, SkinFault::StuckAxis, {}, inner, {}, {}},
          {"one axis stuck, leaf 17", 3, SkinFault::StuckAxis, {}, leaf, {}, {}},
          {"healthy", 3, {}, {}, CellId(), {}, kFalse},
          {"healthy", 4, {}, {}, CellId(), {}, kFalse}};
}

std::string barText(const Case& what) {
  std::string bar;
  if (what.bar_found) bar += ">= " + formatFixed(*what.bar_found, 0) + " %";
  if (what.bar_false) bar += std::string(bar.empty() ? "" : ", ") + "<= " + formatFixed(*what.bar_false, 1) + " %";
  return bar.empty() ? "-" : bar;
}

FigureRow runRow(const Trials& trials, const Case& what, std::size_t sessions) {
  const Tally tally =
      trials.run(what.name, sessions, [&](Tally& found, std::size_t seed) { runTrial(found, what, seed); });
  const auto found = tally.percent("found");
  const auto false_links = tally.percent("false links");
  return {ofText("fault", "fault", what.name),
          ofCount("poses", "poses", what.poses),
          ofPercent("found", "found_percent", found, 1),
          ofPercent("false, per link", "false_per_link_percent", false_links, 3),
          ofPercent("false, per cell", "false_per_cell_percent", tally.percent("false cells"), 3),
          ofText("bars", "", barText(what)),
          ofNumber("", "bar_found_percent", what.bar_found),
          ofNumber("", "bar_false_percent", what.bar_false),
          ofBar(what.bar_found || what.bar_false,
                (!what.bar_found || found >= what.bar_found) && (!what.bar_false || false_links <= what.bar_false))};
}

}  // namespace

Json countDetections(const Trials& trials, bool prints) {
  const std::size_t sessions = trials.seeds() < kFullRun ? trials.seeds() : std::max(trials.seeds(), kFullSessions);
  std::vector<FigureRow> rows;
  for (const Case& what : cases()) rows.push_back(runRow(trials, what, sessions));
  if (prints) {
    std::cout
        << "What is broken is found, on a simulated X17, global solver, defaults: " << sessions
        << " sessions per row.\n"
        << "Found: named as what it is; at a leaf, cell or link. False: sound links muted, sound cells blamed.\n\n";
    printTable(rows);
  }
  return {{"sessions", sessions}, {"rows", toJson(rows)}, {"garbage", countGarbage(trials, prints)}};
}

}  // namespace hexoderm::cli
