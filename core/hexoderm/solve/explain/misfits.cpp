#include "hexoderm/skin/skin_graph_boost.h"
#include "hexoderm/solve/explain/explainer.h"
#include "hexoderm/solve/faults/suspects.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

struct BadSensor {
  std::size_t cell = 0;
  std::optional<TurnBetweenPoses> turn;  ///< that explains its readings
};

/// The turn against the others between two poses that explains what a cell reads, if one does.
std::optional<TurnBetweenPoses> explainingTurn(const GlobalRefinement& joint, std::size_t cell, double max_misfit) {
  const TurnBetweenPoses turn = joint.turnOf(cell);
  const Misfit misfit = joint.misfitOf(cell);
  const Misfit left{misfit.chi_squared - turn.gain.chi_squared, misfit.degrees - turn.gain.degrees};
  const bool explains = left.degrees > 0 && left.deviate() <= max_misfit;
  return explains ? std::optional(turn) : std::nullopt;
}

/// Marks the cell and those within two links of it: what it reads bends them, too.
void markAround(const SkinGraph& graph, std::size_t cell, std::vector<bool>& marked) {
  constexpr int kReach = 2;
  std::vector<std::size_t> front = {cell};
  marked[cell] = true;
  for (int reach = 0; reach < kReach; ++reach) {
    std::vector<std::size_t> next;
    for (const std::size_t at : front) {
      for (const std::size_t link : graph.linksAt(at)) next.push_back(graph.links()[link].other(at));
    }
    for (const std::size_t at : next) marked[at] = true;
    front = std::move(next);
  }
}

/// The cell, none of `but`, whose readings fit the gravity of all others worst, and cells far from it and from each
/// other that clearly fit it no better: each round costs a solution.
std::vector<BadSensor> worstSensors(const SkinLinks& skin, const PatchSolver& patch,
                                    const std::vector<std::size_t>& but) {
  // With hundreds of poses the smallest misfit is significant; only one that also matters makes a sensor useless.
  constexpr double kMinChiSquaredPerDegree = 2;
  const double limit = skin.options().max_misfit;
  const GlobalRefinement& joint = *patch.joint();
  std::vector<std::pair<double, std::size_t>> suspects;
  for (const std::size_t cell : patch.cells()) {
    if (!skin.readings().measured(cell) || skin.table().usablePoseCount(cell) < 2) continue;
    if (std::ranges::count(but, cell) > 0) continue;
    const Misfit found = joint.misfitOf(cell);
    const double misfit = found.deviate();
    if (misfit <= limit || found.chi_squared < kMinChiSquaredPerDegree * found.degrees) continue;
    suspects.emplace_back(misfit, cell);
  }
  // Ties: the first of the patch.
  std::ranges::stable_sort(suspects, std::greater<>(), &std::pair<double, std::size_t>::first);
  std::vector<bool> is_near(skin.graph().cells().size(), false);
  std::vector<BadSensor> worst;
  for (const auto& [misfit, cell] : suspects) {
    const bool is_as_bad = 2 * misfit > suspects.front().first || misfit > kClearly * limit;
    if (is_near[cell] || !is_as_bad) continue;
    worst.push_back({cell, explainingTurn(joint, cell, limit)});
    markAround(skin.graph(), cell, is_near);
  }
  return worst;
}

Finding describe(const SkinLinks& skin, const BadSensor& bad) {
  if (!bad.turn) {
    const bool is_leaf = out_degree(bad.cell, skin.graph()) == 1;
    return describeBadSensor(skin, bad.cell, is_leaf);
  }
  const std::size_t pose = skin.table().usablePoses(bad.cell)[bad.turn->first_after];
  return describeMovedCell(skin, bad.cell, pose, bad.turn->angle_rad);
}

class Misfits {
 public:
  [[nodiscard]] std::optional<Explanation> operator()(const Estimate& estimate) {
    if (std::exchange(revision_, estimate.placementRevision()) != estimate.placementRevision()) suspicious_.clear();
    Explanation found;
    for (const PatchSolver& patch : estimate.patches()) {
      if (patch.joint() == nullptr) continue;
      for (const BadSensor& bad : worstSensors(estimate.skin(), patch, suspicious_)) {
        add(estimate.skin(), *patch.joint(), bad, found);
      }
    }
    return found.empty() ? std::nullopt : std::optional(std::move(found));
  }

 private:
  void add(const SkinLinks& skin, const GlobalRefinement& joint, const BadSensor& bad, Explanation& found) {
    const bool is_clear = joint.misfitOf(bad.cell).deviate() > kClearly * skin.options().max_misfit;
    if (hasTooFewPoses(skin, bad.cell) && !is_clear) {
      found.remarks.push_back(describeSuspiciousSensor(skin, bad.cell));
      suspicious_.push_back(bad.cell);
    } else {
      found.findings.push_back(describe(skin, bad));
      found.cells.push_back(bad.cell);
      found.keeps_placements = true;
    }
  }

  std::size_t revision_ = 0;             // of the placements
  std::vector<std::size_t> suspicious_;  // cells, in these placements
};

}  // namespace

Explainer makeMisfitExplainer() { return {Estimate::Stage::Patches, Misfits()}; }

}  // namespace hexoderm
