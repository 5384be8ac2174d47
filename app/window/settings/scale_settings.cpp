#include "app/window/settings/scale_settings.h"

#include "widgets/coloring/scale_ranges.h"

#include <QSettings>
#include <QString>
#include <QStringList>

namespace hexoderm {
namespace {

/// The colouring's English name, which no translation changes.
QString rangeKey(Coloring coloring) {
  return QStringLiteral("colours/") + QString::fromUtf8(coloringRow(coloring).name).replace(' ', '_');
}

}  // namespace

void restoreScaleRanges(ScaleRanges& ranges) {
  const QSettings settings;
  for (const ColoringRow& row : coloringTable()) {
    const QStringList ends = settings.value(rangeKey(row.coloring)).toStringList();
    if (ends.size() != 2) continue;
    bool has_low = false;
    bool has_high = false;
    const ColorRange range{ends[0].toDouble(&has_low), ends[1].toDouble(&has_high)};
    if (has_low && has_high) ranges.fix(row.coloring, range);
  }
}

void keepScaleRange(const ScaleRanges& ranges, Coloring coloring) {
  QSettings settings;
  const std::optional<ColorRange> range = ranges.fixed(coloring);
  if (range) {
    constexpr int kDigits = 12;
    settings.setValue(rangeKey(coloring), QStringList{QString::number(range->low, 'g', kDigits),
                                                      QString::number(range->high, 'g', kDigits)});
  } else {
    settings.remove(rangeKey(coloring));
  }
}

}  // namespace hexoderm
