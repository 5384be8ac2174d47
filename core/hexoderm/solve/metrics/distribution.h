#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

/// The value that a share of ascending values is below, interpolated linearly; there must be one.
double quantileOf(const std::vector<double>& sorted, double share);

/// A bar of a histogram: values from `lower` on and below `upper`. The last bin has its upper end too.
struct ValueBin {
  double lower = 0;
  double upper = 0;
  std::size_t count = 0;
};

/// How values are spread, for a histogram: in bins of one width, which is 1, 2 or 5 times a power of ten, whose edges
/// are multiples of it. In the unit of the values.
struct Distribution {
  std::vector<ValueBin> bins;  ///< neighbours share an edge; empty without values
  std::size_t count = 0;
  double least = 0;
  double median = 0;
  double percentile_95 = 0;  ///< interpolated linearly, as the median is
  double largest = 0;

  [[nodiscard]] double lower() const { return bins.empty() ? 0 : bins.front().lower; }  ///< where the first bin begins
  [[nodiscard]] double upper() const { return bins.empty() ? 1 : bins.back().upper; }   ///< where the last bin ends
};

/// `most_bins`: at least 2. Values that are not finite are left out. A value on an edge counts in the upper bin, but
/// for the last edge.
Distribution distributionOf(std::vector<double> values, std::size_t most_bins);
/// The bins of a distribution, of which there are about twice the root of the number of values and 40 at most.
std::vector<ValueBin> binValues(const std::vector<double>& values);
/// The bin of a distribution that a value is in; none beyond them.
std::optional<std::size_t> binOf(std::span<const ValueBin> bins, double value);

}  // namespace hexoderm
