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

/// Everything that cells sent, bit for bit.
inline void expectSameFrame(const SampleFrame& a, const SampleFrame& b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a.time_s), std::bit_cast<std::uint64_t>(b.time_s));
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t k = 0; k < a.samples.size(); ++k) {
    EXPECT_EQ(a.samples[k].cell, b.samples[k].cell);
    EXPECT_TRUE(sameBits(a.samples[k].acceleration_g, b.samples[k].acceleration_g)) << "sample " << k;
  }
  ASSERT_EQ(a.means.size(), b.means.size());
  for (std::size_t k = 0; k < a.means.size(); ++k) {
    EXPECT_EQ(a.means[k].cell, b.means[k].cell);
    EXPECT_EQ(a.means[k].count, b.means[k].count);
    EXPECT_TRUE(sameBits(a.means[k].mean_g, b.means[k].mean_g)) << "mean " << k;
    EXPECT_TRUE(sameBits(a.means[k].variance_g2, b.means[k].variance_g2)) << "mean " << k;
  }
  ASSERT_EQ(a.temperatures.size(), b.temperatures.size());
  for (std::size_t k = 0; k < a.temperatures.size(); ++k) {
    EXPECT_EQ(a.temperatures[k].cell, b.temperatures[k].cell);
    EXPECT_EQ(a.temperatures[k].temperature_c, b.temperatures[k].temperature_c);
  }
}

inline void expectSameFrames(const std::vector<SampleFrame>& a, const std::vector<SampleFrame>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    SCOPED_TRACE("frame " + std::to_string(k));
    expectSameFrame(a[k], b[k]);
  }
}

}  // namespace hexoderm::test
