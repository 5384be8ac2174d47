#include "widgets/coloring/scale_ranges.h"

#include <cmath>

namespace hexoderm {

std::optional<ColorRange> ScaleRanges::fixed(Coloring coloring) const {
  const auto found = fixed_.find(coloring);
  return found == fixed_.end() ? std::nullopt : std::optional(found->second);
}

void ScaleRanges::fix(Coloring coloring, const ColorRange& range) {
  if (!(range.low < range.high) || !std::isfinite(range.low) || !std::isfinite(range.high)) return;
  if (!isQuantity(coloring) || fixed(coloring) == range) return;
  fixed_[coloring] = range;
  emit changed(coloring);
}

void ScaleRanges::release(Coloring coloring) {
  if (fixed_.erase(coloring) > 0) emit changed(coloring);
}

}  // namespace hexoderm
