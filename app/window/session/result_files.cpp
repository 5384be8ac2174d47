#include "app/window/session/result_files.h"

#include "app/window/files/session_paths.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/io/calibration_json.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QMetaObject>
#include <exception>
#include <string_view>
#include <utility>

namespace hexoderm {
namespace {

constexpr const char* kReportPdf = "report.pdf";
constexpr const char* kReportHtml = "report.html";

}  // namespace

void ResultFiles::startWriting(const QString& activity, BackgroundWork::Work work) {
  work_.startWriting(activity, [work = std::move(work), session = toPath(controller_.file().sessionPath()),
                                calibration = toPath(controller_.file().calibrationPath())] {
    const KeptFile open_session(session);
    const KeptFile open_calibration(calibration);
    return work();
  });
}

void ResultFiles::write(const QString& activity, const QString& path, std::function<QString()> make) {
  startWriting(activity.arg(QFileInfo(path).fileName()),
               [this, path, make = std::move(make)]() -> BackgroundWork::Continuation {
                 return [this, path, left_out = make()] { emit exported(path, left_out); };
               });
}

void ResultFiles::exportTo(const ExportRequest& request) {
  if (!controller_.reconstruction()) return;
  write(tr("Exporting %1"), request.path, [request, reconstruction = controller_.reconstruction()] {
    if (!request.format) {
      writeCalibrationJson(*reconstruction, toPath(request.path));
      return QString();
    }
    exportReconstruction(*reconstruction, *request.format, toPath(request.path), request.options);
    return words(leftOutText(patchesLeftOut(*reconstruction, *request.format, request.options)));
  });
}

void ResultFiles::saveImage(const QImage& image, const QString& path) {
  savePicture([image, path] { return image.save(path, "PNG"); }, path);
}

void ResultFiles::savePicture(std::function<bool()> save, const QString& path) {
  write(tr("Saving %1"), path, [save = std::move(save), path] {
    requireReplaceable(toPath(path), path.toStdString());
    if (!save()) {
      throw StorageError(message("The picture {} could not be written: is the folder writable?", path.toStdString()));
    }
    return QString();
  });
}

void ResultFiles::saveTable(const QByteArray& csv, const QString& path) {
  write(tr("Saving %1"), path, [csv, path] {
    writeFileAtomically(toPath(path), std::string_view(csv.constData(), static_cast<std::size_t>(csv.size())));
    return QString();
  });
}

void ResultFiles::writeReport(const ReportContent& content, const QString& path) {
  if (!content.reconstruction) return;
  write(tr("Writing the report %1"), path, [content, path] {
    hexoderm::writeReport(content, path);
    return QString();
  });
}

void ResultFiles::exportPackage(const PackageRequest& request, const ReportContent& report) {
  if (!report.reconstruction) return;
  package_stop_ = {};
  const auto tell = [this](const std::string& name, std::size_t done, std::size_t count) {
    QMetaObject::invokeMethod(
        &work_,
        [this, name = QString::fromStdString(name), done = static_cast<int>(done), count = static_cast<int>(count)] {
          emit packageProgress(name, done, count);
        },
        Qt::QueuedConnection);
  };
  startWriting(tr("Exporting %1").arg(QFileInfo(request.path).fileName()),
               [this, request, report, tell, stop = package_stop_.get_token()]() -> BackgroundWork::Continuation {
                 try {
                   PackageContent content = packageContent(request);
                   for (PackageAttachment& attachment : content.attachments) {
                     if (stop.stop_requested()) return [this] { emit packageCancelled(); };
                     tell(attachment.name, 0, 0);
                     const QByteArray bytes =
                         attachment.name == kReportPdf ? reportPdf(report) : reportHtml(report).toUtf8();
                     attachment.bytes = bytes.toStdString();
                   }
                   WrittenPackage written = hexoderm::exportPackage(*report.reconstruction, content,
                                                                    toPath(request.path), request.options, stop, tell);
                   if (written.entries.empty()) return [this] { emit packageCancelled(); };
                   return [this, path = request.path, entries = std::move(written.entries)] {
                     emit packageWritten(path, entries);
                   };
                 } catch (const std::exception& error) {
                   return [this, message = words(error)] { emit packageFailed(message); };
                 }
               });
}

PackageContent packageContent(const PackageRequest& request) {
  PackageContent content{request.formats, request.calibration, {}};
  if (request.report_pdf) {
    content.attachments.push_back(
        {kReportPdf, {}, message("report with verdict, pictures, checks and tables, to be sent or printed")});
  }
  if (request.report_html) {
    content.attachments.push_back({kReportHtml, {}, message("the same report for a browser, in one file")});
  }
  return content;
}

}  // namespace hexoderm
