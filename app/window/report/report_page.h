#pragma once

#include "app/window/report/report.h"
#include "app/window/report/report_blocks.h"

#include <QCoreApplication>
#include <vector>

namespace hexoderm {

/// Puts together what a report says; how it is laid out, report_pdf and report_html say.
class ReportPage {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ReportPage)

 public:
  explicit ReportPage(const ReportContent& content) : content_(content), result_(*content.reconstruction) {}

  [[nodiscard]] ReportDocument document();
  /// "Page 2 of 5".
  static QString pageNumber(int page, int pages) { return tr("Page %1 of %2").arg(page).arg(pages); }
  static QString drawingFor(const QString& caption) { return tr("Picture: %1").arg(caption); }

 private:
  void addTitle();
  void addVerdict();
  void addKeyMetrics();
  void addFindings();
  void addShapes();
  void addShape(std::size_t patch);
  void addLinks();
  void addPoses();
  void addVerify();
  void addPlaces();
  void addCells();
  void addAllLinks();
  void addOptions();
  void addOrigins();

  void heading(const QString& text, bool large = false);
  void paragraph(const QString& text, Tone tone = Tone::Neutral);
  void note(const QString& text);
  void table(std::vector<ReportTable::Column> columns, std::vector<ReportTable::Row> rows, const QString& note = {});
  void linkTable(const std::vector<const LinkEstimate*>& links);

  const ReportContent& content_;
  const Reconstruction& result_;
  ReportDocument document_;
};

}  // namespace hexoderm
