#include "hexoderm/solve/reconstructor.h"

#include "hexoderm/solve/estimate/fit_test.h"
#include "hexoderm/solve/estimate/forecast.h"
#include "hexoderm/solve/estimate/patch_description.h"
#include "hexoderm/solve/estimate/skin_description.h"
#include "hexoderm/solve/estimate/unlikely_sensors.h"
#include "hexoderm/solve/faults/consequences.h"
#include "hexoderm/solve/metrics/assess.h"
#include "hexoderm/solve/metrics/pose_summary.h"
#include "hexoderm/solve/solve.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace hexoderm {
namespace {

/// Of all that was excluded, and of all that does not fit although it is used.
std::vector<Finding> findingsOf(const Estimate& estimate) {
  std::vector<Finding> findings = estimate.findings();
  if (estimate.skin().options().solver == Solver::Global) {
    for (const PatchSolver& patch : estimate.patches()) {
      nameInconsistentPoses(estimate.skin(), patch, findings);
      nameUnconverged(estimate.skin().graph().cells()[patch.origin()].id, patch.joint()->solution(), findings);
    }
    nameUnlikelySensors(estimate.skin(), estimate.patches(), findings);
    // One finding for one cause: what is refuted already fits poorly.
    if (std::ranges::none_of(findings, refutesModel, &Finding::code)) {
      namePoorFit(estimate.skin(), estimate.patches(), findings);
    }
  }
  addConsequences(estimate.skin(), findings);
  return findings;
}

std::shared_ptr<Reconstruction> describe(const Estimate& estimate) {
  const SkinLinks& skin = estimate.skin();
  std::vector<Finding> findings = findingsOf(estimate);
  // Takes most memory of all, so that it comes before what makes the result large.
  const std::optional<Forecast> forecast = forecastOf(skin, estimate.patches());
  auto result = describeSkin(skin, describePatches(skin, estimate.patches(), estimate.weights()));
  result->findings = std::move(findings);
  judgePoses(*result, result->findings);
  result->assessment = assess(*result, forecast);
  if (result->assessment.level == VerdictLevel::NotTrusted) withdrawUncertainties(*result);
  if (std::optional<Finding> open = describeTooFewDirections(*result)) result->findings.push_back(std::move(*open));
  return result;
}

}  // namespace

std::shared_ptr<const Reconstruction> reconstruct(const SessionSnapshot& snapshot, const SolverOptions& options,
                                                  const Reconstruction* earlier, const std::stop_token& stop,
                                                  SolveProgress* progress) {
  const auto start = std::chrono::steady_clock::now();
  snapshot.model->validate();  // a snapshot can be made without a Session
  const std::unique_ptr<const Estimate> estimate = solveSkin(snapshot, options, earlier, stop, progress);
  if (estimate == nullptr) return nullptr;
  if (progress != nullptr) progress->enter(SolveStage::Figures);
  const std::shared_ptr<Reconstruction> result = describe(*estimate);
  result->solve_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace hexoderm
