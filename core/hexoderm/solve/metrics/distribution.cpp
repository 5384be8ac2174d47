#include "hexoderm/solve/metrics/distribution.h"

#include "hexoderm/solve/metrics/value_scale.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hexoderm {
namespace {

constexpr double kMedian = 0.5;
constexpr double kNearlyAll = 0.95;

/// Edges are multiples of a width, so that a range may need one bin more than its length says.
std::size_t binsOf(double least, double largest, double width) {
  const double first = std::floor(least / width);
  return static_cast<std::size_t>(std::max(1.0, std::ceil(largest / width) - first));
}

double roundWidth(double least, double largest, std::size_t most_bins) {
  const double range = largest - least;
  const double size = std::max(std::abs(least), std::abs(largest));
  // Values that are all alike have a bin about them, as wide as a figure of their size can be read.
  constexpr double kRounding = 1e-6;
  const double width_of_one = size > 0 ? size / 10 : 1.0;
  const double wanted = range > kRounding * size ? range / static_cast<double>(most_bins) : width_of_one;
  double width = roundStep(wanted);
  while (binsOf(least, largest, width) > most_bins) width = roundStep(1.5 * width);
  return width;
}

/// Of a value that is in one of the bins.
std::size_t placeIn(std::span<const ValueBin> bins, double value) {
  const auto above = std::upper_bound(bins.begin(), bins.end(), value,
                                      [](double of_value, const ValueBin& bin) { return of_value < bin.lower; });
  return above == bins.begin() ? 0 : static_cast<std::size_t>(above - bins.begin()) - 1;
}

}  // namespace

double quantileOf(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Distribution distributionOf(std::vector<double> values, std::size_t most_bins) {
  if (most_bins < 2) throw std::logic_error("a distribution needs two bins");
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  Distribution result;
  if (values.empty()) return result;
  std::ranges::sort(values);
  result.count = values.size();
  result.least = values.front();
  result.largest = values.back();
  result.median = quantileOf(values, kMedian);
  result.percentile_95 = quantileOf(values, kNearlyAll);
  const double width = roundWidth(result.least, result.largest, most_bins);
  const double first = std::floor(result.least / width);
  const std::size_t count = binsOf(result.least, result.largest, width);
  for (std::size_t k = 0; k < count; ++k) {
    const double edge = first + static_cast<double>(k);
    result.bins.push_back({edge * width, (edge + 1) * width, 0});
  }
  for (const double value : values) ++result.bins[placeIn(result.bins, value)].count;
  return result;
}

std::vector<ValueBin> binValues(const std::vector<double>& values) {
  constexpr double kMax = 40;
  const auto count = static_cast<double>(std::max<std::size_t>(1, values.size()));
  return distributionOf(values, static_cast<std::size_t>(std::min(kMax, 2 * std::sqrt(count)))).bins;
}

std::optional<std::size_t> binOf(std::span<const ValueBin> bins, double value) {
  if (bins.empty() || !(value >= bins.front().lower) || value > bins.back().upper) return std::nullopt;
  return placeIn(bins, value);
}

}  // namespace hexoderm
