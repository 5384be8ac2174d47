#include "hexoderm/reconstruction/patch/patch_solver.h"

#include "hexoderm/graph/cut_elements.h"
#include "hexoderm/reconstruction/faults/suspects.h"
#include "hexoderm/util/median.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include <algorithm>
#include <cassert>

namespace hexoderm {
namespace {

/// The covariance of every cell's own attitude error, per cell of the patch.
std::vector<Eigen::Matrix3d> attitudeCovariances(const SkinLinks& skin, const ShortestPaths& paths) {
  const auto place = [&skin](std::size_t cell) { return skin.graph().cells()[cell].place; };
  std::vector<std::size_t> links = paths.link;
  if (paths.order.size() > 1) links[place(paths.root)] = paths.link[place(paths.order[1])];
  return skin.attitudeCovariances(skin.graph().patches()[skin.graph().cells()[paths.root].patch.value()], links);
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

Finding describeOpenLink(const SkinGraph& graph, const JointRefinement::OpenLink& open, double limit_m) {
  const LinkEnd source = graph.sourceEnd(graph.links()[open.link]);
  const LinkEnd target = graph.targetEnd(graph.links()[open.link]);
  const Message link = linkInWords(source, target);
  const Millimetres opening{open.opening_m, 0};
  const Millimetres limit{limit_m, 0};
  const std::size_t candidates = linksOfAllLoopsThrough(graph, open.link).size();
  return makeFinding(
      FindingCode::LinkDoesNotClose,
      candidates > 1
          ? message("With all other links the ends of the {} come to lie {} apart, and a skin link leaves no more than "
                    "{}. All of its loops have {} links in common, and any one of these may be a cable. The link is "
                    "not used.",
                    link, opening, limit, candidates)
          : message("With all other links the ends of the {} come to lie {} apart, and a skin link leaves no more than "
                    "{}: it is probably a cable, since no other link is in all of its loops. The link is not used.",
                    link, opening, limit),
      {source.cell, target.cell}, {source.port, target.port});
}

}  // namespace

PatchSolver::PatchSolver(SkinLinks& skin, std::span<const double> weights, std::size_t patch)
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

std::unique_ptr<JointRefinement> PatchSolver::jointFrom(const PatchReconstruction* earlier) {
  std::vector<SE3> start = startingPlacements(earlier);
  placements_ = std::vector<TreePlacement>();
  return std::make_unique<JointRefinement>(skin_.model(), skin_.graph(), skin_.table(), skin_.options(), cells_,
                                           origin(), std::move(start));
}

Completion PatchSolver::refine(const PatchReconstruction* earlier, const std::stop_token& stop,
                               std::vector<Finding>& findings) {
  assert(joint_ == nullptr);
  joint_ = jointFrom(earlier);
  joint_->solve(stop);
  if (stop.stop_requested()) return Completion::Stopped;
  std::vector<std::size_t> suspicious;
  while (const auto bad = worstSensor(suspicious)) {
    const bool is_clear = joint_->misfitOf(bad->cell).deviate() > kClearly * skin_.options().max_misfit;
    if (hasTooFewPoses(skin_.table(), bad->cell) && !is_clear) {
      addOnce(findings, describeSuspiciousSensor(skin_.graph(), skin_.table(), bad->cell));
      suspicious.push_back(bad->cell);
      continue;
    }
    findings.push_back(describe(*bad));
    skin_.dropCell(bad->cell);
    if (bad->cell == origin()) {
      skin_.estimateEdges();
      placeAlongPaths();
      joint_ = jointFrom(nullptr);
    } else {
      joint_->leaveOut(bad->cell);
    }
    joint_->solve(stop);
    if (stop.stop_requested()) return Completion::Stopped;
    dropped_cells_ = true;
  }
  return Completion::Finished;
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

/// The cell, none of `but`, whose readings fit the gravity of all others worst.
std::optional<PatchSolver::BadSensor> PatchSolver::worstSensor(const std::vector<std::size_t>& but) const {
  // With hundreds of poses the smallest misfit is significant; only one that also matters makes a sensor useless.
  constexpr double kLeastTimes = 2;
  std::optional<BadSensor> worst;
  double worst_misfit = skin_.options().max_misfit;
  for (const std::size_t cell : cells_) {
    if (!skin_.readings().measured(cell) || skin_.table().usablePoses(cell).size() < 2) continue;
    if (std::ranges::count(but, cell) > 0) continue;
    if (joint_->mostMisfitOf(cell).deviate() <= worst_misfit) continue;
    const Misfit found = joint_->misfitOf(cell);
    const double misfit = found.deviate();
    if (misfit <= worst_misfit || found.chi_squared < kLeastTimes * found.degrees) continue;
    worst = BadSensor{cell, std::nullopt};
    worst_misfit = misfit;
  }
  if (worst) worst->turn = turnOf(worst->cell);
  return worst;
}

/// The turn against the others between two poses that explains what a cell reads, if one does.
std::optional<TurnBetweenPoses> PatchSolver::turnOf(std::size_t cell) const {
  const TurnBetweenPoses turn = joint_->turnOf(cell);
  const Misfit misfit = joint_->misfitOf(cell);
  const Misfit left{misfit.chi_squared - turn.gain.chi_squared, misfit.degrees - turn.gain.degrees};
  const bool explains = left.degrees > 0 && left.deviate() <= skin_.options().max_misfit;
  return explains ? std::optional(turn) : std::nullopt;
}

Finding PatchSolver::describe(const BadSensor& bad) const {
  if (!bad.turn) {
    return describeBadSensor(skin_.graph(), skin_.table(), skin_.snapshot(), bad.cell, isLeaf(bad.cell));
  }
  const std::size_t pose = skin_.table().usablePoses(bad.cell)[bad.turn->first_after];
  return describeMovedCell(skin_.graph(), skin_.snapshot(), bad.cell, pose, bad.turn->angle_rad);
}

/// One link alone holds the cell.
bool PatchSolver::isLeaf(std::size_t cell) const {
  const SkinGraph& graph = skin_.graph();
  return std::ranges::count_if(graph.linksAt(cell), [&](std::size_t k) { return !graph.links()[k].muted(); }) == 1;
}

bool muteOpenLinks(SkinLinks& skin, std::span<const PatchSolver> patches, std::vector<Finding>& findings) {
  const double limit_m = skin.options().max_opening * skin.model().link_sigma_m;
  std::vector<std::size_t> links;
  for (const PatchSolver& patch : patches) {
    const auto widest = patch.joint()->widestOpen();
    if (!widest || widest->opening_m <= limit_m) continue;
    links.push_back(widest->link);
    findings.push_back(describeOpenLink(skin.graph(), *widest, limit_m));
  }
  if (links.empty()) return false;
  skin.mute(links, FindingCode::LinkDoesNotClose);
  return true;
}

void nameInconsistentPoses(const SkinLinks& skin, const PatchSolver& patch, std::vector<Finding>& findings) {
  const JointRefinement& joint = *patch.joint();
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

void nameUnconverged(CellId origin, const JointSolution& solution, std::vector<Finding>& findings) {
  if (solution.termination != JointTermination::StepLimit) return;
  findings.push_back(makeFinding(
      FindingCode::NotConverged,
      message("The joint estimate of the patch of cell {} has not converged after {} steps: a more probable shape is "
              "nearby, and the stated uncertainty can't be relied on. Take another pose.",
              origin, solution.iterations),
      {origin}));
}

}  // namespace hexoderm
