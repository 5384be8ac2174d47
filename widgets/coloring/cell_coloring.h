#pragma once

#include "hexoderm/device/sample_frame.h"
#include "hexoderm/reconstruction/figures/cell_figures.h"
#include "widgets/style/scene_colors.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace hexoderm {

/// What the colour of a cell in the 3D scene means.
enum class CellColoring {
  LinkQuality,
  Residual,                ///< of the worst link, deg
  Deviation,               ///< predicted, of the worst link, deg
  PositionUncertainty,     ///< 95 %, mm
  OrientationUncertainty,  ///< 95 %, deg
  PathDistance,            ///< from the origin along the path, mm
  SurfaceDistance,         ///< from the fitted surface, signed, mm
  Patch,
  BodyPart,
  ReadingX,  ///< of the accelerometer, along its axes, g
  ReadingY,
  ReadingZ,
  ReadingNorm,
  Temperature,  ///< degrees Celsius
};

/// Has a scale; the others are categories.
bool isQuantity(CellColoring coloring);
/// Changes with the readings.
bool isReading(CellColoring coloring);

/// What cells can be coloured by that no reconstruction holds.
struct CellReadings {
  std::unordered_map<CellId, Eigen::Vector3d> acceleration_g;
  std::unordered_map<CellId, double> temperature_c;
  std::unordered_map<CellId, double> surface_distance_m;
};

/// The quantity for every cell in the unit that is shown; absent where it is not known. Order of the figures.
std::vector<std::optional<double>> cellValues(CellColoring coloring, const CellFigures& figures,
                                              const CellReadings& readings);

/// Whether it says something about any cell.
bool hasValues(CellColoring coloring, const CellFigures& figures, const CellReadings& readings);

/// The ends of a quantity's scale in the unit that is shown. They are the same for every skin, so that two pictures can
/// be compared; only the distance along the path, which a skin's size decides, ends at the next round length.
struct ColorRange {
  double low = 0;
  double high = 1;
};
ColorRange colorRange(CellColoring coloring, const std::vector<std::optional<double>>& values);

/// The colour of every cell's front face; neutral where nothing is known.
std::vector<Rgb> cellColors(CellColoring coloring, const CellFigures& figures, const CellReadings& readings,
                            const SceneColors& colors);

}  // namespace hexoderm
