#include "app/window/presenters/help_presenter.h"
#include "tests/app/window/presenters/presenter_test.h"

#include <QDialog>

namespace hexoderm {
namespace {

class HelpPresenterTest : public PresenterTest {};

TEST_F(HelpPresenterTest, TheListOfKeysIsSearched) {
  press(Qt::Key_H);
  auto* dialog = waitForDialog<QDialog>("keysDialog");
  ASSERT_NE(dialog, nullptr);
  keepPicture(dialog->grab().toImage(), "keys-light");
  const auto shownTexts = [&] {
    QStringList texts;
    for (const QLabel* label : dialog->findChildren<QLabel*>()) {
      if (label->isVisible()) texts << label->text();
    }
    return texts;
  };
  EXPECT_GT(shownTexts().size(), 40);
  QTest::keyClicks(dialog->findChild<QLineEdit*>("keysSearch"), "undo");
  EXPECT_TRUE(shownTexts().contains("Ctrl+Z"));
  EXPECT_FALSE(shownTexts().contains("F12"));
}

}  // namespace
}  // namespace hexoderm
