#include "hexoderm/capture/capture_workflow.h"

#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/reconstructor.h"
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
    if (const auto* taken = std::get_if<PoseTaken>(&event)) taken_.push_back(taken->captured.pose->id);
    if (const auto* kept = std::get_if<PoseKept>(&event)) {
      kept_.push_back(kept->captured.pose->id);
      kept_in_.push_back(kept->where);
      repeats_ = kept->captured.repeats;
    }
    if (const auto* lost = std::get_if<PoseLost>(&event)) lost_.push_back(lost->why);
    if (std::holds_alternative<FileRefused>(event)) ++refusals_;
    if (std::holds_alternative<FileRenewed>(event)) kept_when_renewed_.push_back(kept_.size());
    if (const auto* changed = std::get_if<SkinChanged>(&event)) {
      ++skin_changes_;
      other_models_ += changed->other_model ? 1 : 0;
    }
    if (std::holds_alternative<WorkflowFinished>(event)) ++finishes_;
    if (const auto* wanted = std::get_if<AdviceWanted>(&event)) question_ = wanted->question;
    if (const auto* refused = std::get_if<TurnRefused>(&event)) turn_refusals_.push_back(*refused);
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
  std::vector<PoseId> taken_, kept_;
  std::vector<KeptIn> kept_in_;
  std::optional<PoseId> repeats_;  ///< of the pose that was kept last
  std::vector<Message> lost_;
  std::vector<std::size_t> kept_when_renewed_;  ///< the number of poses that were kept when the file was written anew
  int refusals_ = 0, skin_changes_ = 0, other_models_ = 0, finishes_ = 0;
  std::optional<AdviceQuestion> question_;
  std::vector<TurnRefused> turn_refusals_;
};

TEST_F(CaptureWorkflowTest, APoseCountsAsCapturedOnlyWhenItIsOnDisk) {
  const PoseId pose = take();
  EXPECT_THAT(session_.poses(), SizeIs(1));
  EXPECT_THAT(taken_, ElementsAre(pose));
  EXPECT_THAT(kept_, IsEmpty());
  EXPECT_EQ(course_->waiting(), 1U);
  refuse(pose);
  refuse(pose);
  EXPECT_THAT(kept_, IsEmpty());
  EXPECT_EQ(refusals_, 1) << "it is told once";
  EXPECT_TRUE(course_->isFileRefused());
  store(pose);
  EXPECT_THAT(kept_, ElementsAre(pose));
  EXPECT_THAT(kept_in_, ElementsAre(KeptIn::File));
  EXPECT_EQ(course_->waiting(), 0U);
  EXPECT_FALSE(course_->isFileRefused());
  store(pose);
  EXPECT_THAT(kept_, SizeIs(1)) << "once";
}

TEST_F(CaptureWorkflowTest, TellsThatTheFileWasWrittenAnewBeforeItsPose) {
  StoreOutcome outcome{1, {}, false};
  outcome.renewed = Message::verbatim("it was removed");
  course_->setStored(take(), outcome);
  store(take());
  EXPECT_THAT(kept_when_renewed_, ElementsAre(0U));
}

TEST_F(CaptureWorkflowTest, WithoutAFileItCountsAtOnceAndIsSaidToBeInMemory) {
  const PoseId first = take();
  course_->setKeptIn(KeptIn::Memory);
  EXPECT_THAT(kept_, ElementsAre(first)) << "what waited for the file does so no more";
  const PoseId second = take();
  EXPECT_THAT(kept_, ElementsAre(first, second));
  EXPECT_THAT(kept_in_, ElementsAre(KeptIn::Memory, KeptIn::Memory));
  course_->setKeptIn(KeptIn::File);
  take();
  EXPECT_THAT(kept_, SizeIs(2));
}

TEST_F(CaptureWorkflowTest, APoseThatCanNotBeWrittenForGoodIsLost) {
  course_->setStored(take(), {0, Message::verbatim("the session was closed"), false});
  EXPECT_THAT(lost_, ElementsAre(Message::verbatim("the session was closed")));
  EXPECT_THAT(kept_, IsEmpty());
  EXPECT_EQ(course_->waiting(), 0U);
}

TEST_F(CaptureWorkflowTest, PosesThatAreBeingWrittenBecomeCapturedAfterTheSkinIsGoneButNotOfAnotherSession) {
  const PoseId first = take();
  const PoseId second = take();
  course_->end();
  store(first);
  EXPECT_THAT(kept_, ElementsAre(first));
  course_->forget();
  store(second);
  EXPECT_THAT(kept_, ElementsAre(first));
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

TEST_F(CaptureWorkflowTest, WithoutOptionsNobodyTriesAgainByItself) {
  refuse(take());
  course_->tick(CaptureWorkflow::Clock::time_point(std::chrono::hours(1)));
  EXPECT_EQ(retries_, 0);
  EXPECT_FALSE(course_->isFinished());
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
  EXPECT_THAT(taken_, ElementsAre(PoseId(1), PoseId(2), PoseId(3), PoseId(2)));
  store(PoseId(2));
  EXPECT_EQ(kept_.back(), PoseId(2));
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
    return repeats_;
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
  EXPECT_THAT(kept_, ElementsAre(pose));
  EXPECT_EQ(course_->waiting(), 1U);
  store(again);
  EXPECT_THAT(kept_, ElementsAre(pose, again));
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
  EXPECT_EQ(skin_changes_, 1);
  EXPECT_EQ(session_.neighbors(), other.neighbors);
  course_->describe(other);
  EXPECT_EQ(skin_changes_, 1) << "nothing is new";
  course_->describe(description_);
  EXPECT_EQ(skin_changes_, 2);
  EXPECT_THAT(session_.poses(), SizeIs(1)) << "poses stay";
  EXPECT_EQ(other_models_, 0);
}

TEST_F(CaptureWorkflowTest, AnotherCellModelIsNoticedAndTakenOver) {
  take();
  SkinDescription other = description_;
  CellModel model = *other.model;
  model.accelerometer.range_g = 4;
  other.model = std::make_shared<const CellModel>(model);
  course_->describe(other);
  EXPECT_EQ(other_models_, 1);
  EXPECT_EQ(session_.model().accelerometer.range_g, 4);
  EXPECT_THAT(session_.poses(), SizeIs(1)) << "poses stay";
  course_->describe(other);
  EXPECT_EQ(skin_changes_, 1) << "nothing is new";
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
  while (finishes_ == 0 && session_.poses().size() < 2 * CaptureWorkflow::kMaxPosesByItself) takeStoreAndSolve();
  EXPECT_EQ(finishes_, 1);
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
  while (finishes_ == 1 && session_.poses().size() < 2 * wanted) takeStoreAndSolve();
  EXPECT_THAT(session_.poses(), SizeIs(wanted));
  EXPECT_FALSE(course_->isRobotOn());
  EXPECT_TRUE(course_->isFinished());
  EXPECT_FALSE(course_->wantsMorePoses()) << "the number was the robot's";
  course_->setRobot(true);
  EXPECT_FALSE(course_->isRobotOn()) << "without a number, the assessment says that there are enough";
}

TEST_F(CaptureWorkflowTest, ANumberThatIsReachedAlreadyStopsTheRobotAtOnce) {
  takeStoreAndSolve();
  takeStoreAndSolve();
  turns_.clear();
  course_->setRobot(true, 2);
  EXPECT_FALSE(course_->isRobotOn());
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
  ASSERT_THAT(turn_refusals_, SizeIs(1));
  EXPECT_EQ(turn_refusals_[0].why.english(), "out of reach");
  ASSERT_THAT(turns_, SizeIs(2));
  EXPECT_LT(turns_[1].up_u.dot(turns_[0].up_u), std::cos(30 * kDegree));
  for (std::size_t k = 1; k <= CaptureWorkflow::kMaxRefusals; ++k) {
    EXPECT_TRUE(course_->isRobotOn());
    answerTurn(false);
    advise();
  }
  EXPECT_FALSE(course_->isRobotOn());
  EXPECT_TRUE(turn_refusals_.back().gave_up);
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
  EXPECT_THAT(turn_refusals_, IsEmpty());
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
  EXPECT_THAT(turn_refusals_, IsEmpty());
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
