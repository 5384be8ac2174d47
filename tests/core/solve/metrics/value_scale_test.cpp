#include "hexoderm/solve/metrics/value_scale.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;
using Values = std::vector<std::optional<double>>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// 1, 1.1, ... 1.9
Values crowd() {
  Values values;
  for (int k = 0; k < 10; ++k) values.emplace_back(1 + 0.1 * k);
  return values;
}

void expectRange(const ValueRange& range, double low, double high) {
  EXPECT_NEAR(range.low, low, 1e-9);
  EXPECT_NEAR(range.high, high, 1e-9);
}

TEST(ValueScale, EndsWithTheValuesRoundedOutwards) {
  expectRange(fitRange(crowd(), {.least_span = 0.1}), 1, 1.9);
  expectRange(fitRange(Values{0.2113, 0.8961, 0.5}, {.least_span = 0.1}), 0.2, 0.9);
  const ValueRange small = fitRange(Values{3e-7, 8e-7}, {.least_span = 1e-9});
  EXPECT_LE(small.low, 3e-7 * (1 + 1e-9));
  EXPECT_GE(small.high, 8e-7 * (1 - 1e-9));
  EXPECT_LT(small.high - small.low, 5.6e-7);
  expectRange(fitRange(Values{-12.0, 7.0}, {.least_span = 1}), -12, 7);
}

TEST(ValueScale, OneValueFarFromAllOthersIsLeftBeyondTheEnd) {
  Values values = crowd();
  values.emplace_back(20);
  const ValueRange range = fitRange(values, {.least_span = 0.1});
  expectRange(range, 1, 1.9);
  EXPECT_EQ(countValues(values, range, 4).above, 1U) << "and it is counted";
  values.emplace_back(-15);
  expectRange(fitRange(values, {.least_span = 0.1}), 1, 1.9);
  EXPECT_EQ(countValues(values, range, 4).below, 1U);
}

TEST(ValueScale, ValuesThatAreNotAloneOrNotFarOffStayWithin) {
  Values two = crowd();
  two.emplace_back(20);
  two.emplace_back(21);
  expectRange(fitRange(two, {.least_span = 0.1}), 1, 21);
  Values near = crowd();
  near.emplace_back(3.3);
  EXPECT_GE(fitRange(near, {.least_span = 0.1}).high, 3.3);
  expectRange(fitRange(Values{1.0, 1.1, 1.2, 1.3, 20.0}, {.least_span = 0.1}), 1, 20);
}

TEST(ValueScale, OfManyValuesAFewMayLieBeyond) {
  Values values;
  for (int k = 0; k < 400; ++k) values.emplace_back(1 + 0.002 * k);
  for (int k = 0; k < 15; ++k) values.emplace_back(50 + k);
  const ValueRange range = fitRange(values, {.least_span = 0.1});
  EXPECT_LT(range.high, 2);
  EXPECT_EQ(countValues(values, range, 8).above, 15U);
  for (int k = 0; k < 10; ++k) values.emplace_back(80 + k);
  EXPECT_GE(fitRange(values, {.least_span = 0.1}).high, 64) << "more than 20 are no outliers";
}

TEST(ValueScale, ValuesThatHardlyDifferDoNotLookAsIfTheyDid) {
  expectRange(fitRange(Values{0.5, 0.5, 0.5}, {.least_span = 0.2}), 0.4, 0.6);
  expectRange(fitRange(Values{0.5}, {.least_span = 0.2}), 0.4, 0.6);
  expectRange(fitRange(Values{0.0, 0.0}, {.least_span = 0.2}), 0, 0.2);
  expectRange(fitRange(Values{-3.0}, {.least_span = 2}), -4, -2);
  expectRange(fitRange({}, {.least_span = 0.2}), 0, 0.2);
  expectRange(fitRange(Values{std::nullopt, std::nullopt}, {.least_span = 5}), 0, 5);
  EXPECT_THROW(fitRange(crowd(), {.least_span = 0}), InvalidArgument);
}

TEST(ValueScale, WhatIsNoNumberIsKeptOut) {
  Values values = crowd();
  values.insert(values.end(), {kNan, kInfinity, -kInfinity, std::nullopt});
  const ValueRange range = fitRange(values, {.least_span = 0.1});
  expectRange(range, 1, 1.9);
  const ValueHistogram counted = countValues(values, range, 3);
  EXPECT_EQ(counted.unknown, 4U);
  EXPECT_EQ(counted.above + counted.below, 0U);
  expectRange(fitRange(Values{kNan}, {.least_span = 1}), 0, 1);
}

TEST(ValueScale, SignedValuesHaveTheirCenterInTheMiddle) {
  expectRange(fitRange(Values{-1.0, 0.2, 0.4}, {.least_span = 0.1, .center = 0.0}), -1, 1);
  expectRange(fitRange(Values{1.1, 1.05}, {.least_span = 0.1, .center = 1.0}), 0.9, 1.1);
  expectRange(fitRange({}, {.least_span = 0.4, .center = 0.0}), -0.2, 0.2);
  Values values = {-0.2, -0.1, 0.1, 0.2, 0.15, 0.05, -9.0};
  const ValueRange range = fitRange(values, {.least_span = 0.1, .center = 0.0});
  expectRange(range, -0.2, 0.2);
  EXPECT_EQ(countValues(values, range, 2).below, 1U);
}

TEST(ValueScale, TicksAreNumbersThatAreRead) {
  const ValueTicks ticks = roundTicks({0.17, 0.93}, 5);
  EXPECT_THAT(ticks.values, Pointwise(DoubleNear(1e-12), {0.2, 0.4, 0.6, 0.8}));
  EXPECT_EQ(ticks.decimals, 1);
  EXPECT_THAT(roundTicks({0, 6}, 5).values, ElementsAre(0, 2, 4, 6));
  EXPECT_THAT(roundTicks({-1, 1}, 5).values, Pointwise(DoubleNear(1e-12), {-1.0, -0.5, 0.0, 0.5, 1.0}));
  EXPECT_FALSE(std::signbit(roundTicks({-1, 1}, 5).values[2])) << "nobody writes -0";
  EXPECT_EQ(roundTicks({0.0101, 0.0109}, 5).decimals, 4);
  EXPECT_EQ(roundTicks({0, 5000}, 5).decimals, 0);
  for (const double width : {0.03, 0.11, 0.7, 1.0, 3.3, 42.0, 9999.0}) {
    for (const std::size_t most : {2U, 3U, 5U, 8U}) {
      EXPECT_LE(roundTicks({0.1, 0.1 + width}, most).values.size(), most) << width;
      EXPECT_GE(roundTicks({0.1, 0.1 + width}, most).values.size(), most / 4) << width;
    }
  }
  EXPECT_TRUE(roundTicks({1, 1}, 5).values.empty());
}

TEST(ValueScale, EveryValueIsCountedOnce) {
  const Values values = {0.0, 0.1, 0.25, 0.5, 0.99, 1.0, 1.01, -0.01, std::nullopt};
  const ValueHistogram counted = countValues(values, {0, 1}, 4);
  EXPECT_THAT(counted.counts, ElementsAre(2, 1, 1, 2));
  EXPECT_EQ(counted.below, 1U);
  EXPECT_EQ(counted.above, 1U);
  EXPECT_EQ(counted.unknown, 1U);
  EXPECT_EQ(counted.largest(), 2U);
  EXPECT_THROW(countValues(values, {0, 1}, 0), InvalidArgument);
  EXPECT_THROW(countValues(values, {1, 1}, 4), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
