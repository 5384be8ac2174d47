#pragma once

#include "hexoderm/device/sample_frame.h"
#include "tests/support/testing.h"

#include <bit>

namespace hexoderm::test {

/// Same bits, so that -0 and 0 are not the same.
template <class A, class B>
bool sameBits(const A& a, const B& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return false;
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
      if (std::bit_cast<std::uint64_t>(a(i, j)) != std::bit_cast<std::uint64_t>(b(i, j))) return false;
    }
  }
  return true;
}

/// Two lists are equally long, and `expect(a, b)` holds of their items.
template <class Items, class Expect>
void expectSameItems(const Items& a, const Items& b, Expect expect) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    SCOPED_TRACE("item " + std::to_string(k));
    expect(a[k], b[k]);
  }
}

/// Everything that cells sent, bit for bit.
inline void expectSameFrame(const SampleFrame& a, const SampleFrame& b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a.time_s), std::bit_cast<std::uint64_t>(b.time_s));
  expectSameItems(a.samples, b.samples, [](const CellSample& x, const CellSample& y) {
    EXPECT_EQ(x.cell, y.cell);
    EXPECT_TRUE(sameBits(x.acceleration_g, y.acceleration_g));
  });
  expectSameItems(a.means, b.means, [](const CellMean& x, const CellMean& y) {
    EXPECT_EQ(x.cell, y.cell);
    EXPECT_EQ(x.count, y.count);
    EXPECT_TRUE(sameBits(x.mean_g, y.mean_g));
    EXPECT_TRUE(sameBits(x.variance_g2, y.variance_g2));
  });
  expectSameItems(a.temperatures, b.temperatures, [](const CellTemperature& x, const CellTemperature& y) {
    EXPECT_EQ(x.cell, y.cell);
    EXPECT_EQ(x.temperature_c, y.temperature_c);
  });
}

inline void expectSameFrames(const std::vector<SampleFrame>& a, const std::vector<SampleFrame>& b) {
  expectSameItems(a, b, expectSameFrame);
}

}  // namespace hexoderm::test
