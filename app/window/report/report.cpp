#include "app/window/report/report.h"

#include "app/window/files/session_paths.h"
#include "app/window/report/report_html.h"
#include "app/window/report/report_page.h"
#include "app/window/report/report_pdf.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"

#include <QFileInfo>
#include <QThread>

namespace hexoderm {

QString reportHtml(const ReportContent& content) { return htmlOf(ReportPage(content).document()); }

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
