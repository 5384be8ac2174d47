#include "hexoderm/solve/metrics/value_scale.h"

#include "hexoderm/base/error.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace hexoderm {
namespace {

constexpr std::size_t kMinForOutliers = 6;
constexpr std::size_t kMaxOutliers = 20;
constexpr double kFarApart = 2;      // times the width of the others
constexpr double kEndRounding = 40;  // ends are rounded to less than the range's width divided by this
constexpr double kSlack = 1e-9;      // share of a step that rounding errors may take

std::vector<double> finiteValues(std::span<const std::optional<double>> values) {
  std::vector<double> numbers;
  numbers.reserve(values.size());
  for (const std::optional<double>& value : values) {
    if (value && std::isfinite(*value)) numbers.push_back(*value);
  }
  return numbers;
}

/// How many values at an end may lie beyond the scale.
std::size_t mostOutliers(std::size_t values) { return std::clamp<std::size_t>(values / 20, 1, kMaxOutliers); }

/// The value that as many are smaller than as may be outliers.
double leastOfTheCrowd(std::vector<double> values) {
  if (values.size() < kMinForOutliers) return *std::ranges::min_element(values);
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(mostOutliers(values.size()));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// The largest value without those that lie far above all others, which begin at `least`.
double largestOfTheCrowd(std::vector<double> values, double least, double least_span) {
  if (values.size() < kMinForOutliers) return *std::ranges::max_element(values);
  const std::size_t outliers = mostOutliers(values.size());
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(outliers + 1);
  std::partial_sort(values.begin(), end, values.end(), std::greater<>());
  // From below, so that a second value far out does not hide behind a third one.
  for (std::size_t k = outliers; k > 0; --k) {
    if (values[k - 1] - values[k] > kFarApart * std::max(values[k] - least, least_span)) return values[k];
  }
  return values.front();
}

/// Rounded outwards; the ends of a range that is none of the computer's making stay as they are.
ValueRange rounded(double low, double high) {
  const double step = roundStep((high - low) / kEndRounding);
  return {step * std::floor(low / step + kSlack), step * std::ceil(high / step - kSlack)};
}

ValueRange fitAround(double center, std::vector<double> values, double least_span) {
  for (double& value : values) value = std::abs(value - center);
  const double reach = values.empty() ? 0 : largestOfTheCrowd(values, 0, least_span / 2);
  const double half = rounded(0, std::max(reach, least_span / 2)).high;
  return {center - half, center + half};
}

}  // namespace

double roundStep(double least) {
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * decade >= least * (1 - kSlack)) return step * decade;
  }
  return 10 * decade;
}

ValueRange fitRange(std::span<const std::optional<double>> values, const ValueRangeOptions& options) {
  if (!(options.least_span > 0)) throw InvalidArgument("fitRange: least_span must be positive");
  std::vector<double> numbers = finiteValues(values);
  if (options.center) return fitAround(*options.center, std::move(numbers), options.least_span);
  if (numbers.empty()) return {0, options.least_span};
  const bool is_positive = *std::ranges::min_element(numbers) >= 0;
  double high = largestOfTheCrowd(numbers, leastOfTheCrowd(numbers), options.least_span);
  for (double& number : numbers) number = -number;
  double low = -largestOfTheCrowd(numbers, leastOfTheCrowd(numbers), options.least_span);
  if (high - low < options.least_span) {
    const double middle = 0.5 * (low + high);
    low = middle - 0.5 * options.least_span;
    if (is_positive) low = std::max(low, 0.0);
    high = low + options.least_span;
  }
  return rounded(low, high);
}

ValueTicks roundTicks(const ValueRange& range, std::size_t most) {
  const double width = range.high - range.low;
  ValueTicks ticks;
  if (!(width > 0) || !std::isfinite(width)) return ticks;
  double step = roundStep(width / static_cast<double>(std::max<std::size_t>(most, 2)));
  const auto first = [&] { return std::ceil(range.low / step - kSlack); };
  const auto last = [&] { return std::floor(range.high / step + kSlack); };
  // One tick more than there are steps stands in a range that begins at a tick.
  while (last() - first() + 1 > static_cast<double>(std::max<std::size_t>(most, 2))) step = roundStep(1.5 * step);
  // Not -0: nobody writes that.
  for (double k = first(); k <= last(); ++k) ticks.values.push_back(k == 0 ? 0.0 : k * step);
  ticks.decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - kSlack)));
  return ticks;
}

std::size_t ValueHistogram::largest() const { return counts.empty() ? 0 : *std::ranges::max_element(counts); }

ValueHistogram countValues(std::span<const std::optional<double>> values, const ValueRange& range, std::size_t bins) {
  if (bins == 0 || !(range.low < range.high)) throw InvalidArgument("countValues: bins and low < high needed");
  ValueHistogram histogram;
  histogram.counts.resize(bins);
  for (const std::optional<double>& value : values) {
    if (!value || !std::isfinite(*value)) {
      ++histogram.unknown;
    } else if (*value < range.low) {
      ++histogram.below;
    } else if (*value > range.high) {
      ++histogram.above;
    } else {
      const double place = (*value - range.low) / (range.high - range.low) * static_cast<double>(bins);
      ++histogram.counts[std::min(static_cast<std::size_t>(place), bins - 1)];
    }
  }
  return histogram;
}

}  // namespace hexoderm
