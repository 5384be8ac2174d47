#include "hexoderm/solve/solve.h"

#include "hexoderm/solve/explain/explainer.h"

#include <array>
#include <span>
#include <utility>

namespace hexoderm {
namespace {

enum class Answer { Explained, NothingLeft, Stopped };

/// Excludes from the estimate what the first explainer finds that finds anything.
Answer explainOnce(Estimate& estimate, std::span<const Explainer> explainers, const std::stop_token& stop,
                   SolveProgress* progress) {
  for (const Explainer& explainer : explainers) {
    if (estimate.bringTo(explainer.needs, stop) == Completion::Stopped) return Answer::Stopped;
    if (progress != nullptr && explainer.needs == Estimate::Stage::Patches) progress->enter(SolveStage::Findings);
    if (std::optional<Explanation> explanation = explainer.explain(estimate)) {
      const bool ends_search = explanation->ends_search;
      estimate.exclude(std::move(*explanation));
      if (!ends_search) return Answer::Explained;
      return estimate.bringTo(Estimate::Stage::Patches, stop) == Completion::Stopped ? Answer::Stopped
                                                                                     : Answer::NothingLeft;
    }
  }
  return Answer::NothingLeft;
}

}  // namespace

/// Lines 1 to 16 of the paper's Algorithm 1 for the poses of one snapshot. The paper repeats lines 7 to 16 with each
/// new pose; here whoever calls does. The loop is not the paper's: it excludes one explanation of faults at a time and
/// estimates again, until no explainer finds anything that contradicts the model.
std::unique_ptr<const Estimate> solveSkin(const SessionSnapshot& snapshot, const SolverOptions& options,
                                          const Reconstruction* earlier, const std::stop_token& stop,
                                          SolveProgress* progress) {
  options.validate();
  if (progress != nullptr) progress->enter(SolveStage::Links);
  // Lines 1 to 6, the graph and its patches, and 8, the gravity vectors.
  auto estimate = std::make_unique<Estimate>(snapshot, options, earlier, progress);
  // Those that need least of the estimate first.
  const std::array explainers = {makeTurnedGroupExplainer(), makeWholeSkinExplainer(), makeNeighborExplainer(),
                                 makeMisfitExplainer(),      makeOpenLinkExplainer(),  makeAttitudeExplainer(),
                                 makeInsideOutExplainer()};
  Answer answer{};
  do {
    // Lines 9 and 10, rotations of links and their weights (Stage::Links), and 11 to 15, origins, paths and placements
    // (Stage::Patches), as far as an explainer needs them.
    answer = explainOnce(*estimate, explainers, stop, progress);
  } while (answer == Answer::Explained);
  if (answer == Answer::Stopped) return nullptr;
  estimate->reportPlacements(stop);
  return stop.stop_requested() ? nullptr : std::move(estimate);
}

}  // namespace hexoderm
