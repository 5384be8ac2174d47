#pragma once

#include <cstddef>
#include <vector>

namespace hexoderm {

/// The value that a share of ascending values is below, interpolated linearly; there must be one.
double quantileOf(const std::vector<double>& sorted, double share);

/// How values are spread, for a histogram: in bins of one width, which is 1, 2 or 5 times a power of ten, whose edges
/// are multiples of it. In the unit of the values.
struct Distribution {
  /// A bar of the histogram.
  struct Bin {
    double lower = 0;
    double upper = 0;
    std::size_t count = 0;
  };
  std::vector<Bin> bins;  ///< neighbours share an edge; empty without values
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

}  // namespace hexoderm
