#include "widgets/coloring/scale_legend.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

struct ScaleLegendWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ScaleLegend)
};

QString scaleUnitOf(Coloring coloring) { return QString::fromUtf8(coloringRow(coloring).unit); }

QString withUnit(const QString& number, Coloring coloring) {
  const QString unit = scaleUnitOf(coloring);
  return unit == QStringLiteral("°") ? number + unit : number + QLatin1Char(' ') + unit;
}

QString cellsText(std::size_t count) {
  return count == 1 ? ScaleLegendWords::tr("1 cell")
                    : ScaleLegendWords::tr("%1 cells").arg(QLocale().toString(static_cast<qulonglong>(count)));
}

}  // namespace

ScaleLegend makeScaleLegend(Coloring coloring, const std::vector<std::optional<double>>& shown,
                            const std::vector<std::optional<double>>& scaled, const std::optional<ColorRange>& fixed,
                            const SolverOptions& options) {
  ScaleLegend legend;
  legend.coloring = coloring;
  legend.range = rangeOf(coloring, scaled, fixed);
  legend.is_fixed = fixed.has_value();
  legend.counts = countValues(shown, legend.range, ScaleLegend::kBins);
  legend.limits = limitsOf(coloring, options);
  for (const std::optional<double>& value : shown) {
    if (!value || !std::isfinite(*value)) continue;
    if (!legend.extremes) legend.extremes = {*value, *value};
    legend.extremes->first = std::min(legend.extremes->first, *value);
    legend.extremes->second = std::max(legend.extremes->second, *value);
  }
  return legend;
}

QString valueOnScale(double value, const ColorRange& range) {
  constexpr double kTellApart = 100;
  const double step = (range.high - range.low) / kTellApart;
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step))), 0, 9);
  return QLocale().toString(value, 'f', decimals);
}

QString valueWithUnit(double value, const ColorRange& range, Coloring coloring) {
  return withUnit(valueOnScale(value, range), coloring);
}

QString limitWord(ScaleLimit::Kind kind) {
  return kind == ScaleLimit::Kind::Goal ? ScaleLegendWords::tr("goal") : ScaleLegendWords::tr("limit");
}

QString limitBeyondText(const ScaleLegend& legend) {
  if (!legend.extremes) return {};
  for (const ScaleLimit& limit : legend.limits) {
    if (limit.kind != ScaleLimit::Kind::Goal) continue;
    const QString value = withUnit(QLocale().toString(limit.value, 'g', 6), legend.coloring);
    if (limit.value > legend.range.high && legend.extremes->second <= limit.value) {
      return ScaleLegendWords::tr("all within the goal of %1").arg(value);
    }
    if (limit.value < legend.range.low && legend.extremes->first > limit.value) {
      return ScaleLegendWords::tr("none within the goal of %1").arg(value);
    }
  }
  return {};
}

QString binText(const ScaleLegend& legend, int bin) {
  const auto bins = static_cast<int>(legend.counts.counts.size());
  const ColorRange& range = legend.range;
  if (bin < 0) {
    return ScaleLegendWords::tr("less than %1: %2")
        .arg(valueWithUnit(range.low, range, legend.coloring), cellsText(legend.counts.below));
  }
  if (bin >= bins) {
    return ScaleLegendWords::tr("more than %1: %2")
        .arg(valueWithUnit(range.high, range, legend.coloring), cellsText(legend.counts.above));
  }
  const double width = (range.high - range.low) / bins;
  return ScaleLegendWords::tr("%1 to %2: %3")
      .arg(valueOnScale(range.low + bin * width, range),
           valueWithUnit(range.low + (bin + 1) * width, range, legend.coloring),
           cellsText(legend.counts.counts[static_cast<std::size_t>(bin)]));
}

QString scaleText(const ScaleLegend& legend) {
  const ColorRange& range = legend.range;
  const bool is_usual = !legend.is_fixed && !coloringRow(legend.coloring).is_fitted;
  const QString state = legend.is_fixed ? ScaleLegendWords::tr("range fixed")
                        : is_usual      ? ScaleLegendWords::tr("usual range")
                                        : ScaleLegendWords::tr("range fitted to what is shown");
  QStringList words = {
      ScaleLegendWords::tr("from %1 to %2, %3")
          .arg(valueOnScale(range.low, range), valueWithUnit(range.high, range, legend.coloring), state)};
  if (legend.counts.below > 0) words << binText(legend, -1);
  if (legend.counts.above > 0) words << binText(legend, static_cast<int>(legend.counts.counts.size()));
  if (legend.counts.unknown > 0) words << ScaleLegendWords::tr("not known: %1").arg(cellsText(legend.counts.unknown));
  for (const ScaleLimit& limit : legend.limits) {
    if (limit.value < range.low || limit.value > range.high) continue;
    words << limitWord(limit.kind) + QLatin1Char(' ') +
                 withUnit(QLocale().toString(limit.value, 'g', 6), legend.coloring);
  }
  const QString beyond = limitBeyondText(legend);
  if (!beyond.isEmpty()) words << beyond;
  return words.join(QStringLiteral("; "));
}

}  // namespace hexoderm
