#include "widgets/capture/capture_panel.h"

#include "hexoderm/base/units.h"
#include "tests/support/qt_wait.h"
#include "widgets/capture/capture_words.h"
#include "widgets/capture/hold_ring.h"
#include "widgets/capture/live_strip.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

HoldStatus shaking() {
  HoldStatus hold;
  hold.stillness.blocker = Blocker::Shaking;
  hold.stillness.cells = 17;
  hold.stillness.excess_cell = CellId(7);
  hold.stillness.excess_g = 0.044;
  hold.stillness.excess_limit_g = 0.030;
  return hold;
}

NextPose nextPose() {
  NextPose next;
  next.target = {CellId(7), Facing::Floor};
  next.turn_rad = 72 * kDegree;
  next.gain = PoseGain::OutOfPlane;
  next.sigma_now_rad = 4.9 * kDegree;
  next.sigma_then_rad = 0.7 * kDegree;
  return next;
}

SourceStatus streaming() {
  SourceStatus status;
  status.state = SourceState::Streaming;
  return status;
}

class CapturePanelTest : public testing::Test {
 protected:
  void show(const QSize& size = {300, 640}) {
    panel.resize(size);
    panel.show();
    ASSERT_TRUE(test::waitUntilExposed(panel));
  }
  QString text(const char* name) { return panel.findChild<QLabel*>(QLatin1String(name))->text(); }
  HoldRing* ring() { return panel.findChild<HoldRing*>(); }

  QAction automatic{"Capture by itself when still"};
  QAction capture{"Capture now"};
  QAction skip{"Skip this pose"};
  QAction turn{"Turn the part for me"};
  CapturePanel panel{{&automatic, &capture, &skip, &turn}};
};

TEST(LiveStrip, NamesWhatWasLostAndNothingWhereNothingWas) {
  SourceStatus status;
  status.frames = 17230;
  HoldStatus hold;
  EXPECT_EQ(lossesText(status, hold), "");
  EXPECT_EQ(countersText(status, hold), "17,230 frames · 0 lost · 0 late");
  status.lost_samples = 1;
  EXPECT_EQ(lossesText(status, hold), "1 sample lost");
  status.lost_samples = 12;
  EXPECT_EQ(lossesText(status, hold), "12 samples lost");
  status.late_frames = 1;
  hold.late_frames = 2;
  status.dropped_by_device = 40;
  EXPECT_EQ(lossesText(status, hold), "12 samples lost · 3 frames late · 40 samples dropped by the device");
  EXPECT_EQ(countersText(status, hold), "17,230 frames · 12 lost · 3 late · 40 dropped by the device");
}

TEST_F(CapturePanelTest, SaysWhatToDoHowFarAndWhy) {
  show();
  EXPECT_TRUE(ring()->isHidden()) << "no skin is connected";
  panel.setSource(streaming());
  EXPECT_TRUE(text("captureWhat").startsWith("Working out"));
  panel.setAdvice(nextPose());
  EXPECT_EQ(text("captureWhat"), "Turn the part so that cell 7 faces the floor.");
  EXPECT_EQ(text("captureTurn"), "About 70° around the horizontal axis shown.");
  EXPECT_TRUE(text("captureWhy").contains("offset"));
  EXPECT_EQ(text("captureSigma"), "With this pose the error falls to about 14\u00a0% of what it is now.");
}

TEST_F(CapturePanelTest, SaysWhenThePartIsThereAndWhenThereIsEnoughAndWhatAnotherPoseWouldStillBringThen) {
  panel.setSource(streaming());
  NextPose next = nextPose();
  next.turn_rad = 8 * kDegree;
  panel.setAdvice(next);
  EXPECT_EQ(text("captureTurn"), "It is there: hold it like this.");
  next.worthwhile = false;
  panel.setAdvice(next);
  EXPECT_TRUE(text("captureWhat").contains("enough poses"));
  EXPECT_EQ(text("captureSigma"), QString());
  next.is_good = true;
  panel.setAdvice(next);
  EXPECT_EQ(text("captureWhat"), "There are enough poses: the result is good.");
  EXPECT_EQ(text("captureWhy"), "Why: at the worst cell the error is below 2° and 3 mm.");
  EXPECT_EQ(text("captureSigma"), "With another pose the error would fall to about 14\u00a0% of what it is now.");
}

TEST_F(CapturePanelTest, EveryBlockerHasItsWords) {
  HoldStatus hold = shaking();
  for (const Blocker blocker :
       {Blocker::None, Blocker::Waiting, Blocker::NotMoved, Blocker::Turning, Blocker::Shaking, Blocker::CellTurning}) {
    hold.stillness.blocker = blocker;
    EXPECT_FALSE(holdText(hold).word.isEmpty());
    EXPECT_FALSE(waitText(hold).isEmpty());
  }
  hold.stillness.odd_cells = {{CellId(5), OddCellKind::Noisy, 0.2}, {CellId(9), OddCellKind::Silent, 2}};
  EXPECT_EQ(oddCellsText(hold), "Not waited for: cell 5 (noisy), cell 9 (silent)");
}

TEST_F(CapturePanelTest, TheRingCountsWhileReadingsAreTaken) {
  show();
  panel.setSource(streaming());
  HoldStatus hold = shaking();
  hold.stillness.blocker = Blocker::None;
  hold.phase = HoldPhase::Collecting;
  hold.progress = 0.6;
  const QImage before = ring()->grab().toImage();
  panel.setHold(hold);
  EXPECT_EQ(ring()->content().word, "Hold…");
  EXPECT_EQ(ring()->content().detail, "60 %");
  EXPECT_NE(ring()->grab().toImage(), before);
}

TEST_F(CapturePanelTest, ACaptureIsShownForAMomentAndAPoseThatIsBeingWrittenIsNotSaidToBeCaptured) {
  show();
  panel.setSource(streaming());
  panel.setHold(HoldStatus{});
  panel.showCaptured(PoseId(3), "Pose 3 repeats pose 1.");
  EXPECT_TRUE(ring()->content().captured);
  EXPECT_EQ(ring()->content().detail, "pose 3");
  EXPECT_TRUE(test::waitUntil([&] { return !ring()->content().captured; }));
  EXPECT_EQ(text("captureRemark"), "Pose 3 repeats pose 1.");
  panel.showCaptured(PoseId(3), "Pose 3 repeats pose 1.");
  panel.showWriting(PoseId(4));
  EXPECT_FALSE(ring()->content().captured);
  EXPECT_EQ(ring()->content().word, "Writing");
  EXPECT_EQ(ring()->content().detail, "pose 4");
  EXPECT_EQ(text("captureRemark"), QString()) << "that was said of the pose before";
  panel.setHold(HoldStatus{});
  EXPECT_EQ(ring()->content().word, "Writing") << "as long as the part is not moved";
  panel.showCaptured(PoseId(4));
  EXPECT_TRUE(ring()->content().captured);
  EXPECT_TRUE(test::waitUntil([&] { return !ring()->content().captured; }));
  EXPECT_NE(ring()->content().word, "Writing");

  panel.showWriting(PoseId(5));
  HoldStatus moved_on;
  moved_on.stillness.armed = true;
  moved_on.progress = 0.2;
  panel.setHold(moved_on);
  EXPECT_NE(ring()->content().word, "Writing") << "the next hold has begun";
  panel.showWriting(PoseId(6));
  panel.endWriting(PoseId(5));
  EXPECT_EQ(ring()->content().word, "Writing");
  panel.endWriting(PoseId(6));
  EXPECT_NE(ring()->content().word, "Writing");
}

TEST_F(CapturePanelTest, ASilentSourceIsSaidInsteadOfOldReadings) {
  show();
  panel.setSource(streaming());
  panel.setHold(shaking());
  SourceStatus silent;
  silent.state = SourceState::Silent;
  silent.message = Message::verbatim("Nothing came for 1 s");
  panel.setSource(silent);
  EXPECT_EQ(ring()->content().word, "Silent");
  EXPECT_EQ(text("captureWait"), "Nothing came for 1 s");
}

TEST_F(CapturePanelTest, TheSentenceGrowsWithItsPlaceAndIsNeverCutOff) {
  panel.setSource(streaming());
  panel.setAdvice(nextPose());
  panel.setHold(shaking());
  auto* what = panel.findChild<QLabel*>("captureWhat");
  show({260, 700});
  const double usual = panel.font().pointSizeF();
  EXPECT_GE(what->font().pointSizeF(), 1.6 * usual - 0.01);
  EXPECT_GE(what->height(), what->heightForWidth(what->width()));
  const double narrow = what->font().pointSizeF();
  panel.resize(1200, 500);
  EXPECT_TRUE(test::waitUntil([&] { return what->font().pointSizeF() > 1.2 * narrow; }));
}

}  // namespace
}  // namespace hexoderm
