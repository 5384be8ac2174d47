#include "app/window/report/report_page.h"

#include "app/window/report/report_patch.h"
#include "app/window/report/report_plots.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/assess.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/metrics/review_summary.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>

namespace hexoderm {
namespace {

constexpr std::size_t kWorstLinks = 10;
/// Of a skin of many patches the largest are drawn.
constexpr std::size_t kMaxPictured = 4;

QString millimetresAlone(double length_m) { return figureText(toMillimetres(length_m), 1); }

QString hundredths(std::optional<double> angle_rad) {
  return angle_rad ? figureText(toDegrees(*angle_rad), 2) + QStringLiteral("°") : noValue();
}

ReportDrawing drawingOf(const ReportPicture& picture) {
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

QString countText(std::size_t count) { return QLocale().toString(static_cast<qulonglong>(count)); }

}  // namespace

ReportDocument ReportPage::document() {
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

void ReportPage::heading(const QString& text, bool large) { document_.blocks.emplace_back(ReportHeading{text, large}); }

void ReportPage::paragraph(const QString& text, Tone tone) {
  document_.blocks.emplace_back(ReportParagraph{text, false, tone});
}

void ReportPage::note(const QString& text) { document_.blocks.emplace_back(ReportParagraph{text, true}); }

void ReportPage::table(std::vector<ReportTable::Column> columns, std::vector<ReportTable::Row> rows,
                       const QString& note) {
  document_.blocks.emplace_back(ReportTable{std::move(columns), std::move(rows), note});
}

void ReportPage::addTitle() {
  const ReportTitle& title = content_.title;
  for (const auto& [name, value] : {std::pair(tr("Robot"), title.robot), std::pair(tr("Part"), title.part),
                                    std::pair(tr("Operator"), title.made_by), std::pair(tr("Notes"), title.notes)}) {
    if (!value.trimmed().isEmpty()) document_.title.emplace_back(name, value.trimmed());
  }
}

void ReportPage::addVerdict() {
  const Assessment& verdict = result_.assessment;
  const QString goal = tr("±%1 mm and ±%2").arg(millimetresAlone(kGoodPosition_m), degreesText(kGoodOrientation_rad));
  QString meaning;
  if (verdict.isUsable() && verdict.position_95_m && verdict.orientation_95_rad) {
    meaning = tr("With a probability of 95 %, each measured cell is at most %1 mm and %2 from where this report says, "
                 "along or about any one axis, seen from the origin cell of its patch.")
                  .arg(millimetresAlone(*verdict.position_95_m), degreesText(verdict.orientation_95_rad));
    meaning += QLatin1Char(' ');
    meaning += verdict.level == VerdictLevel::Good
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
  } else {
    meaning = tr("Something is broken or missing, as the findings say. The places of the cells should not be used.");
  }
  document_.blocks.emplace_back(
      ReportVerdict{toneOf(verdict.level), words(verdict.reason), meaning,
                    verdict.next_action.empty() ? QString() : tr("Next: %1").arg(words(verdict.next_action))});
}

void ReportPage::addKeyMetrics() {
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
                     {verdict.position_95_m ? tr("±%1 mm").arg(millimetresAlone(*verdict.position_95_m)) : noValue(),
                      tr("position, worst cell, 95 %")},
                     {verdict.orientation_95_rad ? tr("±%1").arg(degreesText(verdict.orientation_95_rad)) : noValue(),
                      tr("orientation, worst cell, 95 %")}}});
}

void ReportPage::addFindings() {
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

void ReportPage::addShapes() {
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

void ReportPage::addShape(std::size_t index) {
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
  HistogramPlot plot{tr("How well the places of the cells are known, and the colours of the pictures above"),
                     coloring.distribution,
                     coloring.axis,
                     tr("cells"),
                     true,
                     {{coloring.distribution.median, tr("median")}}};
  plot.marks.push_back(
      {toMillimetres(kGoodPosition_m), tr("good: up to %1 mm").arg(millimetresAlone(kGoodPosition_m))});
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
                    {toDegrees(kGoodOrientation_rad), tr("good: up to %1").arg(degreesText(kGoodOrientation_rad))}};
  std::ranges::sort(of_turns.marks, {}, &HistogramPlot::Mark::value);
  plots.push_back(histogramDrawing(std::move(of_turns)));
  document_.blocks.emplace_back(ReportDrawings{2, std::move(plots)});
}

void ReportPage::linkTable(const std::vector<const LinkEstimate*>& links) {
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

void ReportPage::addLinks() {
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

void ReportPage::addPoses() {
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

}  // namespace hexoderm
