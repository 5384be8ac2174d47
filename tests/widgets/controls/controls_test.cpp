// Small controls, and how they lie.

#include "tests/support/qt_wait.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/notice_stack.h"
#include "widgets/controls/selection.h"
#include "widgets/controls/view_mark.h"

#include <gtest/gtest.h>
#include <QSignalSpy>

namespace hexoderm {
namespace {

TEST(ActionButton, ATextThatIsWiderThanItsPlaceStandsInSeveralLines) {
  QAction action("Let the simulated robot take the poses");
  ActionButton button;
  button.setAction(&action);
  const QSize whole = button.sizeHint();
  button.setRoom(whole.width() * 2 / 3);
  EXPECT_LE(button.sizeHint().width(), whole.width() * 2 / 3);
  EXPECT_GT(button.sizeHint().height(), whole.height());
  EXPECT_EQ(button.text(), action.text()) << "what it says is the same";
  button.setRoom(whole.width());
  EXPECT_EQ(button.sizeHint(), whole);
}

TEST(ElidedLabel, TwoLinesHoldMoreThanOne) {
  const QString text = "Usable: so many millimetres at the worst cell";
  ElidedLabel one(1);
  ElidedLabel two(2);
  for (ElidedLabel* label : {&one, &two}) {
    label->setText(text);
    label->resize(label->fontMetrics().horizontalAdvance(text) * 3 / 4, label->sizeHint().height());
  }
  EXPECT_TRUE(one.isElided());
  EXPECT_FALSE(two.isElided());
}

TEST(NoticeStack, HasOneNoticeAboveTheOtherInsideOfItsHost) {
  QWidget host;
  auto* notices = new NoticeStack(&host);
  auto* message = new MessageBar;
  auto* other = new MessageBar;
  notices->add(other);
  notices->add(message);
  host.resize(700, 500);
  host.show();
  ASSERT_TRUE(test::waitUntilExposed(host));
  EXPECT_FALSE(notices->isVisible());
  message->showMessage(Tone::Bad, QStringLiteral("Something went wrong with a file whose name is long. ").repeated(8));
  other->showMessage(Tone::Good, "Saved.");
  test::letTurnsPass();
  EXPECT_GE(message->height(), message->heightForWidth(message->width())) << "the whole text is seen";
  EXPECT_LT(other->geometry().bottom(), message->geometry().top());
  EXPECT_TRUE(host.rect().contains(notices->geometry()));
  host.resize(500, 400);
  test::letTurnsPass();
  EXPECT_TRUE(host.rect().contains(notices->geometry()));
  message->hide();
  other->hide();
  EXPECT_FALSE(notices->isVisible());
}

TEST(Selection, WhatIsSoughtIsPickedFirst) {
  Selection selection;
  std::optional<CellId> picked_then;
  QObject::connect(&selection, &Selection::sought, &selection, [&] { picked_then = selection.cell(); });
  QSignalSpy changed(&selection, &Selection::changed);
  selection.seekCell(CellId(7));
  EXPECT_EQ(picked_then, CellId(7));
  EXPECT_EQ(changed.count(), 1);
  // It may have gone out of sight since.
  picked_then.reset();
  selection.seekCell(CellId(7));
  EXPECT_EQ(picked_then, CellId(7));
  EXPECT_EQ(changed.count(), 1);
}

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
