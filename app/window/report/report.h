#pragma once

#include "hexoderm/solve/checks/calibration_check.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/checks/loop_search.h"
#include "hexoderm/solve/hold_out.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <QDateTime>
#include <QSize>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QPainter;

namespace hexoderm {

/// A picture for the report, which is drawn on the thread that writes the report.
struct ReportPicture {
  QString title;  ///< under the picture: "Skin graph"
  QSize size;     ///< that `draw` fills, in pixels of a screen
  std::function<void(QPainter& painter)> draw;
};

/// What stands at the head of a report besides the name of the file, in the operator's words. Empty ones are left out.
struct ReportTitle {
  QString robot;
  QString part;  ///< of the robot, that wears the skin
  QString made_by;
  QString notes;

  friend bool operator==(const ReportTitle&, const ReportTitle&) = default;
};

/// The checks of the step Verify as they stand; absent: it was not made, or is out of date.
struct VerifyOutcome {
  std::optional<HoldOutResult> hold_out;
  std::optional<std::vector<FoundLoop>> loops;
  std::optional<std::vector<SurfaceEvaluation>> surfaces;
  QStringList surface_remarks;
  std::optional<std::vector<Comparison>> comparisons;
  QString compared_with;
  std::optional<CalibrationCheck> old_calibration;
  QString old_calibration_name;
};

/// Everything that is in a report, so that it can be written on any thread.
struct ReportContent {
  std::shared_ptr<const Reconstruction> reconstruction;  ///< not null
  QString name;                                          ///< name of the session or calibration
  std::optional<ReportPicture> graph{};                  ///< of the skin
  QDateTime made_at;
  ReportTitle title{};
  VerifyOutcome verify{};
  bool simulated = false;  ///< stamped on every page
};

/// The report as one page of HTML, in the language of the window: title, verdict and what it means, key figures,
/// findings, every patch from four sides in the colours of its uncertainty, links, poses, the checks of the step
/// Verify, places on the robot, then cells, links, methods and origins as tables. All that comes from files or devices
/// is escaped. Precondition: there is a reconstruction.
QString reportHtml(const ReportContent& content);

/// The same report on A4 pages with page numbers. May be called from any thread.
QByteArray reportPdf(const ReportContent& content);

/// Writes the report as PDF or HTML, by the ending of `path`: whole or not at all. Throws InvalidArgument for another
/// ending, StorageError if it can't be written.
void writeReport(const ReportContent& content, const QString& path);

}  // namespace hexoderm
