#include "hexoderm/reconstruction/solved_skin.h"

#include "hexoderm/reconstruction/faults/cell_health.h"
#include "hexoderm/reconstruction/faults/consequences.h"
#include "hexoderm/reconstruction/faults/fault_isolation.h"
#include "hexoderm/reconstruction/patch/attitude_faults.h"
#include "hexoderm/reconstruction/patch/patch_description.h"
#include "hexoderm/reconstruction/patch/unlikely_sensors.h"
#include "hexoderm/reconstruction/result/completion.h"
#include "hexoderm/reconstruction/skin_description.h"

#include <algorithm>
#include <unordered_map>

namespace hexoderm {
namespace {

/// Takes out everything that readings alone show to be broken, and estimates the links from what is left.
Completion prepare(SkinLinks& skin, const std::stop_token& stop, std::vector<Finding>& findings) {
  setLinksAside(skin, findings);
  judgeCells(skin.snapshot(), skin.graph(), skin.table(), findings);
  leaveOutCells(skin, findings);
  skin.estimateEdges();
  return isolateSuspects(skin, stop, findings);
}

std::vector<PatchSolver> placePatches(SkinLinks& skin, std::span<const double> weights) {
  std::vector<PatchSolver> patches;
  patches.reserve(skin.graph().patches().size());
  for (std::size_t patch = 0; patch < skin.graph().patches().size(); ++patch) {
    patches.emplace_back(skin, weights, patch);
  }
  return patches;
}

/// The patches of an earlier result by their origins, to start from; none if it is not the global solver's.
using EarlierPatches = std::unordered_map<CellId, const PatchReconstruction*>;
EarlierPatches earlierPatches(const Reconstruction* earlier) {
  EarlierPatches patches;
  if (earlier == nullptr || earlier->solver != solverName(Solver::Global)) return patches;
  for (const PatchReconstruction& patch : earlier->patches) patches.emplace(patch.origin, &patch);
  return patches;
}

Completion refinePatches(SkinLinks& skin, std::vector<PatchSolver>& patches, const EarlierPatches& earlier,
                         const std::stop_token& stop, SolveProgress* progress, std::vector<Finding>& findings) {
  for (PatchSolver& patch : patches) {
    if (progress != nullptr) progress->enterPatch(static_cast<std::size_t>(&patch - patches.data()), patches.size());
    const auto known = earlier.find(skin.graph().cells()[patch.origin()].id);
    const PatchReconstruction* start = known == earlier.end() ? nullptr : known->second;
    if (patch.refine(start, stop, findings) == Completion::Stopped) return Completion::Stopped;
  }
  if (std::ranges::any_of(patches, &PatchSolver::droppedCells)) skin.estimateEdges();
  return Completion::Finished;
}

/// The joint estimate of every patch, again from the tree as long as it shows links that are none.
Completion solveGlobally(SkinLinks& skin, std::span<const double> weights, const EarlierPatches& earlier,
                         const std::stop_token& stop, SolveProgress* progress, std::vector<PatchSolver>& patches,
                         std::vector<Finding>& findings) {
  if (refinePatches(skin, patches, earlier, stop, progress, findings) == Completion::Stopped) {
    return Completion::Stopped;
  }
  while (muteOpenLinks(skin, patches, findings)) {
    patches = placePatches(skin, weights);
    if (refinePatches(skin, patches, earlier, stop, progress, findings) == Completion::Stopped) {
      return Completion::Stopped;
    }
  }
  return Completion::Finished;
}

/// To whoever does not want to wait for the rest.
void reportPlacements(const SkinLinks& skin, std::span<const PatchSolver> patches, std::span<const double> weights,
                      const std::stop_token& stop, const SolveProgress* progress) {
  if (progress == nullptr || stop.stop_requested()) return;
  const SolveProgress::Report report = progress->placementsReport(skin.graph().cells().size());
  if (report) report(describeSkin(skin, describePlacements(skin, patches, weights)));
}

/// An earlier result of the global solver has all patches: better than any tree.
bool areKnown(std::span<const PatchSolver> patches, const SkinLinks& skin, const EarlierPatches& earlier) {
  return skin.options().solver == Solver::Global && std::ranges::all_of(patches, [&](const PatchSolver& patch) {
           const auto known = earlier.find(skin.graph().cells()[patch.origin()].id);
           return known != earlier.end() && patch.canStartFrom(*known->second);
         });
}

/// All patches by the chosen solver, again as long as their attitudes show what is no part of them.
Completion solve(SkinLinks& skin, const EarlierPatches& earlier, const std::stop_token& stop, SolveProgress* progress,
                 std::vector<double>& weights, std::vector<PatchSolver>& patches, std::vector<Finding>& findings) {
  constexpr int kRounds = 3;  // what a first search leaves is rare; each costs a solve
  AttitudeIsolation attitudes(skin);
  for (int round = 0;; ++round) {
    // The paths of every round of the global solver are found with the same weights.
    weights = linkWeights(skin);
    patches = placePatches(skin, weights);
    if (round == 0 && !areKnown(patches, skin, earlier)) reportPlacements(skin, patches, weights, stop, progress);
    if (skin.options().solver == Solver::Global) {
      if (solveGlobally(skin, weights, earlier, stop, progress, patches, findings) == Completion::Stopped) {
        return Completion::Stopped;
      }
      reportPlacements(skin, patches, weights, stop, progress);
    }
    if (stop.stop_requested()) return Completion::Stopped;
    if (progress != nullptr) progress->enter(SolveStage::Findings);
    if (round == kRounds || !attitudes.isolate(patches, findings)) break;
    skin.estimateEdges();
  }
  if (skin.options().solver == Solver::Global) {
    for (const PatchSolver& patch : patches) {
      nameInconsistentPoses(skin, patch, findings);
      nameUnconverged(skin.graph().cells()[patch.origin()].id, patch.joint()->solution(), findings);
    }
    nameUnlikelySensors(skin, patches, findings);
  }
  return Completion::Finished;
}

}  // namespace

std::unique_ptr<const SolvedSkin> solveSkin(const SessionSnapshot& snapshot, const SolverOptions& options,
                                            const Reconstruction* earlier, const std::stop_token& stop,
                                            SolveProgress* progress) {
  options.validate();
  if (progress != nullptr) progress->enter(SolveStage::Links);
  auto solved = std::make_unique<SolvedSkin>(snapshot, options);
  if (prepare(solved->skin_, stop, solved->findings_) == Completion::Stopped) return nullptr;
  if (solve(solved->skin_, earlierPatches(earlier), stop, progress, solved->weights_, solved->patches_,
            solved->findings_) == Completion::Stopped) {
    return nullptr;
  }
  if (stop.stop_requested()) return nullptr;
  addConsequences(solved->skin_, solved->findings_);
  return solved;
}

}  // namespace hexoderm
