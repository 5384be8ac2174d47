#include "app/window/log/bug_report.h"
#include "tests/app/window/presenters/presenter_test.h"

namespace hexoderm {
namespace {

class LogPresenterTest : public PresenterTest {};

TEST_F(LogPresenterTest, TheLogTellsWhatHappenedAndCanBeSearched) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  ASSERT_TRUE(waitUntil([&] { return logText().contains(", 2 poses, "); })) << logText().toStdString();
  EXPECT_TRUE(logText().contains("Opened Demo skin"));
  EXPECT_TRUE(logText().contains("Asked for: Start the demo skin"));

  auto* tabs = find<QTabBar>("detailTabs");
  for (int k = 0; k < tabs->count(); ++k) {
    if (tabs->tabText(k).contains("Log")) tabs->setCurrentIndex(k);
  }
  auto* table = find<QTableView>("logTable");
  ASSERT_TRUE(table->isVisible());
  EXPECT_TRUE(
      waitUntil([&] { return table->model()->rowCount() == static_cast<int>(window_->log().linesAfter(0).size()); }));
  auto* text = find<QLineEdit>("logText");
  QTest::keyClicks(text, "solved");
  EXPECT_TRUE(waitUntil([&] { return table->model()->rowCount() == logText().count("Solved: "); }));
  EXPECT_LT(table->model()->rowCount(), static_cast<int>(window_->log().linesAfter(0).size()));
  text->clear();
  find<QComboBox>("logSeverity")->setCurrentIndex(2);
  EXPECT_EQ(table->model()->rowCount(), 0) << logText().toStdString();
  window_->log().add(Severity::Error, "the disk is full");
  EXPECT_TRUE(waitUntil([&] { return table->model()->rowCount() == 1; }));
}

TEST_F(LogPresenterTest, AReportHoldsVersionsAndLinesAndNoHome) {
  const QString secret = QDir::homePath() + "/secret-project/arm.hexo";
  window_->log().add(Severity::Info, "Saved to " + secret);
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  for (int k = 0; k < 250; ++k) window_->log().add(Severity::Info, QStringLiteral("line %1").arg(k));
  action("actionCopyReport")->trigger();
  EXPECT_THAT(message(), HasText("Copied"));
  QString report = QGuiApplication::clipboard()->text();
  for (const char* part :
       {"Hexoderm: 0", "Qt: 5", "VTK: 9", "OpenGL", "System: ", "Screen: ", "17 cells", "line 249"}) {
    EXPECT_THAT(report, HasText(part));
  }
  EXPECT_TRUE(report.contains("line 100\n"));
  EXPECT_FALSE(report.contains("line 20\n")) << "more than the last lines";
  EXPECT_FALSE(report.contains(QDir::homePath()));
  EXPECT_EQ(withoutHome("in " + secret, QDir::homePath()), "in ~/secret-project/arm.hexo");
  EXPECT_EQ(withoutHome("in /home/me2/arm.hexo and /home/me", "/home/me"), "in /home/me2/arm.hexo and ~");
  EXPECT_EQ(withoutHome("in /x", "/"), "in /x");
}

}  // namespace
}  // namespace hexoderm
