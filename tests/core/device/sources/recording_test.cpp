#include "hexoderm/device/sources/recording.h"

#include "hexoderm/base/file.h"
#include "hexoderm/device/skinwire/codec.h"
#include "tests/core/device/skinwire/collecting_listener.h"
#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/support/failing_disk.h"
#include "tests/support/sample_matchers.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

#include <chrono>
#include <thread>

namespace hexoderm {
namespace {

using ::testing::_;
using ::testing::FieldsAre;

constexpr double kLsb_g = 0.00390625;

SkinDescription twoCells() {
  return {Message::verbatim("two cells"), std::make_shared<const CellModel>(builtInCellModel("hex-bma150")),
          skinwire::topologyMessage().cells, true, false};
}

SampleFrame frameAt(double time_s) {
  return {time_s,
          {{CellId(1), Eigen::Vector3d(1, -2, 256) * kLsb_g}, {CellId(2), Eigen::Vector3d(0, 5, 250) * kLsb_g}}};
}

/// Ten frames, 1 ms apart.
void record(const std::filesystem::path& path) {
  CollectingListener ignored;
  StreamRecorder recorder(path, ignored);
  recorder.onSkin(twoCells());
  for (int k = 1; k <= 10; ++k) recorder.onFrame(frameAt(k / 1000.0));
  recorder.finish();
}

CollectingListener::Delivered play(const std::filesystem::path& path, ReplayOptions options) {
  CollectingListener listener;
  const auto source = replaySource(path, options);
  source->start(listener);
  EXPECT_TRUE(listener.waitFor(
      [](const auto& d) { return d.sawState(SourceState::Ended) || d.sawState(SourceState::Incompatible); }));
  source->stop();
  return listener.delivered();
}

constexpr ReplayOptions kAtOnce{std::numeric_limits<double>::infinity(), false};

void appendNumber(std::uint64_t value, int bytes, std::string& out) {
  for (int k = 0; k < bytes; ++k) out += static_cast<char>(value >> (8 * k));
}

std::string recordOf(std::uint64_t arrived_us, const skinwire::Bytes& body) {
  std::string record;
  appendNumber(arrived_us, 8, record);
  appendNumber(body.size(), 4, record);
  return record.append(body.begin(), body.end());
}

/// A recording of given arrival times.
std::string recordingOf(const std::vector<std::pair<std::uint64_t, skinwire::Message>>& messages) {
  std::string file = "SKINREC1";
  for (const auto& [arrived_us, message] : messages) file += recordOf(arrived_us, skinwire::encodeBody(message));
  return file;
}

class Recording : public testing::Test {
 protected:
  /// Without the sync of writeFileAtomically, which takes its time.
  void write(const std::string& content) const { folder_.put("a.skinrec", content); }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "a.skinrec";
  CollectingListener listener_;
};

TEST_F(Recording, PlaysWhatWasRecordedBitByBit) {
  record(path_);
  const auto delivered = play(path_, kAtOnce);
  ASSERT_EQ(delivered.skins.size(), 1U);
  EXPECT_EQ(delivered.skins[0].device.english(), "two cells");
  EXPECT_EQ(delivered.skins[0].neighbors, twoCells().neighbors);
  EXPECT_EQ(delivered.skins[0].model->name, "hex-bma150");
  ASSERT_EQ(delivered.frames.size(), 10U);
  for (std::size_t k = 0; k < 10; ++k) {
    test::expectSameFrame(delivered.frames[k], frameAt(static_cast<double>(k + 1) / 1000.0));
  }
  EXPECT_THAT(delivered.statuses.back().state, SourceState::Stopped);
  EXPECT_EQ(delivered.statuses.back().rejected_messages, 0U);
}

TEST_F(Recording, TellsWhatTheDeviceSaidAndWhatWasLostOnTheWay) {
  StreamRecorder recorder(path_, listener_);
  recorder.onSkin(twoCells());
  recorder.onFrame(frameAt(0.001));
  recorder.onDeviceStatus({"warm\n", true, 2, 0});
  SourceStatus status;
  status.lost_samples = 6;
  recorder.onStatus(status);
  recorder.onFrame(frameAt(0.005));
  recorder.onDeviceStatus({"", false, 4, 6});
  status.lost_samples = 4;  // two came late
  recorder.onStatus(status);
  recorder.onFrame(frameAt(0.006));
  recorder.onCommandOutcome({7, true, {}});
  recorder.finish();
  const auto live = listener_.delivered();
  EXPECT_EQ(live.skins.size(), 1U) << "everything is passed on, too";
  EXPECT_EQ(live.frames.size(), 3U);
  EXPECT_EQ(live.status().lost_samples, 4U);
  EXPECT_NE(live.outcomeOf(7), nullptr);
  ASSERT_EQ(live.device_statuses.size(), 2U);
  EXPECT_EQ(live.device_statuses[1].samples_dropped, 6U);

  const auto delivered = play(path_, kAtOnce);
  EXPECT_EQ(delivered.frames.size(), 3U);
  EXPECT_THAT(delivered.device_statuses, ElementsAre(FieldsAre("warm ", true, _, _), FieldsAre(_, _, 4U, 6U)));
  EXPECT_TRUE(delivered.saw(SourceState::Streaming, "the device said: warm"));
  EXPECT_EQ(delivered.status().dropped_by_device, 6U);
  EXPECT_EQ(delivered.status().lost_samples, 6U);
}

TEST_F(Recording, KeepsWhereTheJointsStood) {
  StreamRecorder recorder(path_, listener_);
  recorder.onSkin(twoCells());
  recorder.onJoints({0.001, {{{"elbow", 0.1}, {"wrist", -1.0 / 3}}}});
  recorder.onFrame(frameAt(0.001));
  recorder.onJoints({0.002, {{{"elbow", 0.2}, {"wrist", -1.0 / 3}}}});
  recorder.onJoints({0.003, {{{"elbow", 0.3}}}});
  recorder.onSkin(twoCells());
  recorder.onJoints({0.004, {{{"elbow", 0.4}}}});
  recorder.finish();
  EXPECT_EQ(listener_.delivered().joints.size(), 4U);
  const auto delivered = play(path_, kAtOnce);
  ASSERT_EQ(delivered.joints.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(delivered.joints[k].angles, listener_.delivered().joints[k].angles);
    EXPECT_NEAR(delivered.joints[k].time_s, listener_.delivered().joints[k].time_s, 1e-9);
  }
}

TEST_F(Recording, KeepsFramesAfterTheDevicesClockBeganAnew) {
  StreamRecorder recorder(path_, listener_);
  recorder.onSkin(twoCells());
  for (const double time_s : {10.0, 10.001, 0.5, 0.501}) recorder.onFrame(frameAt(time_s));
  recorder.finish();
  const auto delivered = play(path_, kAtOnce);
  EXPECT_EQ(delivered.frames.size(), 4U);
  EXPECT_EQ(delivered.skins.size(), 1U);
}

TEST_F(Recording, CutOffAnywhereItPlaysUpToTheLastWholeFrame) {
  record(path_);
  const std::string whole = readFile(path_);
  std::vector<std::size_t> ends = {8};  // ends of the magic and of each record
  for (RecordingReader reader(path_); const auto record = reader.next();) {
    ends.push_back(ends.back() + 12 + record->body.size());
  }
  ASSERT_EQ(ends.size(), 13U);
  ASSERT_EQ(ends.back(), whole.size());
  for (std::size_t size = ends[10]; size < whole.size(); ++size) {
    write(whole.substr(0, size));
    RecordingReader reader(path_);
    std::size_t records = 0;
    while (reader.next()) ++records;
    EXPECT_EQ(records, size < ends[11] ? 10U : 11U) << size;
    EXPECT_EQ(reader.damage().empty(), size == ends[10] || size == ends[11]) << size;
  }
  write(whole.substr(0, whole.size() - 1));
  const auto delivered = play(path_, kAtOnce);
  EXPECT_EQ(delivered.frames.size(), 9U);
  EXPECT_TRUE(delivered.saw(SourceState::Ended, "is cut off"));
}

TEST_F(Recording, ImpossibleLengthsEndItWithoutAllocation) {
  std::string file = recordingOf({{0, skinwire::helloMessage()}});
  appendNumber(0, 8, file);
  appendNumber(UINT32_MAX, 4, file);
  write(file);
  RecordingReader reader(path_);
  EXPECT_TRUE(reader.next().has_value());
  EXPECT_FALSE(reader.next().has_value());
  EXPECT_THAT(reader.damage().english(), HasSubstr("4294967295"));
}

TEST_F(Recording, IsPlayedInRealTimeOrFaster) {
  // Eleven days, in a tenth of a second.
  constexpr std::uint64_t kMillion = 1'000'000;
  write(recordingOf({{0, skinwire::helloMessage()},
                     {0, skinwire::topologyMessage()},
                     {kMillion * kMillion, skinwire::rawSamples(0, 1000)}}));
  const auto began = std::chrono::steady_clock::now();
  const auto delivered = play(path_, {10.0 * kMillion, false});
  EXPECT_GE(std::chrono::steady_clock::now() - began, std::chrono::milliseconds(100));
  EXPECT_EQ(delivered.frames.size(), 2U);

  // Played at its own pace, it can be stopped long before its end.
  const auto source = replaySource(path_);
  source->start(listener_);
  EXPECT_TRUE(listener_.waitFor([](const auto& d) { return d.sawState(SourceState::Streaming); }));
  source->stop();
  EXPECT_TRUE(listener_.delivered().frames.empty());
}

TEST_F(Recording, IsPlayedStepByStep) {
  record(path_);
  const auto source = replaySource(path_, {1, true});
  source->start(listener_);
  // A refused command shows that the thread waits although nothing may be delivered.
  const std::uint32_t command = source->send(SetRate{100});
  ASSERT_TRUE(listener_.waitFor([&](const auto& d) { return d.outcomeOf(command) != nullptr; }));
  EXPECT_FALSE(listener_.delivered().outcomeOf(command)->done);
  for (std::size_t step = 1; step <= 3; ++step) {
    source->step();
    ASSERT_TRUE(listener_.waitFor([&](const auto& d) { return d.frames.size() == step; }));
  }
  source->step(1000);
  ASSERT_TRUE(listener_.waitFor([](const auto& d) { return d.sawState(SourceState::Ended); }));
  EXPECT_EQ(listener_.delivered().frames.size(), 10U);
  source->stop();
}

TEST_F(Recording, StopsWhileItWaitsForAStep) {
  record(path_);
  const auto source = replaySource(path_, {1, true});
  source->start(listener_);
  ASSERT_TRUE(listener_.waitFor([](const auto& d) { return !d.skins.empty(); }));
  source->stop();
  EXPECT_TRUE(listener_.delivered().frames.empty());
}

TEST_F(Recording, FilesThatAreNoneAreNamed) {
  EXPECT_THROW(replaySource(path_)->start(listener_), StorageError);
  EXPECT_THROW(replaySource(folder_.path())->start(listener_), StorageError);
  for (const char* content : {"", "SKIN", "{\"format\": \"hexoderm-session\"}"}) {
    write(content);
    EXPECT_THROW(replaySource(path_)->start(listener_), FormatError) << content;
  }
  write("SKINREC2...");
  EXPECT_THAT(test::messageOf<FormatError>([&] { replaySource(path_)->start(listener_); }),
              HasSubstr("version 2, this program reads version 1"));
}

TEST_F(Recording, FramesOfAnotherMajorVersionEndIt) {
  write("SKINREC1" + recordOf(0, skinwire::bodyOf(1, {}, 2)));
  const auto delivered = play(path_, kAtOnce);
  EXPECT_TRUE(delivered.saw(SourceState::Incompatible, "SkinWire 2, this program SkinWire 1"));
}

/// What happens behind the first frame, the time of the next one, and what is said of it in the end.
struct Ending {
  std::string why;
  std::function<void()> happens = [] {};
  double next_s = 2;
};

TEST_F(Recording, WhatEndsItDoesNotEndListening) {
  const auto elsewhere = folder_.path() / "elsewhere.skinrec";
  std::optional<test::NoFileGrows> full;
  const Ending endings[] = {
      {"a.skinrec: the recording ended: it was moved to " + elsewhere.string(),
       [&] { std::filesystem::rename(path_, elsewhere); }},
      {"a.skinrec: the recording ended: it was removed while", [&] { std::filesystem::remove(path_); }},
      {"the recording ended", [] {}, 1e300},
      {"a.skinrec", [&] { full.emplace(); }}};
  for (const Ending& ending : endings) {
    SCOPED_TRACE(ending.why);
    CollectingListener listener;
    StreamRecorder recorder(path_, listener);
    recorder.onSkin(twoCells());
    recorder.onFrame(frameAt(1));
    ending.happens();
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // it looks once a second
    recorder.onFrame(frameAt(ending.next_s));
    EXPECT_TRUE(full || recorder.error().english().find(ending.why) != std::string::npos) << recorder.error();
    recorder.onFrame(frameAt(ending.next_s + 1));
    EXPECT_EQ(listener.delivered().frames.size(), 3U);
    EXPECT_THROW(recorder.finish(), StorageError);
    EXPECT_THAT(recorder.error().english(), HasSubstr(ending.why));
    full.reset();
  }
  EXPECT_EQ(play(elsewhere, kAtOnce).frames.size(), 2U);
}

TEST_F(Recording, IsNotBegunOnAFullDisk) {
  const test::NoFileGrows full;
  EXPECT_THROW(StreamRecorder(path_, listener_), StorageError);
  EXPECT_EQ(folder_.entryCount(), 0U);
}

TEST_F(Recording, WithoutASkinLeavesWhatHasItsNameByNow) {
  {
    StreamRecorder recorder(path_, listener_);
    std::filesystem::remove(path_);
    write("of somebody else");
  }
  EXPECT_EQ(readFile(path_), "of somebody else");
}

TEST_F(Recording, AFileThatIsGoneAtTheEndIsSaid) {
  StreamRecorder recorder(path_, listener_);
  recorder.onSkin(twoCells());
  std::filesystem::remove(path_);
  EXPECT_THROW(recorder.finish(), StorageError);
}

}  // namespace
}  // namespace hexoderm
