#include "app/window/session/result_files.h"

#include "app/window/files/session_paths.h"
#include "app/window/session/background_work.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "widgets/words/words.h"

#include <QDateTime>
#include <QFileInfo>
#include <string_view>
#include <utility>

namespace hexoderm {

void ResultFiles::exportTo(const ExportRequest& request) {
  if (!controller_.reconstruction()) return;
  work_.startWriting(tr("Exporting %1").arg(QFileInfo(request.path).fileName()),
                     [this, request, reconstruction = controller_.reconstruction()]() -> BackgroundWork::Continuation {
                       QString left_out;
                       if (request.format) {
                         left_out =
                             words(leftOutInWords(patchesLeftOut(*reconstruction, *request.format, request.options)));
                         exportReconstruction(*reconstruction, *request.format, toPath(request.path), request.options);
                       } else {
                         writeCalibrationJson(*reconstruction, toPath(request.path));
                       }
                       return [this, path = request.path, left_out] { emit exported(path, left_out); };
                     });
}

void ResultFiles::saveImage(const QImage& image, const QString& path) {
  savePicture([image, path] { return image.save(path, "PNG"); }, path);
}

void ResultFiles::savePicture(std::function<bool()> write, const QString& path) {
  work_.startWriting(tr("Saving %1").arg(QFileInfo(path).fileName()),
                     [this, write = std::move(write), path]() -> BackgroundWork::Continuation {
                       if (!write()) {
                         throw StorageError(message("The picture {} could not be written: is the folder writable?",
                                                    path.toStdString()));
                       }
                       return [this, path] { emit exported(path, {}); };
                     });
}

void ResultFiles::saveTable(const QByteArray& csv, const QString& path) {
  work_.startWriting(
      tr("Saving %1").arg(QFileInfo(path).fileName()), [this, csv, path]() -> BackgroundWork::Continuation {
        writeFileAtomically(toPath(path), std::string_view(csv.constData(), static_cast<std::size_t>(csv.size())));
        return [this, path] { emit exported(path, {}); };
      });
}

void ResultFiles::writeReport(const std::vector<ReportPicture>& pictures, const QString& path) {
  if (!controller_.reconstruction()) return;
  const ReportContent content{controller_.reconstruction(), controller_.file().name(), pictures,
                              QDateTime::currentDateTime()};
  work_.startWriting(tr("Writing the report %1").arg(QFileInfo(path).fileName()),
                     [this, content, path]() -> BackgroundWork::Continuation {
                       hexoderm::writeReport(content, path);
                       return [this, path] { emit exported(path, {}); };
                     });
}

}  // namespace hexoderm
