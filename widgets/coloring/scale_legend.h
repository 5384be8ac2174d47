#pragma once

#include "widgets/coloring/coloring.h"

#include <QString>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// All that a legend says of the scale of a quantity.
struct ScaleLegend {
  /// More bins are narrower than what a hand points at.
  static constexpr std::size_t kBins = 24;

  Coloring coloring = Coloring::Residual;
  ColorRange range;
  bool is_fixed = false;  ///< by the operator
  ValueHistogram counts;  ///< of what is coloured
  std::vector<ScaleLimit> limits;
  std::optional<std::pair<double, double>> extremes;  ///< the smallest and the largest value

  friend bool operator==(const ScaleLegend&, const ScaleLegend&) = default;
};

/// `shown`: the values of what is coloured. `scaled`: those that the scale is fitted to (scaledValues()).
ScaleLegend makeScaleLegend(Coloring coloring, const std::vector<std::optional<double>>& shown,
                            const std::vector<std::optional<double>>& scaled, const std::optional<ColorRange>& fixed,
                            const SolverOptions& options);

// The words of a legend, in the user's language and locale.

/// "0.25": with as many decimals as tell steps of the range apart.
QString valueOnScale(double value, const ColorRange& range);
/// "0.25 mm", "6°"
QString valueWithUnit(double value, const ColorRange& range, Coloring coloring);
/// "goal" or "limit"
QString limitWord(ScaleLimit::Kind kind);
/// "all within the goal of 3 mm": of the limits that lie outside of the scale, where that can be said of all values;
/// empty otherwise.
QString limitBeyondText(const ScaleLegend& legend);
/// "0.20 to 0.24 mm: 3 cells". `bin` is below 0 or at kBins for what lies beyond an end.
QString binText(const ScaleLegend& legend, int bin);
/// "from 0.2 to 0.9 mm, fitted to these cells; 1 beyond": for screen readers.
QString scaleText(const ScaleLegend& legend);

}  // namespace hexoderm
