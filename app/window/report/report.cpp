#include "app/window/report/report.h"

#include "app/window/files/session_paths.h"
#include "app/window/report/report_page.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "widgets/style/palette.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QThread>
#include <QUrl>
#include <cmath>
#include <memory>

namespace hexoderm {
namespace {

QString dataUri(const QImage& image) {
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return QStringLiteral("data:image/png;base64,") + QString::fromLatin1(png.toBase64());
}

QString nameOfPicture(std::size_t index) { return QStringLiteral("picture:%1").arg(index); }

/// The name on the left, the page's number on the right.
void paintFoot(QPainter& painter, const QRectF& foot, const QString& name, int page, int pages) {
  QFont font = painter.font();
  font.setPointSizeF(8);
  painter.setFont(font);
  painter.setPen(Colors::of(Theme::Light).text_muted);
  const QString number = QCoreApplication::translate("hexoderm::ReportPage", "Page %1 of %2").arg(page).arg(pages);
  painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom, number);
  const int width = static_cast<int>(foot.width()) - 2 * painter.fontMetrics().horizontalAdvance(number);
  painter.drawText(foot, Qt::AlignLeft | Qt::AlignBottom,
                   painter.fontMetrics().elidedText(name, Qt::ElideMiddle, width));
}

QByteArray drawPdf(const ReportContent& content) {
  QByteArray pdf;
  QBuffer buffer(&pdf);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(18, 16, 18, 16), QPageLayout::Millimeter);
  constexpr int kDotsPerInch = 300;
  writer.setResolution(kDotsPerInch);
  writer.setTitle(QCoreApplication::translate("hexoderm::ReportPage", "Calibration report: %1").arg(content.name));
  writer.setCreator(QStringLiteral("Hexoderm " HEXODERM_VERSION));

  QTextDocument document;
  for (std::size_t k = 0; k < content.pictures.size(); ++k) {
    document.addResource(QTextDocument::ImageResource, QUrl(nameOfPicture(k)), content.pictures[k].image);
  }
  document.documentLayout()->setPaintDevice(&writer);
  document.setDocumentMargin(0);
  document.setHtml(
      ReportPage(content, [](const QImage& /*image*/, std::size_t index) { return nameOfPicture(index); }).html());

  const QRectF paper(0, 0, writer.width(), writer.height());
  const double foot_height = 0.35 * kDotsPerInch;
  const QSizeF body(paper.width(), paper.height() - foot_height);
  document.setPageSize(body);
  const int pages = document.pageCount();
  QPainter painter(&writer);
  for (int page = 0; page < pages; ++page) {
    if (page > 0) writer.newPage();
    painter.save();
    painter.translate(0, -page * body.height());
    QAbstractTextDocumentLayout::PaintContext context;
    context.clip = QRectF(QPointF(0, page * body.height()), body);
    context.palette.setColor(QPalette::Text, Colors::of(Theme::Light).text);
    painter.setClipRect(context.clip);
    document.documentLayout()->draw(&painter, context);
    painter.restore();
    paintFoot(painter, paper, content.name, page + 1, pages);
  }
  painter.end();
  return pdf;
}

}  // namespace

QString reportHtml(const ReportContent& content) {
  return ReportPage(content, [](const QImage& image, std::size_t /*index*/) { return dataUri(image); }).html();
}

QByteArray reportPdf(const ReportContent& content) {
  // A document's layout has timers, which ask for a thread of Qt's.
  QByteArray pdf;
  const std::unique_ptr<QThread> thread(QThread::create([&] { pdf = drawPdf(content); }));
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
