#include "widgets/capture/capture_words.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/assess.h"
#include "widgets/style/of_enum.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

struct CaptureWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::CaptureWords)
};

QString name(CellId cell) { return QString::number(cell.value()); }
QString degrees(double angle_rad, int decimals) {
  return CaptureWords::tr("%1°").arg(figureText(toDegrees(angle_rad), decimals));
}
QString milliG(double value_g) { return CaptureWords::tr("%1 mg").arg(figureText(1000 * value_g, 0)); }
QString degreesPerSecond(double rate_rad_s) {
  return CaptureWords::tr("%1 °/s").arg(figureText(toDegrees(rate_rad_s), 1));
}

QString kindText(OddCellKind kind) {
  return ofEnum(kind, {CaptureWords::tr("reads no gravity"), CaptureWords::tr("stuck"), CaptureWords::tr("noisy"),
                       CaptureWords::tr("turns by itself"), CaptureWords::tr("silent")});
}

double roundedTurn_deg(double turn_rad) {
  constexpr double kStep_deg = 10;  // fine enough for a hand
  return kStep_deg * std::round(toDegrees(turn_rad) / kStep_deg);
}

/// What the error would be with the pose, in percent of what it is; empty where that is nearly the same. A share,
/// because the verdict states the worst cell's error and this is that of an edge.
QString shareWithPose(const NextPose& next) {
  const double share = next.sigma_now_rad > 0 ? next.sigma_then_rad / next.sigma_now_rad : 1;
  return share > 0.95 ? QString() : figureText(std::max(1.0, std::round(100 * share)), 0);
}

}  // namespace

QString nextPoseText(const NextPose& next) {
  const QString share = shareWithPose(next);
  if (next.gain == PoseGain::First) return CaptureWords::tr("Hold the part still, any way up.");
  if (!next.worthwhile) {
    return next.is_good ? CaptureWords::tr("There are enough poses: the result is good.")
           : share.isEmpty()
               ? CaptureWords::tr("There are enough poses. Another one would hardly help.")
               : CaptureWords::tr(
                     "There are enough poses. With another one the error would fall to about %1 % of what "
                     "it is now.")
                     .arg(share);
  }
  switch (next.target.facing) {
    case Facing::Ceiling:
      return CaptureWords::tr("Turn the part so that cell %1 faces the ceiling.").arg(name(next.target.cell));
    case Facing::Floor:
      return CaptureWords::tr("Turn the part so that cell %1 faces the floor.").arg(name(next.target.cell));
    case Facing::Wall:
      return CaptureWords::tr("Turn the part so that cell %1 faces a wall, as the picture shows.")
          .arg(name(next.target.cell));
  }
  return {};
}

QString turnText(const NextPose& next) {
  if (!next.isWanted() || !next.turn_rad) return {};
  if (*next.turn_rad < kThere_rad) return CaptureWords::tr("It is there: hold it like this.");
  const double rounded = roundedTurn_deg(*next.turn_rad);
  if (rounded >= 180) return CaptureWords::tr("Half a turn around a horizontal axis.");
  return CaptureWords::tr("About %1° around the horizontal axis shown.").arg(figureText(rounded, 0));
}

QString turnAngleText(const NextPose& next) {
  if (!next.isWanted() || !next.turn_rad || *next.turn_rad < kThere_rad) return {};
  return CaptureWords::tr("%1°").arg(figureText(roundedTurn_deg(*next.turn_rad), 0));
}

QString gainText(const NextPose& next) {
  if (!next.worthwhile) {
    return next.is_good ? CaptureWords::tr("Why: at the worst cell the error is below %1° and %2 mm.")
                              .arg(figureText(toDegrees(next.goal.orientation_rad), 0),
                                   figureText(toMillimetres(next.goal.position_m), 0))
                        : CaptureWords::tr("Why: the error that is left does not come from too few directions.");
  }
  switch (next.gain) {
    case PoseGain::First:
      return CaptureWords::tr(
          "Why: gravity, as every cell feels it, tells how the cells are turned against each other.");
    case PoseGain::SecondDirection:
      return CaptureWords::tr(
          "Why: gravity has been seen along one line only. A second direction tells how the cells are turned about "
          "it.");
    case PoseGain::OutOfPlane:
      return CaptureWords::tr(
          "Why: two directions can't tell a cell's turn from its sensor's offset. A third one, far from both, can.");
    case PoseGain::Opposite:
      return CaptureWords::tr("Why: the opposite of pose %1 tells each sensor's offset from its scale.")
          .arg(next.opposite_of ? next.opposite_of->value() : 0);
    case PoseGain::Further:
      return CaptureWords::tr("Why: a further direction averages out what the sensors still get wrong.");
  }
  return {};
}

QString sigmaText(const NextPose& next) {
  const bool could_be_better = next.gain != PoseGain::First && next.is_good;
  if (!next.isWanted() && !could_be_better) return {};
  const QString share = shareWithPose(next);
  if (share.isEmpty()) return CaptureWords::tr("Another pose would hardly make it better.");
  const QString sentence =
      next.isWanted() ? CaptureWords::tr("With this pose the error falls to about %1 % of what it is now.")
                      : CaptureWords::tr("With another pose the error would fall to about %1 % of what it is now.");
  return sentence.arg(share);
}

QString missingText(const PoseCoverage& coverage, const std::optional<Eigen::Vector3d>& next_up_o) {
  if (!coverage.missing) {
    if (coverage.enabled == 0) return {};
    return coverage.quality == EdgeQuality::Over
               ? CaptureWords::tr("No direction is missing: all three values reach %1.")
                     .arg(figureText(coverage.threshold, 2))
               : CaptureWords::tr("The result does not need all three values to reach %1.")
                     .arg(figureText(coverage.threshold, 2));
  }
  const MissingDirection& missing = *coverage.missing;
  if (missing.which == 1) return CaptureWords::tr("No pose yet: any direction will do.");
  const bool second = missing.which == 2;
  const QString value = figureText(missing.value, 2);
  const QString threshold = figureText(coverage.threshold, 2);
  if (next_up_o) {
    // If another pose is asked for at the moment, for a better reason, there are no two instructions at a time.
    const bool fills = fillsMissing(coverage, *next_up_o);
    const QString sentence =
        fills ? (second ? CaptureWords::tr("A second direction is missing (value %1, needs %2); the next pose is one.")
                        : CaptureWords::tr("A third direction is missing (value %1, needs %2); the next pose is one."))
              : (second ? CaptureWords::tr("A second direction is not seen yet: its value is %1, of %2.")
                        : CaptureWords::tr("A third direction is not seen yet: its value is %1, of %2."));
    return sentence.arg(value, threshold);
  }
  const QString sentence =
      missing.facing.facing == Facing::Wall
          ? (second ? CaptureWords::tr(
                          "No pose yet with the side of cell %1 up or down: the second value is %2, needs %3.")
                    : CaptureWords::tr(
                          "No pose yet with the side of cell %1 up or down: the third value is %2, needs %3."))
          : (second
                 ? CaptureWords::tr(
                       "No pose yet with cell %1 facing the ceiling or the floor: the second value is %2, needs %3.")
                 : CaptureWords::tr(
                       "No pose yet with cell %1 facing the ceiling or the floor: the third value is %2, needs %3."));
  return sentence.arg(name(missing.facing.cell), value, threshold);
}

QString longMissingText() {
  return CaptureWords::tr("No pose yet with cell %1 facing the ceiling or the floor: the second value is %2, needs %3.")
      .arg(name(CellId(100)), figureText(0, 2), figureText(0.5, 2));
}

QString poseCountText(const PoseCoverage& coverage) {
  const QString count = posesText(coverage.enabled);
  std::size_t disabled = 0;
  for (const SeenDirection& seen : coverage.seen) disabled += seen.enabled ? 0U : 1U;
  return disabled == 0 ? count : CaptureWords::tr("%1, %2 disabled").arg(count).arg(disabled);
}

QString coverageText(const PoseCoverage& coverage, const std::optional<Eigen::Vector3d>& next_up_o) {
  QStringList parts = {poseCountText(coverage)};
  for (const SeenDirection& seen : coverage.seen) {
    const QString text = seen.at.side == Hemisphere::Front ? CaptureWords::tr("pose %1 on the front")
                                                           : CaptureWords::tr("pose %1 on the back");
    const QString said = text.arg(seen.pose.value());
    parts.push_back(seen.enabled ? said : CaptureWords::tr("%1, disabled").arg(said));
  }
  parts.push_back(CaptureWords::tr("values %1, %2 and %3, of which %4 is enough: %5")
                      .arg(figureText(coverage.singular_values.x(), 2), figureText(coverage.singular_values.y(), 2),
                           figureText(coverage.singular_values.z(), 2), figureText(coverage.threshold, 2),
                           qualityWord(coverage.quality)));
  return parts.join(QStringLiteral("; ")) + QStringLiteral(". ") + missingText(coverage, next_up_o);
}

HoldWords holdText(const HoldStatus& hold) {
  const QString percent = CaptureWords::tr("%1 %").arg(figureText(std::floor(100 * hold.progress), 0));
  if (hold.phase != HoldPhase::Watching) {
    return {hold.forced ? CaptureWords::tr("Capturing…") : CaptureWords::tr("Hold…"), percent};
  }
  switch (hold.stillness.blocker) {
    case Blocker::None:
      return hold.automatic ? HoldWords{CaptureWords::tr("Hold…"), percent}
                            : HoldWords{CaptureWords::tr("Still"), CaptureWords::tr("ready to capture")};
    case Blocker::NotMoved:
      // A capture by hand needs no move since the last pose.
      return hold.automatic ? HoldWords{CaptureWords::tr("Turn the part"), CaptureWords::tr("then hold it still")}
                            : HoldWords{CaptureWords::tr("Still"), CaptureWords::tr("ready to capture")};
    case Blocker::Turning:
    case Blocker::Shaking:
    case Blocker::CellTurning:
      return {CaptureWords::tr("Hold still"), hold.progress > 0 ? percent : CaptureWords::tr("waits for stillness")};
    case Blocker::Waiting:
      return {CaptureWords::tr("Waiting"), CaptureWords::tr("for readings")};
  }
  return {};
}

QString waitText(const HoldStatus& hold) {
  const Stillness& still = hold.stillness;
  if (hold.phase == HoldPhase::Confirming) return CaptureWords::tr("Looking whether it stayed still…");
  if (hold.phase == HoldPhase::Collecting) {
    return hold.forced ? CaptureWords::tr("Taking readings as they are, moved or not")
                       : CaptureWords::tr("Taking readings of %1 cells").arg(still.cells);
  }
  switch (still.blocker) {
    case Blocker::None:
      return hold.automatic ? CaptureWords::tr("The part is still")
                            : CaptureWords::tr("The part is still. Automatic capture is off");
    case Blocker::Waiting:
      return still.cells == 0
                 ? CaptureWords::tr("Waiting: no cell sends readings")
                 : CaptureWords::tr("Waiting: %1 s of readings are needed to judge").arg(figureText(still.window_s, 1));
    case Blocker::NotMoved:
      if (!hold.automatic) return CaptureWords::tr("The part is still. Automatic capture is off");
      return CaptureWords::tr("Waiting: moved %1 since the last pose, needs %2")
          .arg(degrees(still.moved_rad, 1), degrees(still.rearm_rad, 0));
    case Blocker::Turning:
      return CaptureWords::tr("Waiting: the part turns by %1, limit %2")
          .arg(degreesPerSecond(still.drift_rad_s), degreesPerSecond(still.drift_limit_rad_s));
    case Blocker::Shaking:
      return CaptureWords::tr("Waiting: cell %1 moves %2, limit %3")
          .arg(name(still.excess_cell), milliG(still.excess_g), milliG(still.excess_limit_g));
    case Blocker::CellTurning:
      return CaptureWords::tr("Waiting: cell %1 turns by %2 against the rest, limit %3")
          .arg(name(still.turning_cell), degreesPerSecond(still.turning_rad_s),
               degreesPerSecond(kRestlessTimesLimit * still.drift_limit_rad_s));
  }
  return {};
}

QString oddCellsText(const HoldStatus& hold) {
  constexpr std::size_t kMax = 3;
  const std::vector<OddCell>& odd = hold.stillness.odd_cells;
  if (odd.empty()) return {};
  QStringList cells;
  for (std::size_t k = 0; k < std::min(kMax, odd.size()); ++k) {
    cells.push_back(CaptureWords::tr("cell %1 (%2)").arg(name(odd[k].cell), kindText(odd[k].kind)));
  }
  if (odd.size() > kMax) cells.push_back(CaptureWords::tr("%1 more").arg(odd.size() - kMax));
  return CaptureWords::tr("Not waited for: %1").arg(cells.join(QStringLiteral(", ")));
}

}  // namespace hexoderm
