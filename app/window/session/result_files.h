#pragma once

#include "app/window/report/report.h"
#include "app/window/session/background_work.h"
#include "hexoderm/io/export_package.h"

#include <QImage>
#include <QObject>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace hexoderm {

class SessionController;

/// The request of an export dialog. Without a format: Hexoderm's own calibration file.
struct ExportRequest {
  std::optional<ExportFormat> format;
  QString path;
  ExportOptions options;
};

/// Several files in a folder, or in an archive if `path` ends in .zip.
struct PackageRequest {
  std::vector<ExportFormat> formats;
  bool calibration = false;  ///< Hexoderm's own file too
  bool report_pdf = false;
  bool report_html = false;
  QString path;
  ExportOptions options;

  [[nodiscard]] bool hasReport() const { return report_pdf || report_html; }
  [[nodiscard]] bool isEmpty() const { return formats.empty() && !calibration && !hasReport(); }
};

/// What it will hold, with reports that are not written yet.
PackageContent packageContent(const PackageRequest& request);

/// Files that are made of what the window shows.
class ResultFiles : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this object.
  ResultFiles(const SessionController& controller, BackgroundWork& work) : controller_(controller), work_(work) {}
  /// A package that is being written is given up.
  ~ResultFiles() override { cancelPackage(); }

 public slots:
  /// The result, in a format of other programs or in Hexoderm's own.
  void exportTo(const hexoderm::ExportRequest& request);
  /// Calls `save` on the thread for files; false from it is a failure.
  void savePicture(std::function<bool()> save, const QString& path);
  void saveImage(const QImage& image, const QString& path);
  /// A table of the window, as CSV.
  void saveTable(const QByteArray& csv, const QString& path);
  /// The result with what `content` says besides, as PDF or HTML by the ending of `path`.
  void writeReport(const hexoderm::ReportContent& content, const QString& path);
  /// All of it or nothing. `report`: of the reports in it. One of the three signals follows.
  void exportPackage(const hexoderm::PackageRequest& request, const hexoderm::ReportContent& report);
  /// packageCancelled() follows, unless it was too late.
  void cancelPackage() { package_stop_.request_stop(); }

 signals:
  /// `left_out`: what of the result is not in the file, in words; empty if nothing.
  void exported(const QString& path, const QString& left_out);
  void packageProgress(const QString& name, int done, int count);
  void packageWritten(const QString& path, const std::vector<hexoderm::PackageEntry>& entries);
  void packageFailed(const QString& message);
  void packageCancelled();

 private:
  /// In place of no file that is open in the window.
  void startWriting(const QString& activity, BackgroundWork::Work work);
  /// One file. `activity` has a place for its name; `make` returns what of the result is not in it.
  void write(const QString& activity, const QString& path, std::function<QString()> make);

  const SessionController& controller_;
  BackgroundWork& work_;
  std::stop_source package_stop_;
};

}  // namespace hexoderm
