#include "hexoderm/reconstruction/figures/value_bins.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace hexoderm {
namespace {

std::size_t countOf(const std::vector<ValueBin>& bins) {
  std::size_t count = 0;
  for (const ValueBin& bin : bins) count += bin.count;
  return count;
}

TEST(ValueBins, EveryValueIsInTheBinItIsSaidToBeIn) {
  std::mt19937 random(3);
  for (const double size : {1e-6, 0.3, 1.0, 70.0, 1e5}) {
    std::normal_distribution<double> normal(2 * size, size);
    std::vector<double> values(300);
    for (double& value : values) value = normal(random);
    const auto bins = binValues(values);
    EXPECT_EQ(countOf(bins), values.size());
    EXPECT_LE(bins.size(), 41U);
    EXPECT_GE(bins.size(), 8U);
    const double width = bins.front().upper - bins.front().lower;
    const double mantissa = width / std::pow(10.0, std::floor(std::log10(width) + 1e-9));
    EXPECT_TRUE(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 || std::abs(mantissa - 5) < 1e-6);
    EXPECT_NEAR(std::remainder(bins.front().lower, width), 0, 1e-12 * std::max(width, std::abs(bins.front().lower)));
    std::vector<std::size_t> counted(bins.size());
    for (const double value : values) {
      const auto bin = binOf(bins, value);
      ASSERT_TRUE(bin.has_value());
      EXPECT_GE(value, bins[*bin].lower - 1e-9 * size);
      EXPECT_LE(value, bins[*bin].upper + 1e-9 * size);
      ++counted[*bin];
    }
    for (std::size_t k = 0; k < bins.size(); ++k) EXPECT_EQ(counted[k], bins[k].count) << k;
  }
}

TEST(ValueBins, OneValueManyTimesIsOneBin) {
  for (const double value : {0.0, 3.2, -70.0}) {
    const auto bins = binValues(std::vector<double>(5, value));
    ASSERT_EQ(bins.size(), 1U) << value;
    EXPECT_EQ(bins[0].count, 5U);
    EXPECT_EQ(binOf(bins, value), std::optional<std::size_t>(0));
  }
}

TEST(ValueBins, WhatIsNotFiniteIsLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(binValues(std::vector<double>{}).empty());
  EXPECT_TRUE(binValues(std::vector<double>{nan}).empty());
  const auto bins = binValues(std::vector<double>{1, nan, 2, std::numeric_limits<double>::infinity()});
  EXPECT_EQ(countOf(bins), 2U);
  EXPECT_EQ(binOf(bins, nan), std::nullopt);
  EXPECT_EQ(binOf(bins, bins.back().upper + 1), std::nullopt);
  EXPECT_EQ(binOf({}, 1), std::nullopt);
}

}  // namespace
}  // namespace hexoderm
