#pragma once

#include "app/window/report/report.h"
#include "hexoderm/io/exporter.h"

#include <QImage>
#include <QObject>
#include <functional>
#include <optional>
#include <vector>

namespace hexoderm {

class BackgroundWork;
class SessionController;

/// The request of an export dialog. Without a format: Hexoderm's own calibration file.
struct ExportRequest {
  std::optional<ExportFormat> format;
  QString path;
  ExportOptions options;
};

/// Files that are made of what the window shows.
class ResultFiles : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this object.
  ResultFiles(const SessionController& controller, BackgroundWork& work) : controller_(controller), work_(work) {}

 public slots:
  /// The result, in a format of other programs or in Hexoderm's own.
  void exportTo(const hexoderm::ExportRequest& request);
  /// Calls `write` on the thread for files; false from it is a failure.
  void savePicture(std::function<bool()> write, const QString& path);
  void saveImage(const QImage& image, const QString& path);
  /// A table of the window, as CSV.
  void saveTable(const QByteArray& csv, const QString& path);
  /// The result with these pictures, as PDF or HTML by the ending of `path`.
  void writeReport(const std::vector<hexoderm::ReportPicture>& pictures, const QString& path);

 signals:
  /// `left_out`: what of the result is not in the file, in words; empty if nothing.
  void exported(const QString& path, const QString& left_out);

 private:
  const SessionController& controller_;
  BackgroundWork& work_;
};

}  // namespace hexoderm
