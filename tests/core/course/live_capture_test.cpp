#include "hexoderm/course/live_capture.h"

#include "hexoderm/io/open_file.h"
#include "hexoderm/util/error.h"
#include "tests/support/error_matchers.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <chrono>
#include <future>
#include <stop_token>
#include <thread>
#include <variant>
#include <vector>

namespace hexoderm {
namespace {

using test::messageOf;
using test::saysAll;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* kSkin = "sim:x17?speed=max";

LiveCaptureOptions fourPoses() {
  LiveCaptureOptions options;
  options.source = kSkin;
  options.automatic = true;
  options.poses = 4;
  return options;
}

std::vector<PoseId> posesOf(LiveCapture& capture) {
  std::vector<PoseId> poses;
  while (const auto pose = capture.next()) poses.push_back(pose->pose->id);
  return poses;
}

TEST(LiveCapture, GivesEachPoseWithTheResultOfAll) {
  LiveCapture capture(fourPoses());
  EXPECT_FALSE(capture.state().last);
  std::size_t poses = 0;
  while (const auto pose = capture.next()) {
    const LiveCaptureState state = capture.state();
    ++poses;
    ASSERT_TRUE(state.last);
    EXPECT_EQ(state.last->captured.pose, pose->pose);
    EXPECT_EQ(state.last->where, KeptIn::Memory);
    EXPECT_TRUE(state.can_turn);
    EXPECT_EQ(pose->pose->id, PoseId(static_cast<std::uint32_t>(poses)));
    ASSERT_TRUE(state.session);
    EXPECT_THAT(state.session->poses(), SizeIs(poses));
    ASSERT_NE(state.result, nullptr);
    EXPECT_THAT(state.result->poses, SizeIs(poses));
    // The last one needs no further pose, and what was advised before it is over.
    ASSERT_EQ(state.up.has_value(), poses < 4);
    EXPECT_EQ(state.advice.empty(), poses == 4);
    EXPECT_EQ(state.status.english() == "There are enough poses.", poses == 4);
    EXPECT_NEAR(state.up.value_or(Eigen::Vector3d::UnitX()).norm(), 1, 1e-9);
  }
  EXPECT_EQ(poses, 4U);
  EXPECT_FALSE(capture.next());  // and stays so
  EXPECT_EQ(capture.state().result->cellCount(), 17U);
  EXPECT_EQ(capture.state().status.english(), "There are enough poses.");
}

TEST(LiveCapture, SaysNothingOfAPartThatItDoesNotLookAtAnyMore) {
  LiveCapture capture(fourPoses());
  ASSERT_TRUE(capture.next());
  EXPECT_FALSE(capture.state().advice.empty());
  capture.close();
  const LiveCaptureState state = capture.state();
  EXPECT_TRUE(state.advice.empty());
  EXPECT_FALSE(state.up);
  EXPECT_EQ(state.status.english(), "The capture is over.");
}

TEST(LiveCapture, AdvisesNoPoseThatTheResultDoesNotWant) {
  LiveCaptureOptions options;
  options.source = kSkin;  // turned on request, and without a number of poses it goes on as long as somebody does
  LiveCapture capture(options);
  bool is_wanted = true;
  for (std::size_t poses = 1; is_wanted && poses <= CaptureCourse::kMostPosesByItself; ++poses) {
    ASSERT_TRUE(capture.next());
    const LiveCaptureState state = capture.state();
    is_wanted = state.result->assessment.wantsPose();
    EXPECT_EQ(state.advice.empty(), !is_wanted);
    EXPECT_EQ(state.up.has_value(), is_wanted);
    capture.turnToNextPose();
  }
  EXPECT_FALSE(is_wanted);
}

TEST(LiveCapture, EndsByItselfWhereTheVerdictIsGoodEnough) {
  LiveCaptureOptions options = fourPoses();
  options.poses = 0;
  LiveCapture capture(options);
  EXPECT_THAT(posesOf(capture), testing::Not(IsEmpty()));
  EXPECT_NE(capture.state().result->assessment.level, VerdictLevel::NotEnough);
}

TEST(LiveCapture, KeepsThePosesInItsFileAndWhatTheDeviceSentInARecording) {
  const test::TemporaryFolder folder;
  LiveCaptureOptions options = fourPoses();
  options.file = folder.path() / "live.hexo";
  options.record_to = folder.path() / "live.skinrec";
  std::size_t in_file = 0;
  {
    LiveCapture capture(options);
    while (capture.next()) {
      ++in_file;
      EXPECT_EQ(capture.state().last->where, KeptIn::File);
      const auto opened = openFile(options.file, builtInCellModel("hex-bma150"));
      EXPECT_THAT(std::get<Session>(opened).poses(), SizeIs(testing::Ge(in_file)));
    }
    capture.close();
  }
  EXPECT_EQ(in_file, 4U);

  // A recording is played to its end; its poses are the same.
  LiveCaptureOptions replay;
  replay.source = "replay:" + options.record_to.string() + "?speed=max";
  LiveCapture again(replay);
  EXPECT_THAT(posesOf(again), ElementsAre(PoseId(1), PoseId(2), PoseId(3), PoseId(4)));
}

TEST(LiveCapture, RefusesWhatCanNotBe) {
  const test::TemporaryFolder folder;
  LiveCaptureOptions options = fourPoses();
  options.file = folder.path() / "live.json";
  EXPECT_THAT(messageOf<InvalidArgument>([&] { LiveCapture capture(options); }), saysAll(".hexo", "live.json"));
  options.file = folder.put("live.hexo", "somebody's");
  EXPECT_THAT(messageOf<StorageError>([&] { LiveCapture capture(options); }), saysAll("live.hexo", "exists already"));
  options.file.clear();
  options.source = "nonsense://x";
  EXPECT_THAT(messageOf<InvalidArgument>([&] { LiveCapture capture(options); }), saysAll("nonsense"));
  options = fourPoses();
  options.timeout_s = 0;
  EXPECT_THAT(messageOf<InvalidArgument>([&] { LiveCapture capture(options); }), saysAll("timeout_s"));
}

TEST(LiveCapture, SaysWhyNothingComes) {
  LiveCaptureOptions options;
  options.source = "tcp://127.0.0.1:1";
  options.timeout_s = 0.2;
  LiveCapture capture(options);
  EXPECT_THAT(messageOf<DeviceError>([&] { capture.next(); }),
              saysAll("tcp://127.0.0.1:1", "the device did not describe itself for 0.2 s"));
  EXPECT_FALSE(capture.next());
}

TEST(LiveCapture, SaysThatNoSkinDescribedItself) {
  const test::TemporaryFolder folder;
  LiveCaptureOptions options;
  options.source = "replay:" + folder.put("stream", "SKINREC1").string() + "?speed=max";
  LiveCapture capture(options);
  EXPECT_EQ(messageOf<DeviceError>([&] { capture.next(); }), options.source + ": ended before a skin described itself");
}

TEST(LiveCapture, ADeviceThatDoesNotTurnCanNotBeAsked) {
  LiveCaptureOptions options;
  options.source = "sim:x17?speed=max&motion=robot";  // it moves, but not when it is asked to
  options.poses = 1;
  LiveCapture unasked(options);
  EXPECT_TRUE(unasked.next());
  EXPECT_FALSE(unasked.state().can_turn);
  EXPECT_EQ(messageOf<InvalidArgument>([&] { unasked.turnToNextPose(); }),
            options.source + ": this device does not turn by itself");
  options.automatic = true;
  LiveCapture automatic(options);
  EXPECT_THAT(messageOf<DeviceError>([&] { automatic.next(); }), saysAll(options.source, "auto needs", "can't"));
  options = {};
  options.source = "stdin";
  LiveCapture waits(options);
  EXPECT_THAT(messageOf<InvalidArgument>([&] { waits.turnToNextPose(); }),
              saysAll("stdin", "no skin has described itself yet"));
}

TEST(LiveCapture, IsAskedToTurnWhileAnotherThreadWaits) {
  LiveCaptureOptions options;
  options.source = kSkin;  // it turns only when it is asked to
  options.poses = 2;
  LiveCapture capture(options);
  auto waiting = std::async(std::launch::async, [&] { return posesOf(capture); });
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!capture.state().last && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_TRUE(capture.state().last);
  EXPECT_EQ(waiting.wait_for(std::chrono::milliseconds(300)), std::future_status::timeout);
  capture.turnToNextPose();
  EXPECT_EQ(waiting.wait_for(std::chrono::seconds(60)), std::future_status::ready);
  capture.close();
  EXPECT_THAT(waiting.get(), ElementsAre(PoseId(1), PoseId(2)));
}

TEST(LiveCapture, StopsWhenItIsToldAndGoesOn) {
  LiveCaptureOptions options = fourPoses();
  LiveCapture capture(options);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(capture.next(stop.get_token()));
  EXPECT_THAT(posesOf(capture), SizeIs(4));
}

TEST(LiveCapture, IsClosedByAnotherThread) {
  LiveCaptureOptions options;
  options.source = "sim:x17";  // nobody turns it, so that there is no second pose
  options.poses = 2;
  LiveCapture capture(options);
  auto waiting = std::async(std::launch::async, [&] { return posesOf(capture).size(); });
  EXPECT_EQ(waiting.wait_for(std::chrono::milliseconds(300)), std::future_status::timeout);
  capture.close();
  EXPECT_LE(waiting.get(), 1U);
  capture.close();
}

}  // namespace
}  // namespace hexoderm
