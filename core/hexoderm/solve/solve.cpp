#include "hexoderm/solve/solve.h"

#include "hexoderm/solve/explain/explainer.h"
#include "hexoderm/solve/faults/tears.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace hexoderm {
namespace {

enum class Answer { Explained, NothingLeft, Stopped };

/// How many explanations of placed patches are looked for, each of which costs a solution of the patch: enough for a
/// skin with some faults, and no more than a large one without a sound model would get anyway.
class Rounds {
 public:
  explicit Rounds(const SkinGraph& graph)
      : most_(std::max(kFewest, kCells / std::max<std::size_t>(1, graph.cells().size()))) {}

  void count(const Explainer& explainer, const Explanation& explanation) {
    if (explainer.needs == Estimate::Stage::Patches && explanation.excludes()) ++used_;
  }
  [[nodiscard]] bool areOver() const { return used_ >= most_; }

 private:
  static constexpr std::size_t kFewest = 8;
  static constexpr std::size_t kCells = 4000;  ///< a small skin is solved in no time

  std::size_t most_;
  std::size_t used_ = 0;
};

Finding describeTooManyFaults(std::size_t faults) {
  return makeFinding(
      FindingCode::PoorFit,
      message("After {} findings the readings still do not fit the model, and the search was ended: there "
              "is one cause behind them that it does not know, or most of the skin is faulty.",
              faults));
}

/// Excludes from the estimate what the first explainer finds that finds anything.
Answer explainOnce(Estimate& estimate, std::span<const Explainer> explainers, Rounds& rounds,
                   const std::stop_token& stop, SolveProgress* progress) {
  for (const Explainer& explainer : explainers) {
    if (estimate.bringTo(explainer.needs, stop) == Completion::Stopped) return Answer::Stopped;
    if (progress != nullptr && explainer.needs == Estimate::Stage::Patches) progress->enter(SolveStage::Findings);
    if (std::optional<Explanation> explanation = explainer.explain(estimate)) {
      foldTears(estimate.skin(), *explanation);
      if (rounds.areOver() && explanation->excludes()) {
        Explanation end;
        end.findings.push_back(describeTooManyFaults(estimate.findings().size()));
        estimate.exclude(std::move(end));
        return Answer::NothingLeft;
      }
      rounds.count(explainer, *explanation);
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
  const std::array explainers = {makeShiftedIdExplainer(), makeTurnedGroupExplainer(), makeWholeSkinExplainer(),
                                 makeNeighborExplainer(),  makeTearExplainer(),        makeMovingPoseExplainer(),
                                 makeMisfitExplainer(),    makeOpenLinkExplainer(),    makeAttitudeExplainer(),
                                 makeInsideOutExplainer()};
  Rounds rounds(estimate->skin().graph());
  Answer answer{};
  do {
    // Lines 9 and 10, rotations of links and their weights (Stage::Links), and 11 to 15, origins, paths and placements
    // (Stage::Patches), as far as an explainer needs them.
    answer = explainOnce(*estimate, explainers, rounds, stop, progress);
  } while (answer == Answer::Explained);
  if (answer == Answer::Stopped) return nullptr;
  estimate->reportPlacements(stop);
  return stop.stop_requested() ? nullptr : std::move(estimate);
}

}  // namespace hexoderm
