#include "widgets/coloring/cell_coloring.h"

#include "hexoderm/util/units.h"

#include <algorithm>

namespace hexoderm {
namespace {

using Values = std::vector<std::optional<double>>;

template <class Convert>
Values converted(const Values& values, Convert convert) {
  Values result(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (values[k]) result[k] = convert(*values[k]);
  }
  return result;
}

template <class Map, class Convert>
Values lookedUp(const std::vector<CellId>& cells, const Map& known, Convert convert) {
  Values result(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto found = known.find(cells[k]);
    if (found != known.end()) result[k] = convert(found->second);
  }
  return result;
}

/// The next of 100, 200, 500, 1,000 ... mm.
double roundLength(const Values& values) {
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

bool isQuantity(CellColoring coloring) {
  return coloring != CellColoring::LinkQuality && coloring != CellColoring::Patch && coloring != CellColoring::BodyPart;
}

bool isReading(CellColoring coloring) {
  return coloring >= CellColoring::ReadingX && coloring <= CellColoring::Temperature;
}

Values cellValues(CellColoring coloring, const CellFigures& figures, const CellReadings& readings) {
  const auto axis = [&](int k) {
    return lookedUp(figures.cells, readings.acceleration_g, [k](const Eigen::Vector3d& g) { return g[k]; });
  };
  switch (coloring) {
    case CellColoring::Residual:
      return converted(figures.residual_rad, toDegrees);
    case CellColoring::Deviation:
      return converted(figures.sigma_rad, toDegrees);
    case CellColoring::PositionUncertainty:
      return converted(figures.position_95_m, toMillimetres);
    case CellColoring::OrientationUncertainty:
      return converted(figures.orientation_95_rad, toDegrees);
    case CellColoring::PathDistance:
      return converted(figures.path_length_m, toMillimetres);
    case CellColoring::SurfaceDistance:
      return lookedUp(figures.cells, readings.surface_distance_m, toMillimetres);
    case CellColoring::ReadingX:
      return axis(0);
    case CellColoring::ReadingY:
      return axis(1);
    case CellColoring::ReadingZ:
      return axis(2);
    case CellColoring::ReadingNorm:
      return lookedUp(figures.cells, readings.acceleration_g, [](const Eigen::Vector3d& g) { return g.norm(); });
    case CellColoring::Temperature:
      return lookedUp(figures.cells, readings.temperature_c, [](double celsius) { return celsius; });
    case CellColoring::LinkQuality:
    case CellColoring::Patch:
    case CellColoring::BodyPart:
      break;
  }
  return Values(figures.cells.size());
}

bool hasValues(CellColoring coloring, const CellFigures& figures, const CellReadings& readings) {
  const auto any = [](const auto& values) {
    return std::ranges::any_of(values, [](const auto& value) { return value.has_value(); });
  };
  switch (coloring) {
    case CellColoring::Residual:
      return any(figures.residual_rad);
    case CellColoring::Deviation:
      return any(figures.sigma_rad);
    case CellColoring::PositionUncertainty:
      return any(figures.position_95_m);
    case CellColoring::OrientationUncertainty:
      return any(figures.orientation_95_rad);
    case CellColoring::PathDistance:
      return any(figures.path_length_m);
    case CellColoring::SurfaceDistance:
      return !readings.surface_distance_m.empty();
    case CellColoring::BodyPart:
      return !figures.body_parts.empty();
    case CellColoring::ReadingX:
    case CellColoring::ReadingY:
    case CellColoring::ReadingZ:
    case CellColoring::ReadingNorm:
      return !readings.acceleration_g.empty();
    case CellColoring::Temperature:
      return !readings.temperature_c.empty();
    case CellColoring::LinkQuality:
    case CellColoring::Patch:
      break;
  }
  return true;
}

ColorRange colorRange(CellColoring coloring, const Values& values) {
  switch (coloring) {
    case CellColoring::Residual:
      return {0, kResidualScaleEnd_deg};
    case CellColoring::Deviation:
      return {0, kDeviationScaleEnd_deg};
    case CellColoring::PositionUncertainty:
      return {0, kPositionScaleEnd_mm};
    case CellColoring::OrientationUncertainty:
      return {0, kOrientationScaleEnd_deg};
    case CellColoring::PathDistance:
      return {0, roundLength(values)};
    case CellColoring::SurfaceDistance:
      return {-3, 3};
    case CellColoring::ReadingX:
    case CellColoring::ReadingY:
    case CellColoring::ReadingZ:
      return {-1, 1};
    case CellColoring::ReadingNorm:
      return {0.8, 1.2};
    case CellColoring::Temperature:
      return {15, 45};
    case CellColoring::LinkQuality:
    case CellColoring::Patch:
    case CellColoring::BodyPart:
      break;
  }
  return {};
}

std::vector<Rgb> cellColors(CellColoring coloring, const CellFigures& figures, const CellReadings& readings,
                            const SceneColors& colors) {
  const std::size_t count = figures.cells.size();
  std::vector<Rgb> result(count, colors.neutral);
  if (coloring == CellColoring::LinkQuality) {
    for (std::size_t k = 0; k < count; ++k) {
      if (figures.quality[k]) result[k] = colors.quality.at(static_cast<std::size_t>(*figures.quality[k]));
    }
  } else if (coloring == CellColoring::Patch) {
    const std::size_t patches = count > 0 ? figures.patch.back() + 1 : 0;
    for (std::size_t k = 0; k < count; ++k) result[k] = categoryColor(colors, figures.patch[k], patches);
  } else if (coloring == CellColoring::BodyPart) {
    for (std::size_t k = 0; k < count; ++k) {
      if (figures.body_part[k]) result[k] = categoryColor(colors, *figures.body_part[k], figures.body_parts.size());
    }
  } else {
    const Values values = cellValues(coloring, figures, readings);
    const ColorRange range = colorRange(coloring, values);
    for (std::size_t k = 0; k < count; ++k) {
      if (values[k]) result[k] = onScale(colors.scale, (*values[k] - range.low) / (range.high - range.low));
    }
  }
  return result;
}

}  // namespace hexoderm
