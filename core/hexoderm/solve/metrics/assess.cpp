#include "hexoderm/solve/metrics/assess.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/skin_signs.h"
#include "hexoderm/solve/result/patch_placements.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace hexoderm {
namespace {

/// Beyond this an orientation is of no use to robot software.
constexpr double kUsableOrientation_rad = 20 * kDegree;
/// A result is usable within so many times the goal.
constexpr double kUsable = 3;
/// Readings that lower an uncertainty by less than a seventh are not worth another pose, and by less than a twentieth
/// are not worth a word.
constexpr double kWorthwhile = 0.85;
constexpr double kWorthAWord = 0.95;

Uncertainty95 worseOf(const Uncertainty95& a, const Uncertainty95& b) {
  return {std::max(a.position_m, b.position_m), std::max(a.orientation_rad, b.orientation_rad)};
}

std::vector<const CellPlacement*> cellsThatCount(const PatchReconstruction& patch) {
  const auto measured = [&](std::size_t cell) { return patch.cells[cell].placed_by == PlacedBy::Samples; };
  std::vector<const CellPlacement*> cells;
  for (const std::size_t cell : countedCells(patch.cells.size(), measured)) cells.push_back(&patch.cells[cell]);
  return cells;
}

/// Whether the cell can be less certain than `worst`: no eigenvalue is larger than the root of the sum of squares. That
/// is seen much faster than how certain it is.
bool mayBeWorse(const Matrix6d& cov_t_r, const Uncertainty95& worst) {
  constexpr double kRounding = 1 + 1e-6;
  const auto may = [](const Eigen::Matrix3d& covariance, double largest) {
    const double deviation = largest / kSigmasFor95Percent;
    return covariance.norm() * kRounding > deviation * deviation;
  };
  return may(cov_t_r.topLeftCorner<3, 3>(), worst.position_m) ||
         may(cov_t_r.bottomRightCorner<3, 3>(), worst.orientation_rad);
}

Uncertainty95 worstUncertainty(const Reconstruction& r) {
  Uncertainty95 worst;
  for (const PatchReconstruction& patch : r.patches) worst = worseOf(worst, worstUncertainty(patch));
  return worst;
}

/// Whether a finding muted the link by what its cells read: a link of the skin, as far as the report goes.
bool isMutedByReadings(const LinkEstimate& link) {
  using enum FindingCode;
  constexpr std::array kCodes = {ImplausibleBend, ImplausibleTwist, ImplausibleYaw, LinkNotRigid, LinkDoesNotClose};
  return link.muted_by && std::ranges::count(kCodes, *link.muted_by) > 0;
}

/// Of a link between two patches the index of its target's patch.
std::optional<std::size_t> otherPatch(const Reconstruction& r, std::size_t patch, const LinkEstimate& link) {
  if (link.used || r.patches[patch].findCell(link.target.cell) != nullptr) return std::nullopt;
  const PatchReconstruction* other = r.find(link.target.cell).patch;
  return other == nullptr ? std::nullopt : std::optional(static_cast<std::size_t>(other - r.patches.data()));
}

/// Groups of patches that nothing known holds together: neither a joint, which is where one body part ends or where the
/// operator set a link aside, nor places on a robot.
std::size_t separateGroups(const Reconstruction& r) {
  std::vector<std::size_t> group_of(r.patches.size());
  std::iota(group_of.begin(), group_of.end(), std::size_t{0});
  const auto join = [&](std::size_t a, std::size_t b) {
    std::ranges::replace(group_of, std::size_t{group_of[b]}, std::size_t{group_of[a]});
  };
  std::optional<std::size_t> placed;
  for (std::size_t p = 0; p < r.patches.size(); ++p) {
    const PatchPlacement* place = placementOf(r, r.patches[p]);
    if (place != nullptr && place->place) join(placed.value_or(p), p);
    if (place != nullptr && place->place) placed = p;
    for (const LinkEstimate& link : r.patches[p].links) {
      if (link.muted_by != FindingCode::BodyPartBoundary && link.muted_by != FindingCode::LinkSetAside) continue;
      if (const auto other = otherPatch(r, p, link)) join(p, *other);
    }
  }
  return std::set(group_of.begin(), group_of.end()).size();
}

/// Links between patches that findings muted, and nobody said that there is a joint.
std::size_t unexplainedSplits(const Reconstruction& r) {
  std::size_t splits = 0;
  for (std::size_t p = 0; p < r.patches.size(); ++p) {
    splits += static_cast<std::size_t>(std::ranges::count_if(r.patches[p].links, [&](const LinkEstimate& link) {
      return isMutedByReadings(link) && otherPatch(r, p, link);
    }));
  }
  return splits;
}

/// Cells whose readings findings hold against them, although they have some.
std::set<CellId> accusedCells(const Reconstruction& r) {
  std::set<CellId> accused;
  for (const Finding& finding : r.findings) {
    const bool counts = finding.severity != Severity::Info && finding.code != FindingCode::NoSamples;
    if (counts && isAboutCells(finding.code)) accused.insert(finding.cells.begin(), finding.cells.end());
  }
  return accused;
}

/// Cells that no link joins to another.
std::size_t loneCells(const Reconstruction& r) {
  return static_cast<std::size_t>(
      std::ranges::count_if(r.patches, [](const auto& patch) { return patch.cells.size() == 1; }));
}

/// Cells placed by what they read, not by their links alone.
std::size_t measuredCells(const Reconstruction& r) {
  std::size_t measured = 0;
  for (const PatchReconstruction& patch : r.patches) {
    measured += static_cast<std::size_t>(std::ranges::count(patch.cells, PlacedBy::Samples, &CellPlacement::placed_by));
  }
  return measured;
}

Message plusMinus(const Uncertainty95& spread) {
  return message("±{}, ±{}", Millimetres{spread.position_m, 1}, Degrees{spread.orientation_rad, 1});
}

Message posesText(std::size_t poses) { return poses == 1 ? message("1 pose") : message("{} poses", poses); }

class Assessor {
 public:
  Assessor(const Reconstruction& r, const std::optional<Forecast>& forecast)
      : r_(r),
        forecast_(forecast),
        advice_(adviseNextPose(*r.model, directionsSeen(r))),
        worst_(worstUncertainty(r)),
        poses_(static_cast<std::size_t>(std::ranges::count(r.poses, true, &PoseSummary::enabled))),
        groups_(separateGroups(r)),
        finding_(worstFinding(r)) {}

  Assessment run() {
    if (r_.cellCount() == 0) {
      fail(message("The skin has no cells."), message("Check the connection to the skin and explore it again."));
    } else if (r_.cellCount() == 1) {
      assessOneCell();
    } else if (2 * loneCells(r_) > r_.cellCount()) {
      assessLoneCells();
    } else if (poses_ > 0 && 2 * measuredCells(r_) < r_.cellCount()) {
      assessUnmeasuredCells();
    } else if (const std::optional<Message> why = poses_ > 0 ? whyNotTrusted() : std::nullopt) {
      assessContradiction(*why);
    } else {
      assessPlacements();
    }
    return result_;
  }

 private:
  void fail(Message reason, Message next) {
    result_.level = VerdictLevel::Failed;
    result_.limit = Limit::NoSkin;
    result_.remedy = Remedy::CheckSkin;
    result_.reason = std::move(reason);
    result_.next_action = std::move(next);
  }

  void assessOneCell() {
    result_.level = VerdictLevel::Usable;
    result_.limit = Limit::NoSkin;
    result_.reason = message("One cell: it is its own origin, there is nothing to estimate.");
    result_.next_action = message("Export.");
    result_.position_95_m = 0;
    result_.orientation_95_rad = 0;
  }

  void assessLoneCells() {
    const std::size_t lone = loneCells(r_);
    Message reason =
        lone == r_.cellCount()
            ? message("No cell is linked to another: nothing says how the {} cells lie.", lone)
            : message("{} of {} cells are linked to no other: nothing says how they lie.", lone, r_.cellCount());
    if (finding_ != nullptr) reason = inRow({reason, finding_->message});
    fail(std::move(reason), message("Check the links between the cells, then the findings."));
  }

  void assessUnmeasuredCells() {
    Message reason =
        message("Of {} cells only {} have readings that can be used: the shape shown follows mostly from the ports.",
                r_.cellCount(), measuredCells(r_));
    if (finding_ != nullptr) reason = inRow({reason, finding_->message});
    fail(std::move(reason), message("Look at the findings and check the readings of the cells."));
    result_.limit = Limit::Findings;
  }

  /// Why what the covariances say can't be believed; nothing if it can.
  [[nodiscard]] std::optional<Message> whyNotTrusted() const {
    // One cell of three or one cable of a chain is a fault like any other.
    constexpr std::size_t kFewCells = 1;
    constexpr std::size_t kFewLinks = 3;
    const auto refuting = std::ranges::find_if(r_.findings, refutesModel, &Finding::code);
    if (refuting != r_.findings.end()) return refuting->message;
    const std::set<CellId> accused = accusedCells(r_);
    std::size_t reading = accused.size();
    for (const PatchReconstruction& patch : r_.patches) {
      reading += static_cast<std::size_t>(std::ranges::count_if(patch.cells, [&](const CellPlacement& cell) {
        return cell.placed_by == PlacedBy::Samples && !accused.contains(cell.cell);
      }));
    }
    if (accused.size() > kFewCells && 3 * accused.size() >= reading) {
      return message("Something is wrong with the readings of {} of {} cells: too many to tell which are right.",
                     accused.size(), reading);
    }
    const std::size_t splits = unexplainedSplits(r_);
    if (splits > kFewLinks) {
      return message("The skin fell apart at {} links that do not fit it, and nothing says that there is a joint.",
                     splits);
    }
    return std::nullopt;
  }

  void assessContradiction(const Message& why) {
    result_.level = VerdictLevel::NotTrusted;
    result_.limit = Limit::Findings;
    result_.remedy = Remedy::CheckSkin;
    result_.reason = message("Not to be trusted: {}", why);
    if (r_.patches.size() > 1) result_.reason = inRow({result_.reason, patchesText()});
    result_.next_action =
        message("Look at the findings, and compare the cell model, the cells and their links with the skin.");
  }

  [[nodiscard]] Message patchesText() const {
    return message("No used link joins the {} patches: each lies in the frame of its own origin.", r_.patches.size());
  }

  void assessPlacements() {
    result_.position_95_m = worst_.position_m;
    result_.orientation_95_rad = worst_.orientation_rad;
    const Goal& goal = r_.options.goal;
    const bool is_precise = meets(worst_, goal);
    const bool is_whole = groups_ == 1;
    if (poses_ == 0) {
      result_.level = VerdictLevel::NotEnough;
      result_.limit = Limit::NoPose;
      result_.remedy = Remedy::TakePose;
    } else if (lieAlongOneLine(directionsSeen(r_))) {
      result_.level = VerdictLevel::NotEnough;
      result_.limit = Limit::Directions;
      result_.remedy = Remedy::TakePose;
    } else if (worst_.orientation_rad > kUsableOrientation_rad) {
      result_.level = VerdictLevel::NotEnough;
      chooseLimit();
    } else if (is_precise && finding_ == nullptr && is_whole) {
      result_.level = VerdictLevel::Good;
    } else {
      const bool is_usable = meets(worst_, {kUsable * goal.position_m, kUsable * goal.orientation_rad});
      result_.level = is_usable ? VerdictLevel::Usable : VerdictLevel::Coarse;
      if (is_precise) {
        result_.limit = !is_whole ? Limit::Patches : Limit::Findings;
      } else {
        chooseLimit();
      }
    }
    sayReason();
    sayNext();
  }

  /// Whether readings that lead to `then` would bring what is above the goal to this share of it.
  [[nodiscard]] bool helps(const Uncertainty95& then, double share = kWorthwhile) const {
    const Uncertainty95& now = forecast_ ? forecast_->now : worst_;
    const Goal& goal = r_.options.goal;
    return (now.orientation_rad > goal.orientation_rad && then.orientation_rad <= share * now.orientation_rad) ||
           (now.position_m > goal.position_m && then.position_m <= share * now.position_m);
  }

  /// With the advised pose.
  [[nodiscard]] Uncertainty95 expected() const {
    if (forecast_) return forecast_->with_pose;
    const double share = advice_.sigma_now_rad > 0 ? advice_.sigma_then_rad / advice_.sigma_now_rad : 1;
    return {worst_.position_m * share, worst_.orientation_rad * share};
  }

  void chooseLimit() {
    const bool pose_helps = helps(expected());
    const bool readings_help = forecast_ && !forecast_->retake.empty() && helps(forecast_->with_all_readings);
    if (readings_help &&
        (!pose_helps || forecast_->with_all_readings.orientation_rad <= forecast_->with_pose.orientation_rad)) {
      result_.limit = Limit::Readings;
      result_.remedy = Remedy::RetakePoses;
      result_.limiting_cells = forecast_->lacking;
      result_.retake = forecast_->retake;
    } else if (pose_helps) {
      result_.limit = Limit::Directions;
      result_.remedy = Remedy::TakePose;
    } else {
      result_.limit = groups_ > 1 ? Limit::Patches : finding_ != nullptr ? Limit::Findings : Limit::Mould;
      result_.remedy = result_.level == VerdictLevel::NotEnough ? Remedy::CheckSkin : Remedy::Nothing;
    }
  }

  void sayReason() {
    const Message spread = spreadText();
    const Message poses = posesText(poses_);
    result_.reason = result_.level == VerdictLevel::Good     ? message("Good: {}, {}.", spread, poses)
                     : result_.level == VerdictLevel::Usable ? message("Usable: {}, {}.", spread, poses)
                     : result_.level == VerdictLevel::Coarse ? message("Coarse: {}, {}.", spread, poses)
                     : poses_ == 0 ? message("Not enough: no pose yet. The shape shown follows from the ports alone.")
                                   : message("Not enough: {}, {}.", spread, poses);
    std::vector<Message> sentences = {result_.reason};
    if (result_.limit == Limit::Readings) {
      sentences.push_back(message("What limits it is that {} can't be used in {}: the readings are missing or no good.",
                                  cellsText(result_.limiting_cells), posesToRetake()));
    } else if (result_.limit == Limit::Mould) {
      const Uncertainty95 then = expected();
      sentences.push_back(
          helps(then, kWorthAWord)
              ? message("What limits it is mostly how the cells lie in the mould: another pose would bring {}.",
                        fromTo(then))
              : message("What limits it is how the cells lie in the mould: another pose would hardly help."));
    }
    if (r_.patches.size() > 1) {
      sentences.push_back(groups_ > 1
                              ? patchesText()
                              : message("The {} patches, which a joint or the robot holds together, lie each in "
                                        "the frame of its own origin.",
                                        r_.patches.size()));
    }
    if (finding_ != nullptr && poses_ > 0) sentences.push_back(finding_->message);
    if (sentences.size() > 1) result_.reason = inRow(std::move(sentences));
  }

  /// "±1.2 mm, ±0.4° (95 %, worst: cell 16)".
  [[nodiscard]] Message spreadText() const {
    const Message spread = plusMinus(worst_);
    const std::vector<CellId> cells = worstCells(r_);
    if (cells.empty()) return message("{} (95 %)", spread);
    // Cells that are placed through their links are not counted in, and are less sure.
    return measuredCells(r_) == r_.cellCount() ? message("{} (95 %, worst: {})", spread, cellsText(cells))
                                               : message("{} (95 %, worst measured: {})", spread, cellsText(cells));
  }

  [[nodiscard]] Message posesToRetake() const {
    return result_.retake.size() == 1 ? message("pose {}", result_.retake.front())
                                      : message("poses {}", result_.retake);
  }

  void sayNext() {
    switch (result_.remedy) {
      case Remedy::TakePose:
        sayPose();
        return;
      case Remedy::RetakePoses:
        result_.next_action =
            message("Take {} again. That should bring {}.", posesToRetake(), fromTo(forecast_->with_all_readings));
        return;
      case Remedy::CheckSkin:
        result_.next_action = message("Look at the findings and check the links between the cells.");
        return;
      case Remedy::Nothing:
        result_.next_action = finding_ != nullptr ? message("Look at the findings, then export.")
                              : groups_ > 1       ? message("Look for the missing link, or export patch by patch.")
                                                  : message("Export.");
    }
  }

  /// "±2.8° to about ±1.3°": of what is above the goal, and falls by more.
  [[nodiscard]] Message fromTo(const Uncertainty95& then) const {
    const Goal& goal = r_.options.goal;
    const bool turns_more =
        then.orientation_rad * worst_.position_m <= then.position_m * worst_.orientation_rad || worst_.position_m == 0;
    if (worst_.orientation_rad > goal.orientation_rad && (turns_more || worst_.position_m <= goal.position_m)) {
      return message("±{} to about ±{}", Degrees{worst_.orientation_rad, 1}, Degrees{then.orientation_rad, 1});
    }
    return message("±{} to about ±{}", Millimetres{worst_.position_m, 1}, Millimetres{then.position_m, 1});
  }

  void sayPose() {
    if (poses_ == 0) {
      result_.next_action = message("Hold the part still and take a first pose.");
      return;
    }
    result_.next_action = inRow({adviceText(advice_, r_), message("That should bring {}.", fromTo(expected()))});
  }

  const Reconstruction& r_;
  const std::optional<Forecast>& forecast_;
  PoseAdvice advice_;
  Uncertainty95 worst_;
  std::size_t poses_;
  std::size_t groups_;  ///< of patches
  const Finding* finding_;
  Assessment result_;
};

}  // namespace

const Finding* worstFinding(const Reconstruction& r) {
  const Finding* worst = nullptr;
  for (const Finding& finding : r.findings) {
    if (finding.severity == Severity::Info) continue;
    if (worst == nullptr || finding.severity > worst->severity) worst = &finding;
  }
  return worst;
}

bool refutesModel(FindingCode code) { return code == FindingCode::ContradictsModel || code == FindingCode::PoorFit; }

void withdrawUncertainties(Reconstruction& r) {
  std::set<CellId> refuted;
  for (const Finding& finding : r.findings) {
    if (refutesModel(finding.code)) refuted.insert(finding.cells.begin(), finding.cells.end());
  }
  for (PatchReconstruction& patch : r.patches) {
    const auto isRefuted = [&](const CellPlacement& cell) { return refuted.contains(cell.cell); };
    if (!refuted.empty() && std::ranges::none_of(patch.cells, isRefuted)) continue;
    patch.covariance.reset();
    for (CellPlacement& cell : patch.cells) {
      cell.cov_t_r.reset();
      cell.shape_cov_t_r.reset();
    }
  }
}

std::vector<std::size_t> countedCells(std::size_t count, const std::function<bool(std::size_t)>& measured) {
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < count; ++cell) {
    if (measured(cell)) cells.push_back(cell);
  }
  if (!cells.empty()) return cells;
  cells.resize(count);
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  return cells;
}

Uncertainty95 worstUncertainty(const PatchReconstruction& patch) {
  Uncertainty95 worst;
  for (const CellPlacement* cell : cellsThatCount(patch)) {
    if (cell->cov_t_r && mayBeWorse(*cell->cov_t_r, worst)) worst = worseOf(worst, uncertaintyBy(*cell->cov_t_r));
  }
  return worst;
}

Uncertainty95 worstUncertainty(std::span<const Matrix6d> covariances) {
  Uncertainty95 worst;
  for (const Matrix6d& cov_t_r : covariances) {
    if (mayBeWorse(cov_t_r, worst)) worst = worseOf(worst, uncertaintyBy(cov_t_r));
  }
  return worst;
}

std::vector<CellId> worstCells(const Reconstruction& r) {
  const CellPlacement* position = nullptr;
  const CellPlacement* orientation = nullptr;
  Uncertainty95 worst;
  for (const PatchReconstruction& patch : r.patches) {
    for (const CellPlacement* cell : cellsThatCount(patch)) {
      if (!cell->cov_t_r || !mayBeWorse(*cell->cov_t_r, worst)) continue;
      const Uncertainty95 known = uncertaintyBy(*cell->cov_t_r);
      if (known.position_m > worst.position_m) position = cell;
      if (known.orientation_rad > worst.orientation_rad) orientation = cell;
      worst = worseOf(worst, known);
    }
  }
  std::vector<CellId> cells;
  if (position != nullptr) cells.push_back(position->cell);
  if (orientation != nullptr && orientation != position) cells.push_back(orientation->cell);
  return cells;
}

std::optional<Finding> describeTooFewDirections(const Reconstruction& r) {
  if (r.assessment.level != VerdictLevel::NotEnough || r.assessment.limit != Limit::Directions) return std::nullopt;
  std::vector<PoseId> poses;
  for (const PoseSummary& pose : r.poses) {
    if (pose.enabled) poses.push_back(pose.pose);
  }
  return makeFinding(
      FindingCode::TooFewDirections,
      message("The directions of gravity that were seen leave open how the cells are turned: take a pose "
              "in which the part is turned by about 90 degrees about a horizontal axis."),
      {}, {}, poses);
}

Assessment assess(const Reconstruction& reconstruction, const std::optional<Forecast>& forecast) {
  return Assessor(reconstruction, forecast).run();
}

}  // namespace hexoderm
