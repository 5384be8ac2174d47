// Undo and redo of every command that changes a session: in the window, in its result and in its file.

#include "tests/app/window/window_test.h"

namespace hexoderm {
namespace {

/// The parts of a session that can be changed.
struct State {
  std::vector<std::pair<PoseId, bool>> poses;  ///< with "disabled"
  std::vector<double> readings;                ///< one of each pose, which tells it from others of its number
  std::vector<MutedLink> muted;
  friend bool operator==(const State&, const State&) = default;
};
void PrintTo(const State& state, std::ostream* out) {
  for (const auto& [pose, disabled] : state.poses) *out << pose << (disabled ? " disabled, " : ", ");
  for (const MutedLink& link : state.muted) {
    *out << link.source.cell << ':' << link.source.port << " is aside (" << link.why << "), ";
  }
}
State stateOf(const Session& session) {
  State state;
  for (const SessionPose& pose : session.poses()) {
    state.poses.emplace_back(pose.capture->id, pose.disabled);
    state.readings.push_back(pose.capture->samples.front().mean_g.x());
  }
  state.muted = session.mutedLinks();
  return state;
}

class WindowUndoTest : public WindowTest {
 protected:
  /// A session of four poses that is kept in a file, with one link that was set aside for a reason.
  void openKept() {
    Session session = simulated(4);
    const CellReport& cell = session.neighbors().back();
    const NeighborReport& link = cell.neighbors.front();
    aside_ = {{cell.id, link.port}, {link.cell, link.cell_port.value()}};
    session.setLinkMuted(aside_.first, aside_.second, true, "the wire at the elbow");
    ASSERT_NO_FATAL_FAILURE(openSession("arm.hexo", session));
    ASSERT_TRUE(waitUntilKept());
  }
  State now() { return stateOf(*controller().session()); }
  /// The session, its result and its file are all like this.
  void expectAllAre(const State& expected, const char* when) {
    ASSERT_TRUE(waitUntilKept()) << when;
    EXPECT_EQ(now(), expected) << when;
    EXPECT_EQ(stateOf(readSessionStore(path_.toStdString())), expected) << when << ", in the file";
    const Reconstruction& result = *controller().reconstruction();
    ASSERT_EQ(result.poses.size(), expected.poses.size()) << when;
    for (std::size_t k = 0; k < expected.poses.size(); ++k) {
      EXPECT_EQ(result.poses[k].pose, expected.poses[k].first) << when;
      EXPECT_EQ(result.poses[k].enabled, !expected.poses[k].second) << when;
    }
    for (const MutedLink& link : expected.muted) {
      const LinkEstimate* shown = result.findLink(link.source, link.target);
      ASSERT_NE(shown, nullptr) << when;
      EXPECT_FALSE(shown->used) << when;
    }
  }
  void undo() { press(Qt::Key_Z, Qt::ControlModifier); }
  void redo() { press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }

  /// Does it, takes it back, does it again by both keys. `words`: what the menu calls it.
  void expectUndoAndRedo(const std::function<void()>& change, const QString& words) {
    const State before = now();
    change();
    const State after = now();
    ASSERT_FALSE(after == before);
    ASSERT_NO_FATAL_FAILURE(expectAllAre(after, "done"));
    EXPECT_THAT(action("actionUndo")->text(), HasText(words));
    undo();
    ASSERT_NO_FATAL_FAILURE(expectAllAre(before, "undone"));
    EXPECT_THAT(action("actionRedo")->text(), HasText(words));
    redo();
    ASSERT_NO_FATAL_FAILURE(expectAllAre(after, "redone"));
    undo();
    ASSERT_NO_FATAL_FAILURE(expectAllAre(before, "undone again"));
    press(Qt::Key_Y, Qt::ControlModifier);
    ASSERT_NO_FATAL_FAILURE(expectAllAre(after, "redone by the other key"));
    expectDisabled("actionRedo", "Nothing to redo");
  }
  void pickPose(int row) {
    clickRow("poseView", row);
    ASSERT_TRUE(waitUntil([this] { return action("actionTogglePose")->isEnabled(); }));
  }

  const QString path_ = pathTo("arm.hexo");
  Selection::Link aside_;
};

TEST_F(WindowUndoTest, APoseThatIsDisabledEnabledAgainOrDeletedWhileItIsDisabled) {
  ASSERT_NO_FATAL_FAILURE(openKept());
  expectDisabled("actionTogglePose", "Pick a pose");
  ASSERT_NO_FATAL_FAILURE(pickPose(1));
  const auto toggle = [this] { press(Qt::Key_Delete); };
  expectUndoAndRedo(toggle, "disable pose 2");
  expectUndoAndRedo(toggle, "enable pose 2");
  toggle();
  ASSERT_TRUE(waitUntilKept());
  expectUndoAndRedo([this] { press(Qt::Key_Delete, Qt::ShiftModifier); }, "delete pose 2");
  // What was undone is gone when something else is done.
  undo();
  ASSERT_TRUE(waitUntilKept());
  ASSERT_NO_FATAL_FAILURE(pickPose(2));
  toggle();
  const State last = now();
  redo();
  ASSERT_NO_FATAL_FAILURE(expectAllAre(last, "nothing to redo"));
}

TEST_F(WindowUndoTest, ALinkThatIsSetAsideAndOneThatIsTakenBackWithTheReasonThatItWasSetAsideFor) {
  ASSERT_NO_FATAL_FAILURE(openKept());
  ASSERT_EQ(now().muted.size(), 1U);
  EXPECT_EQ(now().muted[0].why, "the wire at the elbow");
  const auto mute = [this] { press(Qt::Key_M); };
  const LinkEstimate& link = controller().reconstruction()->patches.front().links.front();
  window_->selection().selectLink(link.source, link.target);
  expectUndoAndRedo(mute, "aside");
  window_->selection().selectLink(aside_.first, aside_.second);
  expectUndoAndRedo(mute, "back");
  EXPECT_TRUE(waitUntil([this] {
    const LinkEstimate* back = controller().reconstruction()->findLink(aside_.first, aside_.second);
    return back != nullptr && back->used;
  }));
}

TEST_F(WindowUndoTest, APoseThatIsTakenAndOneThatIsTakenAgainInOneStep) {
  window_->connectTo({"sim:x17?speed=20", path_, false});
  ASSERT_TRUE(waitForPoses(1));
  controller().liveSession().setAutomatic(false);
  ASSERT_TRUE(waitUntilKept());
  const auto capture = [this] {
    press(Qt::Key_Space);
    ASSERT_TRUE(waitForPoses(2));
  };
  expectUndoAndRedo(capture, "take pose 2");
  const int steps = controller().undoStack()->count();
  expectUndoAndRedo(
      [this] {
        clickRow("poseView", 0);
        press(Qt::Key_R);
        const auto before = controller().session()->poses()[0].capture;
        press(Qt::Key_Space);
        ASSERT_TRUE(waitUntil([&] { return controller().session()->poses()[0].capture != before; }));
      },
      "recapture pose 1");
  EXPECT_EQ(controller().undoStack()->count(), steps + 1);
  EXPECT_EQ(now().poses[0].first, PoseId(1)) << "it keeps its number";
  EXPECT_EQ(now().poses[1].first, PoseId(2));
}

}  // namespace
}  // namespace hexoderm
