#include "app/window/guide/guide_window.h"
#include "app/window/settings/theme.h"
#include "app/window/settings/translation.h"
#include "tests/app/window/window_test.h"

namespace hexoderm {
namespace {

QString textOf(const QString& language, const QString& page) {
  QFile file(QStringLiteral(":/hexoderm/guide/%1/%2.md").arg(language, page));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
  return QString::fromUtf8(file.readAll());
}

TEST(UserGuide, HasEveryPageWithATitleInEveryLanguage) {
  for (const QString& language : shippedLanguages()) {
    installTranslations(*qApp, language);
    for (const QString& page : GuideWindow::pages()) {
      EXPECT_FALSE(GuideWindow::titleOf(page).isEmpty()) << language.toStdString() << "/" << page.toStdString();
      EXPECT_TRUE(textOf(language, page).contains(GuideWindow::titleOf(page)));
    }
  }
  EXPECT_EQ(GuideWindow::titleOf("keys"), "Tasten");
  installTranslations(*qApp, "en");
  EXPECT_EQ(GuideWindow::titleOf("keys"), "Keys");
  EXPECT_TRUE(GuideWindow::titleOf("nothing").isEmpty());
}

TEST(UserGuide, LinksAndPicturesLeadSomewhere) {
  const GuideWindow guide;  // has the resources loaded
  static const QRegularExpression target("\\]\\(([^)]+)\\)");
  for (const QString& language : shippedLanguages()) {
    int targets = 0;
    for (const QString& page : GuideWindow::pages()) {
      const QString text = textOf(language, page);
      for (auto it = target.globalMatch(text); it.hasNext(); ++targets) {
        const QString path = QStringLiteral(":/hexoderm/guide/%1/%2").arg(language, it.next().captured(1));
        EXPECT_TRUE(QFile::exists(QDir::cleanPath(path))) << page.toStdString() << ": " << path.toStdString();
      }
    }
    EXPECT_GT(targets, 0) << language.toStdString();
  }
}

TEST(UserGuide, LeadsFromPageToPageAndBack) {
  GuideWindow guide;
  guide.show();
  auto* browser = guide.findChild<QTextBrowser*>("guidePage");
  auto* contents = guide.findChild<QListWidget*>("guideContents");
  auto* back = guide.findChild<QToolButton*>("guideBack");
  ASSERT_TRUE(browser && contents && back);
  EXPECT_EQ(guide.currentPage(), "demo");
  EXPECT_FALSE(back->isEnabled());
  EXPECT_TRUE(browser->toPlainText().contains("17 cells"));

  const QRect row = contents->visualItemRect(contents->item(4));
  QTest::mouseClick(contents->viewport(), Qt::LeftButton, Qt::NoModifier, row.center());
  EXPECT_EQ(guide.currentPage(), GuideWindow::pages().at(4));
  ASSERT_TRUE(back->isEnabled());
  QTest::mouseClick(back, Qt::LeftButton);
  EXPECT_EQ(guide.currentPage(), "demo");
  EXPECT_EQ(contents->currentRow(), 0);
  guide.showPage("no such page");
  EXPECT_EQ(guide.currentPage(), "demo");
}

TEST(UserGuide, ReadsItsPageOnceWhenTheThemeChangesAndStaysWhereItIs) {
  applyTheme(Theme::Light);
  GuideWindow guide(nullptr, "faults");
  EXPECT_EQ(guide.currentPage(), "faults");
  guide.resize(500, 300);
  guide.show();
  ASSERT_TRUE(test::waitUntilExposed(guide));
  auto* browser = guide.findChild<QTextBrowser*>("guidePage");
  ASSERT_NE(browser, nullptr);
  QScrollBar* bar = browser->verticalScrollBar();
  ASSERT_GT(bar->maximum(), 50);
  bar->setValue(50);
  QSignalSpy read(browser, &QTextBrowser::sourceChanged);
  applyTheme(Theme::Dark);
  EXPECT_TRUE(test::waitUntil([&] { return read.count() > 0; }));
  QCoreApplication::processEvents();
  EXPECT_EQ(read.count(), 1);
  EXPECT_EQ(bar->value(), 50);
  EXPECT_EQ(guide.currentPage(), "faults");
}

TEST(UserGuide, FindsWordsInThePageOnceAround) {
  GuideWindow guide;
  guide.show();
  ASSERT_TRUE(test::waitUntilExposed(guide));
  auto* browser = guide.findChild<QTextBrowser*>("guidePage");
  auto* search = guide.findChild<QLineEdit*>("guideSearch");
  auto* not_found = guide.findChild<QLabel*>("guideNotFound");
  QTest::keyClicks(search, "demo");
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(browser->textCursor().selectedText().toLower(), "demo");
  const int first = browser->textCursor().position();
  for (int k = 0; k < 50 && browser->textCursor().position() >= first; ++k) {
    QTest::keyClick(search, Qt::Key_Return);
    if (browser->textCursor().position() == first) break;
  }
  EXPECT_EQ(browser->textCursor().position(), first) << "it goes once around";
  EXPECT_FALSE(not_found->isVisible());
  search->setText("xylophone");
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_TRUE(not_found->isVisible());
}

class GuideFromTheWindow : public WindowTest {};

TEST_F(GuideFromTheWindow, OpensWithF1AtThePageAboutWhatIsToBeDone) {
  press(Qt::Key_F1);
  auto* guide = waitForDialog<GuideWindow>("guideWindow");
  EXPECT_EQ(guide->currentPage(), "demo");
  QTest::keyClick(guide, Qt::Key_Escape);
  EXPECT_TRUE(waitUntil([&] { return window_->findChild<GuideWindow*>() == nullptr; }));

  takeDemoPoses(1);
  press(Qt::Key_F1);
  guide = waitForDialog<GuideWindow>("guideWindow");
  EXPECT_EQ(guide->currentPage(), "capture");
  guide->showPage("keys");
  const QString keys = guide->findChild<QTextBrowser*>("guidePage")->toPlainText();
  for (const QAction* known : {window_->actions().open, window_->actions().guide, window_->actions().report}) {
    EXPECT_TRUE(keys.contains(known->shortcut().toString(QKeySequence::NativeText))) << known->text().toStdString();
    EXPECT_TRUE(keys.contains(known->text().remove('&').remove(QChar(0x2026)))) << known->text().toStdString();
  }
  EXPECT_FALSE(keys.contains(QLatin1Char('@')));
  EXPECT_FALSE(keys.contains("Step 8")) << "there are seven";
  guide->close();
}

}  // namespace
}  // namespace hexoderm
