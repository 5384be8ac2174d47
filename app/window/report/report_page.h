#pragma once

#include "app/window/report/report.h"

#include <QCoreApplication>
#include <QStringList>
#include <functional>

namespace hexoderm {

/// Puts together the HTML of a report; see reportHtml(). For browser and QTextDocument alike.
class ReportPage {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ReportPage)

 public:
  using PictureSource = std::function<QString(const QImage& image, std::size_t index)>;

  /// `source`: what stands in <img src="">.
  ReportPage(const ReportContent& content, PictureSource source)
      : content_(content), result_(*content.reconstruction), source_(std::move(source)) {}

  [[nodiscard]] QString html();

 private:
  struct Column {
    QString title;
    bool figure = false;  ///< aligned to the right
  };

  void addHead();
  void addVerdict();
  void addKeyFigures();
  void addPictures();
  void addFindings();
  void addPoses();
  void addWorstLinks();
  void addCells();
  void addAllLinks();
  void addOptions();
  void addOrigins();

  void heading(const QString& text);
  void paragraph(const QString& text, const char* style = "note");
  /// Texts are escaped here.
  void table(const std::vector<Column>& columns, const std::vector<QStringList>& rows);
  void pairs(const std::vector<std::pair<QString, QString>>& rows);
  void linkTable(const std::vector<const LinkEstimate*>& links);
  QString pictureCell(std::size_t index, int width_px, int height_px) const;

  const ReportContent& content_;
  const Reconstruction& result_;
  PictureSource source_;
  QString html_;
};

}  // namespace hexoderm
