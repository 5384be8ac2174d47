#include "tests/benchmarks/reproduce/detection_bound.h"
#include "tests/benchmarks/reproduce/experiments.h"

#include "hexoderm/base/text.h"
#include "hexoderm/sim/fault_names.h"
#include "hexoderm/solve/reconstructor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <set>

namespace hexoderm::cli {
namespace {

constexpr std::size_t kFullSeeds = 200;         ///< from so many seeds on, healthy sessions are counted in
constexpr std::size_t kHealthySessions = 2000;  ///< for each of the two healthy rows
constexpr double kBarFound = 95;                ///< percent
constexpr double kBelowBound = 5;               ///< percent, where the bound is lower than the bar
constexpr double kBarFalseAlarms = 0.2;         ///< percent of sessions
constexpr double kBarAccused = 0.1;             ///< percent of cells

struct Garbage {
  std::string name;
  std::size_t poses = 3;
  std::optional<SkinFault> cell_fault;
  std::optional<WholeSkinFault> whole_fault;
};

struct Outcome {
  bool found = false;
  std::optional<BestDetection> best;
};

bool isAlarm(const Finding& finding) {
  return finding.severity != Severity::Info && finding.code != FindingCode::TooFewDirections;
}

/// Only noise can be left of such a skin.
bool mustFail(WholeSkinFault fault) {
  return fault == WholeSkinFault::Identical || fault == WholeSkinFault::Random || fault == WholeSkinFault::Shuffled ||
         fault == WholeSkinFault::PortOffset;
}

/// The cell that a session's fault is at: any, but a leaf for a cell that came loose.
CellId faultyCell(SkinFault fault, std::size_t seed) {
  constexpr std::array<std::uint32_t, 4> kLeaves = {5, 9, 13, 17};
  constexpr std::size_t kCells = 17;
  if (fault == SkinFault::Reglued) return CellId(kLeaves.at(seed % kLeaves.size()));
  return CellId(static_cast<std::uint32_t>(1 + seed % kCells));
}

CellId firstNeighbor(const SimulatedSkin& skin, CellId cell) {
  const auto& links = std::ranges::find(skin.neighbors(), cell, &CellReport::id)->neighbors;
  return std::ranges::find_if(links, [](const NeighborReport& n) { return n.cell.value() != 0; })->cell;
}

Outcome tryGarbage(const Garbage& what, std::size_t seed) {
  SkinCase skin_case = {.patch = "x17", .surface = "cylinder:r=0.0501", .poses = what.poses};
  std::set<CellId> guilty;
  if (what.cell_fault) skin_case.faults = {{*what.cell_fault, faultyCell(*what.cell_fault, seed)}};
  if (what.whole_fault) skin_case.whole_skin_faults = {*what.whole_fault};
  SimulatedSkin skin = makeSkin(skin_case, seed);
  Outcome outcome;
  if (what.cell_fault) {
    const CellFault& fault = skin_case.faults.front();
    guilty.insert(fault.cell);
    if (*what.cell_fault == SkinFault::Swapped || *what.cell_fault == SkinFault::Echo) {
      guilty.insert(firstNeighbor(skin, fault.cell));
    }
    if (*what.cell_fault != SkinFault::Echo) outcome.best = bestDetection(skin, fault, what.poses);
  }
  const auto result = reconstruct(*measure(skin, skin_case).snapshot(), globalSolver());
  const VerdictLevel level = result->assessment.level;
  if (what.whole_fault && mustFail(*what.whole_fault)) {
    outcome.found = level == VerdictLevel::Failed;
    return outcome;
  }
  const bool named = std::ranges::any_of(result->findings, [&](const Finding& finding) {
    if (!isAlarm(finding)) return false;
    return guilty.empty() || std::ranges::any_of(finding.cells, [&](CellId cell) { return guilty.contains(cell); });
  });
  outcome.found = named && level != VerdictLevel::Good;
  return outcome;
}

std::vector<Garbage> garbage() {
  std::vector<Garbage> all;
  for (const SkinFault fault : {SkinFault::Echo, SkinFault::Swapped, SkinFault::Yawed, SkinFault::Reglued}) {
    for (const std::size_t poses : {2U, 3U, 4U, 6U}) {
      all.push_back({std::string(kSkinFaultNames.of(fault)), poses, fault, {}});
    }
  }
  for (const std::string_view name : kWholeSkinFaultNames.names) {
    for (const std::size_t poses : {3U, 4U}) {
      all.push_back({std::string(name) + ", all cells", poses, {}, kWholeSkinFaultNames.find(name)});
    }
  }
  return all;
}

struct HealthyCount {
  Share alarms;      ///< sessions
  Share accused;     ///< cells named as wrong
  Share suspicious;  ///< cells
  Share muted;       ///< links
};

struct HealthySkin {
  const char* patch;
  const char* surface;
  LinkLaw law;
};

constexpr std::array<HealthySkin, 11> kHealthySkins = {{{"x17", "cylinder:r=0.0501", LinkLaw::Bend},
                                                        {"x17", "cylinder:r=0.0501", LinkLaw::Surface},
                                                        {"x17", "sphere:r=0.1", LinkLaw::Bend},
                                                        {"ring8", "", LinkLaw::Bend},
                                                        {"ring8:closed", "", LinkLaw::Bend},
                                                        {"sheet:5x5", "plane", LinkLaw::Bend},
                                                        {"sheet:6x6", "cylinder:r=0.08", LinkLaw::Bend},
                                                        {"sheet:6x6", "sphere:r=0.15", LinkLaw::Surface},
                                                        {"sheet:6x6", "torus:R=0.2,r=0.1", LinkLaw::Bend},
                                                        {"sheet:4x6", "cone:r=0.06,angle=0.3", LinkLaw::Bend},
                                                        {"sheet:1x5", "cylinder:r=0.06", LinkLaw::Bend}}};

HealthyCount tryHealthy(std::size_t seed, std::size_t poses) {
  const HealthySkin& kind = kHealthySkins.at(seed % kHealthySkins.size());
  const SkinCase skin_case = {.patch = kind.patch, .surface = kind.surface, .law = kind.law, .poses = poses};
  SimulatedSkin skin = makeSkin(skin_case, seed);
  const auto result = reconstruct(*measure(skin, skin_case).snapshot(), globalSolver());
  std::set<CellId> accused;
  std::set<CellId> suspicious;
  bool alarm = false;
  for (const Finding& finding : result->findings) {
    if (!isAlarm(finding)) continue;
    alarm = true;
    if (finding.code == FindingCode::SuspiciousSensor) {
      suspicious.insert(finding.cells.begin(), finding.cells.end());
    } else if (finding.ports.empty()) {
      accused.insert(finding.cells.begin(), finding.cells.end());
    }
  }
  HealthyCount count;
  count.alarms = {alarm ? 1U : 0U, 1};
  count.accused = {accused.size(), result->cellCount()};
  count.suspicious = {suspicious.size(), result->cellCount()};
  for (const PatchReconstruction& patch : result->patches) {
    count.muted += {static_cast<std::size_t>(std::ranges::count_if(
                        patch.links, [](const LinkEstimate& link) { return link.muted_by.has_value(); })),
                    patch.links.size()};
  }
  return count;
}

HealthyCount countHealthy(const Trials& trials, std::size_t poses, std::size_t sessions) {
  HealthyCount sum;
  const auto counts =
      trials.run("healthy, all patches", sessions, [poses](std::size_t seed) { return tryHealthy(seed, poses); });
  for (const HealthyCount& count : counts) {
    sum.alarms += count.alarms;
    sum.accused += count.accused;
    sum.suspicious += count.suspicious;
    sum.muted += count.muted;
  }
  return sum;
}

}  // namespace

nlohmann::ordered_json countGarbage(const Trials& trials, bool prints) {
  std::vector<FigureRow> rows;
  for (const Garbage& what : garbage()) {
    const auto outcomes =
        trials.run(what.name, trials.seeds(), [&](std::size_t seed) { return tryGarbage(what, seed); });
    Share found;
    std::vector<double> known;
    std::vector<double> unknown;
    for (const Outcome& outcome : outcomes) {
      found += {outcome.found ? 1U : 0U, 1};
      if (!outcome.best) continue;
      known.push_back(outcome.best->cell_known);
      unknown.push_back(outcome.best->cell_unknown);
    }
    const std::optional<double> bound = unknown.empty() ? std::nullopt : std::optional(mean(unknown));
    const std::optional<double> bound_known = known.empty() ? std::nullopt : std::optional(mean(known));
    const double bar = bound ? std::min(kBarFound, *bound - kBelowBound) : kBarFound;
    rows.push_back({ofText("garbage", "garbage", what.name),
                    ofCount("poses", "poses", what.poses),
                    ofShare("found (95 %)", "found", found, 1),
                    ofPercent("best, cell known", "best_test_cell_known_percent", bound_known, 1),
                    ofPercent("best test", "best_test_percent", bound, 1),
                    {"bar", ">= " + formatFixed(bar, 1) + " %", "bar_percent", bar},
                    ofBar(true, found.percent() >= bar)});
  }
  const std::size_t sessions =
      trials.seeds() < kFullSeeds ? trials.seeds() : std::max(trials.seeds(), kHealthySessions);
  std::vector<FigureRow> healthy;
  for (const std::size_t poses : {2U, 3U, 4U}) {
    const HealthyCount count = countHealthy(trials, poses, sessions);
    healthy.push_back(
        {ofText("healthy, all patches", "", ""), ofCount("poses", "poses", poses),
         ofShare("sessions with a false alarm (95 %)", "alarms", count.alarms, 2),
         ofShare("cells accused (95 %)", "accused", count.accused, 3),
         ofPercent("cells suspicious", "", count.suspicious.percent(), 3),
         ofShare("", "suspicious", count.suspicious, 3), ofPercent("links muted", "", count.muted.percent(), 3),
         ofShare("", "muted", count.muted, 3), ofText("bars", "", "<= 0.2 %, <= 0.1 %"),
         ofBar(true, count.alarms.percent() <= kBarFalseAlarms && count.accused.percent() <= kBarAccused)});
  }
  if (prints) {
    std::cout
        << "\nGarbage, on a simulated X17 (r = 50.1 mm), global solver, defaults: " << trials.seeds()
        << " sessions per row.\nFound: a finding names it, and the verdict is lower; of what leaves nothing but noise: "
           "the verdict is failed.\nBest test: a likelihood ratio with 0.2 % false alarms a session that knows the "
           "fault, and its cell, or has to ask of every\ncell and axis. The bar is 95 %, or 5 % less than the latter "
           "where that is lower.\n\n";
    printTable(rows);
    std::cout << "\nHealthy skins, hand-held, " << kHealthySkins.size() << " patches: " << sessions
              << " sessions per row. Intervals are Wilson's, 95 %.\n\n";
    printTable(healthy);
  }
  return {{"interval", "Wilson, 95 %"}, {"rows", toJson(rows)}, {"healthy", toJson(healthy)}};
}

}  // namespace hexoderm::cli
