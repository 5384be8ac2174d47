// Everything that can be reached has a name, and everything that can be done is in a menu and says what it is for.

#include "tests/app/window/keyboard.h"
#include "tests/screenshots/text_fit.h"

namespace hexoderm {
namespace {

class AccessibilityTest : public KeyboardTest {
 protected:
  /// Focusable widgets that a screen reader would not know what to call.
  static QStringList nameless(QWidget* root) {
    QStringList found;
    for (QWidget* widget : root->findChildren<QWidget*>()) {
      if (widget->focusPolicy() == Qt::NoFocus || widget->focusProxy() || !widget->isVisibleTo(root)) continue;
      // Parts of one control, which speaks for them.
      if (widget->objectName().startsWith("qt_") || qobject_cast<QScrollBar*>(widget)) continue;
      if (widget->parentWidget() && (widget->parentWidget()->inherits("QComboBoxPrivateContainer") ||
                                     qobject_cast<QAbstractItemView*>(widget->parentWidget()))) {
        continue;
      }
      const QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(widget);
      if (interface && !interface->text(QAccessible::Name).trimmed().isEmpty()) continue;
      found << QStringLiteral("%1 \"%2\" in \"%3\"")
                   .arg(widget->metaObject()->className(), widget->objectName(),
                        widget->parentWidget() ? widget->parentWidget()->objectName() : QString());
    }
    return found;
  }

  static void collect(const QList<QAction*>& actions, QSet<QAction*>& found) {
    for (QAction* action : actions) {
      if (action->menu()) {
        collect(action->menu()->actions(), found);
      } else {
        found << action;
      }
    }
  }
};

TEST_F(AccessibilityTest, EverythingThatTakesTheFocusHasAName) {
  EXPECT_EQ(nameless(window_.get()).join("\n").toStdString(), "") << "before anything is open";
  window_->recentFiles().note(pathTo("a.hexo"), 3);
  EXPECT_EQ(nameless(window_.get()).join("\n").toStdString(), "") << "with a recent file";
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  auto* tabs = find<QTabBar>("detailTabs");
  for (int k = 0; k < tabs->count(); ++k) {
    tabs->setCurrentIndex(k);
    EXPECT_EQ(nameless(window_.get()).join("\n").toStdString(), "") << tabs->tabText(k).toStdString();
  }
  for (int number = 1; auto* head = window_->findChild<QAbstractButton*>(QStringLiteral("stepHead%1").arg(number));
       ++number) {
    head->click();
    EXPECT_EQ(nameless(window_.get()).join("\n").toStdString(), "") << "step " << number;
  }
}

TEST_F(AccessibilityTest, EverythingInDialogsHasANameAndRoom) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  for (const char* name : {"actionPreferences", "actionKeys", "actionConnect", "actionExport", "actionAbout"}) {
    action(name)->trigger();
    QPointer<QDialog> dialog;
    ASSERT_TRUE(waitUntil([&] {
      for (auto* candidate : window_->findChildren<QDialog*>()) {
        if (candidate->isVisible()) dialog = candidate;
      }
      return !dialog.isNull();
    })) << name;
    ASSERT_TRUE(test::waitUntilExposed(*dialog));
    EXPECT_FALSE(dialog->windowTitle().isEmpty()) << name;
    auto* tabs = dialog->findChild<QTabWidget*>();
    for (int page = 0; page < (tabs ? tabs->count() : 1); ++page) {
      if (tabs) tabs->setCurrentIndex(page);
      QCoreApplication::processEvents();
      EXPECT_EQ(nameless(dialog).join("\n").toStdString(), "") << name << ", page " << page;
      EXPECT_EQ(findCutTexts(*dialog), QStringList()) << name << ", page " << page;
    }
    dialog->close();
    ASSERT_TRUE(waitUntil([&] { return dialog.isNull(); })) << name;
  }
}

TEST_F(AccessibilityTest, EveryActionIsInAMenuAndSaysWhatItIsFor) {
  QSet<QAction*> in_menus;
  collect(window_->findChild<QMenuBar*>()->actions(), in_menus);
  ASSERT_FALSE(window_->QWidget::actions().isEmpty());
  for (QAction* action : window_->QWidget::actions()) {
    const std::string name = action->objectName().toStdString();
    EXPECT_TRUE(in_menus.contains(action)) << name << " is in no menu";
    EXPECT_FALSE(action->text().isEmpty()) << name;
    EXPECT_FALSE(action->toolTip().isEmpty()) << name;
    EXPECT_NE(action->toolTip(), action->text()) << name << " does not say what it is for";
  }
  // No two of the same key.
  QSet<QString> keys;
  for (QAction* action : in_menus) {
    for (const QKeySequence& key : action->shortcuts()) {
      EXPECT_FALSE(keys.contains(key.toString())) << key.toString().toStdString();
      keys << key.toString();
    }
  }
}

TEST_F(AccessibilityTest, TabGoesRoundThroughEverythingAtTheStart) {
  window_->recentFiles().note(writeFile("a.hexo", "x"), 3);
  activateWindow();
  const auto* welcome = find<QWidget>("welcomePanel");
  QSet<QString> names;
  int buttons = 0;
  for (const QWidget* widget : tabStops()) {
    names << widget->objectName();
    if (welcome->isAncestorOf(widget) && qobject_cast<const QPushButton*>(widget)) ++buttons;
  }
  for (const char* name : {"recentOpen", "recentRemove", "stepHead1", "bannerButton"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
  EXPECT_EQ(buttons, 4);
}

}  // namespace
}  // namespace hexoderm
