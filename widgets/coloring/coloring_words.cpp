#include "widgets/coloring/coloring_words.h"

#include <QCoreApplication>
#include <QLocale>

namespace hexoderm {
namespace {

struct ColoringWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::Coloring)
};

/// A number with as few decimals as the ends of the scales have.
QString endNumber(double value) { return QLocale().toString(value, 'g', 6); }

/// "6°", "6 mm"
QString withUnit(const QString& number, const QString& unit) {
  return unit == QStringLiteral("°") ? number + unit : number + QLatin1Char(' ') + unit;
}

}  // namespace

QString coloringName(Coloring coloring) { return ColoringWords::tr(coloringRow(coloring).name); }

ScaleWords graphScaleInWords(Coloring coloring) {
  const ColoringRow& row = coloringRow(coloring);
  const ColorRange range = row.range.value_or(ColorRange{});
  const QString end = QString::fromUtf8(row.sign) + withUnit(endNumber(range.high), QString::fromUtf8(row.unit));
  return {ColoringWords::tr(row.graph_title), endNumber(range.low), ColoringWords::tr("%1 or more").arg(end)};
}

ScaleWords patchScaleInWords(Coloring coloring, const ColorRange& range) {
  const ColoringRow& row = coloringRow(coloring);
  const QString low = endNumber(range.low);
  const QString high = endNumber(range.high);
  return {patchTitle(coloring), row.open_below ? ColoringWords::tr("%1 or less").arg(low) : low,
          row.open_above ? ColoringWords::tr("%1 or more").arg(high) : high};
}

QString patchTitle(Coloring coloring) {
  const ColoringRow& row = coloringRow(coloring);
  if (row.patch_title == nullptr) return coloringName(coloring);
  const QString title = ColoringWords::tr(row.patch_title);
  const QString unit = QString::fromUtf8(row.unit);
  return unit.isEmpty() ? title : title + QStringLiteral(", ") + unit;
}

QString whyNoColoring(Coloring coloring, bool has_values) {
  const char* missing = coloringRow(coloring).missing;
  return has_values || missing == nullptr ? QString() : ColoringWords::tr(missing);
}

QString patchWord(std::size_t index) { return ColoringWords::tr("patch %1").arg(index + 1); }

QString notKnownWord() { return ColoringWords::tr("not known"); }

}  // namespace hexoderm
