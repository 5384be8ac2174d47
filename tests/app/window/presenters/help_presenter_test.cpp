#include "tests/app/window/presenters/presenter_test.h"

namespace hexoderm {
namespace {

class HelpPresenterTest : public PresenterTest {};

TEST_F(HelpPresenterTest, TheListOfKeysHasEveryKeyIsSearchedAndIsAllThatEscapeCloses) {
  press(Qt::Key_H);
  auto* dialog = waitForDialog("keysDialog");
  auto* list = dialog->findChild<QTreeWidget*>("keysList");
  const auto shownTexts = [&] {
    QStringList texts;
    for (QTreeWidgetItemIterator shown(list, QTreeWidgetItemIterator::NotHidden); *shown != nullptr; ++shown) {
      texts << (*shown)->text(0) << (*shown)->text(1);
    }
    return texts;
  };
  EXPECT_GT(shownTexts().size(), 40);
  for (const char* key : {"Space", "Del", "Shift+Del", "Ctrl+Z", "Ctrl+E", "F12"}) {
    EXPECT_FALSE(shownTexts().filter(key).isEmpty()) << key;
  }
  QTest::keyClicks(dialog->findChild<QLineEdit*>("keysSearch"), "undo");
  EXPECT_TRUE(shownTexts().contains("Ctrl+Z"));
  EXPECT_FALSE(shownTexts().contains("F12"));
  QTest::keyClick(dialog, Qt::Key_Escape);
  EXPECT_TRUE(waitUntilGone("keysDialog"));
  press(Qt::Key_Escape);
  EXPECT_TRUE(window_->isVisible());
}

}  // namespace
}  // namespace hexoderm
