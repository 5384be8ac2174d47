#include "widgets/coloring/coloring.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/assess.h"

#include <QCoreApplication>
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

/// One of a link's angles, which exist only together with its figures.
template <double LinkEstimate::*Angle>
std::optional<double> angleOfLink(const LinkEstimate& link) {
  return link.hasMetrics() ? std::optional(toDegrees(link.*Angle)) : std::nullopt;
}
std::optional<double> sizeOfYaw(const LinkEstimate& link) {
  return link.hasMetrics() ? std::optional(toDegrees(std::abs(link.yaw_rad))) : std::nullopt;
}

/// One of a cell's angles or lengths among its figures.
template <std::vector<std::optional<double>> CellMetrics::*Angles>
std::optional<double> angleOfCell(const CellMetrics& figures, const CellReadings& /*readings*/, std::size_t index) {
  return inDegrees((figures.*Angles)[index]);
}
template <std::vector<std::optional<double>> CellMetrics::*Lengths>
std::optional<double> lengthOfCell(const CellMetrics& figures, const CellReadings& /*readings*/, std::size_t index) {
  return inMillimetres((figures.*Lengths)[index]);
}

template <int Axis>
std::optional<double> readingOfCell(const CellMetrics& figures, const CellReadings& readings, std::size_t index) {
  const auto g = lookedUp(readings.acceleration_g, figures.cells[index]);
  return g ? std::optional((*g)[Axis]) : std::nullopt;
}
std::optional<double> normOfCell(const CellMetrics& figures, const CellReadings& readings, std::size_t index) {
  const auto g = lookedUp(readings.acceleration_g, figures.cells[index]);
  return g ? std::optional(g->norm()) : std::nullopt;
}
std::optional<double> temperatureOfCell(const CellMetrics& figures, const CellReadings& readings, std::size_t index) {
  return lookedUp(readings.temperature_c, figures.cells[index]);
}
std::optional<double> surfaceDistanceOfCell(const CellMetrics& figures, const CellReadings& readings,
                                            std::size_t index) {
  return inMillimetres(lookedUp(readings.surface_distance_m, figures.cells[index]));
}

// What rows of one kind have in common.

constexpr ColoringRow angleOfLinks(ColoringRow row) {
  row.group = ColoringGroup::Links;
  row.unit = "°";
  row.colors_links = true;
  row.missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "No link was measured yet");
  return row;
}
constexpr ColoringRow uncertainty(ColoringRow row) {
  row.group = ColoringGroup::Uncertainty;
  row.least_span = 0.1;
  row.patch_title = row.graph_title;
  return row;
}
constexpr ColoringRow reading(ColoringRow row) {
  row.group = ColoringGroup::Readings;
  row.unit = "g";
  row.is_fitted = false;
  row.missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "There are no readings: connect a skin");
  return row;
}

// The usual scales of quantities end beyond good values, so that these can be told apart, and where bad is bad enough.
constexpr std::array kTable = {
    ColoringRow{.coloring = Coloring::LinkQuality,
                .group = ColoringGroup::Links,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "link quality"),
                .colors_links = true,
                .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "link quality"),
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "link quality")},
    angleOfLinks({.coloring = Coloring::Residual,
                  .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "residual"),
                  .of_link = [](const LinkEstimate& link) { return inDegrees(link.knownResidual()); },
                  .of_cell = angleOfCell<&CellMetrics::residual_rad>,
                  .range = ColorRange{0, 2},
                  .least_span = 0.1,
                  .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "residual, rms over poses"),
                  .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "worst link's residual")}),
    angleOfLinks({.coloring = Coloring::Deviation,
                  .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "predicted deviation"),
                  .of_link = [](const LinkEstimate& link) { return inDegrees(link.knownSigma()); },
                  .of_cell = angleOfCell<&CellMetrics::sigma_rad>,
                  .range = ColorRange{0, 6},
                  .least_span = 0.1,
                  .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "predicted deviation"),
                  .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "worst link's predicted deviation")}),
    angleOfLinks({.coloring = Coloring::Bend,
                  .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "bend"),
                  .of_link = angleOfLink<&LinkEstimate::bend_rad>,
                  .of_cell = angleOfCell<&CellMetrics::bend_rad>,
                  .range = ColorRange{-30, 30},
                  .least_span = 2,
                  .center = 0,
                  .limit_rad = &SolverOptions::max_bend_rad,
                  .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "bend"),
                  .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "largest bend of the cell's links")}),
    angleOfLinks({.coloring = Coloring::Twist,
                  .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "twist"),
                  .of_link = angleOfLink<&LinkEstimate::twist_rad>,
                  .of_cell = angleOfCell<&CellMetrics::twist_rad>,
                  .range = ColorRange{-20, 20},
                  .least_span = 2,
                  .center = 0,
                  .limit_rad = &SolverOptions::max_twist_rad,
                  .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "twist"),
                  .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "largest twist of the cell's links")}),
    angleOfLinks({.coloring = Coloring::Yaw,
                  .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "yaw"),
                  .of_link = sizeOfYaw,
                  .of_cell = angleOfCell<&CellMetrics::yaw_rad>,
                  .range = ColorRange{0, 6},
                  .limit_rad = &SolverOptions::max_yaw_rad,
                  .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "yaw, either way"),
                  .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "largest yaw of the cell's links")}),
    uncertainty(
        {.coloring = Coloring::ShapeUncertainty,
         .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "uncertainty of the shape"),
         .unit = "mm",
         .of_cell = lengthOfCell<&CellMetrics::shape_position_95_m>,
         .range = ColorRange{0, 3},
         .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "uncertainty of the shape (95 %)"),
         .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "This result does not state how well its shape is known")}),
    uncertainty(
        {.coloring = Coloring::ShapeOrientation,
         .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "orientation in the shape"),
         .unit = "°",
         .of_cell = angleOfCell<&CellMetrics::shape_orientation_95_rad>,
         .range = ColorRange{0, 3},
         .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "uncertainty of the orientation in the shape (95 %)"),
         .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "This result does not state how well its shape is known")}),
    uncertainty({.coloring = Coloring::PositionUncertainty,
                 .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "position uncertainty"),
                 .unit = "mm",
                 .of_cell = lengthOfCell<&CellMetrics::position_95_m>,
                 .range = ColorRange{0, 6},
                 .goal = toMillimetres(Goal().position_m),
                 .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "position uncertainty (95 %)"),
                 .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "This result states no uncertainties")}),
    uncertainty({.coloring = Coloring::OrientationUncertainty,
                 .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "orientation uncertainty"),
                 .unit = "°",
                 .of_cell = angleOfCell<&CellMetrics::orientation_95_rad>,
                 .range = ColorRange{0, 6},
                 .goal = toDegrees(Goal().orientation_rad),
                 .graph_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "orientation uncertainty (95 %)"),
                 .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "This result states no uncertainties")}),
    ColoringRow{.coloring = Coloring::PathDistance,
                .group = ColoringGroup::Shape,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "distance from the origin"),
                .unit = "mm",
                .of_cell = lengthOfCell<&CellMetrics::path_length_m>,
                .range = ColorRange{0, 500},
                .least_span = 10,
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "path length from the origin"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "This result holds no paths from the origin")},
    ColoringRow{.coloring = Coloring::SurfaceDistance,
                .group = ColoringGroup::Shape,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "distance from the fitted surface"),
                .unit = "mm",
                .of_cell = surfaceDistanceOfCell,
                .range = ColorRange{-3, 3},
                .least_span = 0.2,
                .center = 0,
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
    reading({.coloring = Coloring::ReadingX,
             .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "reading x"),
             .of_cell = readingOfCell<0>,
             .range = ColorRange{-1, 1},
             .center = 0,
             .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "newest reading along x")}),
    reading({.coloring = Coloring::ReadingY,
             .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "reading y"),
             .of_cell = readingOfCell<1>,
             .range = ColorRange{-1, 1},
             .center = 0,
             .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "newest reading along y")}),
    reading({.coloring = Coloring::ReadingZ,
             .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "reading z"),
             .of_cell = readingOfCell<2>,
             .range = ColorRange{-1, 1},
             .center = 0,
             .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "newest reading along z")}),
    reading({.coloring = Coloring::ReadingNorm,
             .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "reading, norm"),
             .of_cell = normOfCell,
             .range = ColorRange{0.8, 1.2},
             .center = 1,
             .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "norm of the newest reading")}),
    ColoringRow{.coloring = Coloring::Temperature,
                .group = ColoringGroup::Readings,
                .name = QT_TRANSLATE_NOOP("hexoderm::Coloring", "temperature"),
                .unit = "°C",
                .of_cell = temperatureOfCell,
                .range = ColorRange{15, 45},
                .least_span = 5,
                .patch_title = QT_TRANSLATE_NOOP("hexoderm::Coloring", "temperature"),
                .missing = QT_TRANSLATE_NOOP("hexoderm::Coloring", "The skin sends no temperatures")}};

struct ColoringWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::Coloring)
};

QString titleWithUnit(const char* title, Coloring coloring) {
  if (title == nullptr) return coloringName(coloring);
  const QString unit = QString::fromUtf8(coloringRow(coloring).unit);
  const QString words = ColoringWords::tr(title);
  return unit.isEmpty() ? words : words + QStringLiteral(", ") + unit;
}

}  // namespace

std::span<const ColoringRow> coloringTable() { return kTable; }

const ColoringRow& coloringRow(Coloring coloring) { return kTable.at(static_cast<std::size_t>(coloring)); }

bool isQuantity(Coloring coloring) {
  const ColoringRow& row = coloringRow(coloring);
  return row.of_link != nullptr || row.of_cell != nullptr;
}

bool isReading(Coloring coloring) { return coloringRow(coloring).group == ColoringGroup::Readings; }

std::vector<ScaleLimit> limitsOf(Coloring coloring, const SolverOptions& options) {
  const ColoringRow& row = coloringRow(coloring);
  std::vector<ScaleLimit> limits;
  if (row.goal) limits.push_back({ScaleLimit::Kind::Goal, *row.goal});
  if (row.limit_rad == nullptr) return limits;
  const double limit = toDegrees(options.*row.limit_rad);
  if (row.center) limits.push_back({ScaleLimit::Kind::Limit, -limit});
  limits.push_back({ScaleLimit::Kind::Limit, limit});
  return limits;
}

std::vector<std::optional<double>> cellValues(Coloring coloring, const CellMetrics& figures,
                                              const CellReadings& readings) {
  std::vector<std::optional<double>> values(figures.cells.size());
  const ColoringRow& row = coloringRow(coloring);
  if (row.of_cell == nullptr) return values;
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = row.of_cell(figures, readings, k);
  return values;
}

bool hasValues(Coloring coloring, const CellMetrics& figures, const CellReadings& readings) {
  if (coloring == Coloring::BodyPart) return !figures.body_parts.empty();
  const ColoringRow& row = coloringRow(coloring);
  if (row.of_cell == nullptr) return true;
  for (std::size_t k = 0; k < figures.cells.size(); ++k) {
    if (row.of_cell(figures, readings, k)) return true;
  }
  return false;
}

std::vector<std::optional<double>> scaledValues(Coloring coloring, const Reconstruction& reconstruction,
                                                const CellMetrics& figures, const CellReadings& readings) {
  const ColoringRow& row = coloringRow(coloring);
  if (row.of_link == nullptr) return cellValues(coloring, figures, readings);
  std::vector<std::optional<double>> values;
  values.reserve(reconstruction.linkCount());
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      if (link.used) values.push_back(row.of_link(link));
    }
  }
  return values;
}

ColorRange rangeOf(Coloring coloring, const std::vector<std::optional<double>>& values,
                   const std::optional<ColorRange>& fixed) {
  if (fixed) return *fixed;
  const ColoringRow& row = coloringRow(coloring);
  if (!row.is_fitted && row.range) return *row.range;
  return fitRange(values, {.least_span = row.least_span, .center = row.center});
}

QString coloringName(Coloring coloring) { return ColoringWords::tr(coloringRow(coloring).name); }

QString graphTitle(Coloring coloring) { return titleWithUnit(coloringRow(coloring).graph_title, coloring); }

QString patchTitle(Coloring coloring) { return titleWithUnit(coloringRow(coloring).patch_title, coloring); }

QString whyNoColoring(Coloring coloring, bool has_values) {
  const char* missing = coloringRow(coloring).missing;
  return has_values || missing == nullptr ? QString() : ColoringWords::tr(missing);
}

QString patchWord(std::size_t index) { return ColoringWords::tr("patch %1").arg(index + 1); }

QString notKnownWord() { return ColoringWords::tr("not known"); }

}  // namespace hexoderm
