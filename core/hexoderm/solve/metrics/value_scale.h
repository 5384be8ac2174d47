#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

// Scales for figures of many cells or links: where a scale ends, where its ticks stand, and how many values lie where.
// Units are those of the values. Absent values and such that are no finite number count as not known.

/// 1, 2 or 5 times a power of ten, not below `least`; positive.
double roundStep(double least);

/// The ends of a scale, low < high.
struct ValueRange {
  double low = 0;
  double high = 1;
  friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

/// How a range is chosen for values.
struct ValueRangeOptions {
  /// The scale is at least this wide, so that values that hardly differ don't look as if they did; positive.
  double least_span = 1;
  /// Lies in the middle of the scale: of signed values zero, as a rule.
  std::optional<double> center{};
};

/// The ends that a scale needs to show these values: those of the values, rounded outwards to a number that can be
/// read. Values that lie far apart from all others (by more than twice the width of these; at either end a twentieth
/// of the values, 20 at most and one at least, which don't count for that width) are left beyond the end, as with them
/// the others would all look alike; who shows the scale must say so (ValueHistogram::above). Never with fewer than six
/// values.
///
/// Of values that are all the same, of a single one and of none the range is `least_span` wide. A range of values that
/// are not negative does not begin below zero. O(n).
ValueRange fitRange(std::span<const std::optional<double>> values, const ValueRangeOptions& options);

/// Multiples of 1, 2 or 5 times a power of ten within the range, at most `most` of them (2 at least), ascending.
struct ValueTicks {
  std::vector<double> values;
  int decimals = 0;  ///< that it takes to write them
};
ValueTicks roundTicks(const ValueRange& range, std::size_t most);  ///< round values within the range, at most so many

/// Number of values in each of equally wide bins from end to end. A value at the upper end lies in the last bin.
struct ValueHistogram {
  std::vector<std::size_t> counts;
  std::size_t below = 0;  ///< the lower end
  std::size_t above = 0;  ///< the upper end
  std::size_t unknown = 0;

  [[nodiscard]] std::size_t largest() const;  ///< of the counts; 0 without bins
  friend bool operator==(const ValueHistogram&, const ValueHistogram&) = default;
};
/// Throws InvalidArgument for no bins, and for a range that is none.
ValueHistogram countValues(std::span<const std::optional<double>> values, const ValueRange& range, std::size_t bins);

}  // namespace hexoderm
