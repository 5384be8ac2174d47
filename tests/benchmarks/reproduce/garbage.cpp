#include "tests/benchmarks/reproduce/detection_bound.h"
#include "tests/benchmarks/reproduce/trials.h"

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

struct Garbage {
  std::string name;
  std::size_t poses = 3;
  std::optional<SkinFault> cell_fault;
  std::optional<WholeSkinFault> whole_fault;
};

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

void tryGarbage(Tally& tally, const Garbage& what, std::size_t seed) {
  SkinCase skin_case = {.patch = "x17", .surface = "cylinder:r=0.0501", .poses = what.poses};
  std::set<CellId> guilty;
  if (what.cell_fault) skin_case.faults = {{*what.cell_fault, faultyCell(*what.cell_fault, seed)}};
  if (what.whole_fault) skin_case.whole_skin_faults = {*what.whole_fault};
  SimulatedSkin skin = makeSkin(skin_case, seed);
  if (what.cell_fault) {
    const CellFault& fault = skin_case.faults.front();
    guilty.insert(fault.cell);
    if (*what.cell_fault == SkinFault::Swapped || *what.cell_fault == SkinFault::Echo) {
      guilty.insert(linksOf(skin, fault.cell).front().cell);
    }
    if (*what.cell_fault != SkinFault::Echo) {
      const BestDetection best = bestDetection(skin, fault, what.poses);
      tally.note("cell known", best.cell_known);
      tally.note("cell unknown", best.cell_unknown);
    }
  }
  const auto result = reconstruct(*measure(skin, skin_case).snapshot());
  const VerdictLevel level = result->assessment.level;
  const bool named = std::ranges::any_of(result->findings, [&](const Finding& finding) {
    if (!isAlarm(finding)) return false;
    return guilty.empty() || std::ranges::any_of(finding.cells, [&](CellId cell) { return guilty.contains(cell); });
  });
  const bool must_fail = what.whole_fault && mustFail(*what.whole_fault);
  tally.count("found", must_fail ? level == VerdictLevel::Failed : named && level != VerdictLevel::Good);
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

void tryHealthy(Tally& tally, std::size_t seed, std::size_t poses) {
  const HealthySkin& kind = kHealthySkins.at(seed % kHealthySkins.size());
  const SkinCase skin_case = {.patch = kind.patch, .surface = kind.surface, .law = kind.law, .poses = poses};
  SimulatedSkin skin = makeSkin(skin_case, seed);
  countFalseAlarms(tally, *reconstruct(*measure(skin, skin_case).snapshot()));
}

FigureRow runRow(const Trials& trials, const Garbage& what) {
  const Tally tally = trials.run(what.name, [&](Tally& found, std::size_t seed) { tryGarbage(found, what, seed); });
  const auto bound = tally.mean("cell unknown");
  const double bar = bound ? std::min(kBarFound, *bound - kBelowBound) : kBarFound;
  return {ofText("garbage", "garbage", what.name),
          ofCount("poses", "poses", what.poses),
          ofShare("found (95 %)", "found", tally.share("found"), 1),
          ofPercent("best, cell known", "best_test_cell_known_percent", tally.mean("cell known"), 1),
          ofPercent("best test", "best_test_percent", bound, 1),
          {"bar", ">= " + formatFixed(bar, 1) + " %", "bar_percent", bar},
          ofBar(true, tally.percent("found") >= bar)};
}

FigureRow runHealthyRow(const Trials& trials, std::size_t poses, std::size_t sessions) {
  const Tally tally = trials.run("healthy, all patches", sessions,
                                 [poses](Tally& found, std::size_t seed) { tryHealthy(found, seed, poses); });
  return withFalseAlarms({ofText("healthy, all patches", "", ""), ofCount("poses", "poses", poses)}, tally);
}

}  // namespace

Json countGarbage(const Trials& trials, bool prints) {
  std::vector<FigureRow> rows;
  for (const Garbage& what : garbage()) rows.push_back(runRow(trials, what));
  const std::size_t sessions =
      trials.seeds() < kFullSeeds ? trials.seeds() : std::max(trials.seeds(), kHealthySessions);
  std::vector<FigureRow> healthy;
  for (const std::size_t poses : {2U, 3U, 4U}) healthy.push_back(runHealthyRow(trials, poses, sessions));
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
