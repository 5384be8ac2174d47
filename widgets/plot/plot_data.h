#pragma once

#include "hexoderm/solve/metrics/distribution.h"
#include "widgets/coloring/coloring.h"
#include "widgets/controls/selection.h"

#include <QString>
#include <optional>
#include <vector>

namespace hexoderm {

/// The things that a plot has a point for.
enum class PlotSubject { Cells, Links };

/// A figure along an axis: a quantity of the table of colourings; none: the number of the cell, of a link the smaller
/// one of its two cells.
using PlotFigure = std::optional<Coloring>;

/// The figures that cells or links have, in the order of their menu: the cell's number, then as in the table.
std::vector<PlotFigure> plotMetrics(PlotSubject subject);
/// "position uncertainty (95 %)", and with its unit.
QString plotFigureName(PlotSubject subject, PlotFigure figure);
QString plotAxisTitle(PlotSubject subject, PlotFigure figure);
/// "0.83 mm", in the user's locale.
QString plotValueText(PlotFigure figure, double value);

struct PlotPoint {
  CellId cell;                          ///< of a link the one of its source
  std::optional<Selection::Link> link;  ///< set if links are plotted
  double x = 0;
  double y = 0;  ///< of a histogram: 0
};

/// A value that says whether others are good.
struct PlotLimit {
  double value = 0;
  QString word;
};
std::vector<PlotLimit> plotLimits(PlotFigure figure);

/// What a plot shows.
struct PlotChoice {
  PlotSubject subject = PlotSubject::Cells;
  PlotFigure x;
  PlotFigure y;
  bool is_histogram = false;  ///< of x; y is not looked at

  friend bool operator==(const PlotChoice&, const PlotChoice&) = default;
};

/// The points of a plot, those of which all figures are known, in order of patch and ID; and the bins of a histogram.
struct PlotData {
  PlotChoice choice;
  std::vector<PlotPoint> points;
  std::vector<ValueBin> bins;
  std::size_t unknown = 0;  ///< cells or links that lack a figure

  /// The cells of a point: one, or both ends of a link.
  [[nodiscard]] std::vector<CellId> cellsOf(const PlotPoint& point) const;
  /// The point that is picked, if there is one.
  [[nodiscard]] std::optional<std::size_t> pickedIn(const Selection& selection) const;
  /// The ends of the points' values; from 0 to 1 without points. `along_y`: else along x.
  [[nodiscard]] ColorRange bounds(bool along_y) const;
};

/// `figures`: of the reconstruction's cells; `readings`: those that are no part of it. Null: nothing is plotted.
PlotData makePlotData(const Reconstruction* reconstruction, const CellMetrics& figures, const CellReadings& readings,
                      const PlotChoice& choice);

}  // namespace hexoderm
