#include "widgets/controls/view_mark.h"

#include <gtest/gtest.h>
#include "tests/support/qt_wait.h"

namespace hexoderm {
namespace {

class ViewMarkTest : public testing::Test {
 protected:
  ViewMarkTest() : mark_(new ViewMark(&view_)) {
    QPalette black;
    black.setColor(QPalette::Window, Qt::black);
    view_.setAutoFillBackground(true);
    view_.setPalette(black);
    view_.resize(400, 300);
    view_.show();
    EXPECT_TRUE(test::waitUntilExposed(view_));
  }
  QColor at(int x, int y) { return view_.grab().toImage().pixelColor(x, y); }

  QWidget view_;
  ViewMark* mark_;
};

TEST_F(ViewMarkTest, IsNotThereUntilSomethingIsMarked) {
  EXPECT_FALSE(mark_->isVisible());
  EXPECT_EQ(at(1, 150), QColor(Qt::black));
}

TEST_F(ViewMarkTest, AFrameIsSeenOnAllSidesAndTheMiddleIsFree) {
  mark_->setContent(ViewMark::Content{Tone::Bad, "No readings", true, false});
  ASSERT_TRUE(mark_->isVisible());
  const QColor bad = toneColor(Tone::Bad, Theme::Light);
  for (const QPoint& edge : {QPoint(1, 150), QPoint(398, 150), QPoint(200, 1), QPoint(200, 298)}) {
    EXPECT_EQ(at(edge.x(), edge.y()), bad) << edge.x() << ", " << edge.y();
  }
  EXPECT_EQ(at(200, 200), QColor(Qt::black));
  EXPECT_NE(at(200, 20), QColor(Qt::black)) << "the words stand on a plate";
  EXPECT_EQ(mark_->accessibleName(), "No readings");
  view_.resize(500, 200);
  EXPECT_EQ(mark_->geometry(), view_.rect());
}

TEST_F(ViewMarkTest, AnOldPictureIsMutedAndGetsItsColoursBack) {
  mark_->setContent(ViewMark::Content{Tone::Caution, "from before: 3 poses", false, true});
  const QColor muted = at(200, 200);
  EXPECT_NE(muted, QColor(Qt::black));
  EXPECT_LT(muted.lightness(), 160) << "it is still seen";
  EXPECT_EQ(at(1, 150), muted) << "no frame";
  mark_->setContent(std::nullopt);
  EXPECT_EQ(at(200, 200), QColor(Qt::black));
}

}  // namespace
}  // namespace hexoderm
