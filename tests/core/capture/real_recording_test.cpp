// A real accelerometer laid by hand in 13 orientations.

#include "hexoderm/base/text.h"
#include "tests/core/capture/captures_of.h"
#include "tests/support/paths.h"
#include "tests/support/testing.h"

#include <fstream>

namespace hexoderm {
namespace {

using test::Captures;

/// Raw counts to g, as the recording's description says.
std::vector<SampleFrame> recording() {
  std::ifstream file(std::string(HEXODERM_REFERENCE_DATA) + "/real/xsens_static_poses_part1.csv");
  std::vector<SampleFrame> frames;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = split(line, ',');
    Eigen::Vector3d reading_g;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      reading_g(static_cast<int>(axis)) = (parseNumber(fields.at(axis + 1), "count") - 32768) / 4070;
    }
    frames.push_back({parseNumber(fields.at(0), "time"), {{CellId(1), reading_g}}});
  }
  return frames;
}

/// The times in which the standard deviation over 0.5 s (rms of the axes) stays below 6 mg for longer than 1.5 s; in
/// between it is hundreds of mg. Found without the detector.
constexpr std::array kHeld_s = {std::pair(0.03, 52.62),    std::pair(54.72, 64.17),   std::pair(66.97, 76.72),
                                std::pair(79.62, 89.12),   std::pair(92.47, 102.87),  std::pair(105.87, 113.77),
                                std::pair(116.22, 125.47), std::pair(128.22, 135.87), std::pair(138.07, 147.91),
                                std::pair(152.36, 161.11), std::pair(164.31, 172.21), std::pair(176.21, 188.31),
                                std::pair(192.41, 199.96)};

/// Every hold is captured once, and no motion.
Captures capturedOf(const std::vector<SampleFrame>& frames) {
  Captures captures;
  PoseRecorder recorder(captures);
  for (const SampleFrame& frame : frames) recorder.addFrame(frame);
  EXPECT_EQ(captures.poses.size(), kHeld_s.size());
  for (std::size_t k = 0; k < std::min(kHeld_s.size(), captures.poses.size()); ++k) {
    EXPECT_GE(captures.poses[k].start_s, kHeld_s[k].first);
    EXPECT_LE(captures.poses[k].end_s, kHeld_s[k].second);
    EXPECT_FALSE(captures.poses[k].forced);
  }
  return captures;
}

TEST(RealRecording, EveryHoldIsCapturedOnceAndNoMotion) {
  const std::vector<SampleFrame> frames = recording();
  ASSERT_EQ(frames.size(), 19999U);
  const std::vector<CapturedPose> poses = capturedOf(frames).poses;
  for (const CapturedPose& captured : poses) EXPECT_GE(captured.pose->samples.front().count, 70U);
  // It was laid on some sides twice.
  EXPECT_EQ(poses.at(3).repeats, PoseId(1));
  EXPECT_EQ(poses.at(5).repeats, PoseId(2));
  EXPECT_EQ(poses.at(7).repeats, PoseId(3));
  EXPECT_FALSE(poses.at(8).repeats);
}

TEST(RealRecording, IsFoundAlikeAtHalfTheRateAndInAnotherUnitOfGain) {
  std::vector<SampleFrame> frames = recording();
  for (std::size_t k = 0; 2 * k < frames.size(); ++k) frames[k] = frames[2 * k];
  frames.resize(frames.size() / 2);
  for (SampleFrame& frame : frames) frame.samples.front().acceleration_g *= 0.9;
  capturedOf(frames);
}

}  // namespace
}  // namespace hexoderm
