#include "app/window/report/report.h"

#include "app/window/files/session_paths.h"
#include "app/window/report/report_blocks.h"
#include "app/window/report/report_page.h"
#include "app/window/report/report_pdf.h"
#include "app/window/report/report_plots.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "widgets/style/palette.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QSvgGenerator>
#include <QThread>

namespace hexoderm {
namespace {

constexpr double kPixelsPerPoint = 96.0 / 72;
/// In the 96ths of an inch of CSS.
constexpr double kPageWidth = 860;
/// Shapes of more bytes are slower to open than pixels.
constexpr int kMaxSvgBytes = 400000;
constexpr double kPictureFineness = 2;
QString reportStyles() {
  const Colors& colors = Colors::of(Theme::Light);
  QString css = QStringLiteral(
      "*{box-sizing:border-box}"
      "body{font-family:Inter,'DejaVu Sans',sans-serif;font-size:13px;line-height:1.45;color:@text;background:#fff;"
      "max-width:860px;margin:32px auto;padding:0 16px}"
      "h1{font-size:28px;font-weight:600;margin:0;overflow-wrap:anywhere}"
      "h2{font-size:18px;font-weight:600;margin:36px 0 10px;padding-bottom:4px;border-bottom:1px solid @muted}"
      "h3{font-size:14px;font-weight:600;margin:22px 0 6px}"
      "p{margin:6px 0;white-space:pre-line;overflow-wrap:anywhere}"
      ".note,.label,figcaption{color:@muted;font-size:12px}"
      ".title{display:grid;grid-template-columns:repeat(3,1fr);gap:10px 20px;margin:18px 0}"
      ".title p{margin:0;font-size:14px}.title .wide{grid-column:1/-1}"
      ".verdict{border-left:6px solid;padding:14px 18px;margin:20px 0}"
      ".verdict p:first-child{font-size:17px;font-weight:600}"
      ".said{border-left:4px solid;padding-left:12px}"
      ".figures{display:flex;flex-wrap:wrap;gap:12px 28px;margin:18px 0}.figures>div{flex:1 1 100px}"
      ".figures b{display:block;font-size:20px;font-weight:600}"
      ".pictures{display:grid;gap:16px 20px;margin:12px 0}"
      "figure{margin:0;break-inside:avoid}figure img{width:100%;height:auto;display:block}"
      "table{border-collapse:collapse;min-width:60%;font-size:12px;margin:8px 0;font-variant-numeric:tabular-nums}"
      "th{color:@muted;font-weight:600;text-align:left;vertical-align:bottom;border-bottom:1px solid @muted}"
      "td{vertical-align:top;border-bottom:1px solid @border;overflow-wrap:anywhere}"
      "th,td{padding:4px 6px}th:first-child,td:first-child{padding-left:0}th:last-child,td:last-child{padding-right:0}"
      ".figure{text-align:right;white-space:nowrap}.remarkable td{font-weight:600}"
      ".pairs td{border:none;padding:2px 12px 2px 0}.pairs td:first-child{color:@muted;white-space:nowrap}"
      ".stamp{border:2px solid @bad;border-radius:4px;color:@bad;font-weight:600;padding:3px "
      "12px;position:fixed;top:8px;"
      "right:16px;background:#fff}"
      ".foot{color:@muted;font-size:12px;margin-top:40px;border-top:1px solid @border;padding-top:8px}"
      "@page{size:A4;margin:18mm 16mm}"
      "@media print{body{margin:0;padding:0;max-width:none;font-size:12px}h2,h3{break-after:avoid}"
      "thead{display:table-header-group}tr,.verdict,.figures{break-inside:avoid}.stamp{top:-12mm;right:0}}");
  css.replace(QStringLiteral("@text"), colors.text.name());
  css.replace(QStringLiteral("@muted"), colors.text_muted.name());
  css.replace(QStringLiteral("@border"), colors.border.name());
  css.replace(QStringLiteral("@bad"), colors.bad.name());
  return css;
}

QString dataUri(const char* type, const QByteArray& bytes) {
  return QStringLiteral("data:%1;base64,%2").arg(QLatin1String(type), QString::fromLatin1(bytes.toBase64()));
}

QByteArray svgOf(const ReportDrawing& drawing, const QSizeF& size) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(96);
  generator.setSize(size.toSize());
  generator.setViewBox(QRectF(QPointF(0, 0), size));
  generator.setTitle(drawing.caption);
  QPainter painter(&generator);
  drawing.draw(painter, QRectF(QPointF(0, 0), size), kPixelsPerPoint);
  painter.end();
  return buffer.data();
}

QByteArray pngOf(const ReportDrawing& drawing, const QSizeF& size) {
  const QImage image = reportImage((size * kPictureFineness).toSize(), [&](QPainter& painter) {
    drawing.draw(painter, QRectF(QPointF(0, 0), size * kPictureFineness), kPixelsPerPoint * kPictureFineness);
  });
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return buffer.data();
}

/// Makes the report one file for a browser, with all pictures in it and without scripts. Printed, it has its stamp and
/// the heads of its tables on every page, too.
class HtmlMaker {
 public:
  QString make(const ReportDocument& document) {
    html_ = QStringLiteral(
                "<!DOCTYPE html>\n<html lang=\"%1\"><head><meta charset=\"utf-8\"/>"
                "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/><title>%2</title>\n"
                "<style>%3</style></head>\n<body>\n")
                .arg(QLocale().name().left(2), (document.kind + QStringLiteral(": ") + document.name).toHtmlEscaped(),
                     reportStyles());
    if (!document.stamp.isEmpty()) element("div", document.stamp, "stamp");
    element("p", document.kind, "label");
    element("h1", document.name);
    element("p", document.subtitle, "note");
    addTitle(document.title);
    for (const ReportBlock& block : document.blocks) {
      std::visit([this](const auto& kind) { add(kind); }, block);
    }
    element("p", document.foot, "foot");
    html_ += QStringLiteral("</body></html>\n");
    return html_;
  }

 private:
  void element(const char* name, const QString& text, const char* style = nullptr) {
    const QString tag = QLatin1String(name);
    const QString attributes = style == nullptr ? QString() : QStringLiteral(" class=\"%1\"").arg(QLatin1String(style));
    html_ += QStringLiteral("<%1%2>%3</%1>\n").arg(tag, attributes, text.toHtmlEscaped());
  }

  void addTitle(const std::vector<std::pair<QString, QString>>& title) {
    if (title.empty()) return;
    constexpr int kLong = 60;
    html_ += QStringLiteral("<div class=\"title\">\n");
    for (const auto& [name, value] : title) {
      const bool is_wide = value.size() > kLong || value.contains(QLatin1Char('\n'));
      html_ += QStringLiteral("<div%1><span class=\"label\">%2</span><p>%3</p></div>\n")
                   .arg(is_wide ? QStringLiteral(" class=\"wide\"") : QString(), name.toHtmlEscaped(),
                        value.toHtmlEscaped());
    }
    html_ += QStringLiteral("</div>\n");
  }

  void add(const ReportHeading& heading) { element(heading.large ? "h2" : "h3", heading.text); }

  void add(const ReportParagraph& paragraph) {
    if (paragraph.tone == Tone::Neutral) {
      element("p", paragraph.text, paragraph.is_note ? "note" : nullptr);
      return;
    }
    html_ += QStringLiteral("<p class=\"said\" style=\"border-color:%1\">%2</p>\n")
                 .arg(reportColor(paragraph.tone).name(), paragraph.text.toHtmlEscaped());
  }

  void add(const ReportVerdict& verdict) {
    const QColor color = reportColor(verdict.tone);
    html_ += QStringLiteral("<div class=\"verdict\" style=\"border-color:%1;background:%2\">\n")
                 .arg(color.name(), reportTint(color).name());
    for (const QString& text : {verdict.reason, verdict.meaning, verdict.next}) {
      if (!text.isEmpty()) element("p", text);
    }
    html_ += QStringLiteral("</div>\n");
  }

  void add(const ReportMetrics& figures) {
    html_ += QStringLiteral("<div class=\"figures\">\n");
    for (const auto& [figure, label] : figures.figures) {
      html_ += QStringLiteral("<div><b>%1</b><span class=\"label\">%2</span></div>\n")
                   .arg(figure.toHtmlEscaped(), label.toHtmlEscaped());
    }
    html_ += QStringLiteral("</div>\n");
  }

  void add(const ReportPairs& pairs) {
    html_ += QStringLiteral("<table class=\"pairs\"><tbody>\n");
    for (const auto& [name, value] : pairs.rows) {
      html_ += QStringLiteral("<tr><td>%1</td><td>%2</td></tr>\n").arg(name.toHtmlEscaped(), value.toHtmlEscaped());
    }
    html_ += QStringLiteral("</tbody></table>\n");
  }

  void add(const ReportDrawings& row) {
    html_ += QStringLiteral("<div class=\"pictures\" style=\"grid-template-columns:repeat(%1,1fr)\">\n")
                 .arg(static_cast<int>(row.columns));
    for (const ReportDrawing& drawing : row.drawings) {
      const double width = kPageWidth / static_cast<double>(row.columns);
      const QSizeF size(width, width * drawing.aspect);
      const QByteArray svg = svgOf(drawing, size);
      const QString source =
          svg.size() > kMaxSvgBytes ? dataUri("image/png", pngOf(drawing, size)) : dataUri("image/svg+xml", svg);
      html_ +=
          QStringLiteral("<figure><img src=\"%1\" alt=\"%2\"/><figcaption>%3</figcaption></figure>\n")
              .arg(source, ReportPage::drawingFor(drawing.caption).toHtmlEscaped(), drawing.caption.toHtmlEscaped());
    }
    html_ += QStringLiteral("</div>\n");
  }

  void add(const ReportTable& table) {
    const auto style = [](const ReportTable::Column& column) {
      return column.is_figure ? QStringLiteral(" class=\"figure\"") : QString();
    };
    html_ += QStringLiteral("<table><thead><tr>");
    for (const ReportTable::Column& column : table.columns) {
      html_ += QStringLiteral("<th%1>%2</th>").arg(style(column), column.title.toHtmlEscaped());
    }
    html_ += QStringLiteral("</tr></thead>\n<tbody>\n");
    for (const ReportTable::Row& row : table.rows) {
      html_ += row.remarkable ? QStringLiteral("<tr class=\"remarkable\">") : QStringLiteral("<tr>");
      for (std::size_t k = 0; k < table.columns.size(); ++k) {
        html_ += QStringLiteral("<td%1>%2</td>")
                     .arg(style(table.columns[k]), row.values[static_cast<int>(k)].toHtmlEscaped());
      }
      html_ += QStringLiteral("</tr>\n");
    }
    html_ += QStringLiteral("</tbody></table>\n");
    if (!table.note.isEmpty()) element("p", table.note, "note");
  }

  QString html_;
};

}  // namespace

QString reportHtml(const ReportContent& content) { return HtmlMaker().make(ReportPage(content).document()); }

QByteArray reportPdf(const ReportContent& content) {
  // Fonts and pictures of Qt ask for a thread of Qt's.
  QByteArray pdf;
  const std::unique_ptr<QThread> thread(QThread::create([&] { pdf = pdfOf(ReportPage(content).document()); }));
  thread->start();
  thread->wait();
  return pdf;
}

void writeReport(const ReportContent& content, const QString& path) {
  const QString ending = QFileInfo(path).suffix().toLower();
  QByteArray bytes;
  if (ending == QStringLiteral("pdf")) {
    bytes = reportPdf(content);
  } else if (ending == QStringLiteral("html") || ending == QStringLiteral("htm")) {
    bytes = reportHtml(content).toUtf8();
  } else {
    throw InvalidArgument(located(path.toStdString(), message("expected a name that ends in .pdf or .html")));
  }
  writeFileAtomically(toPath(path), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace hexoderm
