#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

/// Values from `lower` on and below `upper`; the last bin has its upper end too.
struct ValueBin {
  double lower = 0;
  double upper = 0;
  std::size_t count = 0;
};

/// Bins of one width, which is 1, 2 or 5 times a power of ten and of which the ends are multiples, from the least value
/// to the largest: at most `most` of them, and about twice the root of the number of values. Values that are not finite
/// are left out; empty without any other.
inline std::vector<ValueBin> binValues(std::span<const double> values, std::size_t most = 40) {
  double least = 0;
  double largest = 0;
  std::size_t count = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    least = count == 0 ? value : std::min(least, value);
    largest = count == 0 ? value : std::max(largest, value);
    ++count;
  }
  if (count == 0) return {};
  const double wanted =
      std::clamp(2 * std::sqrt(static_cast<double>(count)), 1.0, static_cast<double>(std::max<std::size_t>(most, 1)));
  // All values alike, or as good as: one bin of a width that suits their size.
  const double tiny = 1e-9 * std::max(std::abs(least), std::abs(largest));
  const double spread = std::max(largest - least, tiny > 0 ? tiny : 1e-9);
  double width = std::pow(10.0, std::floor(std::log10(spread / wanted)));
  const auto binsOf = [&](double w) { return std::floor(largest / w) - std::floor(least / w) + 1; };
  constexpr double kSteps[] = {2, 2.5, 2};  // 1, 2, 5, 10
  for (std::size_t k = 0; binsOf(width) > wanted; ++k) width *= kSteps[k % 3];
  const double first = std::floor(least / width);
  std::vector<ValueBin> bins(static_cast<std::size_t>(binsOf(width)));
  for (std::size_t k = 0; k < bins.size(); ++k) {
    bins[k].lower = (first + static_cast<double>(k)) * width;
    bins[k].upper = (first + static_cast<double>(k + 1)) * width;
  }
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    const double place = std::clamp(std::floor(value / width) - first, 0.0, static_cast<double>(bins.size() - 1));
    ++bins[static_cast<std::size_t>(place)].count;
  }
  return bins;
}

/// The bin of binValues() that a value is in; none beyond them.
inline std::optional<std::size_t> binOf(std::span<const ValueBin> bins, double value) {
  if (bins.empty() || !(value >= bins.front().lower) || value > bins.back().upper) return std::nullopt;
  const double width = bins.front().upper - bins.front().lower;
  // As binValues() counts.
  const double place = std::floor(value / width) - std::floor(bins.front().lower / width + 0.5);
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(bins.size() - 1)));
}

}  // namespace hexoderm
