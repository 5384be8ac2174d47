#include "hexoderm/capture/capture_workflow.h"

#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/core/capture/events_of.h"
#include "tests/support/testing.h"

#include <deque>

namespace hexoderm {
namespace {

/// Holds the session, and a file and a device that answer when the test says so.
class CaptureWorkflowTest : public testing::Test, public CaptureOwner {
 protected:
  CaptureWorkflowTest() {
    description_ = {Message::verbatim("test skin"), std::make_shared<const CellModel>(skin_.model()), skin_.neighbors(),
                    false, true};
    begin({});
  }

  void begin(const CaptureWorkflowOptions& options) {
    course_ = std::make_unique<CaptureWorkflow>(*this, options);
    session_ = CaptureWorkflow::sessionOf(description_, "sim:test");
    course_->begin(session_, description_);
    course_->setResult(reconstruct(*session_.snapshot()), true);
  }

  // Actions of the course.
  void perform(const std::vector<SessionEdit>& edits) override {
    for (const SessionEdit& edit : edits) {
      apply(edit, session_);
      if (const auto* add = std::get_if<AddPose>(&edit)) added_.push_back(*add);
    }
    ++steps_;
    course_->noteChange();
  }
  std::uint32_t send(const SkinCommand& command) override {
    turns_.push_back(std::get<TurnTo>(command));
    return static_cast<std::uint32_t>(turns_.size());
  }
  void retryWriting() override { ++retries_; }
  void onWorkflowEvent(const WorkflowEvent& event) override {
    events_.push_back(event);
    if (const auto* wanted = std::get_if<AdviceWanted>(&event)) question_ = wanted->question;
  }

  // What it told.
  template <class Event>
  [[nodiscard]] std::vector<Event> told() const {
    return test::eventsOf<Event>(events_);
  }
  template <class Event>
  [[nodiscard]] std::vector<PoseId> posesOf() const {
    return collect(told<Event>(), [](const Event& event) { return event.captured.pose->id; });
  }

  // Events for the course.
  CapturedPose capture() {
    const auto ups = scriptedUpDirections(next_ + 1);
    const PoseId id(static_cast<std::uint32_t>(next_ + 1));
    CapturedPose captured;
    captured.frames = skin_.record(ups[next_], 20);
    captured.pose = std::make_shared<const PoseCapture>(averageFrames(captured.frames, id, {}));
    ++next_;
    return captured;
  }
  PoseId take() {
    const CapturedPose captured = capture();
    course_->take(captured);
    return captured.pose->id;
  }
  void store(PoseId pose) { course_->setStored(pose, {1, {}, false}); }
  void refuse(PoseId pose, CaptureWorkflow::Clock::time_point now = {}) {
    course_->setStored(pose, {0, Message::verbatim("the disk is full"), true}, now);
  }
  void solve() { course_->setResult(reconstruct(*session_.snapshot()), true); }
  void advise() {
    if (const auto question = std::exchange(question_, std::nullopt)) course_->setAdvice(adviseOn(*question));
  }
  void takeStoreAndSolve() {
    store(take());
    solve();
    advise();
  }
  void answerTurn(bool done) {
    course_->setOutcome(
        {static_cast<std::uint32_t>(turns_.size()), done, done ? Message() : Message::verbatim("out of reach")});
  }

  SimulatedSkin skin_{builtInCellModel("hex-bma150"), {}};
  SkinDescription description_;
  Session session_{builtInCellModel("hex-bma150"), {}};
  std::unique_ptr<CaptureWorkflow> course_;
  std::size_t next_ = 0;

  std::vector<AddPose> added_;
  std::size_t steps_ = 0;
  std::vector<TurnTo> turns_;
  int retries_ = 0;
  std::vector<WorkflowEvent> events_;
  std::optional<AdviceQuestion> question_;
};

TEST_F(CaptureWorkflowTest, APoseCountsAsCapturedOnlyWhenItIsOnDisk) {
  const PoseId pose = take();
  EXPECT_THAT(session_.poses(), SizeIs(1));
  EXPECT_THAT(posesOf<PoseTaken>(), ElementsAre(pose));
  EXPECT_THAT(posesOf<PoseKept>(), IsEmpty());
  EXPECT_EQ(course_->waiting(), 1U);
  refuse(pose);
  refuse(pose);
  EXPECT_THAT(posesOf<PoseKept>(), IsEmpty());
  EXPECT_THAT(told<FileRefused>(), SizeIs(1)) << "it is told once";
  EXPECT_TRUE(course_->isFileRefused());
  course_->tick(CaptureWorkflow::Clock::time_point(std::chrono::hours(1)));
  EXPECT_EQ(retries_, 0) << "without options nobody tries again by itself";
  EXPECT_FALSE(course_->isFinished());
  store(pose);
  EXPECT_THAT(posesOf<PoseKept>(), ElementsAre(pose));
  EXPECT_THAT(collect(told<PoseKept>(), &PoseKept::where), ElementsAre(KeptIn::File));
  EXPECT_EQ(course_->waiting(), 0U);
  EXPECT_FALSE(course_->isFileRefused());
  store(pose);
  EXPECT_THAT(posesOf<PoseKept>(), SizeIs(1)) << "once";
}

TEST_F(CaptureWorkflowTest, TellsThatTheFileWasWrittenAnewBeforeItsPose) {
  StoreOutcome outcome{1, {}, false};
  outcome.renewed = Message::verbatim("it was removed");
  course_->setStored(take(), outcome);
  store(take());
  const std::vector<std::size_t> kinds = collect(events_, &WorkflowEvent::index);
  EXPECT_LT(std::ranges::find(kinds, WorkflowEvent(FileRenewed{}).index()),
            std::ranges::find(kinds, WorkflowEvent(PoseKept{}).index()));
  EXPECT_THAT(told<FileRenewed>(), SizeIs(1));
}

TEST_F(CaptureWorkflowTest, WithoutAFileItCountsAtOnceAndIsSaidToBeInMemory) {
  const PoseId first = take();
  course_->setKeptIn(KeptIn::Memory);
  EXPECT_THAT(posesOf<PoseKept>(), ElementsAre(first)) << "what waited for the file does so no more";
  const PoseId second = take();
  EXPECT_THAT(posesOf<PoseKept>(), ElementsAre(first, second));
  EXPECT_THAT(collect(told<PoseKept>(), &PoseKept::where), ElementsAre(KeptIn::Memory, KeptIn::Memory));
  course_->setKeptIn(KeptIn::File);
  take();
  EXPECT_THAT(posesOf<PoseKept>(), SizeIs(2));
}

TEST_F(CaptureWorkflowTest, APoseThatCanNotBeWrittenForGoodIsLost) {
  course_->setStored(take(), {0, Message::verbatim("the session was closed"), false});
  EXPECT_THAT(collect(told<PoseLost>(), &PoseLost::why), ElementsAre(Message::verbatim("the session was closed")));
  EXPECT_THAT(posesOf<PoseKept>(), IsEmpty());
  EXPECT_EQ(course_->waiting(), 0U);
}

TEST_F(CaptureWorkflowTest, PosesThatAreBeingWrittenBecomeCapturedAfterTheSkinIsGoneButNotOfAnotherSession) {
  const PoseId first = take();
  const PoseId second = take();
  course_->end();
  store(first);
  EXPECT_THAT(posesOf<PoseKept>(), ElementsAre(first));
  course_->forget();
  store(second);
  EXPECT_THAT(posesOf<PoseKept>(), ElementsAre(first));
}

TEST_F(CaptureWorkflowTest, AFullDiskIsTriedAgainAndGivenUp) {
  using std::chrono::seconds;
  begin({.retry_every = seconds(1), .give_up_after = seconds(10)});
  const CaptureWorkflow::Clock::time_point start(seconds(100));
  const PoseId pose = take();
  course_->tick(start);
  refuse(pose, start);
  course_->tick(start);
  EXPECT_EQ(retries_, 0);
  course_->tick(start + seconds(1));
  course_->tick(start + seconds(1));
  EXPECT_EQ(retries_, 1);
  refuse(pose, start + seconds(1));
  course_->tick(start + seconds(9));
  EXPECT_EQ(retries_, 2);
  EXPECT_FALSE(course_->isFinished());
  course_->tick(start + seconds(10));
  EXPECT_TRUE(course_->isFinished());
  EXPECT_EQ(retries_, 2);
  EXPECT_EQ(course_->waiting(), 1U) << "it is still to be tried a last time";
}

TEST_F(CaptureWorkflowTest, RawSamplesGoToTheFileWhereTheyAreWanted) {
  take();
  EXPECT_EQ(added_.back().raw, nullptr);
  begin({.keep_raw = true});
  take();
  ASSERT_NE(added_.back().raw, nullptr);
  EXPECT_THAT(*added_.back().raw, SizeIs(20));
}

TEST_F(CaptureWorkflowTest, PosesAreLabelledByTheFirstResultOfTheSkin) {
  const auto without_poses = reconstruct(*session_.snapshot());
  for (int k = 0; k < 3; ++k) takeStoreAndSolve();
  for (const SessionPose& pose : session_.poses()) {
    EXPECT_FALSE(pose.capture->label.empty());
    EXPECT_EQ(pose.capture->label, poseLabel(*without_poses, *pose.capture));
  }
}

TEST_F(CaptureWorkflowTest, ARecaptureTakesPlaceAndNumberOfItsPoseInOneStepAndTheNextPoseGetsTheNextOne) {
  for (int k = 0; k < 3; ++k) takeStoreAndSolve();
  const auto result = reconstruct(*session_.snapshot());
  const PatchReconstruction& patch = *largestPatch(*result);
  const auto before = session_.poses()[1].capture;
  course_->recapture(PoseId(2));
  EXPECT_EQ(course_->recapturing(), PoseId(2));
  ASSERT_THAT(turns_, SizeIs(1)) << "the device is asked to turn there";
  EXPECT_EQ(turns_[0].cell, patch.origin);
  EXPECT_LT((turns_[0].up_u - patch.gravity[1].g_o).norm(), 1e-3);
  steps_ = 0;
  take();
  EXPECT_EQ(steps_, 1U);
  EXPECT_EQ(course_->recapturing(), std::nullopt);
  EXPECT_EQ(session_.poses()[1].capture->id, PoseId(2));
  EXPECT_NE(session_.poses()[1].capture, before);
  EXPECT_THAT(posesOf<PoseTaken>(), ElementsAre(PoseId(1), PoseId(2), PoseId(3), PoseId(2)));
  store(PoseId(2));
  EXPECT_EQ(posesOf<PoseKept>().back(), PoseId(2));
  take();
  ASSERT_THAT(session_.poses(), SizeIs(4));
  EXPECT_EQ(session_.poses()[3].capture->id, PoseId(4));
}

TEST_F(CaptureWorkflowTest, ARecaptureIsNotSaidToRepeatThePoseThatItReplaces) {
  for (int k = 0; k < 3; ++k) takeStoreAndSolve();
  const auto retake = [&](PoseId repeated) {
    course_->recapture(PoseId(2));
    CapturedPose captured = capture();
    captured.repeats = repeated;
    course_->take(captured);
    store(PoseId(2));
    return told<PoseKept>().back().captured.repeats;
  };
  EXPECT_EQ(retake(PoseId(2)), std::nullopt);
  EXPECT_EQ(retake(PoseId(3)), PoseId(3)) << "another one is told";
}

TEST_F(CaptureWorkflowTest, ARecaptureCountsWhenItIsOnDiskItselfNotWhenThePoseBeforeItIs) {
  const PoseId pose = take();
  course_->recapture(pose);
  course_->take(capture());
  ASSERT_THAT(session_.poses(), SizeIs(1));
  const PoseId again = session_.poses()[0].capture->id;
  EXPECT_NE(again, pose) << "the file will answer about both";
  store(pose);
  EXPECT_THAT(posesOf<PoseKept>(), ElementsAre(pose));
  EXPECT_EQ(course_->waiting(), 1U);
  store(again);
  EXPECT_THAT(posesOf<PoseKept>(), ElementsAre(pose, again));
}

TEST_F(CaptureWorkflowTest, APoseThatIsGoneIsNotRecaptured) {
  for (int k = 0; k < 2; ++k) takeStoreAndSolve();
  course_->recapture(PoseId(2));
  session_.removePose(1);
  course_->noteChange();
  EXPECT_EQ(course_->recapturing(), std::nullopt);
  course_->recapture(PoseId(2));
  EXPECT_EQ(course_->recapturing(), std::nullopt);
  take();
  EXPECT_THAT(session_.poses(), SizeIs(2));
}

TEST_F(CaptureWorkflowTest, ASkinWithOtherCellsDoesNotJoinAndOtherLinksAreTakenOver) {
  takeStoreAndSolve();
  course_->end();
  SkinDescription other = description_;
  other.neighbors.pop_back();
  EXPECT_FALSE(course_->join(session_, other));
  EXPECT_FALSE(course_->isOn());
  other = description_;
  for (CellReport& cell : other.neighbors) cell.neighbors.clear();
  EXPECT_TRUE(course_->join(session_, other));
  EXPECT_THAT(told<SkinChanged>(), SizeIs(1));
  EXPECT_EQ(session_.neighbors(), other.neighbors);
  course_->describe(other);
  EXPECT_THAT(told<SkinChanged>(), SizeIs(1)) << "nothing is new";
  course_->describe(description_);
  EXPECT_THAT(told<SkinChanged>(), SizeIs(2));
  EXPECT_THAT(session_.poses(), SizeIs(1)) << "poses stay";
  for (const SkinChanged& changed : told<SkinChanged>()) EXPECT_FALSE(changed.other_model);
}

TEST_F(CaptureWorkflowTest, AnotherCellModelIsNoticedAndTakenOver) {
  take();
  SkinDescription other = description_;
  CellModel model = *other.model;
  model.accelerometer.range_g = 4;
  other.model = std::make_shared<const CellModel>(model);
  course_->describe(other);
  EXPECT_TRUE(told<SkinChanged>().back().other_model);
  EXPECT_EQ(session_.model().accelerometer.range_g, 4);
  EXPECT_THAT(session_.poses(), SizeIs(1)) << "poses stay";
  course_->describe(other);
  EXPECT_THAT(told<SkinChanged>(), SizeIs(1)) << "nothing is new";
}

TEST_F(CaptureWorkflowTest, TheNextPoseIsWantedNeitherBeforeTheFirstNorOutOfReach) {
  advise();
  ASSERT_TRUE(course_->nextPose());
  EXPECT_FALSE(course_->isNextPoseWanted()) << "any will do for the first";
  takeStoreAndSolve();
  ASSERT_TRUE(course_->isNextPoseWanted());
  const Eigen::Vector3d before = course_->nextPose()->up;
  course_->skipPose();
  advise();
  EXPECT_LT(course_->nextPose()->up.dot(before), std::cos(30 * kDegree));
  course_->end();
  EXPECT_EQ(course_->nextPose(), std::nullopt);
}

TEST_F(CaptureWorkflowTest, AnAnswerToAnEarlierQuestionIsDropped) {
  takeStoreAndSolve();
  course_->skipPose();
  const AdviceQuestion first = *question_;
  course_->skipPose();
  const Eigen::Vector3d before = course_->nextPose()->up;
  course_->setAdvice(adviseOn(first));
  EXPECT_EQ(course_->nextPose()->up, before);
}

TEST_F(CaptureWorkflowTest, TheRobotTurnsWhenPoseResultAndAdviceAreThere) {
  advise();
  course_->setRobot(true);
  EXPECT_THAT(turns_, IsEmpty()) << "the first pose is taken where the part lies";
  const PoseId first = take();
  solve();
  advise();
  EXPECT_THAT(turns_, IsEmpty()) << "the pose is not on disk yet";
  store(first);
  EXPECT_THAT(turns_, SizeIs(1));
  answerTurn(true);
  const PoseId second = take();
  store(second);
  EXPECT_THAT(turns_, SizeIs(1)) << "there is no result yet";
  solve();
  EXPECT_THAT(turns_, SizeIs(1)) << "there is no advice yet";
  advise();
  ASSERT_THAT(turns_, SizeIs(2));
  EXPECT_EQ(turns_[1].up_u, course_->nextPose()->up);
}

TEST_F(CaptureWorkflowTest, TheRobotStopsWhenThereAreEnoughOrAsManyAsItWasTold) {
  course_->setRobot(true);
  while (told<WorkflowFinished>().size() == 0 && session_.poses().size() < 2 * CaptureWorkflow::kMaxPosesByItself)
    takeStoreAndSolve();
  EXPECT_THAT(told<WorkflowFinished>(), SizeIs(1));
  EXPECT_TRUE(course_->isFinished());
  EXPECT_FALSE(course_->isRobotOn());
  EXPECT_FALSE(reconstruct(*session_.snapshot())->assessment.wantsPose());
  ASSERT_FALSE(course_->wantsMorePoses());
  EXPECT_THAT(turns_, SizeIs(session_.poses().size() - 1));

  const std::size_t wanted = CaptureWorkflow::kMaxPosesByItself + 2;
  ASSERT_LT(session_.poses().size(), wanted);
  turns_.clear();
  course_->setRobot(true, wanted);
  EXPECT_TRUE(course_->isRobotOn());
  EXPECT_TRUE(course_->wantsMorePoses());
  EXPECT_THAT(turns_, SizeIs(1)) << "it goes on at once";
  while (told<WorkflowFinished>().size() == 1 && session_.poses().size() < 2 * wanted) takeStoreAndSolve();
  EXPECT_THAT(session_.poses(), SizeIs(wanted));
  EXPECT_FALSE(course_->isRobotOn());
  EXPECT_TRUE(course_->isFinished());
  EXPECT_FALSE(course_->wantsMorePoses()) << "the number was the robot's";
  course_->setRobot(true);
  EXPECT_FALSE(course_->isRobotOn()) << "without a number, the assessment says that there are enough";
  turns_.clear();
  course_->setRobot(true, wanted);
  EXPECT_FALSE(course_->isRobotOn()) << "so many are there already";
  EXPECT_THAT(turns_, IsEmpty());
}

TEST_F(CaptureWorkflowTest, ANumberOfPosesEndsItWhateverTheyAreGoodFor) {
  begin({.poses = 2});
  takeStoreAndSolve();
  EXPECT_FALSE(course_->isFinished());
  const PoseId second = take();
  take();
  EXPECT_THAT(session_.poses(), SizeIs(2)) << "more are not taken";
  solve();
  EXPECT_FALSE(course_->isFinished()) << "not before it is on disk";
  store(second);
  EXPECT_TRUE(course_->isFinished());
}

TEST_F(CaptureWorkflowTest, ARefusedTurnIsNotAdvisedAgainAndARobotGivesUp) {
  course_->setRobot(true);
  takeStoreAndSolve();
  ASSERT_THAT(turns_, SizeIs(1));
  answerTurn(false);
  advise();
  ASSERT_THAT(told<TurnRefused>(), SizeIs(1));
  EXPECT_EQ(told<TurnRefused>()[0].why.english(), "out of reach");
  ASSERT_THAT(turns_, SizeIs(2));
  EXPECT_LT(turns_[1].up_u.dot(turns_[0].up_u), std::cos(30 * kDegree));
  for (std::size_t k = 1; k <= CaptureWorkflow::kMaxRefusals; ++k) {
    EXPECT_TRUE(course_->isRobotOn());
    answerTurn(false);
    advise();
  }
  EXPECT_FALSE(course_->isRobotOn());
  EXPECT_TRUE(told<TurnRefused>().back().gave_up);
  EXPECT_THAT(turns_, SizeIs(CaptureWorkflow::kMaxRefusals + 1));
}

TEST_F(CaptureWorkflowTest, ADeviceThatIsGoneForAMomentHasRefusedNothingAndTheRobotGoesOn) {
  course_->setRobot(true);
  takeStoreAndSolve();
  ASSERT_THAT(turns_, SizeIs(1));
  const Eigen::Vector3d there = turns_[0].up_u;
  course_->setSending(false);
  answerTurn(false);
  advise();
  EXPECT_THAT(told<TurnRefused>(), IsEmpty());
  EXPECT_THAT(turns_, SizeIs(1)) << "nobody is there to be asked";
  EXPECT_TRUE(course_->isRobotOn());
  course_->setSending(true);
  ASSERT_THAT(turns_, SizeIs(2));
  EXPECT_EQ(turns_[1].up_u, there) << "it can be reached";
  course_->setSending(true);
  EXPECT_THAT(turns_, SizeIs(2)) << "it is asked once";
}

TEST_F(CaptureWorkflowTest, ATurnByHandEndsTheRobotsRunAndItsRefusalCountsForNothing) {
  course_->setRobot(true);
  takeStoreAndSolve();
  course_->turnTo(2 * Eigen::Vector3d::UnitX());
  EXPECT_FALSE(course_->isRobotOn());
  EXPECT_EQ(turns_.back().up_u, Eigen::Vector3d::UnitX());
  answerTurn(false);
  EXPECT_THAT(told<TurnRefused>(), IsEmpty());
}

TEST_F(CaptureWorkflowTest, ATurnThatIsAskedForBeforeTheNewAdviceWaitsForIt) {
  takeStoreAndSolve();
  const Eigen::Vector3d old = course_->nextPose()->up;
  store(take());
  course_->turnToNextPose();
  EXPECT_THAT(turns_, IsEmpty()) << "the advice is that of one pose";
  solve();
  EXPECT_THAT(turns_, IsEmpty());
  advise();
  ASSERT_THAT(turns_, SizeIs(1));
  EXPECT_EQ(turns_[0].up_u, course_->nextPose()->up);
  EXPECT_FALSE(turns_[0].up_u.isApprox(old));
  takeStoreAndSolve();
  EXPECT_THAT(turns_, SizeIs(1)) << "it was asked for once";
  store(take());
  course_->turnToNextPose();
  course_->turnTo(Eigen::Vector3d::UnitX());
  solve();
  advise();
  EXPECT_THAT(turns_, SizeIs(2)) << "another turn was asked for instead";
}

TEST_F(CaptureWorkflowTest, ADeviceThatCanNotTurnIsNotAsked) {
  description_.can_turn = false;
  begin({});
  course_->setRobot(true);
  EXPECT_FALSE(course_->isRobotOn());
  takeStoreAndSolve();
  course_->turnToNextPose();
  course_->turnTo(Eigen::Vector3d::UnitX());
  course_->recapture(PoseId(1));
  EXPECT_THAT(turns_, IsEmpty());
  EXPECT_EQ(course_->recapturing(), PoseId(1));
}

}  // namespace
}  // namespace hexoderm
