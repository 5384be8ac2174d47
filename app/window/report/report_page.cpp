#include "app/window/report/report_page.h"

#include "hexoderm/reconstruction/result/uncertainty.h"
#include "hexoderm/util/units.h"
#include "widgets/controls/banner.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QLocale>
#include <algorithm>

namespace hexoderm {
namespace {

constexpr std::size_t kWorstLinks = 10;
// As many rows as a person still leafs through; the calibration file and the CSV tables have all.
constexpr std::size_t kMostRows = 400;
// Width in the 96ths of an inch of CSS: a little less than the width between the margins of A4.
constexpr int kPageWidth_px = 640;

QString millimetres(double length_m) { return figureInWords(toMillimetres(length_m), 1); }

QString utf8(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<int>(text.size())); }

/// QTextDocument knows neither flex nor variables nor max-width; what it does not know it skips.
QString styles() {
  const Colors& colors = Colors::of(Theme::Light);
  QString css = QStringLiteral(
      "body { font-family: Inter, 'DejaVu Sans', sans-serif; font-size: 9pt; color: @text; }"
      "h1 { font-size: 20pt; font-weight: 600; margin-top: 0; margin-bottom: 2px; }"
      "h2 { font-size: 12pt; font-weight: 600; margin-top: 22px; margin-bottom: 6px; }"
      "p { margin-top: 4px; margin-bottom: 4px; }"
      ".note { color: @muted; }"
      ".verdict { font-size: 13pt; font-weight: 600; }"
      ".big { font-size: 14pt; font-weight: 600; }"
      ".label { font-size: 8pt; color: @muted; }"
      ".mono { font-family: 'DejaVu Sans Mono', monospace; font-size: 8pt; }"
      "th { font-size: 8pt; font-weight: 600; color: @muted; border-bottom: 1px solid @muted; }"
      "td { border-bottom: 1px solid @border; }"
      ".plain td { border-bottom: none; }");
  css.replace(QStringLiteral("@text"), colors.text.name());
  css.replace(QStringLiteral("@muted"), colors.text_muted.name());
  css.replace(QStringLiteral("@border"), colors.border.name());
  return css;
}

QString paragraphOf(const QString& text, const char* style) {
  return QStringLiteral("<p class=\"%1\">%2</p>\n").arg(QLatin1String(style), text.toHtmlEscaped());
}

}  // namespace

QString ReportPage::html() {
  html_ = QStringLiteral(
              "<!DOCTYPE html>\n<html lang=\"%1\"><head><meta charset=\"utf-8\"/><title>%2</title>\n"
              "<style>%3</style></head>\n<body style=\"max-width: 900px; margin: 24px auto; padding: 0 16px\">\n")
              .arg(QLocale().name().left(2), tr("Calibration report: %1").arg(content_.name).toHtmlEscaped(), styles());
  addHead();
  addVerdict();
  addKeyFigures();
  addPictures();
  addFindings();
  addPoses();
  addWorstLinks();
  addCells();
  addAllLinks();
  addOptions();
  addOrigins();
  html_ += QStringLiteral("</body></html>\n");
  return html_;
}

void ReportPage::heading(const QString& text) { html_ += QStringLiteral("<h2>%1</h2>\n").arg(text.toHtmlEscaped()); }

void ReportPage::paragraph(const QString& text, const char* style) { html_ += paragraphOf(text, style); }

void ReportPage::table(const std::vector<Column>& columns, const std::vector<QStringList>& rows) {
  html_ += QStringLiteral(
      "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"3\" style=\"border-collapse: "
      "collapse\">\n<thead><tr>");
  const auto align = [](const Column& column) { return QLatin1String(column.figure ? "right" : "left"); };
  // A text right behind a figure would touch it.
  const auto gap = [&columns](std::size_t k) {
    return QLatin1String(k > 0 && columns[k - 1].figure && !columns[k].figure ? "&#160;&#160;" : "");
  };
  for (std::size_t k = 0; k < columns.size(); ++k) {
    html_ +=
        QStringLiteral("<th align=\"%1\">%2%3</th>").arg(align(columns[k]), gap(k), columns[k].title.toHtmlEscaped());
  }
  html_ += QStringLiteral("</tr></thead>\n<tbody>\n");
  for (const QStringList& row : rows) {
    html_ += QStringLiteral("<tr>");
    for (std::size_t k = 0; k < columns.size(); ++k) {
      html_ += QStringLiteral("<td align=\"%1\" valign=\"top\">%2%3</td>")
                   .arg(align(columns[k]), gap(k), row[static_cast<int>(k)].toHtmlEscaped());
    }
    html_ += QStringLiteral("</tr>\n");
  }
  html_ += QStringLiteral("</tbody></table>\n");
}

void ReportPage::pairs(const std::vector<std::pair<QString, QString>>& rows) {
  html_ += QStringLiteral("<table class=\"plain\" cellspacing=\"0\" cellpadding=\"2\">\n");
  for (const auto& [name, value] : rows) {
    html_ += QStringLiteral("<tr><td class=\"note\" valign=\"top\">%1&#160;&#160;</td><td>%2</td></tr>\n")
                 .arg(name.toHtmlEscaped(), value.toHtmlEscaped());
  }
  html_ += QStringLiteral("</table>\n");
}

void ReportPage::addHead() {
  paragraph(tr("Hexoderm calibration report"), "label");
  html_ += QStringLiteral("<h1>%1</h1>\n").arg(content_.name.toHtmlEscaped());
  paragraph(tr("%1 · %2").arg(words(sizeInWords(result_)), QLocale().toString(content_.made_at, QLocale::LongFormat)));
}

void ReportPage::addVerdict() {
  const Assessment& verdict = result_.assessment;
  const QColor color = toneColor(toneOf(verdict.level), Theme::Light);
  // A bar of the verdict's colour beside its words; QTextDocument has no border on the left alone.
  html_ += QStringLiteral(
               "<br/><table class=\"plain\" width=\"100%\" cellspacing=\"0\" cellpadding=\"8\"><tr>"
               "<td width=\"4\" style=\"background-color: %1; padding: 0\"></td><td>%2%3</td></tr></table>\n")
               .arg(color.name(), paragraphOf(words(verdict.reason), "verdict"),
                    verdict.next_action.empty() ? QString()
                                                : paragraphOf(tr("Next: %1").arg(words(verdict.next_action)), "text"));
}

void ReportPage::addKeyFigures() {
  const std::size_t used_links = [&] {
    std::size_t count = 0;
    for (const PatchReconstruction& patch : result_.patches) {
      count += static_cast<std::size_t>(
          std::count_if(patch.links.begin(), patch.links.end(), [](const LinkEstimate& link) { return link.used; }));
    }
    return count;
  }();
  const auto used_poses = static_cast<std::size_t>(
      std::count_if(result_.poses.begin(), result_.poses.end(), [](const PoseSummary& pose) { return pose.enabled; }));
  const auto share = [](std::size_t part, std::size_t whole) {
    return part == whole ? QLocale().toString(static_cast<qulonglong>(whole))
                         : tr("%1 of %2")
                               .arg(QLocale().toString(static_cast<qulonglong>(part)),
                                    QLocale().toString(static_cast<qulonglong>(whole)));
  };
  const Assessment& verdict = result_.assessment;
  const std::vector<std::pair<QString, QString>> figures = {
      {share(result_.cellCount(), result_.cellCount()), tr("cells")},
      {share(used_links, result_.linkCount()), tr("links used")},
      {share(result_.patches.size(), result_.patches.size()), tr("patches")},
      {share(used_poses, result_.poses.size()), tr("poses used")},
      {verdict.position_95_m ? tr("±%1 mm").arg(millimetres(*verdict.position_95_m)) : noValue(),
       tr("position, worst cell, 95 %")},
      {verdict.orientation_95_rad ? tr("±%1").arg(degreesInWords(verdict.orientation_95_rad)) : noValue(),
       tr("orientation, worst cell, 95 %")}};
  html_ += QStringLiteral("<br/><table class=\"plain\" width=\"100%\" cellspacing=\"0\" cellpadding=\"4\"><tr>");
  for (const auto& [figure, label] : figures) {
    html_ += QStringLiteral("<td valign=\"top\"><span class=\"big\">%1</span><br/><span class=\"label\">%2</span></td>")
                 .arg(figure.toHtmlEscaped(), label.toHtmlEscaped());
  }
  html_ += QStringLiteral("</tr></table>\n");
}

QString ReportPage::pictureCell(std::size_t index, int width_px, int height_px) const {
  const ReportPicture& picture = content_.pictures[index];
  const QSize size = picture.image.size().scaled(width_px, height_px, Qt::KeepAspectRatio);
  return QStringLiteral(
             "<td align=\"center\" valign=\"bottom\"><img src=\"%1\" alt=\"%2\" width=\"%3\" height=\"%4\"/>"
             "<br/><span class=\"label\">%2</span></td>")
      .arg(source_(picture.image, index), picture.title.toHtmlEscaped(), QString::number(size.width()),
           QString::number(size.height()));
}

void ReportPage::addPictures() {
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < content_.pictures.size(); ++k) {
    if (!content_.pictures[k].image.isNull()) shown.push_back(k);
  }
  if (shown.empty()) return;
  constexpr std::size_t kInARow = 2;
  html_ += QStringLiteral("<br/><table class=\"plain\" width=\"100%\" cellspacing=\"0\" cellpadding=\"4\">\n");
  for (std::size_t k = 0; k < shown.size(); k += kInARow) {
    html_ += QStringLiteral("<tr>");
    for (std::size_t n = k; n < std::min(k + kInARow, shown.size()); ++n) {
      html_ += pictureCell(shown[n], kPageWidth_px / 2 - 12, kPageWidth_px * 3 / 8);
    }
    html_ += QStringLiteral("</tr>\n");
  }
  html_ += QStringLiteral("</table>\n");
}

void ReportPage::addFindings() {
  heading(tr("Findings"));
  if (result_.findings.empty()) {
    paragraph(tr("None: nothing about topology, links, cells and poses stood out."));
    return;
  }
  std::vector<const Finding*> worst_first;
  for (const Finding& finding : result_.findings) worst_first.push_back(&finding);
  std::stable_sort(worst_first.begin(), worst_first.end(),
                   [](const Finding* a, const Finding* b) { return a->severity > b->severity; });
  std::vector<QStringList> rows;
  for (const Finding* finding : worst_first) {
    rows.push_back({severityWord(finding->severity), words(finding->message), placeInWords(*finding)});
  }
  table({{tr("Severity")}, {tr("What")}, {tr("Where")}}, rows);
}

void ReportPage::addPoses() {
  heading(tr("Poses"));
  if (result_.poses.empty()) {
    paragraph(tr("No poses were taken."));
    return;
  }
  std::vector<QStringList> rows;
  for (const PoseSummary& pose : result_.poses) {
    rows.push_back({QString::number(pose.pose.value()), pose.label.empty() ? noValue() : words(pose.label),
                    pose.enabled ? tr("used") : tr("disabled"),
                    QStringLiteral("%1/%2").arg(pose.cells_measured).arg(result_.cellCount()),
                    pose.noise_g > 0 ? QLocale().toString(1000 * pose.noise_g, 'f', 1) : noValue(),
                    pose.new_by_rad ? wholeDegreesInWords(*pose.new_by_rad) : noValue(),
                    degreesInWords(pose.residual_rad)});
  }
  table({{tr("Pose"), true},
         {tr("Label")},
         {tr("State")},
         {tr("Cells"), true},
         {tr("Noise mg"), true},
         {tr("New by"), true},
         {tr("Residual"), true}},
        rows);
}

void ReportPage::linkTable(const std::vector<const LinkEstimate*>& links) {
  std::vector<QStringList> rows;
  for (const LinkEstimate* link : links) {
    const bool known = link->hasFigures();
    rows.push_back(
        {shortLinkName(*link), known ? qualityWord(link->quality) : noValue(), degreesInWords(link->knownResidual()),
         degreesInWords(link->knownSigma()), known ? degreesInWords(link->bend_rad) : noValue(),
         known ? degreesInWords(link->twist_rad) : noValue(), known ? degreesInWords(link->yaw_rad) : noValue(),
         link->used ? (link->in_tree ? tr("used, in tree") : tr("used")) : tr("muted: %1").arg(mutedBecause(*link))});
  }
  table({{tr("Link")},
         {tr("Quality")},
         {tr("Residual"), true},
         {tr("Predicted"), true},
         {tr("Bend"), true},
         {tr("Twist"), true},
         {tr("Yaw"), true},
         {tr("State")}},
        rows);
}

void ReportPage::addWorstLinks() {
  std::vector<const LinkEstimate*> links;
  for (const PatchReconstruction& patch : result_.patches) {
    for (const LinkEstimate& link : patch.links) {
      if (link.used && link.knownResidual()) links.push_back(&link);
    }
  }
  if (links.empty()) return;
  std::stable_sort(links.begin(), links.end(),
                   [](const LinkEstimate* a, const LinkEstimate* b) { return a->residual_rad > b->residual_rad; });
  links.resize(std::min(links.size(), kWorstLinks));
  heading(tr("Links with the largest residuals"));
  linkTable(links);
}

void ReportPage::addCells() {
  heading(tr("Cells"));
  paragraph(
      tr("Position of the cell's centre in the frame of its patch's origin cell; ± at 95 %, relative to the "
         "origin."));
  std::vector<QStringList> rows;
  std::size_t left_out = 0;
  for (const PatchReconstruction& patch : result_.patches) {
    for (const CellPlacement& cell : patch.cells) {
      if (rows.size() >= kMostRows) {
        ++left_out;
        continue;
      }
      const std::optional<Uncertainty95> known = uncertaintyOf(cell);
      const bool is_origin = patch.origin == cell.cell;
      rows.push_back({QString::number(cell.cell.value()), QString::number(patch.id.value() + 1),
                      cell.body_part.empty() ? noValue() : utf8(cell.body_part), millimetres(cell.T_o_u.t.x()),
                      millimetres(cell.T_o_u.t.y()), millimetres(cell.T_o_u.t.z()),
                      known && !is_origin ? millimetres(known->position_m) : noValue(),
                      known && !is_origin ? degreesInWords(known->orientation_rad) : noValue(),
                      is_origin                             ? tr("origin")
                      : cell.placed_by == PlacedBy::Samples ? tr("measured")
                                                            : tr("through its links")});
    }
  }
  table({{tr("Cell"), true},
         {tr("Patch"), true},
         {tr("Body part")},
         {tr("x mm"), true},
         {tr("y mm"), true},
         {tr("z mm"), true},
         {tr("± mm"), true},
         {tr("± turn"), true},
         {tr("Placed")}},
        rows);
  if (left_out > 0) {
    paragraph(tr("%1 more cells are in the calibration file and in the exported tables.").arg(left_out));
  }
}

void ReportPage::addAllLinks() {
  std::vector<const LinkEstimate*> links;
  std::size_t left_out = 0;
  for (const PatchReconstruction& patch : result_.patches) {
    for (const LinkEstimate& link : patch.links) {
      if (links.size() < kMostRows) {
        links.push_back(&link);
      } else {
        ++left_out;
      }
    }
  }
  if (links.empty()) return;
  heading(tr("All links"));
  linkTable(links);
  if (left_out > 0) {
    paragraph(tr("%1 more links are in the calibration file and in the exported tables.").arg(left_out));
  }
}

void ReportPage::addOptions() {
  const SolverOptions& options = result_.options;
  const QLocale locale;
  heading(tr("Options of the reconstruction"));
  QStringList left_out;
  for (const CellId cell : options.left_out) left_out << QString::number(cell.value());
  pairs({{tr("Solver"), utf8(result_.solver)},
         {tr("Gap model"), utf8(gapModelName(options.gap_model))},
         {tr("Centring"), utf8(centringName(options.centring))},
         {tr("Support axes"), utf8(supportAxesName(options.support_axes))},
         {tr("Link weights"), utf8(linkWeightsName(options.weights))},
         {tr("A direction counts as defined from"), locale.toString(options.class_threshold, 'f', 2)},
         {tr("Limits of bend, twist, yaw"),
          tr("%1, %2, %3")
              .arg(wholeDegreesInWords(options.max_bend_rad), wholeDegreesInWords(options.max_twist_rad),
                   wholeDegreesInWords(options.max_yaw_rad))},
         {tr("Limit of misfit"), tr("%1 standard deviations").arg(locale.toString(options.max_misfit, 'f', 1))},
         {tr("Cells left out"), left_out.isEmpty() ? tr("none") : left_out.join(QStringLiteral(", "))}});
}

void ReportPage::addOrigins() {
  heading(tr("Where it comes from"));
  std::vector<std::pair<QString, QString>> rows = {{tr("Source"), words(result_.source.text)}};
  if (!result_.source.file.empty()) rows.emplace_back(tr("File"), utf8(result_.source.file));
  if (!result_.source.sha256.empty()) rows.emplace_back(tr("SHA-256"), utf8(result_.source.sha256));
  rows.emplace_back(tr("Cell model"), utf8(result_.model->name));
  rows.emplace_back(tr("Program"), QStringLiteral("Hexoderm " HEXODERM_VERSION));
  if (result_.solve_seconds > 0) {
    rows.emplace_back(tr("Solved in"), tr("%1 ms").arg(QLocale().toString(1e3 * result_.solve_seconds, 'f', 1)));
  }
  rows.emplace_back(tr("Written"), content_.made_at.toString(Qt::ISODate));
  pairs(rows);
}

}  // namespace hexoderm
