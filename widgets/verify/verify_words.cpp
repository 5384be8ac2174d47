#include "widgets/verify/verify_words.h"

#include "hexoderm/base/units.h"
#include "widgets/tables/table_cells.h"
#include "widgets/words/formatting.h"
#include "widgets/words/surface_words.h"
#include "widgets/words/words.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

struct VerifyTexts {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::Verify)
};

QString degrees(double angle_rad) { return figureText(toDegrees(angle_rad), 2) + QStringLiteral("°"); }
QString millimetres(double length_m) { return millimetresText(length_m, 2); }
QString percent(double value) { return figureText(value, 1) + QStringLiteral(" %"); }

QVariant inMillimetres(std::optional<double> length_m) {
  return length_m ? QVariant(toMillimetres(*length_m)) : QVariant();
}

using Column = ResultTable::Column;
Column figureColumn(const QString& name, const QString& unit, const QString& explanation, int decimals) {
  return {.name = name, .unit = unit, .explanation = explanation, .decimals = decimals};
}
Column cellColumn() { return figureColumn(VerifyTexts::tr("Cell"), {}, VerifyTexts::tr("ID of the cell"), 0); }
Column degreeColumn(const QString& name, const QString& explanation) {
  return figureColumn(name, QStringLiteral("deg"), explanation, 2);
}
Column millimetreColumn(const QString& name, const QString& explanation) {
  return figureColumn(name, QStringLiteral("mm"), explanation, 2);
}
Column textColumn(const QString& name, const QString& explanation) {
  return {.name = name, .explanation = explanation, .is_text = true};
}

/// "Cylinder, radius 50.30 mm"
QString formText(const SurfaceEvaluation& surface) {
  const QString kind = surfaceKindWord(surface.kind);
  if (!surface.radius_m) return kind;
  return surface.half_angle_rad ? VerifyTexts::tr("%1, half angle %2, radius %3 at its middle")
                                      .arg(kind, degrees(*surface.half_angle_rad), millimetres(*surface.radius_m))
                                : VerifyTexts::tr("%1, radius %2").arg(kind, millimetres(*surface.radius_m));
}

bool isChanged(const CheckedCell& cell) {
  return cell.change != CellChange::None && cell.change != CellChange::NotTold;
}

/// 0: changed, 1: nothing can be told, 2: as calibrated.
int rankInList(const CheckedCell& cell) { return isChanged(cell) ? 0 : cell.change == CellChange::NotTold ? 1 : 2; }

}  // namespace

VerifySentence holdOutText(const HoldOutResult& result) {
  switch (result.outcome) {
    case HoldOutOutcome::TooFewPoses:
      return {
          Tone::Caution,
          VerifyTexts::tr("Needs three poses besides the one that is held out, and there are %1: take another pose.")
              .arg(result.other_poses)};
    case HoldOutOutcome::NothingToCompare:
      return {Tone::Caution,
              VerifyTexts::tr("In pose %1 no two joined cells can be compared.").arg(result.pose.value())};
    case HoldOutOutcome::Stopped:
      return {Tone::Neutral, VerifyTexts::tr("Cancelled.")};
    case HoldOutOutcome::Evaluated:
      break;
  }
  const QString figures =
      VerifyTexts::tr("The other %1 poses predict pose %2 to %3 (rms over %4 cells); %5 were expected.")
          .arg(result.other_poses)
          .arg(result.pose.value())
          .arg(degrees(result.rms_rad))
          .arg(result.cells.size())
          .arg(degrees(result.expected_rms_rad));
  const auto worst = std::ranges::max_element(result.cells, {}, &HoldOutCell::error_rad);
  QString more = VerifyTexts::tr("Worst: cell %1, %2.").arg(worst->cell.value()).arg(degrees(worst->error_rad));
  if (result.turned) {
    more += QLatin1Char(' ') +
            VerifyTexts::tr("The part turned while it was read: %1 rad/s², of a still hand %2 are expected.")
                .arg(figureText(result.turning_rad_s2, 1), figureText(result.expected_turning_rad_s2, 1));
  }
  switch (result.agreement) {
    case HoldOutAgreement::AsStated:
      if (result.coarse) {
        return {Tone::Caution,
                VerifyTexts::tr("As good as stated, but a coarse check: with so few poses, a part that bent by "
                                "less than about %1 would not show. %2")
                    .arg(degrees(result.detectable_rad), figures)};
      }
      return {Tone::Good, VerifyTexts::tr("As good as stated. %1").arg(figures)};
    case HoldOutAgreement::Worse:
      return {Tone::Caution, VerifyTexts::tr("Somewhat worse than stated. %1 %2").arg(figures, more)};
    case HoldOutAgreement::FarWorse:
      break;
  }
  return {Tone::Bad, VerifyTexts::tr("Far worse than stated: the part moved in this pose, or a cell is wrong. %1 %2")
                         .arg(figures, more)};
}

VerifyMetrics holdOutMetrics(const HoldOutResult& result, bool by_link) {
  const Column expected = degreeColumn(VerifyTexts::tr("Expected"),
                                       VerifyTexts::tr("What the stated uncertainties lead one to expect, rms"));
  VerifyMetrics figures;
  if (by_link) {
    figures.columns = {textColumn(VerifyTexts::tr("Link"), VerifyTexts::tr("Cell and port of both ends")),
                       degreeColumn(VerifyTexts::tr("Error °"),
                                    VerifyTexts::tr("Between what its two cells read, brought into one frame")),
                       expected};
    for (const HoldOutLink& link : result.links) {
      figures.rows.push_back(
          {.values = {shortLinkName(link.source, link.target), toDegrees(link.error_rad), toDegrees(link.expected_rad)},
           .link = Selection::linkOf(link.source, link.target),
           .remarkable = isRemarkable(link.error_rad, link.expected_rad)});
    }
    return figures;
  }
  figures.columns = {
      cellColumn(),
      degreeColumn(VerifyTexts::tr("Error °"),
                   VerifyTexts::tr("Between the gravity the cell read and what the other cells and poses predict")),
      expected};
  for (const HoldOutCell& cell : result.cells) {
    figures.rows.push_back({.values = {cell.cell.value(), toDegrees(cell.error_rad), toDegrees(cell.expected_rad)},
                            .cell = cell.cell,
                            .remarkable = isRemarkable(cell.error_rad, cell.expected_rad)});
  }
  return figures;
}

VerifySentence loopsText(const std::vector<FoundLoop>& loops, std::size_t patches) {
  if (loops.empty()) {
    return {
        Tone::Neutral,
        patches > 1
            ? VerifyTexts::tr("No loop in any of the %1 patches: nothing closes that could be checked.").arg(patches)
            : VerifyTexts::tr("No loop in this patch: nothing closes that could be checked.")};
  }
  QStringList sentences;
  Tone tone = Tone::Neutral;
  const auto closed = std::ranges::find(loops, true, &FoundLoop::closed);
  if (const FoundLoop& open = loops.front(); !open.closed) {
    const auto count = closed - loops.begin();
    const QString gap = VerifyTexts::tr("%1, %2 of its %3")
                            .arg(millimetres(open.closure.length_m), percent(open.closure.percent),
                                 millimetres(open.closure.loop_length_m));
    sentences << (count == 1 ? VerifyTexts::tr("One open loop; its gap is %1.").arg(gap)
                             : VerifyTexts::tr("%1 open loops; the largest gap is %2.").arg(count).arg(gap));
  }
  if (closed != loops.end()) {
    const auto count = loops.end() - closed;
    const bool closes = closed->closesWithinLimit();
    tone = closes ? Tone::Good : Tone::Caution;
    const QString gap =
        VerifyTexts::tr("%1 (%2)").arg(millimetres(closed->closure.length_m), percent(closed->closure.percent));
    const QString limit = millimetres(closed->limit_m);
    sentences << (closes ? VerifyTexts::tr(
                               "%1 closed loops close: the largest is left open by %2, and a skin link may leave %3.")
                         : VerifyTexts::tr(
                               "Of %1 closed loops the largest is left open by %2, more than the %3 a skin link may "
                               "leave: one of its links is wrong, or many err alike."))
                     .arg(count)
                     .arg(gap, limit);
  }
  return {tone, sentences.join(QLatin1Char(' '))};
}

VerifyMetrics loopMetrics(const std::vector<FoundLoop>& loops) {
  VerifyMetrics figures;
  figures.columns = {
      textColumn(VerifyTexts::tr("Between"), VerifyTexts::tr("The two ports at which the loop is closed, or open")),
      millimetreColumn(VerifyTexts::tr("Gap mm"),
                       VerifyTexts::tr("Length of what is missing when the loop is walked round")),
      figureColumn(VerifyTexts::tr("Share %"), QStringLiteral("%"),
                   VerifyTexts::tr("The gap in per cent of the accumulated port vectors"), 1),
      textColumn(VerifyTexts::tr("Kind"), VerifyTexts::tr("Closed by a link, or open between two free ports")),
      figureColumn(VerifyTexts::tr("Cells"), {}, VerifyTexts::tr("Cells of the loop"), 0)};
  for (const QString& axis : {VerifyTexts::tr("X mm"), VerifyTexts::tr("Y mm"), VerifyTexts::tr("Z mm")}) {
    figures.columns.push_back(millimetreColumn(axis, VerifyTexts::tr("The gap, in the patch's frame")));
  }
  for (const FoundLoop& loop : loops) {
    const LoopEvaluation& closure = loop.closure;
    ResultTable::Row row;
    row.values = {shortLinkName(closure.first, closure.second), toMillimetres(closure.length_m), closure.percent,
                  loop.closed ? VerifyTexts::tr("closed") : VerifyTexts::tr("open"),
                  static_cast<qulonglong>(loop.cells.size())};
    for (const double gap_m : closure.gap_m) row.values.emplace_back(toMillimetres(gap_m));
    if (loop.closed) {
      row.link = Selection::linkOf(closure.first, closure.second);
    } else {
      row.cell = closure.first.cell;
    }
    row.remarkable = loop.closed && !loop.closesWithinLimit();
    figures.rows.push_back(std::move(row));
  }
  return figures;
}

VerifySentence surfaceText(const SurfaceEvaluation& surface, std::optional<double> stated_m) {
  const std::size_t worst = surface.furthest();
  QStringList sentences;
  sentences << VerifyTexts::tr("%1: %2 cell centres lie within %3 (rms) of it; the worst is cell %4, %5.")
                   .arg(formText(surface))
                   .arg(surface.cells.size())
                   .arg(millimetres(surface.rms_m))
                   .arg(surface.cells.at(worst).value())
                   .arg(millimetres(std::abs(surface.distance_m.at(worst))));
  Tone tone = Tone::Neutral;
  if (surface.better) {
    tone = Tone::Bad;
    sentences << VerifyTexts::tr(
                     "But it is not this surface: the cells are tilted against it by %1 (rms). Positions and tilts "
                     "together fit another one better: %2, with %3.")
                     .arg(degrees(surface.tilt_rms_rad), formText(*surface.better),
                          degrees(surface.better->tilt_rms_rad));
  } else if (stated_m) {
    const bool within = surface.liesWithin(*stated_m);
    tone = within ? Tone::Good : Tone::Caution;
    sentences << (within ? VerifyTexts::tr("That is within the ±%1 stated for positions (95 %).")
                         : VerifyTexts::tr(
                               "That is more than the ±%1 stated for positions (95 %): the part has another shape, or "
                               "positions are worse than stated."))
                     .arg(millimetres(*stated_m));
  }
  if (surface.delta_m && surface.epsilon_m) {
    sentences << VerifyTexts::tr(
                     "The radius is off the true one by Δ = %1, and the cells lie ε = %2 (rms) off the true surface.")
                     .arg(millimetres(*surface.delta_m), millimetres(*surface.epsilon_m));
  }
  return {tone, sentences.join(QLatin1Char(' '))};
}

VerifyMetrics surfaceMetrics(const std::vector<SurfaceEvaluation>& surfaces) {
  VerifyMetrics figures;
  figures.columns = {
      cellColumn(),
      millimetreColumn(VerifyTexts::tr("Distance mm"), VerifyTexts::tr("From the surface; positive outside of it")),
      degreeColumn(VerifyTexts::tr("Tilt °"), VerifyTexts::tr("Between the cell's face and the surface below it"))};
  for (const SurfaceEvaluation& surface : surfaces) {
    for (std::size_t k = 0; k < surface.cells.size(); ++k) {
      figures.rows.push_back({.values = {surface.cells[k].value(), toMillimetres(surface.distance_m[k]),
                                         toDegrees(surface.tilt_rad.at(k))},
                              .cell = surface.cells[k],
                              .remarkable = isRemarkable(surface.distance_m[k], surface.rms_m)});
    }
  }
  return figures;
}

VerifySentence distanceCheckText(const DistanceCheck& check) {
  const QString cells = VerifyTexts::tr("Cells %1 and %2").arg(check.first.value()).arg(check.second.value());
  const QString measured = millimetresText(check.measured_m, 1);
  const QString estimated = millimetresText(check.estimated_m, 1);
  if (!check.sigma_m || !check.deviations || !check.detectable_scale) {
    return {Tone::Neutral,
            VerifyTexts::tr("%1: %2 measured, %3 estimated; no uncertainty is stated to compare them by.")
                .arg(cells, measured, estimated)};
  }
  const QString figures =
      VerifyTexts::tr("%1: %2 measured, %3 estimated; they differ by %4, and %5 are expected (1 sigma).")
          .arg(cells, measured, estimated, millimetresText(std::abs(check.measured_m - check.estimated_m), 1),
               millimetresText(*check.sigma_m, 1));
  switch (check.agreement) {
    case DistanceAgreement::NotStated:
      break;
    case DistanceAgreement::AsStated:
      return {Tone::Good, VerifyTexts::tr("It agrees. %1 Cells %2 larger or smaller than in the cell model would show.")
                              .arg(figures, percent(100 * *check.detectable_scale))};
    case DistanceAgreement::Doubtful:
      return {Tone::Caution,
              VerifyTexts::tr("It does not quite agree: measure again, and between two other cells. %1").arg(figures)};
    case DistanceAgreement::Contradicts:
      return {Tone::Bad,
              VerifyTexts::tr("It contradicts the result. Check the size of the cells in the cell model, the numbering "
                              "of the ports and the axes of the sensors; with fewer than three poses, take more. %1")
                  .arg(figures)};
  }
  return {Tone::Neutral, figures};
}

VerifySentence comparisonText(const std::vector<Comparison>& comparisons, const QString& against) {
  if (comparisons.empty())
    return {Tone::Bad, VerifyTexts::tr("%1 has no cell in common with this calibration.").arg(against)};
  const ComparisonSummary summary = summariseComparisons(comparisons);
  if (summary.cells == 0) {
    return {Tone::Neutral,
            VerifyTexts::tr("No two cells lie in one patch both here and in %1: there is nothing to compare.")
                .arg(against)};
  }
  const WithinStated& within = summary.within;
  const QString figures = VerifyTexts::tr("Against %1, after alignment: %2 and %3 rms over %4 cells.")
                              .arg(against, millimetres(summary.position_rms_m), degrees(summary.orientation_rms_rad))
                              .arg(summary.cells);
  if (within.stated == 0) {
    return {Tone::Neutral, VerifyTexts::tr("%1 Neither of them states an uncertainty to compare with.").arg(figures)};
  }
  const QString counts =
      VerifyTexts::tr("Of %1 cells, %2 have their position and %3 their orientation within what was stated with 95 %.")
          .arg(within.stated)
          .arg(within.position)
          .arg(within.orientation);
  if (within.holds()) {
    return {Tone::Good, VerifyTexts::tr("Within what was stated for 95 % of cells. %1 %2").arg(figures, counts)};
  }
  return {Tone::Caution,
          VerifyTexts::tr("Further apart than what was stated for 95 % of cells. %1 %2").arg(figures, counts)};
}

VerifyMetrics comparisonMetrics(const std::vector<Comparison>& comparisons) {
  VerifyMetrics figures;
  figures.columns = {
      cellColumn(),
      millimetreColumn(VerifyTexts::tr("Moved mm"), VerifyTexts::tr("Distance between the two, after alignment")),
      millimetreColumn(VerifyTexts::tr("Stated mm"),
                       VerifyTexts::tr("Standard deviation stated for that, of both together")),
      degreeColumn(VerifyTexts::tr("Turned °"), VerifyTexts::tr("Angle between the two, after alignment")),
      degreeColumn(VerifyTexts::tr("Stated °"),
                   VerifyTexts::tr("Standard deviation stated for that, of both together"))};
  for (const Comparison& comparison : comparisons) {
    for (const CellDifference& cell : comparison.cells) {
      const bool stated = cell.sigma_t_m.value_or(0) > 0 && cell.sigma_r_rad.value_or(0) > 0;
      figures.rows.push_back(
          {.values = {cell.cell.value(), toMillimetres(cell.position_m.norm()), inMillimetres(cell.sigma_t_m),
                      toDegrees(cell.orientation_rad), rawDegrees(cell.sigma_r_rad)},
           .cell = cell.cell,
           .remarkable = stated && (!isWithinStated(cell.position_m.norm(), cell.sigma_t_m) ||
                                    !isWithinStated(cell.orientation_rad, cell.sigma_r_rad))});
    }
  }
  return figures;
}

VerifySentence oldCalibrationText(const CalibrationCheck& check, const QString& calibration) {
  QStringList sentences;
  for (const Message* said : {&check.summary, &check.advice}) {
    if (!said->empty()) sentences << words(*said);
  }
  for (const Message& remark : check.remarks) sentences << words(remark);
  const QString poses =
      words(check.poses.size() == 1 ? message("pose {}", check.poses.front()) : message("poses {}", check.poses));
  sentences << VerifyTexts::tr("Compared with %1: %2.").arg(calibration, poses);
  // Every cell could be compared, and a turn about any axis would have been seen.
  const bool is_whole = check.compared && std::ranges::all_of(check.cells, [](const CheckedCell& cell) {
                          return cell.change != CellChange::NotTold && cell.noticed_turn_rad.has_value();
                        });
  const Tone tone = check.changed ? Tone::Bad : is_whole ? Tone::Good : Tone::Caution;
  return {tone, sentences.join(QLatin1Char(' '))};
}

VerifyMetrics oldCalibrationMetrics(const CalibrationCheck& check, const Reconstruction& today) {
  VerifyMetrics figures;
  figures.columns = {
      cellColumn(), textColumn(VerifyTexts::tr("Now"), VerifyTexts::tr("What became of the cell, with 1 sigma")),
      degreeColumn(VerifyTexts::tr("Turned °"), VerifyTexts::tr("The turn that explains best what the cell reads")),
      figureColumn(VerifyTexts::tr("Drift mg"), QStringLiteral("mg"),
                   VerifyTexts::tr("The drift of its sensor's offset that explains best what the cell reads"), 0),
      degreeColumn(VerifyTexts::tr("Noticed from °"),
                   VerifyTexts::tr("A turn by so much, about whatever axis, would be found in these poses with 95 %; "
                                   "no figure: a turn about some axis would not be"))};
  std::vector<const CheckedCell*> cells;
  for (const CheckedCell& cell : check.cells) cells.push_back(&cell);
  std::ranges::stable_sort(cells, {}, [](const CheckedCell* cell) { return rankInList(*cell); });
  for (const CheckedCell* cell : cells) {
    constexpr double kMilli = 1000;
    ResultTable::Row row;
    row.values = {cell->cell.value(), words(cell->words),
                  rawDegrees(cell->turn ? std::optional(cell->turn->angle_rad) : std::nullopt),
                  cell->drift ? QVariant(kMilli * cell->drift->offset_g.norm()) : QVariant(),
                  rawDegrees(cell->noticed_turn_rad)};
    if (today.find(cell->cell).cell != nullptr) row.cell = cell->cell;
    row.remarkable = isChanged(*cell);
    figures.rows.push_back(std::move(row));
  }
  return figures;
}

}  // namespace hexoderm
