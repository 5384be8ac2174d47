#include "hexoderm/solve/estimate/estimate.h"

#include "hexoderm/solve/estimate/patch_description.h"
#include "hexoderm/solve/estimate/skin_description.h"
#include "hexoderm/solve/faults/cell_health.h"
#include "hexoderm/solve/faults/requested_exclusions.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace hexoderm {

Estimate::Estimate(const SessionSnapshot& snapshot, const SolverOptions& options, const Reconstruction* earlier,
                   SolveProgress* progress)
    : skin_(snapshot, options, findings_), progress_(progress) {
  setLinksAside(skin_, findings_);
  judgeCells(snapshot, skin_.graph(), skin_.table(), findings_);
  leaveOutCells(skin_, findings_);
  if (earlier == nullptr || earlier->solver != solverName(Solver::Global)) return;
  for (const PatchReconstruction& patch : earlier->patches) earlier_.emplace(patch.origin, &patch);
}

Completion Estimate::bringTo(Stage stage, const std::stop_token& stop) {
  if (stop.stop_requested()) return Completion::Stopped;
  updateLinks();
  if (stage == Stage::Links) return Completion::Finished;
  if (!is_placed_) placePatches(stop);
  return skin_.options().solver == Solver::Global ? solvePatches(stop) : Completion::Finished;
}

void Estimate::updateLinks() {
  if (!all_links_stale_ && stale_cells_.empty()) return;
  if (all_links_stale_ || stale_cells_.size() > 1) {
    skin_.estimateEdges();
    changed_links_.reset();
  } else {
    changed_links_ = skin_.estimateEdgesAround(stale_cells_.front());
  }
  all_links_stale_ = false;
  stale_cells_.clear();
  ++link_revision_;
}

void Estimate::placePatches(const std::stop_token& stop) {
  patches_.clear();
  weights_ = linkWeights(skin_);
  patches_.reserve(skin_.graph().patches().size());
  for (std::size_t patch = 0; patch < skin_.graph().patches().size(); ++patch) {
    patches_.emplace_back(skin_, weights_, patch);
  }
  is_placed_ = unreported_ = true;
  ++placement_revision_;
  // An earlier result of the global solver has all patches: better than any tree.
  const bool are_known =
      skin_.options().solver == Solver::Global && std::ranges::all_of(patches_, [&](const PatchSolver& patch) {
        const PatchReconstruction* known = earlierOf(patch);
        return known != nullptr && patch.canStartFrom(*known);
      });
  if (placement_revision_ == 1 && !are_known) reportPlacements(stop);
}

Completion Estimate::solvePatches(const std::stop_token& stop) {
  for (PatchSolver& patch : patches_) {
    if (patch.isSolved()) continue;
    if (progress_ != nullptr) {
      progress_->enterPatch(static_cast<std::size_t>(&patch - patches_.data()), patches_.size());
    }
    patch.place();
    if (patch.solve(earlierOf(patch), stop) == Completion::Stopped) return Completion::Stopped;
    unreported_ = true;
  }
  if (!std::exchange(was_solved_, true)) reportPlacements(stop);
  return Completion::Finished;
}

const PatchReconstruction* Estimate::earlierOf(const PatchSolver& patch) const {
  const auto known = earlier_.find(skin_.graph().cells()[patch.origin()].id);
  return known == earlier_.end() ? nullptr : known->second;
}

void Estimate::reportPlacements(const std::stop_token& stop) {
  if (!std::exchange(unreported_, false) || progress_ == nullptr || stop.stop_requested()) return;
  const SolveProgress::Report report = progress_->placementsReport(skin_.graph().cells().size());
  if (report) report(describeSkin(skin_, describePlacements(skin_, patches_, weights_)));
}

void Estimate::exclude(Explanation explanation) {
  std::ranges::move(explanation.findings, std::back_inserter(findings_));
  for (Finding& remark : explanation.remarks) addOnce(findings_, std::move(remark));
  const bool only_cells = explanation.links.empty() && explanation.poses.empty() && explanation.corrections.empty();
  for (const auto& [why, links] : explanation.links) skin_.mute(links, why);
  for (const std::size_t pose : explanation.poses) skin_.dropPose(pose);
  for (const std::size_t cell : explanation.cells) skin_.dropCell(cell);
  for (const ReadingCorrection& correction : explanation.corrections) {
    skin_.correct(correction.cell, correction.pose, correction.added_g, correction.variance_g2);
  }
  all_links_stale_ = all_links_stale_ || !only_cells;
  stale_cells_.insert(stale_cells_.end(), explanation.cells.begin(), explanation.cells.end());
  if (!explanation.excludes()) return;
  const bool can_go_on = explanation.keeps_placements && only_cells && skin_.options().solver == Solver::Global;
  is_placed_ = is_placed_ && can_go_on;
  if (!is_placed_) return;
  for (const std::size_t cell : explanation.cells) {
    patches_[skin_.graph().cells()[cell].patch.value()].leaveOut(cell);
  }
}

}  // namespace hexoderm
