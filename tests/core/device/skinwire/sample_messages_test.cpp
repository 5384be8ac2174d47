#include "hexoderm/device/skinwire/sample_messages.h"

#include "hexoderm/device/skinwire/codec.h"
#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/support/sample_matchers.h"
#include "tests/support/testing.h"

namespace hexoderm::skinwire {
namespace {

constexpr double kLsb_g = 0.0039;

SampleFrame quantised(double time_s, std::uint32_t cells) {
  SampleFrame frame{time_s};
  for (std::uint32_t id = 1; id <= cells; ++id) {
    frame.samples.push_back({CellId(id), Eigen::Vector3d(id % 512, -1.0, 256) * kLsb_g});
  }
  return frame;
}

std::vector<Samples> encoded(const SampleFrame& frame) {
  std::vector<Samples> out;
  SampleEncoder(kLsb_g).encode(frame, out);
  return out;
}
SampleFrame decoded(const Samples& message) {
  SampleFrame frame;
  decodeTick(message, 0, kLsb_g, frame);
  return frame;
}

TEST(SampleMessages, ReadingsBetweenTheStepsGoAsFloats) {
  const SampleFrame frame{0, {{CellId(5), {0.25, 0.1, -1}}, {CellId(6), Eigen::Vector3d(1, 2, 3) * kLsb_g}}};
  SampleEncoder encoder(kLsb_g);
  std::vector<Samples> out;
  encoder.encode(frame, out);
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out[0].cells, std::vector<std::uint32_t>{6});
  EXPECT_EQ(out[1].cells, std::vector<std::uint32_t>{5});
  EXPECT_EQ(out[1].acceleration_g, (std::vector<float>{0.25F, 0.1F, -1.0F}));
  EXPECT_EQ(out[1].sequence, 1U);
  EXPECT_EQ(encoder.sequence(), 2U);
}

TEST(SampleMessages, MeansAndTemperaturesComeBack) {
  const SampleFrame frame{2, {}, {{CellId(1), {0, 0.5, -1}, {0.25, 0.5, 0}, 12}}, {{CellId(1), 36.5}}};
  const std::vector<Samples> out = encoded(frame);
  ASSERT_EQ(out.size(), 2U);
  test::expectSameFrame(decoded(out[0]), {2, {}, frame.means});
  test::expectSameFrame(decoded(out[1]), {2, {}, {}, frame.temperatures});
}

TEST(SampleMessages, WhatDoesNotFitABatchGoesOneByOne) {
  std::vector<SampleFrame> frames = {quantised(1, 17), quantised(1.001, 17), quantised(1.0025, 17)};
  SampleEncoder encoder(kLsb_g);
  std::vector<Samples> out;
  encoder.encodeBatch(frames, out);
  EXPECT_EQ(out.size(), 3U);
  out.clear();
  frames = {quantised(1, 17), quantised(1.001, 16)};
  encoder.encodeBatch(frames, out);
  EXPECT_EQ(out.size(), 2U);
  out.clear();
  frames = {quantised(1, 500), quantised(1.001, 500)};
  SampleEncoder datagrams(kLsb_g, kMaxDatagram);
  datagrams.encodeBatch(frames, out);
  EXPECT_GT(out.size(), 4U);
}

TEST(SampleMessages, NumbersThatAreNotFiniteAreLeftOutAndBadTimesRefused) {
  const std::vector<Samples> out =
      encoded({0,
               {{CellId(1), {0, 0, std::nan("")}}, {CellId(2), {0, 0, 1e300}}, {CellId(3), {0, 0, 0.5}}},
               {},
               {{CellId(1), std::nan("")}}});
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].cells, std::vector<std::uint32_t>{3});
  for (const double time_s : {-1.0, std::nan("")}) {
    EXPECT_THROW(encoded({time_s, {{CellId(3), {0, 0, 0.5}}}}), InvalidArgument);
  }
}

}  // namespace
}  // namespace hexoderm::skinwire
