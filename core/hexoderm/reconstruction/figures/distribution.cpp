#include "hexoderm/reconstruction/figures/distribution.h"

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
  for (double decade = std::pow(10.0, std::floor(std::log10(wanted)));; decade *= 10) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double width = step * decade;
      if (width >= wanted * (1 - 1e-9) && binsOf(least, largest, width) <= most_bins) return width;
    }
  }
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
  for (const double value : values) {
    const double bin = std::floor(value / width) - first;
    ++result.bins[std::min(static_cast<std::size_t>(std::max(bin, 0.0)), count - 1)].count;
  }
  return result;
}

}  // namespace hexoderm
