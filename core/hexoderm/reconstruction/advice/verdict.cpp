#include "hexoderm/reconstruction/advice/verdict.h"

#include "hexoderm/reconstruction/advice/pose_advisor.h"
#include "hexoderm/reconstruction/result/uncertainty.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

// Limits of a result that robot software can use without a second thought, and of one that it can use at all.
constexpr double kGoodOrientation = 2 * kDegree;
constexpr double kGoodPosition_m = 3 * kMillimetre;
constexpr double kUsableOrientation = 20 * kDegree;

/// Taken over the measured cells; cells placed through their links are named by findings of their own. If none was
/// measured, over all.
Uncertainty95 worstSpread(const Reconstruction& r) {
  const auto measured = [](const CellPlacement& cell) { return cell.placed_by == PlacedBy::Samples; };
  const bool any_measured = std::ranges::any_of(
      r.patches, [&](const PatchReconstruction& patch) { return std::ranges::any_of(patch.cells, measured); });
  Uncertainty95 worst;
  for (const PatchReconstruction& patch : r.patches) {
    for (const CellPlacement& cell : patch.cells) {
      const std::optional<Uncertainty95> known = any_measured && !measured(cell) ? std::nullopt : uncertaintyOf(cell);
      if (!known) continue;
      worst.position_m = std::max(worst.position_m, known->position_m);
      worst.orientation_rad = std::max(worst.orientation_rad, known->orientation_rad);
    }
  }
  return worst;
}

std::vector<Eigen::Vector3d> directionsSeen(const Reconstruction& r) {
  std::vector<Eigen::Vector3d> seen;
  const PatchReconstruction* largest = largestPatch(r);
  if (largest == nullptr) return seen;
  for (const GravityDirection& gravity : largest->gravity) seen.push_back(gravity.g_o);
  return seen;
}

std::size_t enabledPoses(const Reconstruction& r) {
  return static_cast<std::size_t>(std::ranges::count(r.poses, true, &PoseSummary::enabled));
}

/// Links of which the poses don't show the whole rotation although both cells read.
std::size_t undeterminedLinks(const Reconstruction& r) {
  std::size_t count = 0;
  for (const PatchReconstruction& patch : r.patches) {
    for (const LinkEstimate& link : patch.links) {
      if (link.used && (link.quality == EdgeQuality::Undefined || link.quality == EdgeQuality::Partially)) ++count;
    }
  }
  return count;
}

/// Too little of the skin is linked, or can be read, for the rest to be its shape.
std::optional<Verdict> littleLeft(const Reconstruction& r, std::size_t poses) {
  std::size_t alone = 0;
  std::size_t measured = 0;
  for (const PatchReconstruction& patch : r.patches) {
    if (patch.cells.size() == 1) ++alone;
    measured += static_cast<std::size_t>(
        std::ranges::count(patch.cells, PlacedBy::Samples, &CellPlacement::placed_by));
  }
  Verdict verdict;
  verdict.level = VerdictLevel::Failed;
  if (2 * alone > r.cellCount()) {
    verdict.reason = alone == r.cellCount()
                         ? message("No cell is linked to another: nothing is known of their places.")
                         : message("{} of {} cells are linked to no other: nothing is known of their places.", alone,
                                   r.cellCount());
    verdict.next_action = message("Look at the findings and check the links, the readings and the cell model.");
    return verdict;
  }
  if (poses > 0 && 2 * measured < r.cellCount()) {
    verdict.reason =
        message("Of {} cells only {} have readings that can be used: the shape shown follows mostly from the ports.",
                r.cellCount(), measured);
    verdict.next_action = message("Look at the findings and check the readings of the cells.");
    return verdict;
  }
  return std::nullopt;
}

Message plusMinus(const Uncertainty95& spread) {
  return message("±{}, ±{}", Millimetres{spread.position_m, 1}, Degrees{spread.orientation_rad, 1});
}

}  // namespace

const Finding* worstFinding(const Reconstruction& r) {
  const Finding* worst = nullptr;
  for (const Finding& finding : r.findings) {
    if (finding.severity == Severity::Info) continue;
    if (worst == nullptr || finding.severity > worst->severity) worst = &finding;
  }
  return worst;
}

Verdict judge(const Reconstruction& r) {
  Verdict verdict;
  if (r.cellCount() == 0) {
    verdict.level = VerdictLevel::Failed;
    verdict.reason = message("The skin has no cells.");
    verdict.next_action = message("Check the connection to the skin and explore it again.");
    return verdict;
  }
  const std::size_t poses = enabledPoses(r);
  const PoseAdvice advice = adviseNextPose(*r.model, directionsSeen(r));
  Message turn = adviceInWords(advice, r);

  if (r.cellCount() == 1) {
    verdict.level = VerdictLevel::Usable;
    verdict.reason = message("One cell: it is its own origin, there is nothing to estimate.");
    verdict.position_95_m = 0;
    verdict.orientation_95_rad = 0;
    verdict.next_action = message("Export.");
    return verdict;
  }
  if (auto failed = littleLeft(r, poses)) return *failed;

  const Uncertainty95 spread = worstSpread(r);
  verdict.position_95_m = spread.position_m;
  verdict.orientation_95_rad = spread.orientation_rad;
  if (poses > 0 && advice.sigma_now_rad > 0) {
    turn = inRow({turn, message("That should bring ±{} to about ±{}.", Degrees{spread.orientation_rad, 1},
                                Degrees{spread.orientation_rad * advice.sigma_then_rad / advice.sigma_now_rad, 1})});
  }
  const std::size_t undetermined = undeterminedLinks(r);
  const std::size_t used = [&] {
    std::size_t count = 0;
    for (const PatchReconstruction& patch : r.patches) {
      count += static_cast<std::size_t>(std::ranges::count(patch.links, true, &LinkEstimate::used));
    }
    return count;
  }();
  const Message pose_count = poses == 1 ? message("1 pose") : message("{} poses", poses);

  if (poses == 0) {
    verdict.level = VerdictLevel::NotEnough;
    verdict.reason = message("Not enough poses: none yet. The shape shown follows from the ports alone.");
    verdict.next_action = message("Hold the part still and take a first pose.");
  } else if (2 * undetermined > used) {
    verdict.level = VerdictLevel::NotEnough;
    verdict.reason = message("Not enough poses: {} along one line leave the turn about gravity open ({}).", pose_count,
                             plusMinus(spread));
    if (poses == 1)
      verdict.reason = message("Not enough poses: one leaves the turn about gravity open ({}).", plusMinus(spread));
    verdict.next_action = turn;
  } else if (spread.orientation_rad > kUsableOrientation) {
    verdict.level = VerdictLevel::NotEnough;
    verdict.reason = message("{} are not enough: known to {} only.", pose_count, plusMinus(spread));
    verdict.next_action = turn;
  } else {
    const bool precise = spread.orientation_rad <= kGoodOrientation && spread.position_m <= kGoodPosition_m;
    const Finding* finding = worstFinding(r);
    verdict.level = precise && finding == nullptr ? VerdictLevel::Good : VerdictLevel::Usable;
    verdict.reason = verdict.level == VerdictLevel::Good
                         ? message("Good: {} at the worst cell (95 %), {}.", plusMinus(spread), pose_count)
                         : message("Usable: {} at the worst cell (95 %), {}.", plusMinus(spread), pose_count);
    if (finding != nullptr) verdict.reason = inRow({verdict.reason, finding->message});
    const bool worth_it = advice.sigma_then_rad < 0.9 * advice.sigma_now_rad;
    verdict.next_action = !precise && worth_it ? turn
                          : finding != nullptr ? message("Look at the findings, then export.")
                                               : message("Export.");
  }
  return verdict;
}

}  // namespace hexoderm
