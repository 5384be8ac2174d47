#include "hexoderm/skin/skin_graph_boost.h"
#include "hexoderm/solve/explain/explainer.h"
#include "hexoderm/solve/faults/suspects.h"

#include <algorithm>
#include <utility>

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

/// The cell, none of `but`, whose readings fit the gravity of all others worst.
std::optional<BadSensor> worstSensor(const SkinLinks& skin, const PatchSolver& patch,
                                     const std::vector<std::size_t>& but) {
  // With hundreds of poses the smallest misfit is significant; only one that also matters makes a sensor useless.
  constexpr double kMinChiSquaredPerDegree = 2;
  const GlobalRefinement& joint = *patch.joint();
  std::optional<BadSensor> worst;
  double worst_misfit = skin.options().max_misfit;
  for (const std::size_t cell : patch.cells()) {
    if (!skin.readings().measured(cell) || skin.table().usablePoseCount(cell) < 2) continue;
    if (std::ranges::count(but, cell) > 0) continue;
    const Misfit found = joint.misfitOf(cell);
    const double misfit = found.deviate();
    if (misfit <= worst_misfit || found.chi_squared < kMinChiSquaredPerDegree * found.degrees) continue;
    worst = BadSensor{cell, std::nullopt};
    worst_misfit = misfit;
  }
  if (worst) worst->turn = explainingTurn(joint, worst->cell, skin.options().max_misfit);
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
    for (const PatchSolver& patch : estimate.patches()) {
      if (patch.joint() == nullptr) continue;
      if (const auto bad = worstSensor(estimate.skin(), patch, suspicious_)) {
        return explanationOf(estimate.skin(), *patch.joint(), *bad);
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Explanation explanationOf(const SkinLinks& skin, const GlobalRefinement& joint, const BadSensor& bad) {
    Explanation found;
    const bool is_clear = joint.misfitOf(bad.cell).deviate() > kClearly * skin.options().max_misfit;
    if (hasTooFewPoses(skin, bad.cell) && !is_clear) {
      found.remarks.push_back(describeSuspiciousSensor(skin, bad.cell));
      suspicious_.push_back(bad.cell);
    } else {
      found.findings.push_back(describe(skin, bad));
      found.cells.push_back(bad.cell);
      found.keeps_placements = true;
    }
    return found;
  }

  std::size_t revision_ = 0;             // of the placements
  std::vector<std::size_t> suspicious_;  // cells, in these placements
};

}  // namespace

Explainer makeMisfitExplainer() { return {Estimate::Stage::Patches, Misfits()}; }

}  // namespace hexoderm
