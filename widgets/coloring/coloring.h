#pragma once

#include "hexoderm/solve/metrics/cell_metrics.h"
#include "hexoderm/solve/metrics/value_scale.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <QString>
#include <cstddef>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace hexoderm {

// What the colours of the graph and of the 3D view stand for. The colours themselves are in widgets/style,
// those of the quality of links in core's quality_colors.cpp.

/// The meaning of the colours in the graph and in the 3D view, in the order of their menus.
enum class Coloring {
  LinkQuality,
  Residual,   ///< residual of a link, or of a cell's worst link
  Deviation,  ///< predicted, of a link; of a cell that of its worst link
  Bend,       ///< signed, of a link; of a cell that of the link that bends most; likewise:
  Twist,
  Yaw,                     ///< either way: its sign depends on the end that one looks from
  ShapeUncertainty,        ///< of a cell's position in the shape, 95 %
  ShapeOrientation,        ///< of its orientation in the shape, 95 %
  PositionUncertainty,     ///< relative to the origin, 95 %
  OrientationUncertainty,  ///< likewise
  PathDistance,            ///< from the origin along the path
  SurfaceDistance,         ///< from the fitted surface, signed
  PlacedBy,
  Patch,
  BodyPart,
  ReadingX,  ///< of the accelerometer, along its axes
  ReadingY,
  ReadingZ,
  ReadingNorm,
  Temperature,
};

/// Colourings that stand together in a menu.
enum class ColoringGroup { Links, Uncertainty, Shape, Classes, Readings };

/// The ends of a scale, in the unit that is shown.
using ColorRange = ValueRange;

/// A value that is looked for on a scale.
struct ScaleLimit {
  enum class Kind { Goal, Limit };
  Kind kind = Kind::Goal;
  double value = 0;
  friend bool operator==(const ScaleLimit&, const ScaleLimit&) = default;
};

/// Values of cells that are no part of a reconstruction.
struct CellReadings {
  std::unordered_map<CellId, Eigen::Vector3d> acceleration_g;
  std::unordered_map<CellId, double> temperature_c;
  std::unordered_map<CellId, double> surface_distance_m;
};

/// One row of the table of colourings: all that the views know about a Coloring. Texts are to be translated in the
/// context hexoderm::Coloring (coloringName() and its like do).
struct ColoringRow {
  using OfLink = std::optional<double> (*)(const LinkEstimate& link);
  using OfCell = std::optional<double> (*)(const CellMetrics& figures, const CellReadings& readings, std::size_t index);

  Coloring coloring{};
  ColoringGroup group{};
  const char* name = nullptr;  ///< in menus
  const char* unit = "";       ///< unit of the values; empty for classes

  // Values in the unit, absent where they are not known. Classes have neither.
  OfLink of_link = nullptr;
  OfCell of_cell = nullptr;  ///< `index`: of the cell in the figures

  // The ends of the scale; classes have none.
  /// Usual ones, the same for every skin and every result, so that two pictures can be compared.
  std::optional<ColorRange> range{};
  /// They are fitted to the values that are shown, unless the operator has fixed them; else they are the usual ones.
  bool is_fitted = true;
  double least_span = 1;                       ///< a smaller spread is no difference worth seeing
  std::optional<double> center{};              ///< of signed values: lies in the middle of the scale
  std::optional<double> goal{};                ///< what is wanted of the values
  double SolverOptions::*limit_rad = nullptr;  ///< the angle beyond which a link is no skin link

  bool colors_links = false;          ///< in the graph, where the other colourings colour cells
  const char* graph_title = nullptr;  ///< in the graph's legend; null: the graph does not offer the colouring
  const char* patch_title =
      nullptr;  ///< in the legend of the 3D view, without the unit; null: the 3D view does not offer it
  const char* missing = nullptr;  ///< reason why the 3D view cannot offer it where no cell has a value
};

/// The rows, in the order of Coloring.
std::span<const ColoringRow> coloringTable();
const ColoringRow& coloringRow(Coloring coloring);

/// Has a scale; the others are classes.
bool isQuantity(Coloring coloring);
/// Changes with the readings.
bool isReading(Coloring coloring);

/// What is wanted of the values, and from where on they are bad; of signed values at both ends.
std::vector<ScaleLimit> limitsOf(Coloring coloring, const SolverOptions& options);

/// The values of all cells in the order of the figures.
std::vector<std::optional<double>> cellValues(Coloring coloring, const CellMetrics& figures,
                                              const CellReadings& readings);
/// True if at least one cell has a value or a class.
bool hasValues(Coloring coloring, const CellMetrics& figures, const CellReadings& readings);
/// The values that a scale is fitted to, the same for the graph and the 3D view: those of the used links where links
/// have the figure, else those of the cells.
std::vector<std::optional<double>> scaledValues(Coloring coloring, const Reconstruction& reconstruction,
                                                const CellMetrics& figures, const CellReadings& readings);
/// The ends of the scale of these values, of a quantity. `fixed`: by the operator.
ColorRange rangeOf(Coloring coloring, const std::vector<std::optional<double>>& values,
                   const std::optional<ColorRange>& fixed);

// The words for colours in the user's language, the same in the graph and in the 3D view.

/// "link quality", for menus.
QString coloringName(Coloring coloring);

/// The title with its unit, for the graph's legend: "residual, rms over poses, °".
QString graphTitle(Coloring coloring);
/// The same for the legend of the 3D view; of classes the name.
QString patchTitle(Coloring coloring);

/// The reason why the cells of the 3D view can't be coloured by it; empty if they can.
QString whyNoColoring(Coloring coloring, bool has_values);

/// "patch 3", where patches are classes. `index` counts from 0.
QString patchWord(std::size_t index);
/// The word for cells and links without a value or a class.
QString notKnownWord();

}  // namespace hexoderm
