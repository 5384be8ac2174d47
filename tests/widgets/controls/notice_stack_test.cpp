#include "widgets/controls/notice_stack.h"

#include <gtest/gtest.h>
#include "tests/support/qt_wait.h"
#include "widgets/controls/message_bar.h"

namespace hexoderm {
namespace {

TEST(NoticeStack, LiesOverTheContentAndMovesNothing) {
  QWidget host;
  auto* layout = new QVBoxLayout(&host);
  auto* content = new QWidget;
  layout->addWidget(content);
  auto* notices = new NoticeStack(&host);
  auto* message = new MessageBar;
  auto* other = new MessageBar;
  notices->add(other);
  notices->add(message);
  host.resize(700, 500);
  host.show();
  ASSERT_TRUE(test::waitUntilExposed(host));
  const QRect before = content->geometry();
  EXPECT_FALSE(notices->isVisible());

  message->showMessage(Tone::Bad, QStringLiteral("Something went wrong with a file whose name is long. ").repeated(8));
  EXPECT_TRUE(message->isVisible());
  test::letTurnsPass();
  EXPECT_EQ(content->geometry(), before);
  EXPECT_EQ(host.size(), QSize(700, 500));
  EXPECT_TRUE(host.rect().contains(notices->geometry()));
  EXPECT_GE(message->height(), message->heightForWidth(message->width())) << "the whole text is seen";
  EXPECT_GT(notices->geometry().top(), host.height() / 3);

  other->showMessage(Tone::Good, "Saved.");
  test::letTurnsPass();
  EXPECT_LT(other->geometry().bottom(), message->geometry().top()) << "one above the other";
  EXPECT_TRUE(host.rect().contains(notices->geometry()));

  host.resize(500, 400);
  test::letTurnsPass();
  EXPECT_TRUE(host.rect().contains(notices->geometry()));
  message->hide();
  other->hide();
  EXPECT_FALSE(notices->isVisible());
}

}  // namespace
}  // namespace hexoderm
