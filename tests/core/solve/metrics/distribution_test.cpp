#include "hexoderm/solve/metrics/distribution.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

TEST(Distribution, HasRoundBinsThatHoldEveryValue) {
  std::mt19937 random(7);
  for (const double size : {1e-4, 0.03, 1.0, 17.0, 4e5}) {
    std::normal_distribution<double> normal(size, size / 3);
    std::vector<double> values(500);
    for (double& value : values) value = normal(random);
    const Distribution d = distributionOf(values, 16);
    ASSERT_FALSE(d.bins.empty());
    EXPECT_LE(d.bins.size(), 16U);
    EXPECT_GE(d.bins.size(), 5U) << "a histogram of two bins says little";
    std::size_t count = 0;
    const double width = d.bins.front().upper - d.bins.front().lower;
    const double digits = width / std::pow(10.0, std::floor(std::log10(width) + 1e-9));
    EXPECT_TRUE(std::abs(digits - 1) < 1e-6 || std::abs(digits - 2) < 1e-6 || std::abs(digits - 5) < 1e-6) << width;
    for (std::size_t k = 0; k < d.bins.size(); ++k) {
      count += d.bins[k].count;
      EXPECT_NEAR(d.bins[k].upper - d.bins[k].lower, width, 1e-9 * width);
      if (k == 0) continue;
      EXPECT_DOUBLE_EQ(d.bins[k].lower, d.bins[k - 1].upper);
    }
    EXPECT_EQ(count, values.size());
    EXPECT_LE(d.lower(), d.least);
    EXPECT_GE(d.upper(), d.largest);
    for (const double value : values) {
      const std::size_t bin = binOf(d.bins, value).value();
      EXPECT_GE(value, d.bins[bin].lower - 1e-9 * size);
      EXPECT_LE(value, d.bins[bin].upper + 1e-9 * size);
    }
    EXPECT_EQ(binOf(d.bins, d.upper() + size), std::nullopt);
    EXPECT_LE(binValues(values).size(), 40U);
    EXPECT_GE(binValues(values).size(), 8U);
  }
}

TEST(Distribution, KnowsItsMiddleAndItsEnds) {
  const Distribution d = distributionOf({4, 1, 3, 2, 5}, 10);
  EXPECT_EQ(d.count, 5U);
  EXPECT_DOUBLE_EQ(d.least, 1);
  EXPECT_DOUBLE_EQ(d.median, 3);
  EXPECT_DOUBLE_EQ(d.percentile_95, 4.8);
  EXPECT_DOUBLE_EQ(d.largest, 5);
}

TEST(Distribution, OfEqualValuesIsOneBinAboutThem) {
  for (const double value : {0.0, 2.0, 0.37, -5.5}) {
    const Distribution d = distributionOf({value, value, value}, 16);
    ASSERT_EQ(d.bins.size(), 1U) << value;
    EXPECT_EQ(d.bins[0].count, 3U);
    const double rounding = 1e-12 * std::abs(value);
    EXPECT_LE(d.lower(), value + rounding);
    EXPECT_GE(d.upper(), value - rounding);
    EXPECT_GT(d.upper() - d.lower(), 0.01 * std::abs(value)) << "figures on its axis can be told apart";
  }
}

TEST(Distribution, LeavesOutWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(distributionOf({nan, 1, infinity, 2, -infinity}, 8).count, 2U);
  EXPECT_TRUE(distributionOf({nan}, 8).bins.empty());
  EXPECT_TRUE(distributionOf({}, 8).bins.empty());
  EXPECT_TRUE(binValues({}).empty());
  EXPECT_EQ(binValues({3.2}).size(), 1U);
  EXPECT_EQ(binOf({}, 1), std::nullopt);
  EXPECT_EQ(binOf(distributionOf({1, 2}, 8).bins, nan), std::nullopt);
}

}  // namespace
}  // namespace hexoderm
