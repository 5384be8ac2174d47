#pragma once

#include "widgets/controls/banner.h"

#include <QRectF>
#include <QString>
#include <QStringList>
#include <functional>
#include <utility>
#include <variant>
#include <vector>

class QPainter;

namespace hexoderm {

// What a report consists of, before it is pages or HTML. All texts are plain: nothing in them is markup.

struct ReportHeading {
  QString text;
  bool large = false;  ///< begins a part of the report
};

struct ReportParagraph {
  QString text;
  bool is_note = false;  ///< small and grey
  Tone tone = Tone::Neutral;
};

/// The one answer, with what it means.
struct ReportVerdict {
  Tone tone = Tone::Neutral;
  QString reason;
  QString meaning;
  QString next;  ///< empty: nothing
};

/// Large figures in a row, each with a small text below.
struct ReportMetrics {
  std::vector<std::pair<QString, QString>> figures;
};

/// Names and values, one below the other.
struct ReportPairs {
  std::vector<std::pair<QString, QString>> rows;
};

struct ReportTable {
  struct Column {
    QString title;
    bool is_figure = false;  ///< aligned to the right
  };
  struct Row {
    QStringList values;
    bool remarkable = false;
  };
  std::vector<Column> columns;
  std::vector<Row> rows;
  QString note{};  ///< below it, small and grey; empty: none
};

/// Draws itself into an area; `point` is a typographic point in the painter's units, for texts and lines. Called on the
/// thread that writes the report.
struct ReportDrawing {
  QString caption;
  double aspect = 0.75;  ///< height over width
  std::function<void(QPainter& painter, const QRectF& area, double point)> draw;
};

/// Drawings side by side in columns of one width.
struct ReportDrawings {
  std::size_t columns = 2;
  std::vector<ReportDrawing> drawings;
};

using ReportBlock = std::variant<ReportHeading, ReportParagraph, ReportVerdict, ReportMetrics, ReportPairs, ReportTable,
                                 ReportDrawings>;

struct ReportDocument {
  QString kind;                                    ///< "Calibration report"
  QString name;                                    ///< of the session
  QString subtitle;                                ///< its size and the date
  QString stamp;                                   ///< on every page; empty: none
  QString foot;                                    ///< on every page, beside the number
  std::vector<std::pair<QString, QString>> title;  ///< robot, part, operator
  std::vector<ReportBlock> blocks;
};

}  // namespace hexoderm
