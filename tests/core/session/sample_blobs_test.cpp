// Raw samples as bytes: every layout brings back every bit, and no bytes bring it down.

#include "hexoderm/session/sample_blobs.h"

#include "tests/support/sample_matchers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using test::expectSameFrames;

constexpr double kLsb_g = 0.004;  // no float

/// Cells come and go; readings up to what 16 bits hold.
std::vector<SampleFrame> framesInSteps() {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> steps(-32767, 32767);
  std::vector<SampleFrame> frames(20);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    frames[k].time_s = 0.001 * static_cast<double>(k);
    const std::uint32_t cells = k < 10 ? 7 : static_cast<std::uint32_t>(k % 4);
    for (std::uint32_t id = 1; id <= cells; ++id) {
      const Eigen::Vector3d lsb(steps(random), steps(random), steps(random));
      frames[k].samples.push_back({CellId(id), lsb * kLsb_g});
    }
  }
  frames[3].samples[0].acceleration_g = Eigen::Vector3d(32767, -32767, 0) * kLsb_g;
  frames[4].means = {{CellId(9), {0.1, 0.2, 0.3}, {1e-9, 0, 1}, 20}};
  frames[5].temperatures = {{CellId(9), 36.6}};
  return frames;
}

/// The first number of the bytes.
std::uint32_t widthOf(const Bytes& bytes) { return bytes.at(0); }

TEST(SampleBlobs, WholeStepsOfAPartThatIsHeldStillTakeAByteANumber) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> noise(-63, 63);
  std::vector<SampleFrame> frames(50);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    for (std::uint32_t id = 1; id <= 100; ++id) {
      const Eigen::Vector3d lsb(noise(random), noise(random), 250 + noise(random));
      frames[k].samples.push_back({CellId(id), lsb * kLsb_g});
    }
  }
  const Bytes still = encodeFrames(frames, kLsb_g);
  EXPECT_EQ(still.size(), 16 + 50 * 20 + 100 * 10 + 49 * 100 * 3);
  expectSameFrames(decodeFrames(still, "here"), frames);
  // A step of 127 still fits, one of 128 does not: that frame is written whole, and the next one refers to it.
  for (const auto& [step, more] : {std::pair(127, 0), std::pair(128, 2 * 7 * 100)}) {
    const auto set = [&](std::size_t frame, const Eigen::Vector3d& lsb) {
      for (CellSample& sample : frames[frame].samples) sample.acceleration_g = lsb * kLsb_g;
    };
    for (std::size_t frame = 0; frame < frames.size(); ++frame) set(frame, {1, 0, -1});
    for (const std::size_t frame : {18U, 20U, 21U}) set(frame, Eigen::Vector3d::Zero());
    set(19, Eigen::Vector3d(0, 0, step));
    const Bytes bytes = encodeFrames(frames, kLsb_g);
    EXPECT_EQ(bytes.size(), still.size() + static_cast<std::size_t>(more)) << step;
    expectSameFrames(decodeFrames(bytes, "here"), frames);
  }
}

TEST(SampleBlobs, WholeStepsTakeTwoBytesANumber) {
  const std::vector<SampleFrame> frames = framesInSteps();
  const Bytes bytes = encodeFrames(frames, kLsb_g);
  EXPECT_EQ(widthOf(bytes), 2U);
  EXPECT_LT(bytes.size(), encodeFrames(frames).size());
  expectSameFrames(decodeFrames(bytes, "here"), frames);
}

TEST(SampleBlobs, OtherNumbersTakeFourOrEight) {
  std::vector<SampleFrame> frames = framesInSteps();
  EXPECT_EQ(widthOf(encodeFrames(frames)), 8U);
  expectSameFrames(decodeFrames(encodeFrames(frames), "here"), frames);
  for (const double odd : {32768 * kLsb_g, kLsb_g / 2, -0.0, 1e300, 0.1 + 1e-9}) {
    frames[19].samples[2].acceleration_g.y() = odd;
    const Bytes bytes = encodeFrames(frames, kLsb_g);
    EXPECT_EQ(widthOf(bytes), 8U) << odd;
    expectSameFrames(decodeFrames(bytes, "here"), frames);
  }
  for (SampleFrame& frame : frames) {
    frame.means.clear();
    frame.temperatures.clear();
    for (CellSample& sample : frame.samples) sample.acceleration_g = {0.5, -0.0, 0.25};
  }
  const Bytes bytes = encodeFrames(frames, kLsb_g);
  EXPECT_EQ(widthOf(bytes), 4U);
  expectSameFrames(decodeFrames(bytes, "here"), frames);
}

TEST(SampleBlobs, BytesThatAreCutOffOrChangedAreRefusedOrRead) {
  for (const double lsb_g : {kLsb_g, 0.0}) {
    const Bytes whole = encodeFrames(framesInSteps(), lsb_g);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_THROW(decodeFrames({whole.data(), size}, "here"), FormatError) << size;
    }
    std::mt19937 random(2);
    for (int k = 0; k < 3'000; ++k) {
      Bytes changed = whole;
      changed[random() % 40] = static_cast<std::uint8_t>(random());
      changed[random() % changed.size()] = static_cast<std::uint8_t>(random());
      try {
        for (const SampleFrame& frame : decodeFrames(changed, "here")) {
          for (const CellSample& sample : frame.samples) ASSERT_TRUE(sample.acceleration_g.allFinite());
        }
      } catch (const FormatError&) {
      }
    }
  }
}

TEST(SampleBlobs, CellsOfNoFrameBeforeAreRefused) {
  Bytes bytes = encodeFrames(framesInSteps(), kLsb_g);
  bytes.at(16 + 8 + 3) |= 0x80;  // the first frame's count of samples
  EXPECT_THROW(decodeFrames(bytes, "here"), FormatError);
}

}  // namespace
}  // namespace hexoderm
