#include "widgets/coloring/coloring.h"

#include "hexoderm/util/units.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cmath>

namespace hexoderm {
namespace {

std::optional<double> inDegrees(std::optional<double> angle_rad) {
  return angle_rad ? std::optional(toDegrees(*angle_rad)) : std::nullopt;
}

std::optional<double> inMillimetres(std::optional<double> length_m) {
  return length_m ? std::optional(toMillimetres(*length_m)) : std::nullopt;
}

template <class Map>
std::optional<typename Map::mapped_type> lookedUp(const Map& known, CellId cell) {
  const auto found = known.find(cell);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

/// The size of one of a link's angles, which exist only together with its figures.
template <double LinkEstimate::*Angle>
std::optional<double> sizeOfAngle(const LinkEstimate& link) {
  return link.hasFigures() ? std::optional(toDegrees(std::abs(link.*Angle))) : std::nullopt;
}

/// One of a cell's angles or lengths among its figures.
template <std::vector<std::optional<double>> CellFigures::*Angles>
std::optional<double> angleOfCell(const CellFigures& figures, const CellReadings& /*readings*/, std::size_t index) {
  return inDegrees((figures.*Angles)[index]);
}
template <std::vector<std::optional<double>> CellFigures::*Lengths>
std::optional<double> lengthOfCell(const CellFigures& figures, const CellReadings& /*readings*/, std::size_t index) {
  return inMillimetres((figures.*Lengths)[index]);
}

template <int Axis>
std::optional<double> readingOfCell(const CellFigures& figures, const CellReadings& readings, std::size_t index) {
  const auto g = lookedUp(readings.acceleration_g, figures.cells[index]);
  return g ? std::optional((*g)[Axis]) : std::nullopt;
}
std::optional<double> normOfCell(const CellFigures& figures, const CellReadings& readings, std::size_t index) {
  const auto g = lookedUp(readings.acceleration_g, figures.cells[index]);
  return g ? std::optional(g->norm()) : std::nullopt;
}
std::optional<double> temperatureOfCell(const CellFigures& figures, const CellReadings& readings, std::size_t index) {
  return lookedUp(readings.temperature_c, figures.cells[index]);
}
std::optional<double> surfaceDistanceOfCell(const CellFigures& figures, const CellReadings& readings,
                                            std::size_t index) {
  return inMillimetres(lookedUp(readings.surface_distance_m, figures.cells[index]));
}

// The scales of quantities end beyond good values, so that these can be told apart, and where bad is bad enough.
constexpr std::array kTable = {
    ColoringRow{.coloring = Coloring::LinkQuality,
                .group = ColoringGroup::Links,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "link quality"),
                .colors_links = true,
                .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "link quality"),
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "link quality")},
    ColoringRow{.coloring = Coloring::Residual,
                .group = ColoringGroup::Links,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "residual"),
                .unit = "°",
                .of_link = [](const LinkEstimate& link) { return inDegrees(link.knownResidual()); },
                .of_cell = angleOfCell<&CellFigures::residual_rad>,
                .range = ColorRange{0, 2},
                .open_above = true,
                .colors_links = true,
                .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "residual, rms over poses"),
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "worst link's residual"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "No link was measured yet")},
    ColoringRow{.coloring = Coloring::Deviation,
                .group = ColoringGroup::Links,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "predicted deviation"),
                .unit = "°",
                .of_link = [](const LinkEstimate& link) { return inDegrees(link.knownSigma()); },
                .of_cell = angleOfCell<&CellFigures::sigma_rad>,
                .range = ColorRange{0, 6},
                .open_above = true,
                .colors_links = true,
                .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "predicted deviation"),
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "worst link's predicted deviation"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "No link was measured yet")},
    ColoringRow{.coloring = Coloring::Bend,
                .group = ColoringGroup::Links,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "bend"),
                .unit = "°",
                .of_link = sizeOfAngle<&LinkEstimate::bend_rad>,
                .range = ColorRange{0, 30},
                .open_above = true,
                .colors_links = true,
                .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "bend, either way")},
    ColoringRow{.coloring = Coloring::Twist,
                .group = ColoringGroup::Links,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "twist"),
                .unit = "°",
                .of_link = sizeOfAngle<&LinkEstimate::twist_rad>,
                .range = ColorRange{0, 20},
                .open_above = true,
                .colors_links = true,
                .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "twist, either way")},
    ColoringRow{.coloring = Coloring::Yaw,
                .group = ColoringGroup::Links,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "yaw"),
                .unit = "°",
                .of_link = sizeOfAngle<&LinkEstimate::yaw_rad>,
                .range = ColorRange{0, 6},
                .open_above = true,
                .colors_links = true,
                .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "yaw, either way")},
    ColoringRow{.coloring = Coloring::PositionUncertainty,
                .group = ColoringGroup::Uncertainty,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "position uncertainty"),
                .unit = "mm",
                .of_cell = lengthOfCell<&CellFigures::position_95_m>,
                .range = ColorRange{0, 6},
                .open_above = true,
                .sign = "±",
                .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "position known to (95 %)"),
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "position uncertainty (95 %)"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "This result states no uncertainties")},
    ColoringRow{.coloring = Coloring::OrientationUncertainty,
                .group = ColoringGroup::Uncertainty,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "orientation uncertainty"),
                .unit = "°",
                .of_cell = angleOfCell<&CellFigures::orientation_95_rad>,
                .range = ColorRange{0, 6},
                .open_above = true,
                .sign = "±",
                .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "orientation known to (95 %)"),
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "orientation uncertainty (95 %)"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "This result states no uncertainties")},
    ColoringRow{.coloring = Coloring::PathDistance,
                .group = ColoringGroup::Shape,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "distance from the origin"),
                .unit = "mm",
                .of_cell = lengthOfCell<&CellFigures::path_length_m>,
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "distance from the origin along the path"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "This result holds no paths from the origin")},
    ColoringRow{.coloring = Coloring::SurfaceDistance,
                .group = ColoringGroup::Shape,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "distance from the fitted surface"),
                .unit = "mm",
                .of_cell = surfaceDistanceOfCell,
                .range = ColorRange{-3, 3},
                .open_below = true,
                .open_above = true,
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "distance from the fitted surface"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "No surface was fitted yet")},
    ColoringRow{.coloring = Coloring::PlacedBy,
                .group = ColoringGroup::Classes,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "placed by"),
                .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "placed by")},
    ColoringRow{.coloring = Coloring::Patch,
                .group = ColoringGroup::Classes,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "patch"),
                .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "patch"),
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "patch")},
    ColoringRow{
        .coloring = Coloring::BodyPart,
        .group = ColoringGroup::Classes,
        .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "body part"),
        .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "body part"),
        .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "body part"),
        .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "The skin does not say which body part its cells are on")},
    ColoringRow{.coloring = Coloring::ReadingX,
                .group = ColoringGroup::Readings,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "reading x"),
                .unit = "g",
                .of_cell = readingOfCell<0>,
                .range = ColorRange{-1, 1},
                .open_below = true,
                .open_above = true,
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "newest reading along x"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "There are no readings: connect a skin")},
    ColoringRow{.coloring = Coloring::ReadingY,
                .group = ColoringGroup::Readings,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "reading y"),
                .unit = "g",
                .of_cell = readingOfCell<1>,
                .range = ColorRange{-1, 1},
                .open_below = true,
                .open_above = true,
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "newest reading along y"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "There are no readings: connect a skin")},
    ColoringRow{.coloring = Coloring::ReadingZ,
                .group = ColoringGroup::Readings,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "reading z"),
                .unit = "g",
                .of_cell = readingOfCell<2>,
                .range = ColorRange{-1, 1},
                .open_below = true,
                .open_above = true,
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "newest reading along z"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "There are no readings: connect a skin")},
    ColoringRow{.coloring = Coloring::ReadingNorm,
                .group = ColoringGroup::Readings,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "reading, norm"),
                .unit = "g",
                .of_cell = normOfCell,
                .range = ColorRange{0.8, 1.2},
                .open_below = true,
                .open_above = true,
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "norm of the newest reading"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "There are no readings: connect a skin")},
    ColoringRow{.coloring = Coloring::Temperature,
                .group = ColoringGroup::Readings,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "temperature"),
                .unit = "°C",
                .of_cell = temperatureOfCell,
                .range = ColorRange{15, 45},
                .open_below = true,
                .open_above = true,
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "temperature"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "The skin sends no temperatures")}};

/// The next of 100, 200, 500, 1,000 ... mm.
double roundLength(const std::vector<std::optional<double>>& values) {
  double largest = 0;
  for (const auto& value : values) largest = std::max(largest, value.value_or(0));
  constexpr double kSmallest = 100;
  for (double decade = kSmallest;; decade *= 10) {
    for (const double step : {1.0, 2.0, 5.0}) {
      if (step * decade >= largest) return step * decade;
    }
  }
}

}  // namespace

std::span<const ColoringRow> coloringTable() { return kTable; }

const ColoringRow& coloringRow(Coloring coloring) { return kTable.at(static_cast<std::size_t>(coloring)); }

bool isQuantity(Coloring coloring) {
  const ColoringRow& row = coloringRow(coloring);
  return row.of_link != nullptr || row.of_cell != nullptr;
}

bool isReading(Coloring coloring) { return coloringRow(coloring).group == ColoringGroup::Readings; }

std::vector<std::optional<double>> cellValues(Coloring coloring, const CellFigures& figures,
                                              const CellReadings& readings) {
  std::vector<std::optional<double>> values(figures.cells.size());
  const ColoringRow& row = coloringRow(coloring);
  if (row.of_cell == nullptr) return values;
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = row.of_cell(figures, readings, k);
  return values;
}

bool hasValues(Coloring coloring, const CellFigures& figures, const CellReadings& readings) {
  if (coloring == Coloring::BodyPart) return !figures.body_parts.empty();
  const ColoringRow& row = coloringRow(coloring);
  if (row.of_cell == nullptr) return true;
  for (std::size_t k = 0; k < figures.cells.size(); ++k) {
    if (row.of_cell(figures, readings, k)) return true;
  }
  return false;
}

ColorRange colorRange(Coloring coloring, const std::vector<std::optional<double>>& values) {
  if (coloring == Coloring::PathDistance) return {0, roundLength(values)};
  return coloringRow(coloring).range.value_or(ColorRange{});
}

}  // namespace hexoderm
