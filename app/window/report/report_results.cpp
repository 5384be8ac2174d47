// What a report says besides shape, links and poses: the checks, places on the robot, the long tables, methods and
// origins.

#include "app/window/report/report_page.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/review_summary.h"
#include "hexoderm/solve/result/patch_placements.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/verify/verify_words.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

/// As many rows as a person still leafs through; the calibration file and the CSV tables have all.
constexpr std::size_t kMaxRows = 400;
/// Of a larger skin, those that matter most.
constexpr std::size_t kWorstRows = 100;
/// Of the figures behind a check; of more the largest stand for all.
constexpr std::size_t kCheckRows = 20;
constexpr std::size_t kWorstCheckRows = 12;

QString tenths(double length_m) { return figureText(toMillimetres(length_m), 1); }

QString fromUtf8(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<int>(text.size())); }

double largestFigure(const CellSummary& cell) {
  if (cell.shape) return cell.shape->position_m;
  return cell.stated ? cell.stated->position_m : 0;
}

/// The figures behind a check; where they are too many, the remarkable and the largest ones.
ReportTable tableOf(VerifyMetrics figures, std::size_t* left_out) {
  ReportTable table;
  for (const ResultTable::Column& column : figures.columns) table.columns.push_back({column.name, !column.is_text});
  if (!table.columns.empty()) table.columns.front().is_figure = false;  // IDs
  if (figures.rows.size() > kCheckRows) {
    std::ranges::stable_sort(figures.rows, [](const ResultTable::Row& a, const ResultTable::Row& b) {
      if (a.remarkable != b.remarkable) return a.remarkable;
      return std::abs(a.values.at(1).toDouble()) > std::abs(b.values.at(1).toDouble());
    });
    *left_out += figures.rows.size() - kWorstCheckRows;
    figures.rows.resize(kWorstCheckRows);
  }
  for (const ResultTable::Row& row : figures.rows) {
    ReportTable::Row added{{}, row.remarkable};
    for (std::size_t k = 0; k < figures.columns.size(); ++k) {
      added.values << ResultTable::inWords(figures.columns[k], row.values.at(k));
    }
    table.rows.push_back(std::move(added));
  }
  return table;
}

}  // namespace

void ReportPage::addVerify() {
  heading(tr("Verification"), true);
  QStringList not_made;
  const auto figures = [this](VerifyMetrics found) {
    if (found.rows.empty()) return;
    std::size_t left_out = 0;
    ReportTable made = tableOf(std::move(found), &left_out);
    if (left_out > 0) made.note = tr("Those with the largest figures; %1 more are in the window.").arg(left_out);
    document_.blocks.emplace_back(std::move(made));
  };
  const auto say = [this](const VerifySentence& sentence) { paragraph(sentence.text, sentence.tone); };
  const VerifyOutcome& verify = content_.verify;

  if (verify.hold_out) {
    heading(tr("A pose that was held out"));
    say(holdOutText(*verify.hold_out));
    VerifyMetrics cells = holdOutMetrics(*verify.hold_out, false);
    std::ranges::stable_sort(cells.rows, [](const ResultTable::Row& a, const ResultTable::Row& b) {
      return a.values.at(1).toDouble() > b.values.at(1).toDouble();
    });
    figures(std::move(cells));
  } else {
    not_made << tr("a pose that was held out");
  }
  if (verify.loops) {
    heading(tr("Closed loops"));
    say(loopsText(*verify.loops, result_.patches.size()));
    figures(loopMetrics(*verify.loops));
  } else {
    not_made << tr("closed loops");
  }
  if (verify.surfaces && !(verify.surfaces->empty() && verify.surface_remarks.isEmpty())) {
    heading(tr("The surface that the cells lie on"));
    for (const SurfaceEvaluation& surface : *verify.surfaces) {
      say(surfaceText(surface, result_.assessment.position_95_m));
    }
    for (const QString& remark : verify.surface_remarks) paragraph(remark);
    figures(surfaceMetrics(*verify.surfaces));
  } else {
    not_made << tr("a fitted surface");
  }
  if (verify.comparisons) {
    heading(tr("Comparison with %1").arg(verify.compared_with));
    say(comparisonText(*verify.comparisons, verify.compared_with));
    figures(comparisonMetrics(*verify.comparisons));
  } else {
    not_made << tr("a comparison with an earlier calibration");
  }
  if (verify.old_calibration) {
    heading(tr("Does %1 still hold?").arg(verify.old_calibration_name));
    say(oldCalibrationText(*verify.old_calibration, verify.old_calibration_name));
    figures(oldCalibrationMetrics(*verify.old_calibration, result_));
  } else {
    not_made << tr("a check of an old calibration");
  }
  if (!not_made.isEmpty()) note(tr("Not made for this report: %1.").arg(not_made.join(QStringLiteral(", "))));
}

void ReportPage::addPlaces() {
  std::vector<ReportTable::Row> rows;
  for (const PatchReconstruction& patch : result_.patches) {
    const PatchPlacement* placement = placementOf(result_, patch);
    if (placement == nullptr || placement->link.empty()) continue;
    QStringList row = {QString::number(patch.origin.value()), fromUtf8(placement->link)};
    if (placement->place) {
      const SE3& T = placement->place->T_l_o;
      for (const double length_m : T.t) row << tenths(length_m);
      for (const double angle_rad : rpyFromRotation(T.R)) row << degreesText(angle_rad);
      CellPlacement origin;
      origin.cov_t_r = placement->place->cov_t_r;
      const std::optional<Uncertainty95> known = uncertaintyOf(origin);
      row << (known ? tenths(known->position_m) : noValue())
          << (known ? degreesText(known->orientation_rad) : noValue());
    } else {
      for (int k = 0; k < 8; ++k) row << noValue();
    }
    QStringList by;
    if (placement->by_surface) by << tr("surface of the link");
    if (!placement->points.empty()) by << tr("%1 points").arg(placement->points.size());
    if (!placement->distances.empty()) by << tr("%1 distances").arg(placement->distances.size());
    row << (placement->place ? by.join(QStringLiteral(", ")) : tr("only the link is known"));
    rows.push_back({row, false});
  }
  if (rows.empty()) return;
  heading(tr("Place on the robot"), true);
  if (result_.robot) {
    paragraph(tr("Robot: %1").arg(QFileInfo(QString::fromStdString(result_.robot->urdf)).fileName()));
  }
  note(tr(
      "Where the frame of each patch, that of its origin cell, lies in the frame of its link: position in mm, turn as "
      "roll, pitch and yaw as in a URDF; ± at 95 %, along or about the worst axis."));
  table({{tr("Patch of cell")},
         {tr("Link")},
         {tr("x mm"), true},
         {tr("y mm"), true},
         {tr("z mm"), true},
         {tr("Roll"), true},
         {tr("Pitch"), true},
         {tr("Yaw"), true},
         {tr("± mm"), true},
         {tr("± turn"), true},
         {tr("Found by")}},
        std::move(rows));
}

void ReportPage::addCells() {
  std::vector<CellSummary> cells = summariseCells(result_);
  if (cells.empty()) return;
  const std::size_t all = cells.size();
  if (all > kMaxRows) {
    std::ranges::stable_sort(cells, std::ranges::greater(), largestFigure);
    cells.resize(kWorstRows);
    heading(tr("The %1 cells that are known least well").arg(kWorstRows), true);
  } else {
    heading(tr("Cells"), true);
  }
  note(tr(
      "Position of the cell's centre in the frame of its patch's origin cell; ± at 95 % along or about the worst axis, "
      "relative to the origin, and as a place in the shape as a whole."));
  std::vector<ReportTable::Row> rows;
  for (const CellSummary& cell : cells) {
    const CellPlacement* placement = result_.find(cell.cell).cell;
    const auto length = [](const std::optional<Uncertainty95>& known) {
      return known ? tenths(known->position_m) : noValue();
    };
    const auto turn = [](const std::optional<Uncertainty95>& known) {
      return known ? degreesText(known->orientation_rad) : noValue();
    };
    const std::optional<Uncertainty95> stated = cell.origin ? std::nullopt : cell.stated;
    rows.push_back({{QString::number(cell.cell.value()), QString::number(cell.patch.value() + 1),
                     placement == nullptr || placement->body_part.empty() ? noValue() : fromUtf8(placement->body_part),
                     tenths(cell.T_o_u.t.x()), tenths(cell.T_o_u.t.y()), tenths(cell.T_o_u.t.z()), length(stated),
                     turn(stated), length(cell.shape), turn(cell.shape), degreesText(cell.worst_residual_rad),
                     cell.origin                           ? tr("origin")
                     : cell.placed_by == PlacedBy::Samples ? tr("measured")
                                                           : tr("through its links")},
                    false});
  }
  table({{tr("Cell")},
         {tr("Patch"), true},
         {tr("Body part")},
         {tr("x mm"), true},
         {tr("y mm"), true},
         {tr("z mm"), true},
         {tr("± mm"), true},
         {tr("± turn"), true},
         {tr("Shape ± mm"), true},
         {tr("Shape ± turn"), true},
         {tr("Residual"), true},
         {tr("Placed")}},
        std::move(rows),
        all == cells.size()
            ? QString()
            : tr("%1 more cells are in the calibration file and in the exported tables.").arg(all - cells.size()));
}

void ReportPage::addAllLinks() {
  std::vector<const LinkEstimate*> links;
  for (const PatchReconstruction& patch : result_.patches) {
    for (const LinkEstimate& link : patch.links) links.push_back(&link);
  }
  if (links.empty()) return;
  // The worst of a large skin stand further up already.
  if (links.size() > kMaxRows) {
    note(tr("All %1 links are in the calibration file and in the exported tables.").arg(links.size()));
    return;
  }
  heading(tr("All links"), true);
  linkTable(links);
}

void ReportPage::addOptions() {
  const SolverOptions& options = result_.options;
  const QLocale locale;
  heading(tr("Methods"), true);
  QStringList left_out;
  for (const CellId cell : options.left_out) left_out << QString::number(cell.value());
  std::vector<std::pair<QString, QString>> rows = {
      {tr("Solver"), fromUtf8(result_.solver)},
      {tr("Gap model"), fromUtf8(gapModelName(options.gap_model))},
      {tr("Centring"), fromUtf8(centringName(options.centring))},
      {tr("Support axes"), fromUtf8(supportAxesName(options.support_axes))},
      {tr("Link weights"), fromUtf8(linkWeightsName(options.weights))},
      {tr("A direction counts as defined from"), locale.toString(options.class_threshold, 'f', 2)},
      {tr("Limits of bend, twist, yaw"),
       tr("%1, %2, %3")
           .arg(wholeDegreesText(options.max_bend_rad), wholeDegreesText(options.max_twist_rad),
                wholeDegreesText(options.max_yaw_rad))},
      {tr("Limit of misfit"), tr("%1 standard deviations").arg(locale.toString(options.max_misfit, 'f', 1))},
      {tr("Cells left out"), left_out.isEmpty() ? tr("none") : left_out.join(QStringLiteral(", "))}};
  for (const PatchReconstruction& patch : result_.patches) {
    if (!patch.gap_share) continue;
    rows.emplace_back(tr("Gap share, patch of cell %1").arg(patch.origin.value()),
                      patch.gap_share->sigma > 0 ? tr("%1 ± %2 (1 sigma)")
                                                       .arg(locale.toString(patch.gap_share->share, 'f', 2),
                                                            locale.toString(patch.gap_share->sigma, 'f', 2))
                                                 : locale.toString(patch.gap_share->share, 'f', 2));
  }
  document_.blocks.emplace_back(ReportPairs{std::move(rows)});
}

void ReportPage::addOrigins() {
  heading(tr("Where it comes from"), true);
  std::vector<std::pair<QString, QString>> rows = {{tr("Source"), words(result_.source.text)}};
  if (!result_.source.file.empty()) rows.emplace_back(tr("File"), fromUtf8(result_.source.file));
  if (!result_.source.sha256.empty()) rows.emplace_back(tr("SHA-256"), fromUtf8(result_.source.sha256));
  rows.emplace_back(tr("Cell model"), fromUtf8(result_.model->name));
  if (result_.robot) {
    rows.emplace_back(tr("Robot"), fromUtf8(result_.robot->urdf));
    if (!result_.robot->sha256.empty()) rows.emplace_back(tr("SHA-256"), fromUtf8(result_.robot->sha256));
  }
  rows.emplace_back(tr("Program"), QStringLiteral("Hexoderm " HEXODERM_VERSION));
  if (result_.solve_seconds > 0) {
    rows.emplace_back(tr("Solved in"), tr("%1 ms").arg(QLocale().toString(1e3 * result_.solve_seconds, 'f', 1)));
  }
  rows.emplace_back(tr("Written"), content_.made_at.toString(Qt::ISODate));
  document_.blocks.emplace_back(ReportPairs{std::move(rows)});
}

}  // namespace hexoderm
