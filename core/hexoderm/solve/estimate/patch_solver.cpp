#include "hexoderm/solve/estimate/patch_solver.h"

#include "hexoderm/base/median.h"

#include <algorithm>

namespace hexoderm {
namespace {

/// The covariance of every cell's own attitude error, per cell of the patch.
std::vector<Eigen::Matrix3d> attitudeCovariances(const SkinLinks& skin, const ShortestPaths& paths) {
  const auto place = [&skin](std::size_t cell) { return skin.graph().cells()[cell].place; };
  std::vector<std::size_t> links = paths.link;
  if (paths.order.size() > 1) links[place(paths.root)] = paths.link[place(paths.order[1])];
  std::vector<Eigen::Matrix3d> covariances;
  covariances.reserve(links.size());
  for (const std::size_t cell : skin.graph().patches()[skin.graph().cells()[paths.root].patch.value()]) {
    covariances.push_back(skin.attitudeCovariance(cell, links[place(cell)]));
  }
  return covariances;
}

/// Per cell of a patch. Everything is placed relative to the origin, so it must be a cell that measures, in at least as
/// many poses as half of the patch does.
std::vector<bool> eligibleOrigins(const SkinLinks& skin, const std::vector<std::size_t>& cells) {
  std::vector<double> counts;
  counts.reserve(cells.size());
  for (const std::size_t cell : cells) counts.push_back(static_cast<double>(skin.table().usablePoseCount(cell)));
  std::vector<double> measured = counts;
  std::erase(measured, 0);
  std::vector<bool> eligible(cells.size(), false);
  if (measured.empty()) return eligible;
  const double usual = median(std::move(measured));
  for (std::size_t k = 0; k < cells.size(); ++k) eligible[k] = counts[k] >= usual;
  return eligible;
}

}  // namespace

PatchSolver::PatchSolver(const SkinLinks& skin, std::span<const double> weights, std::size_t patch)
    : skin_(skin), weights_(weights), patch_(patch), cells_(skin.graph().patches()[patch]) {
  placeAlongPaths();
}

void PatchSolver::placeAlongPaths() {
  const SkinGraph& graph = skin_.graph();
  paths_ = findShortestPaths(graph, weights_, findOrigin(graph, weights_, patch_, eligibleOrigins(skin_, cells_)));
  placements_ = placeAlongTree(graph, skin_.model(), paths_, skin_.edges(), attitudeCovariances(skin_, paths_),
                               gapShareOf(skin_.options().gap_model));
}

const SE3& PatchSolver::placementOf(std::size_t cell) const {
  return joint_ != nullptr ? joint_->placementOf(cell) : placements_[skin_.graph().cells()[cell].place].T_o_u;
}

std::unique_ptr<GlobalRefinement> PatchSolver::jointFrom(const PatchReconstruction* earlier) {
  std::vector<SE3> start = startingPlacements(earlier);
  placements_ = std::vector<TreePlacement>();
  return std::make_unique<GlobalRefinement>(skin_.model(), skin_.graph(), skin_.table(), skin_.options(), cells_,
                                            origin(), std::move(start));
}

Completion PatchSolver::solve(const PatchReconstruction* earlier, const std::stop_token& stop) {
  if (joint_ == nullptr) joint_ = jointFrom(earlier);
  joint_->solve(stop);
  solved_ = !stop.stop_requested();
  return solved_ ? Completion::Finished : Completion::Stopped;
}

void PatchSolver::leaveOut(std::size_t cell) {
  solved_ = false;
  if (cell == origin()) lacks_origin_ = true;
  if (joint_ != nullptr) joint_->leaveOut(cell);
}

void PatchSolver::place() {
  if (!lacks_origin_) return;
  joint_.reset();
  placeAlongPaths();
  lacks_origin_ = false;
}

bool PatchSolver::canStartFrom(const PatchReconstruction& earlier) const {
  const auto id = [&](std::size_t cell) { return skin_.graph().cells()[cell].id; };
  return earlier.origin == id(origin()) && std::ranges::equal(cells_, earlier.cells, {}, id, &CellPlacement::cell);
}

/// Of the earlier result if there is one that serves, else the tree's.
std::vector<SE3> PatchSolver::startingPlacements(const PatchReconstruction* earlier) const {
  std::vector<SE3> placements;
  placements.reserve(cells_.size());
  if (earlier != nullptr && canStartFrom(*earlier)) {
    for (const CellPlacement& cell : earlier->cells) placements.push_back(cell.T_o_u);
  } else {
    for (const TreePlacement& placement : placements_) placements.push_back(placement.T_o_u);
  }
  return placements;
}

void nameInconsistentPoses(const SkinLinks& skin, const PatchSolver& patch, std::vector<Finding>& findings) {
  const GlobalRefinement& joint = *patch.joint();
  // Tremor leaves a few standard deviations everywhere; one pose far beyond the others is the odd one out.
  constexpr double kLargest = 8;
  constexpr double kTimesOthers = 3;
  if (joint.poses().size() < 3) return;
  const std::vector<double> misfits = joint.poseMisfits();
  std::vector<double> sorted = misfits;
  std::ranges::sort(sorted);
  const double usual = sorted[sorted.size() / 2];
  for (std::size_t k = 0; k < misfits.size(); ++k) {
    if (misfits[k] < std::max(kLargest, kTimesOthers * usual)) continue;
    const PoseId id = skin.poseId(joint.poses()[k]);
    findings.push_back(
        makeFinding(FindingCode::InconsistentPose,
                    message("In pose {} the cells contradict each other by {} times their noise (other poses {}): the "
                            "part probably moved while it was sampled. Take the pose again.",
                            id, Number{misfits[k], 0}, Number{usual, 1}),
                    {}, {}, {id}));
  }
}

void nameUnconverged(CellId origin, const GlobalSolution& solution, std::vector<Finding>& findings) {
  if (solution.termination != GlobalTermination::StepLimit) return;
  findings.push_back(makeFinding(
      FindingCode::NotConverged,
      message("The joint estimate of the patch of cell {} has not converged after {} steps: a more probable shape is "
              "nearby, and the stated uncertainty can't be relied on. Take another pose.",
              origin, solution.iterations),
      {origin}));
}

}  // namespace hexoderm
