#pragma once

#include "app/window/report/report.h"
#include "app/window/report/report_blocks.h"
#include "app/window/report/report_patch.h"
#include "app/window/report/report_plots.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/assess.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/metrics/review_summary.h"
#include "hexoderm/solve/result/patch_placements.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/verify/verify_words.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <vector>

namespace hexoderm {

/// Puts together what a report says; how it is laid out, report_pdf and report.cpp say.
class ReportPage {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ReportPage)

 public:
  explicit ReportPage(const ReportContent& content) : content_(content), result_(*content.reconstruction) {}

  [[nodiscard]] ReportDocument document() {
    document_ = {};
    document_.kind = tr("Hexoderm calibration report");
    document_.name = content_.name;
    document_.subtitle = tr("%1 · %2").arg(
        words(sizeText(result_)), tr("%1, %2").arg(QLocale().toString(content_.made_at.date(), QLocale::LongFormat),
                                                   QLocale().toString(content_.made_at.time(), QLocale::ShortFormat)));
    document_.foot = content_.name + QStringLiteral(" · Hexoderm " HEXODERM_VERSION " · ") +
                     QLocale().toString(content_.made_at, QLocale::ShortFormat);
    if (content_.simulated) document_.stamp = tr("SIMULATED: nothing real was measured");
    addTitle();
    addVerdict();
    addKeyMetrics();
    addFindings();
    addShapes();
    addLinks();
    addPoses();
    addVerify();
    addPlaces();
    addCells();
    addAllLinks();
    addOptions();
    addOrigins();
    return std::move(document_);
  }
  /// "Page 2 of 5".
  static QString pageNumber(int page, int pages) { return tr("Page %1 of %2").arg(page).arg(pages); }
  static QString drawingFor(const QString& caption) { return tr("Picture: %1").arg(caption); }

 private:
  static constexpr std::size_t kWorstLinks = 10;
  /// Of a skin of many patches the largest are drawn.
  static constexpr std::size_t kMaxPictured = 4;

  static QString tenths(double length_m) { return figureText(toMillimetres(length_m), 1); }

  static QString hundredths(std::optional<double> angle_rad) {
    return angle_rad ? figureText(toDegrees(*angle_rad), 2) + QStringLiteral("°") : noValue();
  }

  static ReportDrawing drawingOf(const ReportPicture& picture) {
    return {picture.title, static_cast<double>(picture.size.height()) / picture.size.width(),
            [picture](QPainter& painter, const QRectF& area, double) {
              constexpr double kDots = 3;  // for a pixel of the screen: sharp in print
              const QImage image = reportImage(picture.size * kDots, [&](QPainter& on_image) {
                on_image.scale(kDots, kDots);
                picture.draw(on_image);
              });
              painter.setRenderHint(QPainter::SmoothPixmapTransform);
              painter.drawImage(area, image, QRectF(image.rect()));
            }};
  }

  static QString countText(std::size_t count) { return QLocale().toString(static_cast<qulonglong>(count)); }

  /// As many rows as a person still leafs through; the calibration file and the CSV tables have all.
  static constexpr std::size_t kMaxRows = 400;
  /// Of a larger skin, those that matter most.
  static constexpr std::size_t kWorstRows = 100;
  /// Of the figures behind a check; of more the largest stand for all.
  static constexpr std::size_t kCheckRows = 20;
  static constexpr std::size_t kWorstCheckRows = 12;

  static QString fromUtf8(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
  }

  static double largestFigure(const CellSummary& cell) {
    if (cell.shape) return cell.shape->position_m;
    return cell.stated ? cell.stated->position_m : 0;
  }

  /// The figures behind a check; where they are too many, the remarkable and the largest ones.
  static ReportTable tableOf(VerifyMetrics figures, std::size_t* left_out) {
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

  void addTitle() {
    const ReportTitle& title = content_.title;
    for (const auto& [name, value] : {std::pair(tr("Robot"), title.robot), std::pair(tr("Part"), title.part),
                                      std::pair(tr("Operator"), title.made_by), std::pair(tr("Notes"), title.notes)}) {
      if (!value.trimmed().isEmpty()) document_.title.emplace_back(name, value.trimmed());
    }
  }
  void addVerdict() {
    const Assessment& verdict = result_.assessment;
    const Goal& wanted = result_.options.goal;
    const QString goal = tr("±%1 mm and ±%2").arg(tenths(wanted.position_m), degreesText(wanted.orientation_rad));
    QString meaning;
    if (verdict.isUsable() && verdict.position_95_m && verdict.orientation_95_rad) {
      meaning =
          tr("With a probability of 95 %, each measured cell is at most %1 mm and %2 from where this report says, "
             "along or about any one axis, seen from the origin cell of its patch.")
              .arg(tenths(*verdict.position_95_m), degreesText(verdict.orientation_95_rad));
      meaning += QLatin1Char(' ');
      meaning += meets({*verdict.position_95_m, *verdict.orientation_95_rad}, wanted)
                     ? tr("A good calibration knows every cell to %1, and this one does.").arg(goal)
                     : tr("A good calibration knows every cell to %1; this one is coarser, and serves where touch need "
                          "not be located more finely.")
                           .arg(goal);
    } else if (verdict.isUsable()) {
      meaning =
          tr("Robot software can use the places of the cells; how exact they are, this calibration does not state.");
    } else if (verdict.level == VerdictLevel::NotEnough) {
      meaning =
          tr("The places of the cells are a first guess: what was measured does not determine them yet. They should "
             "not be used.");
    } else if (verdict.level == VerdictLevel::NotTrusted) {
      meaning = tr(
          "What was measured contradicts the model that the places of the cells follow from, so that this report can't "
          "say how far they are off. They should not be used.");
    } else {
      meaning = tr("Something is broken or missing, as the findings say. The places of the cells should not be used.");
    }
    document_.blocks.emplace_back(
        ReportVerdict{toneOf(verdict.level), words(verdict.reason), meaning,
                      verdict.next_action.empty() ? QString() : tr("Next: %1").arg(words(verdict.next_action))});
  }
  void addKeyMetrics() {
    const std::size_t used_links = [&] {
      std::size_t count = 0;
      for (const PatchReconstruction& patch : result_.patches) {
        count += static_cast<std::size_t>(std::ranges::count_if(patch.links, &LinkEstimate::used));
      }
      return count;
    }();
    const auto used_poses = static_cast<std::size_t>(std::ranges::count_if(result_.poses, &PoseSummary::enabled));
    const auto share = [](std::size_t part, std::size_t whole) {
      return part == whole ? countText(whole) : tr("%1 of %2").arg(countText(part), countText(whole));
    };
    const Assessment& verdict = result_.assessment;
    document_.blocks.emplace_back(
        ReportMetrics{{{countText(result_.cellCount()), tr("cells")},
                       {share(used_links, result_.linkCount()), tr("links used")},
                       {countText(result_.patches.size()), result_.patches.size() == 1 ? tr("patch") : tr("patches")},
                       {share(used_poses, result_.poses.size()), tr("poses used")},
                       {verdict.position_95_m ? tr("±%1 mm").arg(tenths(*verdict.position_95_m)) : noValue(),
                        tr("position, worst cell, 95 %")},
                       {verdict.orientation_95_rad ? tr("±%1").arg(degreesText(verdict.orientation_95_rad)) : noValue(),
                        tr("orientation, worst cell, 95 %")}}});
  }
  void addFindings() {
    heading(tr("Findings"), true);
    if (result_.findings.empty()) {
      paragraph(tr("None: nothing about topology, links, cells and poses stood out."));
      return;
    }
    std::vector<const Finding*> worst_first;
    for (const Finding& finding : result_.findings) worst_first.push_back(&finding);
    std::ranges::stable_sort(worst_first, [](const Finding* a, const Finding* b) { return a->severity > b->severity; });
    std::vector<ReportTable::Row> rows;
    for (const Finding* finding : worst_first) {
      rows.push_back({{severityWord(finding->severity), words(finding->message), placeText(*finding)},
                      finding->severity == Severity::Error});
    }
    table({{tr("Severity")}, {tr("What")}, {tr("Where")}}, std::move(rows));
  }
  void addShapes() {
    std::vector<std::size_t> largest_first;
    for (std::size_t k = 0; k < result_.patches.size(); ++k) {
      if (!result_.patches[k].cells.empty()) largest_first.push_back(k);
    }
    if (largest_first.empty()) return;
    std::ranges::stable_sort(largest_first, std::ranges::greater(),
                             [&](std::size_t k) { return result_.patches[k].cells.size(); });
    const std::size_t pictured = std::min(largest_first.size(), kMaxPictured);
    heading(tr("Shape and its uncertainty"), true);
    for (std::size_t k = 0; k < pictured; ++k) addShape(largest_first[k]);
    if (pictured < largest_first.size()) {
      note(tr("%1 smaller patches are not drawn.").arg(countText(largest_first.size() - pictured)));
    }
  }
  void addShape(std::size_t index) {
    const PatchReconstruction& patch = result_.patches[index];
    if (result_.patches.size() > 1) {
      heading(patch.cells.size() == 1 ? tr("Patch %1: cell %2 alone").arg(index + 1).arg(patch.origin.value())
                                      : tr("Patch %1, of cell %2: %3 cells")
                                            .arg(index + 1)
                                            .arg(patch.origin.value())
                                            .arg(countText(patch.cells.size())));
    }
    const PatchColoring coloring = patchColoring(patch);
    document_.blocks.emplace_back(ReportDrawings{2, patchDrawings(content_.reconstruction, index, coloring)});
    QStringList remarks;
    if (coloring.worst && patch.cells.size() > 1) {
      const CellPlacement& worst = patch.cells[*coloring.worst];
      remarks << tr("Thick outline: cell %1, which is known least well (±%2 mm).")
                     .arg(worst.cell.value())
                     .arg(figureText(*coloring.values[*coloring.worst], 2));
    }
    remarks << tr("Ring: cell %1, the origin of the patch's frame, whose axes are at the lower right.")
                   .arg(patch.origin.value());
    if (std::ranges::any_of(patch.cells, [](const auto& cell) { return cell.placed_by == PlacedBy::Links; })) {
      remarks << tr("Hatched: placed through its links, for it has no readings of its own that could be used.");
    }
    if (!coloring.worst) remarks << tr("White: this calibration states no uncertainties.");
    remarks << tr("Grey: seen from behind.");
    note(remarks.join(QLatin1Char(' ')));
    if (!coloring.worst || patch.cells.size() == 1) return;
    const Goal& goal = result_.options.goal;
    HistogramPlot plot{tr("How well the places of the cells are known, and the colours of the pictures above"),
                       coloring.distribution,
                       coloring.axis,
                       tr("cells"),
                       true,
                       {{coloring.distribution.median, tr("median")}}};
    plot.marks.push_back({toMillimetres(goal.position_m), tr("good: up to %1 mm").arg(tenths(goal.position_m))});
    std::ranges::sort(plot.marks, {}, &HistogramPlot::Mark::value);
    std::vector<ReportDrawing> plots = {histogramDrawing(std::move(plot))};
    std::vector<double> turns;
    for (const CellPlacement& cell : patch.cells) {
      const std::optional<Uncertainty95> stated = coloring.is_of_shape ? shapeUncertaintyOf(cell) : uncertaintyOf(cell);
      if (stated) turns.push_back(toDegrees(stated->orientation_rad));
    }
    constexpr std::size_t kBins = 16;
    HistogramPlot of_turns{tr("How well the orientations of the cells are known"),
                           distributionOf(std::move(turns), kBins),
                           tr("uncertainty of the orientation (95 %), °"),
                           tr("cells"),
                           false,
                           {}};
    of_turns.marks = {{of_turns.distribution.median, tr("median")},
                      {toDegrees(goal.orientation_rad), tr("good: up to %1").arg(degreesText(goal.orientation_rad))}};
    std::ranges::sort(of_turns.marks, {}, &HistogramPlot::Mark::value);
    plots.push_back(histogramDrawing(std::move(of_turns)));
    document_.blocks.emplace_back(ReportDrawings{2, std::move(plots)});
  }
  void addLinks() {
    if (result_.linkCount() == 0 && !content_.graph) return;
    heading(tr("Links"), true);
    if (content_.graph) document_.blocks.emplace_back(ReportDrawings{1, {drawingOf(*content_.graph)}});
    std::vector<const LinkEstimate*> links;
    for (const PatchReconstruction& patch : result_.patches) {
      for (const LinkEstimate& link : patch.links) {
        if (link.used && link.knownResidual()) links.push_back(&link);
      }
    }
    if (links.empty()) return;
    std::vector<double> residuals;
    std::vector<double> sigmas;
    for (const LinkEstimate* link : links) {
      residuals.push_back(toDegrees(*link->knownResidual()));
      if (link->knownSigma()) sigmas.push_back(toDegrees(*link->knownSigma()));
    }
    const auto plotOf = [](const QString& caption, std::vector<double> values, const QString& axis) {
      constexpr std::size_t kBins = 16;
      HistogramPlot plot{caption, distributionOf(std::move(values), kBins), axis, tr("links"), false, {}};
      plot.marks = {{plot.distribution.median, tr("median")}, {plot.distribution.percentile_95, tr("95 %")}};
      return histogramDrawing(std::move(plot));
    };
    std::vector<ReportDrawing> plots = {plotOf(tr("How far the two ends of a link disagree about gravity"),
                                               std::move(residuals), tr("residual, rms over the poses, °"))};
    if (!sigmas.empty()) {
      plots.push_back(plotOf(tr("How exactly the poses determine a link"), std::move(sigmas),
                             tr("predicted deviation about the worst axis, °")));
    }
    document_.blocks.emplace_back(ReportDrawings{2, std::move(plots)});
    std::ranges::stable_sort(
        links, [](const LinkEstimate* a, const LinkEstimate* b) { return a->residual_rad > b->residual_rad; });
    links.resize(std::min(links.size(), kWorstLinks));
    heading(tr("Links with the largest residuals"));
    linkTable(links);
  }
  void addPoses() {
    heading(tr("Poses"), true);
    if (result_.poses.empty()) {
      paragraph(tr("No poses were taken."));
      return;
    }
    std::vector<ReportDrawing> drawings = {
        directionsDrawing(tr("Which way was up in each pose, as the largest patch saw it; rings of 30°, 60° and 90°"),
                          coverageOf(result_))};
    ResidualSummary residuals = summariseResiduals(result_);
    if (!residuals.poses.empty()) {
      drawings.push_back(boxesDrawing({tr("Residuals of the links in each pose: all, the middle half, the median"),
                                       std::move(residuals.poses), tr("pose"), tr("residual, °")}));
    }
    document_.blocks.emplace_back(ReportDrawings{2, std::move(drawings)});
    std::vector<ReportTable::Row> rows;
    for (const PoseSummary& pose : result_.poses) {
      rows.push_back({{QString::number(pose.pose.value()), pose.label.empty() ? noValue() : words(pose.label),
                       pose.enabled ? tr("used") : tr("disabled"),
                       QStringLiteral("%1/%2").arg(pose.cells_measured).arg(result_.cellCount()),
                       pose.noise_g > 0 ? QLocale().toString(1000 * pose.noise_g, 'f', 1) : noValue(),
                       pose.new_by_rad ? wholeDegreesText(*pose.new_by_rad) : noValue(), hundredths(pose.residual_rad)},
                      false});
    }
    table({{tr("Pose")},
           {tr("Label")},
           {tr("State")},
           {tr("Cells"), true},
           {tr("Noise mg"), true},
           {tr("New by"), true},
           {tr("Residual"), true}},
          std::move(rows));
  }
  void addVerify() {
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
  void addPlaces() {
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
    note(
        tr("Where the frame of each patch, that of its origin cell, lies in the frame of its link: position in mm, "
           "turn as "
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
  void addCells() {
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
    note(
        tr("Position of the cell's centre in the frame of its patch's origin cell; ± at 95 % along or about the worst "
           "axis, "
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
      rows.push_back(
          {{QString::number(cell.cell.value()), QString::number(cell.patch.value() + 1),
            placement == nullptr || placement->body_part.empty() ? noValue() : fromUtf8(placement->body_part),
            tenths(cell.T_o_u.t.x()), tenths(cell.T_o_u.t.y()), tenths(cell.T_o_u.t.z()), length(stated), turn(stated),
            length(cell.shape), turn(cell.shape), degreesText(cell.worst_residual_rad),
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
  void addAllLinks() {
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
  void addOptions() {
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
      if (patch.gap_share) {
        rows.emplace_back(tr("Gap share, patch of cell %1").arg(patch.origin.value()),
                          patch.gap_share->sigma > 0 ? tr("%1 ± %2 (1 sigma)")
                                                           .arg(locale.toString(patch.gap_share->share, 'f', 2),
                                                                locale.toString(patch.gap_share->sigma, 'f', 2))
                                                     : locale.toString(patch.gap_share->share, 'f', 2));
      }
      if (patch.lot) {
        rows.emplace_back(tr("Lot of accelerometers, patch of cell %1").arg(patch.origin.value()),
                          lotWords(*patch.lot));
      }
    }
    document_.blocks.emplace_back(ReportPairs{std::move(rows)});
  }
  void addOrigins() {
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

  void heading(const QString& text, bool large = false) { document_.blocks.emplace_back(ReportHeading{text, large}); }
  void paragraph(const QString& text, Tone tone = Tone::Neutral) {
    document_.blocks.emplace_back(ReportParagraph{text, false, tone});
  }
  void note(const QString& text) { document_.blocks.emplace_back(ReportParagraph{text, true}); }
  void table(std::vector<ReportTable::Column> columns, std::vector<ReportTable::Row> rows, const QString& note = {}) {
    document_.blocks.emplace_back(ReportTable{std::move(columns), std::move(rows), note});
  }
  void linkTable(const std::vector<const LinkEstimate*>& links) {
    std::vector<ReportTable::Row> rows;
    for (const LinkEstimate* link : links) {
      const bool known = link->hasMetrics();
      rows.push_back(
          {{shortLinkName(*link), known ? qualityWord(link->quality) : noValue(), hundredths(link->knownResidual()),
            hundredths(link->knownSigma()), known ? degreesText(link->bend_rad) : noValue(),
            known ? degreesText(link->twist_rad) : noValue(), known ? degreesText(link->yaw_rad) : noValue(),
            link->used ? (link->in_tree ? tr("used, in tree") : tr("used"))
                       : tr("muted: %1").arg(excludedBecause(*link))},
           false});
    }
    table({{tr("Link")},
           {tr("Quality")},
           {tr("Residual"), true},
           {tr("Predicted"), true},
           {tr("Bend"), true},
           {tr("Twist"), true},
           {tr("Yaw"), true},
           {tr("State")}},
          std::move(rows));
  }

  const ReportContent& content_;
  const Reconstruction& result_;
  ReportDocument document_;
};

}  // namespace hexoderm
