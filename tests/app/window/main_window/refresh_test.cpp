// How often the window is brought up to date, and painted.

#include "app/window/main_window/main_window.h"
#include "tests/app/window/window_test.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/capture/hold_ring.h"
#include "widgets/patch/patch_view.h"
#include "widgets/patch/scene_widget.h"

namespace hexoderm {
namespace {

class RefreshTest : public WindowTest {};

/// Counts how often a widget is painted.
class PaintCounter : public QObject {
 public:
  explicit PaintCounter(QWidget* watched) { watched->installEventFilter(this); }
  [[nodiscard]] int count() const { return count_; }

 protected:
  bool eventFilter(QObject* /*watched*/, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++count_;
    return false;
  }

 private:
  int count_ = 0;
};

TEST_F(RefreshTest, AWindowThatHasTheKeyboardIsNotPaintedAnewWhenADialogTakesIt) {
  QTest::mouseClick(find<QWidget>("topBar"), Qt::LeftButton);
  ASSERT_TRUE(waitUntil([this] { return QApplication::focusWidget() == window_.get(); }));
  test::letTurnsPass();
  auto* sentence = find<QLabel>("bannerSentence");
  const PaintCounter painted(sentence);
  QMessageBox box(window_.get());
  box.show();
  ASSERT_TRUE(test::waitUntilActive(box));
  test::letTurnsPass();
  EXPECT_EQ(painted.count(), 0);
  sentence->update();
  EXPECT_TRUE(waitUntil([&] { return painted.count() > 0; }));
}

TEST_F(RefreshTest, TheWindowIsRefreshedOnceHoweverMuchAnActionChangesAndAtOnceForAPicture) {
  ASSERT_NO_FATAL_FAILURE(restWithDemoPoses(2));
  clickRow("poseView", 0);
  ASSERT_TRUE(waitUntilIdle());
  test::letTurnsPass();
  ASSERT_TRUE(action("actionTogglePose")->isEnabled());

  const QSignalSpy changed(&controller(), &SessionController::changed);
  const QSignalSpy next_pose(&controller().liveSession(), &LiveSession::nextPoseChanged);
  const QSignalSpy refreshed(window_.get(), &MainWindow::refreshed);
  action("actionTogglePose")->trigger();
  const int at_once = changed.count() + next_pose.count();
  EXPECT_GE(at_once, 2) << "there was nothing to be brought together";
  EXPECT_EQ(refreshed.count(), 0) << "the window waits for the next turn of the event loop";
  ASSERT_TRUE(waitUntilIdle());
  test::letTurnsPass();
  // Once for all that the action changed; and what a result brings later, on a busy computer in turns of its own.
  EXPECT_GE(refreshed.count(), 1);
  EXPECT_LE(refreshed.count(), 1 + changed.count() + next_pose.count() - at_once);
  const int before = refreshed.count();
  controller().setPoseDisabled(1, true);
  ASSERT_EQ(refreshed.count(), before);
  EXPECT_FALSE(window_->picture().isNull());
  EXPECT_EQ(refreshed.count(), before + 1);
}

/// The demo's hand trembles and drifts, twenty times as fast as a person's, and the picture follows what is no tremor.
TEST_F(RefreshTest, ASkinThatIsHeldStillIsHardlyEverPaintedAnew) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  auto* patch = window_->findChild<PatchView*>();
  ASSERT_TRUE(waitUntil([&] { return !patch->isAnimating(); }));
  const PaintCounter painted[] = {
      PaintCounter(patch->findChild<SceneWidget*>()), PaintCounter(window_->findChild<CoverageView*>()),
      PaintCounter(window_->findChild<HoldRing*>()), PaintCounter(find<QLabel>("captureWait"))};
  const QSignalSpy previews(&controller().liveSession().source(), &LiveSource::previewChanged);
  constexpr int kReadings = 120;
  ASSERT_TRUE(waitUntil([&] { return previews.count() >= kReadings; }));
  for (const PaintCounter& part : painted) EXPECT_LT(part.count(), previews.count() / 2);
}

}  // namespace
}  // namespace hexoderm
