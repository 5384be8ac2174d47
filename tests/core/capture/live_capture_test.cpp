#include "hexoderm/capture/live_capture.h"

#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/sim/simulated_skin.h"
#include "tests/core/capture/events_of.h"
#include "tests/support/failing_disk.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

#include <chrono>
#include <future>
#include <stop_token>
#include <thread>

namespace hexoderm {
namespace {

using testing::DoubleNear;

constexpr const char* kSkin = "sim:x17?speed=max";

LiveCaptureOptions fourPoses() { return {.source = kSkin, .poses = 4, .automatic = true}; }

std::vector<PoseId> posesOf(LiveCapture& capture) {
  std::vector<PoseId> poses;
  while (const auto pose = capture.next()) poses.push_back(pose->pose->id);
  return poses;
}

/// Says what the test says, before the capture waits for it, and refuses as many turns as the test says.
class ScriptedSource final : public SkinSource {
 public:
  void start(SkinListener& listener) override { listener_ = &listener; }
  void stop() noexcept override {}
  std::uint32_t send(const SkinCommand& /*command*/) override {
    ++commands_;
    if (commands_ <= refusals) {
      listener_->onCommandOutcome({commands_, false, Message::verbatim("its motors are off")});
    }
    return commands_;
  }
  [[nodiscard]] std::string address() const override { return "script"; }

  void describe(bool can_turn) {
    listener_->onSkin({Message::verbatim("test skin"), std::make_shared<const CellModel>(skin_.model()),
                       skin_.neighbors(), false, can_turn});
    say(SourceState::Streaming);
  }
  void say(SourceState state) {
    SourceStatus status;
    status.state = state;
    status.message = Message::verbatim("as the script says");
    listener_->onStatus(status);
  }
  /// 20 readings a second of every cell, all of which turn alike.
  void read(double duration_s, double turn_rad_s) {
    for (; duration_s > 0; duration_s -= kEvery_s) {
      SampleFrame frame{time_s_ += kEvery_s};
      angle_rad_ += turn_rad_s * kEvery_s;
      const Eigen::AngleAxisd turned(angle_rad_, Eigen::Vector3d::UnitZ());
      for (const GravitySample& sample : at_rest_.samples) {
        frame.samples.push_back({sample.cell, turned * sample.mean_g});
      }
      listener_->onFrame(frame);
    }
  }

  std::uint32_t refusals = 0;

 private:
  static constexpr double kEvery_s = 0.05;
  SimulatedSkin skin_{builtInCellModel("hex-bma150"), {}};
  PoseCapture at_rest_ = averageFrames(skin_.record(Eigen::Vector3d::UnitZ()), PoseId(1), {});
  SkinListener* listener_ = nullptr;
  std::uint32_t commands_ = 0;
  double time_s_ = 0;
  double angle_rad_ = 0;
};

/// A capture from a script, and all that it tells.
struct Scripted {
  explicit Scripted(LiveCaptureOptions options) {
    auto owned = std::make_unique<ScriptedSource>();
    source = owned.get();
    capture =
        std::make_unique<LiveCapture>(std::move(options), std::move(owned), [this](const LiveCaptureEvent& event) {
          events.push_back(event);
          if (then) then(event);
        });
    capture->start();
  }
  /// The part is there, and held long enough for a pose.
  void hold(bool can_turn = false) const {
    source->describe(can_turn);
    source->read(5, 0);
  }
  /// ... and once more, turned.
  void holdAgain() const {
    source->read(4, 0.14);
    source->read(5, 0);
  }

  template <class Event>
  [[nodiscard]] std::vector<Event> told() const {
    return test::eventsOf<Event>(events);
  }
  template <class Event>
  [[nodiscard]] std::vector<Event> toldByCourse() const {
    return test::eventsOf<Event>(told<WorkflowEvent>());
  }

  ScriptedSource* source = nullptr;
  std::vector<LiveCaptureEvent> events;
  LiveCapture::Listener then{};  ///< is told each event after that
  std::unique_ptr<LiveCapture> capture;
};

/// The event of a course.
template <class Event>
bool tells(const LiveCaptureEvent& event) {
  const auto* course = std::get_if<WorkflowEvent>(&event);
  return course != nullptr && std::holds_alternative<Event>(*course);
}

/// Captures into a file.
class LiveCaptureToFile : public testing::Test {
 protected:
  LiveCaptureToFile() { options_.file = folder_.path() / "live.hexo"; }

  const test::TemporaryFolder folder_;
  LiveCaptureOptions options_;
  std::stop_source stop_;
};

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
  // Turned on request, and without a number of poses it goes on as long as somebody does.
  LiveCapture capture(LiveCaptureOptions{.source = kSkin});
  bool is_wanted = true;
  for (std::size_t poses = 1; is_wanted && poses <= CaptureWorkflow::kMaxPosesByItself; ++poses) {
    ASSERT_TRUE(capture.next());
    const LiveCaptureState state = capture.state();
    is_wanted = state.result->assessment.wantsPose();
    EXPECT_EQ(state.advice.empty(), !is_wanted);
    EXPECT_EQ(state.up.has_value(), is_wanted);
    capture.turnToNextPose();
  }
  EXPECT_FALSE(is_wanted);
}

TEST_F(LiveCaptureToFile, KeepsThePosesAndWhatTheDeviceSentInARecording) {
  LiveCaptureOptions options = fourPoses();
  options.file = options_.file;
  options.record_to = folder_.path() / "live.skinrec";
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
  LiveCapture again(LiveCaptureOptions{.source = "replay:" + options.record_to.string() + "?speed=max"});
  EXPECT_THAT(posesOf(again), ElementsAre(PoseId(1), PoseId(2), PoseId(3), PoseId(4)));
  const Session recorded = openSession(options.file);
  for (std::size_t pose = 0; pose < 4; ++pose) {
    const auto& live = recorded.poses()[pose].capture->samples;
    const auto& replayed = again.state().session->poses()[pose].capture->samples;
    ASSERT_EQ(live.size(), replayed.size());
    for (std::size_t cell = 0; cell < live.size(); ++cell) EXPECT_EQ(live[cell].mean_g, replayed[cell].mean_g);
  }
}

TEST_F(LiveCaptureToFile, AFileThatIsRemovedMeanwhileIsWrittenAnew) {
  Scripted scripted(options_);
  scripted.hold();
  ASSERT_TRUE(scripted.capture->next());
  std::filesystem::remove(options_.file);
  scripted.holdAgain();
  ASSERT_TRUE(scripted.capture->next());
  EXPECT_THAT(scripted.toldByCourse<FileRenewed>(), SizeIs(1));
  EXPECT_THAT(openSession(options_.file).poses(), SizeIs(2));
  std::filesystem::remove(options_.file);  // after the last pose, too
  scripted.capture->close();
  EXPECT_THAT(scripted.toldByCourse<FileRenewed>(), SizeIs(2));
  EXPECT_THAT(openSession(options_.file).poses(), SizeIs(2));
  EXPECT_EQ(folder_.entryCount(), 1U);
}

TEST_F(LiveCaptureToFile, AFileWhoseFolderIsMovedAwayIsNotSaidToBeThere) {
  std::filesystem::create_directory(folder_.path() / "before");
  options_.file = folder_.path() / "before" / "live.hexo";
  Scripted scripted(options_);
  scripted.hold();
  ASSERT_TRUE(scripted.capture->next());
  std::filesystem::rename(folder_.path() / "before", folder_.path() / "after");
  EXPECT_THAT(
      messageOf<StorageError>([&] { scripted.capture->close(); }),
      saysAll("before/live.hexo: was moved to ", "after/live.hexo while it was open, with what was stored in it",
              "it can't be written anew", "No such file"));
  EXPECT_THAT(openSession(folder_.path() / "after" / "live.hexo").poses(), SizeIs(1));
}

TEST_F(LiveCaptureToFile, SaysWhichPoseIsNotStoredWhereItIsEndedOnAFullDisk) {
  Scripted scripted(options_);
  scripted.then = [&](const LiveCaptureEvent& event) {
    if (tells<FileRefused>(event)) stop_.request_stop();
  };
  scripted.hold();
  ASSERT_TRUE(scripted.capture->next());
  {
    const test::NoFileGrows full;
    scripted.holdAgain();
    EXPECT_FALSE(scripted.capture->next(stop_.get_token()));
    const std::string why = messageOf<StorageError>([&] { scripted.capture->close(); });
    EXPECT_THAT(why, saysAll("live.hexo: ", "; pose 2 is not stored; 1 pose was stored before"));
    EXPECT_THAT(why, testing::Not(testing::HasSubstr("was closed")));
  }
  EXPECT_THAT(scripted.toldByCourse<FileRefused>(), SizeIs(1)) << "at the end nobody tries again";
  EXPECT_THAT(openSession(options_.file).poses(), SizeIs(1));
}

TEST_F(LiveCaptureToFile, AFileThatTookNoPoseIsNotInTheWayOfTheNextCapture) {
  Scripted scripted(options_);
  std::optional<test::NoFileGrows> full;
  scripted.then = [&](const LiveCaptureEvent& event) {
    if (std::holds_alternative<CaptureBegun>(event)) full.emplace();
    if (tells<FileRefused>(event)) stop_.request_stop();
  };
  scripted.hold();
  EXPECT_FALSE(scripted.capture->next(stop_.get_token()));
  EXPECT_TRUE(std::filesystem::exists(options_.file)) << "the pose may still find room";
  EXPECT_THAT(messageOf<StorageError>([&] { scripted.capture->close(); }),
              saysAll("live.hexo: ", "pose 1 is not stored; 0 poses were stored before"));
  full.reset();
  EXPECT_EQ(folder_.entryCount(), 0U);
}

TEST_F(LiveCaptureToFile, ARecordingThatBreaksInItsLastFlushIsToldAfterADeviceThatFailed) {
  Scripted scripted({.source = "script", .record_to = folder_.path() / "live.skinrec"});
  scripted.source->describe(false);
  scripted.source->read(0.1, 0);
  const test::NoFileGrows full;
  scripted.source->say(SourceState::Incompatible);
  EXPECT_EQ(messageOf<DeviceError>([&] { scripted.capture->next(); }), "script: as the script says");
  ASSERT_THAT(scripted.told<RecordingEnded>(), SizeIs(1));
  EXPECT_THAT(scripted.told<RecordingEnded>().front().why.english(), saysAll("live.skinrec", "the recording ended"));
}

TEST_F(LiveCaptureToFile, ADeviceThatFailsIsSaidBeforeThePosesThatAreNotStored) {
  Scripted scripted(options_);
  std::optional<test::NoFileGrows> full;
  scripted.then = [&](const LiveCaptureEvent& event) {
    if (std::holds_alternative<CaptureBegun>(event)) full.emplace();
    if (tells<FileRefused>(event)) scripted.source->say(SourceState::Incompatible);
  };
  scripted.hold();
  EXPECT_THAT(messageOf<StorageError>([&] { scripted.capture->next(); }),
              testing::AllOf(testing::StartsWith("script: as the script says; "),
                             testing::EndsWith("pose 1 is not stored; 0 poses were stored before")));
}

TEST(LiveCapture, TellsWhatHappensInItsOrder) {
  Scripted scripted({.source = "script", .poses = 1});
  scripted.hold();
  EXPECT_THAT(scripted.events, IsEmpty()) << "next() tells";
  EXPECT_THAT(posesOf(*scripted.capture), ElementsAre(PoseId(1)));
  ASSERT_THAT(scripted.told<SkinDescription>(), SizeIs(1));
  ASSERT_THAT(scripted.told<CaptureBegun>(), SizeIs(1));
  EXPECT_THAT(scripted.told<CaptureBegun>().front().skin.neighbors, SizeIs(17));
  EXPECT_THAT(scripted.told<SourceStatus>(), SizeIs(1));
  EXPECT_THAT(scripted.told<HoldStatus>(), SizeIs(testing::Le(2U))) << "one before the pose and one after it";
  EXPECT_THAT(scripted.toldByCourse<PoseTaken>(), SizeIs(1));
  EXPECT_THAT(scripted.toldByCourse<PoseKept>(), SizeIs(1));
  EXPECT_TRUE(std::holds_alternative<SkinDescription>(scripted.events.front()));
  EXPECT_THAT(scripted.toldByCourse<WorkflowFinished>(), SizeIs(1));
  const LiveCaptureState state = scripted.capture->state();
  EXPECT_EQ(state.device.english(), "test skin");
  EXPECT_EQ(state.source.state, SourceState::Streaming);
  EXPECT_NEAR(state.holds.watched_s(), 5, 0.5);
}

TEST(LiveCapture, SaysEverMoreRarelyThatTheSameKeepsAPoseFromBeingTaken) {
  Scripted scripted({.source = "script"});
  scripted.source->describe(false);
  constexpr double kTurning_rad_s = 0.14;
  scripted.source->read(30, kTurning_rad_s);
  scripted.source->read(5, 0);
  scripted.source->read(8, kTurning_rad_s);
  scripted.source->say(SourceState::Ended);
  EXPECT_THAT(posesOf(*scripted.capture), SizeIs(1));
  std::vector<double> durations_s;
  for (const NoPose& wait : scripted.told<NoPose>()) {
    durations_s.push_back(wait.duration_s);
    EXPECT_THAT(wait.why.english(), testing::HasSubstr("the part turns by"));
  }
  EXPECT_THAT(durations_s,
              ElementsAre(DoubleNear(5, 0.2), DoubleNear(10, 0.4), DoubleNear(20, 0.8), DoubleNear(5, 0.2)));
}

TEST(LiveCapture, GivesUpADeviceThatRefusesEveryTurn) {
  Scripted scripted({.source = "script", .automatic = true});
  scripted.source->refusals = 100;
  scripted.hold(true);
  EXPECT_TRUE(scripted.capture->next());
  EXPECT_EQ(messageOf<DeviceError>([&] { scripted.capture->next(); }),
            "script: refused to turn 11 times, the last time: its motors are off");
  EXPECT_THAT(scripted.toldByCourse<TurnRefused>(), SizeIs(11));
  EXPECT_THAT(scripted.told<PoseAdvised>(), SizeIs(testing::Ge(11U)));
  EXPECT_NE(scripted.capture->state().result, nullptr);
}

TEST(LiveCapture, SaysWhichTurnWasRefusedWhereNoPoseComesInTime) {
  Scripted scripted({.source = "script", .automatic = true, .timeout_s = 0.4});
  scripted.source->refusals = 1;
  scripted.hold(true);
  EXPECT_TRUE(scripted.capture->next());
  EXPECT_THAT(messageOf<DeviceError>([&] { scripted.capture->next(); }),
              saysAll("script: no pose for 0.4 s: ", "The device does not turn there: its motors are off",
                      "as the script says"));
}

TEST_F(LiveCaptureToFile, WhatItsListenerThrowsEndsIt) {
  LiveCapture capture(options_, openSkinSource(kSkin), [](const LiveCaptureEvent& event) {
    if (tells<PoseKept>(event)) throw DeviceError("enough of it");
  });
  capture.start();
  EXPECT_EQ(messageOf<DeviceError>([&] { capture.next(); }), "enough of it");
  EXPECT_FALSE(capture.next());
  EXPECT_THAT(openSession(options_.file).poses(), SizeIs(1));
}

TEST(LiveCapture, PosesThatNobodyLetsItSolveAreKeptWithoutAResult) {
  for (const bool goes_on : {false, true}) {
    std::stop_source stop;
    LiveCapture capture(fourPoses(), openSkinSource(kSkin), [&](const LiveCaptureEvent& event) {
      if (tells<PoseKept>(event)) stop.request_stop();
    });
    capture.start();
    EXPECT_FALSE(capture.next(stop.get_token(), stop.get_token()));
    if (goes_on) {
      EXPECT_EQ(capture.next()->pose->id, PoseId(1));
    }
    capture.close(stop.get_token());
    ASSERT_THAT(capture.state().session->poses(), SizeIs(1));
    EXPECT_EQ(capture.state().result != nullptr, goes_on);
  }
}

TEST_F(LiveCaptureToFile, RefusesWhatCanNotBe) {
  const auto refusal = [](const LiveCaptureOptions& options) {
    return messageOf<Error>([&] { LiveCapture capture(options); });
  };
  EXPECT_THAT(refusal({.source = kSkin, .file = "live.json"}), saysAll(".hexo", "live.json"));
  EXPECT_THAT(refusal({.source = kSkin, .file = folder_.put("live.hexo", "x")}), saysAll("live.hexo: exists already"));
  EXPECT_THAT(refusal({.source = kSkin, .timeout_s = 0}), saysAll("timeout_s"));
}

TEST(LiveCapture, ADeviceThatDoesNotTurnCanNotBeAsked) {
  // It moves, but not when it is asked to.
  LiveCaptureOptions options{.source = "sim:x17?speed=max&motion=robot", .poses = 1};
  LiveCapture unasked(options);
  EXPECT_TRUE(unasked.next());
  EXPECT_FALSE(unasked.state().can_turn);
  EXPECT_EQ(messageOf<InvalidArgument>([&] { unasked.turnToNextPose(); }),
            options.source + ": this device does not turn by itself");
  options.automatic = true;
  LiveCapture automatic(options);
  EXPECT_THAT(messageOf<DeviceError>([&] { automatic.next(); }), saysAll(options.source, "auto needs", "can't"));
  LiveCapture waits(LiveCaptureOptions{.source = "stdin"});
  EXPECT_THAT(messageOf<InvalidArgument>([&] { waits.turnToNextPose(); }),
              saysAll("stdin", "no skin has described itself yet"));
}

TEST(LiveCapture, IsAskedToTurnAndClosedWhileAnotherThreadWaits) {
  LiveCapture capture(LiveCaptureOptions{.source = kSkin, .poses = 3});  // it turns only when it is asked to
  auto waiting = std::async(std::launch::async, [&] { return posesOf(capture); });
  const auto waitForPose = [&](PoseId pose) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < deadline) {
      const auto last = capture.state().last;
      if (last && last->captured.pose->id == pose) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  };
  ASSERT_TRUE(waitForPose(PoseId(1)));
  EXPECT_EQ(waiting.wait_for(std::chrono::milliseconds(300)), std::future_status::timeout);
  capture.turnToNextPose();
  ASSERT_TRUE(waitForPose(PoseId(2)));
  capture.close();
  capture.close();
  EXPECT_THAT(waiting.get(), ElementsAre(PoseId(1), PoseId(2)));
}

TEST(LiveCapture, StopsWhenItIsToldAndGoesOn) {
  LiveCapture capture(fourPoses());
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(capture.next(stop.get_token()));
  EXPECT_THAT(posesOf(capture), SizeIs(4));
}

}  // namespace
}  // namespace hexoderm
