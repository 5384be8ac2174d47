#include "hexoderm/reconstruction/reconstructor.h"

#include "hexoderm/reconstruction/advice/assess.h"
#include "hexoderm/reconstruction/figures/pose_summary.h"
#include "hexoderm/reconstruction/patch/forecast.h"
#include "hexoderm/reconstruction/patch/patch_description.h"
#include "hexoderm/reconstruction/skin_description.h"
#include "hexoderm/reconstruction/solved_skin.h"

#include <chrono>
#include <optional>
#include <utility>

namespace hexoderm {
namespace {

std::shared_ptr<Reconstruction> describe(const SolvedSkin& solved) {
  const SkinLinks& skin = solved.skin();
  // Takes most memory of all, so that it comes before what makes the result large.
  const std::optional<Forecast> forecast = forecastOf(skin, solved.patches());
  auto result = describeSkin(skin, describePatches(skin, solved.patches(), solved.weights()));
  result->findings = solved.findings();
  judgePoses(*result, result->findings);
  result->assessment = assess(*result, forecast);
  if (std::optional<Finding> open = describeTooFewDirections(*result)) result->findings.push_back(std::move(*open));
  return result;
}

}  // namespace

std::shared_ptr<const Reconstruction> reconstruct(const SessionSnapshot& snapshot, const SolverOptions& options,
                                                  const Reconstruction* earlier, const std::stop_token& stop,
                                                  SolveProgress* progress) {
  const auto start = std::chrono::steady_clock::now();
  snapshot.model->validate();  // a snapshot can be made without a Session
  const std::unique_ptr<const SolvedSkin> solved = solveSkin(snapshot, options, earlier, stop, progress);
  if (solved == nullptr) return nullptr;
  if (progress != nullptr) progress->enter(SolveStage::Figures);
  const std::shared_ptr<Reconstruction> result = describe(*solved);
  result->solve_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace hexoderm
