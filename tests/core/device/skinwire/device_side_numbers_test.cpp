// What skinwire.h counts on a device without a double: conversions of floats, means and variances.

#include "hexoderm/device/skinwire/skinwire.h"

#include "tests/support/testing.h"

#include <bit>

namespace hexoderm::skinwire {
namespace {

TEST(DeviceSide, FloatsAndDoublesAreConvertedAsProcessorsDo) {
  std::mt19937_64 random(4);
  const auto expectSame = [](double from) {
    const float in_c = skinwire_float_of_double(std::bit_cast<std::uint64_t>(from));
    const auto expected = static_cast<float>(from);
    if (std::isnan(from)) {
      EXPECT_TRUE(std::isnan(in_c));
    } else {
      EXPECT_EQ(std::bit_cast<std::uint32_t>(in_c), std::bit_cast<std::uint32_t>(expected)) << from;
    }
    EXPECT_EQ(skinwire_is_finite(in_c), std::isfinite(expected)) << from;
  };
  for (int k = 0; k < 200'000; ++k) {
    const auto single = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isnan(single)) {
      ASSERT_EQ(skinwire_double_of_float(single), std::bit_cast<std::uint64_t>(static_cast<double>(single))) << single;
    }
    expectSame(std::bit_cast<double>(random()));
    // Of the magnitudes that a single has, and beyond by a little; and halfway between two of them.
    const double near =
        std::ldexp(1 + static_cast<double>(random() >> 12U) * 0x1p-52, static_cast<int>(random() % 290) - 155);
    expectSame(near);
    if (std::isfinite(single)) {
      const float next = std::nextafter(single, std::numeric_limits<float>::infinity());
      if (std::isfinite(next)) expectSame((static_cast<double>(single) + static_cast<double>(next)) / 2);
    }
  }
}

TEST(DeviceSide, AveragesAsExactlyAsFloatsAllow) {
  std::mt19937_64 random(7);
  constexpr float kLsb_g = 1.0F / 256;
  for (const int count : {1, 2, 3, 100, 65'535, 70'000}) {
    for (const int spread : {1, 10, 65'536}) {
      skinwire_average average{};
      double sum = 0;
      double squares = 0;
      const int counted = std::min<int>(count, SKINWIRE_MAX_AVERAGE);
      std::vector<double> values;
      for (int k = 0; k < count; ++k) {
        const auto value = static_cast<std::int16_t>(
            spread == 65'536 ? (k % 2 == 0 ? INT16_MIN : INT16_MAX)
                             : 256 + static_cast<int>(random() % static_cast<unsigned>(spread)));
        const std::array<std::int16_t, 3> reading = {value, 0, INT16_MIN};
        skinwire_average_add(&average, reading.data());
        if (k < counted) values.push_back(value);
      }
      for (const double value : values) sum += value;
      for (const double value : values) squares += (value - sum / counted) * (value - sum / counted);
      std::array<float, 3> mean_g{};
      std::array<float, 3> variance_g2{};
      std::uint32_t counted_in_c = 0;
      ASSERT_TRUE(skinwire_average_take(&average, kLsb_g, mean_g.data(), variance_g2.data(), &counted_in_c));
      EXPECT_EQ(counted_in_c, static_cast<std::uint32_t>(counted));
      EXPECT_FLOAT_EQ(mean_g[0], static_cast<float>(sum / counted / 256));
      EXPECT_EQ(mean_g[1], 0);
      EXPECT_EQ(mean_g[2], -128);
      EXPECT_FLOAT_EQ(variance_g2[0], count < 2 ? 0 : static_cast<float>(squares / (counted - 1) / 65'536));
      EXPECT_EQ(variance_g2[2], 0);
      EXPECT_FALSE(skinwire_average_take(&average, kLsb_g, mean_g.data(), variance_g2.data(), &counted_in_c));
    }
  }
}

}  // namespace
}  // namespace hexoderm::skinwire
