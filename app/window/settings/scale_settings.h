#pragma once

#include "widgets/coloring/scale_ranges.h"

#include <QSettings>
#include <QString>
#include <QStringList>

namespace hexoderm {

/// The colouring's English name, which no translation changes.
inline QString keptRangeKey(Coloring coloring) {
  return QStringLiteral("colours/") + QString::fromUtf8(coloringRow(coloring).name).replace(' ', '_');
}

/// Fixes the ranges of scales that the operator fixed before, as kept in the settings. What makes no sense there
/// (edited by hand, of another version) is left out.
inline void restoreScaleRanges(ScaleRanges& ranges) {
  const QSettings settings;
  for (const ColoringRow& row : coloringTable()) {
    const QStringList ends = settings.value(keptRangeKey(row.coloring)).toStringList();
    if (ends.size() != 2) continue;
    bool has_low = false;
    bool has_high = false;
    const ColorRange range{ends[0].toDouble(&has_low), ends[1].toDouble(&has_high)};
    if (has_low && has_high) ranges.fix(row.coloring, range);
  }
}

/// Keeps the range of a colouring for the next start, or that it is fixed no longer.
inline void keepScaleRange(const ScaleRanges& ranges, Coloring coloring) {
  QSettings settings;
  const std::optional<ColorRange> range = ranges.fixed(coloring);
  if (range) {
    constexpr int kDigits = 12;
    settings.setValue(keptRangeKey(coloring), QStringList{QString::number(range->low, 'g', kDigits),
                                                          QString::number(range->high, 'g', kDigits)});
  } else {
    settings.remove(keptRangeKey(coloring));
  }
}

}  // namespace hexoderm
