#include "hexoderm/reconstruction/reconstructor.h"

#include "hexoderm/reconstruction/advice/assess.h"
#include "hexoderm/reconstruction/faults/cell_health.h"
#include "hexoderm/reconstruction/faults/fault_isolation.h"
#include "hexoderm/reconstruction/figures/pose_summary.h"
#include "hexoderm/reconstruction/patch/forecast.h"
#include "hexoderm/reconstruction/patch/patch_description.h"
#include "hexoderm/reconstruction/patch/patch_solver.h"

#include <chrono>
#include <optional>
#include <span>
#include <utility>
#include <vector>

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
  for (std::size_t patch = 0; patch < skin.graph().patches().size(); ++patch) {
    patches.emplace_back(skin, weights, patch);
  }
  return patches;
}

Completion refinePatches(std::vector<PatchSolver>& patches, const Reconstruction* earlier, const std::stop_token& stop,
                         std::vector<Finding>& findings) {
  for (PatchSolver& patch : patches) {
    if (patch.refine(earlier, stop, findings) == Completion::Stopped) return Completion::Stopped;
  }
  return Completion::Finished;
}

/// The joint estimate of every patch, again from the tree as long as it shows links that are none.
Completion solveGlobally(SkinLinks& skin, std::span<const double> weights, const Reconstruction* earlier,
                         const std::stop_token& stop, std::vector<PatchSolver>& patches,
                         std::vector<Finding>& findings) {
  if (refinePatches(patches, earlier, stop, findings) == Completion::Stopped) return Completion::Stopped;
  while (muteOpenLinks(skin, patches, findings)) {
    patches = placePatches(skin, weights);
    if (refinePatches(patches, earlier, stop, findings) == Completion::Stopped) return Completion::Stopped;
  }
  for (const PatchSolver& patch : patches) nameInconsistentPoses(skin, patch, findings);
  return Completion::Finished;
}

std::shared_ptr<Reconstruction> describe(const SkinLinks& skin, std::span<const PatchSolver> patches,
                                         std::span<const double> weights, std::vector<Finding> findings) {
  const SessionSnapshot& snapshot = skin.snapshot();
  auto result = std::make_shared<Reconstruction>();
  result->revision = snapshot.revision;
  result->solver = solverName(skin.options().solver);
  result->options = skin.options();
  result->source = snapshot.source;
  result->model = snapshot.model;
  result->patches = describePatches(skin, patches, weights);
  result->poses = summarisePoses(snapshot, skin.table(), *result);
  judgePoses(*result, findings);
  result->findings = std::move(findings);
  result->layout = computeFlatLayout(skin.model(), result->patches);
  result->assessment = assess(*result, forecastOf(skin, patches, *result));
  if (std::optional<Finding> open = describeTooFewDirections(*result)) result->findings.push_back(std::move(*open));
  return result;
}

}  // namespace

std::shared_ptr<const Reconstruction> reconstruct(const SessionSnapshot& snapshot, const SolverOptions& options,
                                                  const Reconstruction* earlier, const std::stop_token& stop) {
  options.validate();
  const auto start = std::chrono::steady_clock::now();
  std::vector<Finding> findings;
  SkinLinks skin(snapshot, options, findings);
  if (prepare(skin, stop, findings) == Completion::Stopped) return nullptr;
  // The paths of every round of the global solver are found with the same weights.
  const std::vector<double> weights = linkWeights(skin);
  std::vector<PatchSolver> patches = placePatches(skin, weights);
  if (options.solver == Solver::Global &&
      solveGlobally(skin, weights, earlier, stop, patches, findings) == Completion::Stopped) {
    return nullptr;
  }
  if (stop.stop_requested()) return nullptr;
  const std::shared_ptr<Reconstruction> result = describe(skin, patches, weights, std::move(findings));
  result->solve_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace hexoderm
