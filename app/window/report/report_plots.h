#pragma once

#include "app/window/report/report_blocks.h"
#include "hexoderm/solve/metrics/distribution.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/metrics/review_summary.h"

#include <QColor>
#include <QFont>
#include <QImage>
#include <QString>
#include <functional>
#include <vector>

namespace hexoderm {

/// The font of reports, in pixels, so that it is as large on paper as in a picture.
QFont reportFont(double pixels, bool is_bold = false);

/// Of a tone on paper, and what lies behind what is said in a colour.
QColor reportColor(Tone tone);
QColor reportTint(const QColor& color);

/// What `draw` makes of a white picture.
QImage reportImage(const QSize& size, const std::function<void(QPainter& painter)>& draw);

/// Colour of a value from 0 (the least) to 1 (the largest) in the pictures of a report and their legend.
QColor reportScale(double share);

/// A histogram with axes. Where its bars have the colours of the scale it is the legend of pictures in these colours.
struct HistogramPlot {
  struct Mark {
    double value = 0;
    QString word;
  };
  QString caption;
  Distribution distribution;
  QString axis;   ///< below the horizontal one, with the unit
  QString count;  ///< beside the vertical one: "cells"
  bool is_legend = false;
  std::vector<Mark> marks;  ///< those outside the axis are not drawn
};
ReportDrawing histogramDrawing(HistogramPlot plot);

/// The residuals of the links in each pose: their whole range as a line, their middle half as a box, the median in it.
struct BoxPlot {
  QString caption;
  std::vector<PoseResiduals> poses;
  QString axis;   ///< below the horizontal one: "pose"
  QString value;  ///< over the vertical one, with the unit
};
ReportDrawing boxesDrawing(BoxPlot plot);

/// The up directions of the poses on two discs, with rings of 30, 60 and 90 degrees; disabled poses are hollow.
ReportDrawing directionsDrawing(const QString& caption, const PoseCoverage& coverage);

}  // namespace hexoderm
