#include "hexoderm/device/sources/skin_stream.h"

#include "tests/core/device/skinwire/collecting_listener.h"
#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/support/options.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using skinwire::Samples;
using Effect = SkinStream::Effect;

class SkinStreamTest : public testing::Test {
 protected:
  Effect take(const skinwire::Message& message) { return take(skinwire::decodeBody(skinwire::encodeBody(message))); }
  Effect take(const skinwire::Decoded& decoded) { return stream.take(decoded, now); }
  void describe() {
    take(skinwire::helloMessage());
    take(skinwire::topologyMessage());
  }
  SourceStatus status() {
    stream.report(SourceState::Streaming, Message::verbatim(std::to_string(++reports)), SkinStream::Clock::now());
    return listener.delivered().status();
  }
  std::size_t frames() { return listener.delivered().frames.size(); }

  CollectingListener listener;
  SkinStream stream{listener};
  SkinStream::Clock::time_point now{};
  int reports = 0;
};

/// One tick of one cell.
Samples oneSample(std::uint32_t cell, std::uint64_t time_us, std::optional<std::uint64_t> sequence = std::nullopt) {
  return {.sequence = sequence, .time_us = time_us, .cells = {cell}, .raw_lsb = {0, 0, 256}};
}

TEST_F(SkinStreamTest, DescribesBeforeItDelivers) {
  EXPECT_EQ(take(skinwire::rawSamples(0, 1000)), Effect::Alive);
  EXPECT_EQ(frames(), 0U);
  take(skinwire::helloMessage());
  EXPECT_FALSE(stream.isDescribed());
  EXPECT_THAT(stream.whatIsMissing().english(), HasSubstr("topology"));
  take(skinwire::topologyMessage());
  EXPECT_TRUE(stream.isDescribed());
  take(skinwire::rawSamples(4, 3000));
  const auto delivered = listener.delivered();
  ASSERT_EQ(delivered.skins.size(), 1U);
  EXPECT_EQ(delivered.skins[0].device.english(), "two cells");
  EXPECT_EQ(delivered.skins[0].neighbors, skinwire::topologyMessage().cells);
  EXPECT_TRUE(delivered.skins[0].can_light_cells && delivered.skins[0].can_turn);
  ASSERT_EQ(delivered.frames.size(), 2U);
  EXPECT_EQ(delivered.frames[1].time_s, 0.004);
  EXPECT_EQ(delivered.frames[1].samples[1].cell, CellId(2));
  EXPECT_EQ(delivered.frames[1].samples[1].acceleration_g, Eigen::Vector3d(-512, 511, 239) * 0.00390625);
  EXPECT_EQ(status().undescribed_samples, 4U) << "those before the description";
}

TEST_F(SkinStreamTest, ACellModelWithoutSenseIsNamedAndLeavesTheSkinUndescribed) {
  take(skinwire::helloWith(&skinwire::Hello::cell_model, R"({"name": "odd", "side_m": -1})"));
  take(skinwire::topologyMessage());
  EXPECT_FALSE(stream.isDescribed());
  EXPECT_THAT(stream.whatIsMissing().english(), HasSubstr("side_m"));
  take(skinwire::helloMessage());
  EXPECT_TRUE(stream.isDescribed());
  EXPECT_EQ(status().rejected_messages, 1U);
}

TEST_F(SkinStreamTest, PartsOfOneTickMayOvertakeEachOther) {
  describe();
  take(oneSample(1, 1000, 0));
  take(oneSample(2, 2000, 2));
  EXPECT_EQ(take(oneSample(1, 2000, 1)), Effect::Alive);
  EXPECT_EQ(frames(), 3U);
  EXPECT_EQ(status().late_frames, 0U);
  EXPECT_EQ(status().lost_samples, 0U);
}

TEST_F(SkinStreamTest, DuplicatesAreFoundWithoutNumbersToo) {
  describe();
  for (int k = 0; k < 2; ++k) {
    Samples samples = skinwire::rawSamples(0, 1000);
    samples.sequence.reset();
    take(samples);
  }
  EXPECT_EQ(frames(), 2U);
  EXPECT_EQ(status().late_frames, 2U);
}

TEST_F(SkinStreamTest, ANewStreamOrConnectionStartsTimeAndNumbersAnew) {
  describe();
  take(oneSample(1, 1'000'000, 5000));
  take(skinwire::helloWith(&skinwire::Hello::stream, skinwire::helloMessage().stream + 1));
  EXPECT_EQ(take(oneSample(1, 1000, 0)), Effect::Alive);
  stream.restart();
  describe();
  EXPECT_EQ(take(oneSample(1, 1000, 0)), Effect::Alive);
  EXPECT_EQ(frames(), 3U);
  EXPECT_EQ(status().lost_samples, 0U);
}

TEST_F(SkinStreamTest, AClockThatIsSetBackCostsHalfASecond) {
  describe();
  const std::uint64_t before_us = 3'600'000'000;
  take(oneSample(1, before_us, 900'000));
  for (std::uint64_t k = 0; k < 200; ++k) take(oneSample(1, 10'000 * k, k));
  EXPECT_EQ(frames(), 151U) << "those of 0.5 s are left out";
  EXPECT_EQ(listener.delivered().frames.back().time_s, 1.99);
  EXPECT_EQ(status().late_frames, 50U);
  EXPECT_EQ(status().clock_restarts, 1U);
  EXPECT_EQ(status().lost_samples, 0U) << "the numbers started anew too";
}

TEST_F(SkinStreamTest, AClockThatWasFarAheadForAMomentCostsHalfASecond) {
  describe();
  take(oneSample(1, 1'000'000));
  take(oneSample(1, skinwire::kMaxTime_us));
  for (std::uint64_t k = 1; k <= 200; ++k) take(oneSample(1, 1'000'000 + 10'000 * k));
  EXPECT_EQ(frames(), 152U);
  take(oneSample(1, 1'000'000'000'000));  // and a jump for good
  take(oneSample(1, 1'000'000'010'000));
  EXPECT_EQ(frames(), 154U);
  EXPECT_EQ(status().clock_restarts, 1U);
}

TEST_F(SkinStreamTest, StragglersAndAClockThatStandsStillAreNoClockSetBack) {
  describe();
  for (std::uint64_t k = 1; k <= 100; ++k) {
    take(oneSample(1, 1'000'000 * k));
    EXPECT_EQ(take(oneSample(2, 1'000'000 * (k - 1))), Effect::Nothing);
  }
  for (int k = 0; k < 1000; ++k) EXPECT_EQ(take(oneSample(1, 5)), Effect::Nothing);
  EXPECT_EQ(frames(), 100U);
  EXPECT_EQ(status().late_frames, 1100U);
  EXPECT_EQ(status().clock_restarts, 0U);
}

TEST_F(SkinStreamTest, NumbersThatStartAnewHideNoLosses) {
  describe();
  take(oneSample(1, 1000, 500));  // nobody listened before
  take(oneSample(1, 2000, 0));
  take(oneSample(1, 3000, 1));
  EXPECT_EQ(status().lost_samples, 0U);
  take(oneSample(1, 4000, 9));
  EXPECT_EQ(status().lost_samples, 7U);
}

/// The two cells, joined or not.
skinwire::Topology twoCells(std::uint32_t id, bool are_joined) {
  skinwire::Topology topology = skinwire::topologyMessage();
  topology.id = id;
  if (!are_joined) {
    for (CellReport& cell : topology.cells) cell.neighbors.clear();
  }
  return topology;
}

TEST_F(SkinStreamTest, ALinkThatComesAndGoesIsPassedOnEveryFewSeconds) {
  describe();
  // 1,000 changes a second for ten seconds, ending apart.
  constexpr std::uint32_t kChanges = 9'999;
  for (std::uint32_t k = 1; k <= kChanges; ++k) {
    now += std::chrono::milliseconds(1);
    take(twoCells(3 + k, k % 2 == 0));
    take(oneSample(1, 1000 * k));
  }
  EXPECT_EQ(status().skin_changes, kChanges);
  EXPECT_EQ(frames(), kChanges) << "samples of cells that are there all the time";
  // Four at once, and then at 3, 6 and 9 s.
  EXPECT_LE(listener.delivered().skins.size(), 1U + 4U + 3U);
  EXPECT_GE(listener.delivered().skins.size(), 1U + 4U);
  now += ChangeBudget::kEvery;
  stream.tend(now);
  EXPECT_EQ(listener.delivered().skins.back().neighbors, twoCells(0, false).cells) << "in the end what is so";
  EXPECT_TRUE(stream.deviceText().empty());
}

TEST_F(SkinStreamTest, WhileChangesWaitTheStatusSaysSo) {
  describe();
  for (std::uint32_t k = 1; k <= 7; ++k) take(twoCells(3 + k, k % 2 == 0));
  EXPECT_THAT(stream.deviceText().english(), HasSubstr("7 times"));
  const std::size_t before = listener.delivered().skins.size();
  take(twoCells(20, true));  // as the listener knows it
  now += ChangeBudget::kEvery;
  stream.tend(now);
  EXPECT_EQ(listener.delivered().skins.size(), before);
}

/// Of cells that state this size of a step.
skinwire::Hello helloOfLsb(double lsb_g) {
  CellModel model = builtInCellModel("hex-bma150");
  model.accelerometer.lsb_g = lsb_g;
  return skinwire::helloWith(&skinwire::Hello::cell_model, cellModelToJson(model));
}

TEST_F(SkinStreamTest, SamplesAreNeverReadByTheModelThatWasBefore) {
  describe();
  for (std::uint32_t k = 1; k <= 5; ++k) {
    take(helloOfLsb(k));
    take(oneSample(1, 1000 * k));
  }
  // The fifth change waits, and so do samples until it is passed on.
  ASSERT_EQ(frames(), 4U);
  EXPECT_EQ(listener.delivered().frames.back().samples[0].acceleration_g.z(), 4 * 256);
  EXPECT_EQ(status().undescribed_samples, 1U);
  now += ChangeBudget::kEvery;
  take(oneSample(1, 9000));
  EXPECT_EQ(listener.delivered().frames.back().samples[0].acceleration_g.z(), 5 * 256);
}

TEST_F(SkinStreamTest, CellsThatAreNotInTheTopologyAreLeftOutAndCounted) {
  describe();
  Samples samples = skinwire::rawSamples(0, 1000);
  samples.cells = {9, 2};
  samples.temperature_cells = {9, 1};
  samples.temperature_c = {20, 21};
  take(samples);
  take(oneSample(9, 9000));
  const auto delivered = listener.delivered();
  ASSERT_EQ(delivered.frames.size(), 2U);
  ASSERT_EQ(delivered.frames[0].samples.size(), 1U);
  EXPECT_EQ(delivered.frames[0].samples[0].cell, CellId(2));
  ASSERT_EQ(delivered.frames[0].temperatures.size(), 1U);
  EXPECT_EQ(delivered.frames[0].temperatures[0].cell, CellId(1));
  EXPECT_TRUE(delivered.frames[1].temperatures.empty());
  EXPECT_EQ(status().unknown_samples, 3U);
}

/// A tick of both cells, in this order or the other.
Samples tickOfBoth(std::uint64_t tick, bool other_order, std::uint64_t step_us) {
  return {.sequence = 2 * tick,
          .time_us = 1000 + step_us * tick,
          .cells = other_order ? std::vector<std::uint32_t>{2, 1} : std::vector<std::uint32_t>{1, 2},
          .raw_lsb = {0, 0, 256, 0, 0, 256}};
}

TEST_F(SkinStreamTest, TheRateIsJudgedInWhateverOrderCellsComeIfNoneIsLost) {
  constexpr std::uint64_t kStated_us = 1000;
  const auto isRateWrong = [this](std::uint64_t step_us, bool is_numbered) {
    stream.restart();
    describe();
    for (std::uint64_t k = 0; k < 200; ++k) {
      Samples samples = tickOfBoth(k, k % 2 == 1, step_us);
      if (!is_numbered) samples.sequence.reset();
      take(samples);
    }
    const std::vector<ProtocolViolation> offences = status().offences;
    return std::ranges::find(offences, ProtocolViolationKind::WrongValue, &ProtocolViolation::kind) != offences.end();
  };
  EXPECT_FALSE(isRateWrong(kStated_us, true));
  EXPECT_FALSE(isRateWrong(2 * kStated_us, false)) << "every other one may have been lost";
  EXPECT_TRUE(isRateWrong(2 * kStated_us, true));
}

TEST_F(SkinStreamTest, ACellTwiceInAMessageIsRefused) {
  describe();
  EXPECT_EQ(take(test::with(skinwire::rawSamples(0, 1000), &Samples::cells, {1, 1})), Effect::Nothing);
  // Nothing remembered of the refused message may be used for one without cells.
  const Samples temperature{.time_us = 2000, .temperature_cells = {1}, .temperature_c = {20}};
  EXPECT_EQ(take(temperature), Effect::Alive);
  EXPECT_EQ(take(skinwire::rawSamples(0, 2000)), Effect::Alive);
  EXPECT_EQ(status().rejected_messages, 1U);
  EXPECT_EQ(frames(), 3U);
}

TEST_F(SkinStreamTest, TheSameCellsAreLookedUpAgainAfterATopologyChanged) {
  describe();
  take(skinwire::rawSamples(0, 1000));
  take(skinwire::Topology{4, 0, 1, {{CellId(2), "", {}}}});
  const Samples temperature{.time_us = 3000, .temperature_cells = {2}, .temperature_c = {20}};
  take(temperature);
  take(skinwire::rawSamples(4, 3000));
  EXPECT_EQ(status().unknown_samples, 2U);
  EXPECT_EQ(listener.delivered().frames.back().samples.size(), 1U);
}

TEST_F(SkinStreamTest, SamplesAndMeansOfOneMomentAreBothDelivered) {
  describe();
  const Samples means{.time_us = 1000, .cells = {1}, .mean_g = {0, 0, 1}, .variance_g2 = {0, 0, 0}, .count = {10}};
  EXPECT_EQ(take(oneSample(1, 1000)), Effect::Alive);
  EXPECT_EQ(take(means), Effect::Alive);
  EXPECT_EQ(take(means), Effect::Nothing);
  EXPECT_EQ(frames(), 2U);
}

TEST_F(SkinStreamTest, WhatIsRightOrTheNetworksDoingIsNoViolation) {
  stream.forgiveFirstPiece();
  take(skinwire::decodeBody(skinwire::Bytes(20, 7)));  // a serial port was opened within a frame
  take(oneSample(1, 1000, 0));                         // it was already sending
  describe();
  take(oneSample(1, 2000, 1));
  take(oneSample(1, 4000, 3));
  take(oneSample(1, 3000, 2));  // overtaken
  take(oneSample(1, 4000, 3));  // twice
  stream.restart();
  describe();
  EXPECT_THAT(status().offences, testing::IsEmpty());
}

TEST_F(SkinStreamTest, ProtocolViolationsAreToldOnceAtOnceAndThenCounted) {
  describe();
  take(oneSample(1, 1000));
  stream.reportCounters({});
  const std::size_t before = listener.delivered().statuses.size();
  take(oneSample(9, 2000));
  stream.reportCounters({});
  ASSERT_EQ(listener.delivered().statuses.size(), before + 1) << "within half a second of the last";
  take(oneSample(9, 3000));
  stream.reportCounters({});
  EXPECT_EQ(listener.delivered().statuses.size(), before + 1);
  const SourceStatus all = status();
  ASSERT_EQ(all.offences.size(), 1U);
  EXPECT_EQ(all.offences[0].kind, ProtocolViolationKind::UnknownCell);
  EXPECT_EQ(all.offences[0].count, 2U);
}

TEST_F(SkinStreamTest, ANewerDeviceMaySayWhatIsNotKnownYet) {
  const char* later = R"({"later_message": {}})";
  take(skinwire::helloWith(&skinwire::Hello::minor, skinwire::kMinor + 1));
  take(skinwire::decodeLine(later));
  EXPECT_THAT(status().offences, testing::IsEmpty());
  take(skinwire::helloMessage());
  take(skinwire::decodeLine(later));
  ASSERT_EQ(status().offences.size(), 1U);
  EXPECT_EQ(status().offences[0].kind, ProtocolViolationKind::UnknownMessage);
}

TEST_F(SkinStreamTest, ADeviceThatNeverDescribesItselfIsNamed) {
  take(skinwire::helloMessage());
  const SkinStream::Clock::time_point start{};
  stream.reportCounters(start);
  take(oneSample(1, 1000));
  stream.reportCounters(start + std::chrono::milliseconds(1900));
  EXPECT_THAT(status().offences, testing::IsEmpty());
  take(skinwire::Status{"", true, 0, 0});
  stream.reportCounters(start + std::chrono::seconds(10));
  EXPECT_THAT(status().offences, testing::IsEmpty()) << "it is exploring";
  take(skinwire::Status{"", false, 0, 0});
  stream.reportCounters(start + std::chrono::seconds(11));
  stream.reportCounters(start + std::chrono::seconds(14));
  ASSERT_EQ(status().offences.size(), 1U);
  EXPECT_EQ(status().offences[0].kind, ProtocolViolationKind::NotDescribed);
}

TEST_F(SkinStreamTest, WhatADeviceSaysCantMoveATerminalsCursor) {
  take(skinwire::helloWith(&skinwire::Hello::device, "red\x1b[31m"));
  take(skinwire::topologyMessage());
  EXPECT_EQ(listener.delivered().skins[0].device.english(), "red [31m");
}

TEST_F(SkinStreamTest, DeliversJointsByTheNamesThatCameLast) {
  take(skinwire::Joints{1'000, {"elbow"}, {0.25}});
  EXPECT_TRUE(listener.delivered().joints.empty()) << "nobody knows the skin yet";
  describe();
  EXPECT_EQ(take(skinwire::Joints{2'000, {}, {0.5}}), Effect::Alive) << "the name is known";
  take(skinwire::Joints{3'000, {"elbow", "wrist"}, {0.75, -1}});
  take(skinwire::Joints{4'000, {}, {1, -2}});
  const auto joints = listener.delivered().joints;
  ASSERT_EQ(joints.size(), 3U);
  EXPECT_EQ(joints[0].angles, (JointAngles{{{"elbow", 0.5}}}));
  EXPECT_EQ(joints[2].time_s, 0.004);
  EXPECT_EQ(joints[2].angles, (JointAngles{{{"elbow", 1}, {"wrist", -2}}}));
}

TEST_F(SkinStreamTest, LeavesOutJointsWithoutNamesAndLateOnes) {
  describe();
  EXPECT_EQ(take(skinwire::Joints{1'000, {}, {0.25}}), Effect::Nothing);
  EXPECT_EQ(status().rejected_messages, 1U);
  take(skinwire::Joints{2'000, {"elbow"}, {0.25}});
  EXPECT_EQ(take(skinwire::Joints{1'999, {}, {0.5}}), Effect::Nothing);
  EXPECT_EQ(status().late_frames, 1U);
  EXPECT_EQ(take(skinwire::Joints{3'000, {}, {0.5, 1}}), Effect::Nothing);
  EXPECT_EQ(listener.delivered().joints.size(), 1U);
  // Another device may come after a new connection: its names have to come too.
  stream.restart();
  describe();
  EXPECT_EQ(take(skinwire::Joints{1'000, {}, {0.25}}), Effect::Nothing);
}

}  // namespace
}  // namespace hexoderm
