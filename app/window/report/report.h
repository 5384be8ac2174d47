#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <QDateTime>
#include <QImage>
#include <QString>
#include <memory>
#include <vector>

namespace hexoderm {

/// A picture for the report; a widget's picture must be taken on the GUI thread.
struct ReportPicture {
  QString title;  ///< under the picture: "Patch from the front"
  QImage image;
};

/// Everything that is in a report, so that it can be written on any thread.
struct ReportContent {
  std::shared_ptr<const Reconstruction> reconstruction;  ///< not null
  QString name;                                          ///< name of the session or calibration
  std::vector<ReportPicture> pictures;                   ///< null images are left out
  QDateTime made_at;
};

/// The report as one page of HTML, in the language of the window: verdict and what to do next, key figures, pictures,
/// findings, poses, worst links, then cells, links, options and origins as tables. All that comes from files or devices
/// is escaped. Only such HTML and CSS as QTextDocument shows, too. Precondition: there is a reconstruction.
QString reportHtml(const ReportContent& content);

/// The same report on A4 pages with page numbers. May be called from any thread.
QByteArray reportPdf(const ReportContent& content);

/// Writes the report as PDF or HTML, by the ending of `path`: whole or not at all. Throws InvalidArgument for another
/// ending, StorageError if it can't be written.
void writeReport(const ReportContent& content, const QString& path);

}  // namespace hexoderm
