// Presenters that connect one view each with the session.

#include "app/window/log/bug_report.h"
#include "app/window/settings/preferences.h"
#include "tests/app/window/presenters/presenter_test.h"
#include "widgets/capture/instruction_voice.h"
#include "widgets/controls/card_dock.h"
#include "widgets/patch/compare_view.h"
#include "widgets/patch/patch_view.h"
#include "widgets/plot/plot_view.h"

#include <qwt_plot.h>

namespace hexoderm {
namespace {

class ComparePresenterTest : public PresenterTest {
 protected:
  CompareView* openComparison() {
    press(Qt::Key_C);
    waitForDialog("compareDialog");
    return window_->findChild<CompareView*>();
  }
};

TEST_F(ComparePresenterTest, ComparesWithTheResultBeforeTheLastChange) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(3));
  controller().liveSession().disconnectSource();
  EXPECT_EQ(window_->findChild<CompareView*>(), nullptr) << "made only when it is asked for";
  CompareView* compare = openComparison();
  ASSERT_NE(compare, nullptr);
  auto* source = compare->findChild<QComboBox*>("compareSource");
  EXPECT_EQ(source->currentText(), "the result before the last change");
  auto* summary = compare->findChild<QLabel*>("compareSummary");
  EXPECT_TRUE(waitUntil([&] { return summary->text().startsWith("17 cells in common."); }));
  const QString before = summary->text();
  // What changes while it is open is compared anew.
  controller().setPoseDisabled(0, true);
  EXPECT_TRUE(waitUntil([&] { return summary->text() != before; }));
  QTest::keyClick(compare, Qt::Key_Escape);
  EXPECT_FALSE(compare->isVisible());
}

TEST_F(ComparePresenterTest, WithoutAnEarlierResultItSaysHowToGetOne) {
  window_->openFile(writeSession(pathTo("one.hexo"), 3));
  ASSERT_TRUE(waitUntilIdle());
  CompareView* compare = openComparison();
  ASSERT_NE(compare, nullptr);
  EXPECT_TRUE(compare->findChild<QLabel*>("compareSummary")->text().startsWith("There is nothing to compare with yet"));
  EXPECT_FALSE(compare->findChild<QComboBox*>("compareSource")->isEnabled());
}

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

class LogPresenterTest : public PresenterTest {};

TEST_F(LogPresenterTest, TheLogTellsWhatHappenedAndCanBeSearched) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  ASSERT_TRUE(waitUntil([&] { return logText().contains(", 2 poses, "); })) << logText().toStdString();
  EXPECT_TRUE(logText().contains("Opened Demo skin"));
  EXPECT_TRUE(logText().contains("Asked for: Start the demo skin"));

  showTab("Log");
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
  const QString report = QGuiApplication::clipboard()->text();
  EXPECT_THAT(report, HasTexts({"Hexoderm: 0", "Qt: 5", "VTK: 9", "OpenGL", "System: ", "Screen: ", "17 cells",
                                "line 249", "line 100\n"}));
  EXPECT_FALSE(report.contains("line 20\n")) << "more than the last lines";
  EXPECT_FALSE(report.contains(QDir::homePath()));
  EXPECT_EQ(withoutHome("in " + secret, QDir::homePath()), "in ~/secret-project/arm.hexo");
  EXPECT_EQ(withoutHome("in /home/me2/arm.hexo and /home/me", "/home/me"), "in /home/me2/arm.hexo and ~");
  EXPECT_EQ(withoutHome("in /x", "/"), "in /x");
}

class PlotPresenterTest : public PresenterTest {
 protected:
  PlotView* plot() { return find<PlotView>("plotView"); }
  void openPlot() {
    press(Qt::Key_P);
    ASSERT_TRUE(waitUntil([&] { return plot()->isVisible() && plot()->plot()->canvas()->hasFocus(); }));
  }
};

TEST_F(PlotPresenterTest, PShowsThePlotOfTheResultAndClosesItAgain) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  EXPECT_FALSE(plot()->isVisible()) << "closed until it is asked for";
  ASSERT_NO_FATAL_FAILURE(openPlot());
  EXPECT_EQ(plot()->data().points.size(), 17U);
  press(Qt::Key_P);
  EXPECT_FALSE(plot()->isVisible());
}

TEST_F(PlotPresenterTest, WhatIsBrushedIsMarkedInTheGraphUntilAnotherSkinIsOpened) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  ASSERT_NO_FATAL_FAILURE(openPlot());
  auto* graph = window_->findChild<GraphView*>();
  const QImage before = graph->grab().toImage();
  QTest::keyClick(plot()->plot()->canvas(), Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(window_->selection().brushed().size(), 17U);
  EXPECT_NE(graph->grab().toImage(), before);
  keepPicture(window_->picture(), "plot-brushed-in-window");
  controller().liveSession().startDemo();
  EXPECT_TRUE(waitUntil([&] { return window_->selection().brushed().empty(); }));
}

TEST_F(PlotPresenterTest, ReadingsArePlottedWhileTheSkinSends) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  ASSERT_NO_FATAL_FAILURE(openPlot());
  plot()->setChoice({PlotSubject::Cells, std::nullopt, Coloring::ReadingNorm, false});
  EXPECT_TRUE(waitUntil([&] { return plot()->data().points.size() == 17; }));
  controller().liveSession().disconnectSource();
  EXPECT_TRUE(waitUntil([&] { return plot()->data().points.empty(); }));
}

class SpeechPresenterTest : public PresenterTest {
 protected:
  InstructionVoice* voice() { return window_->findChild<InstructionVoice*>(); }
};

TEST_F(SpeechPresenterTest, IsOffAtFirstAndSpeaksWhatTheStepCaptureSaysOnceItIsWanted) {
  EXPECT_FALSE(voice()->isEnabled());
  QStringList spoken;
  QObject::connect(voice(), &InstructionVoice::spoken, [&](const QString& sentence) { spoken << sentence; });
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  EXPECT_TRUE(spoken.isEmpty());
  window_->preferences().set(Switch::Speech, true);
  EXPECT_TRUE(waitUntil([&] { return !spoken.isEmpty(); }));
  EXPECT_TRUE(waitUntil([&] { return spoken.contains(labelText("captureWhat")); })) << spoken.join(" / ").toStdString();
  window_->preferences().set(Switch::Speech, false);
  EXPECT_FALSE(voice()->isEnabled());
}

TEST_F(SpeechPresenterTest, ThePreferencesSayWhyItIsNotAvailable) {
  press(Qt::Key_Comma, Qt::ControlModifier);
  auto* dialog = waitForDialog("preferencesDialog");
  auto* speech = dialog->findChild<QCheckBox*>("preferenceSpeech");
  auto* why = dialog->findChild<QLabel*>("preferenceWhyNoSpeech");
  EXPECT_FALSE(speech->isChecked());
  emit voice()->lookedFor("There is no engine.");
  EXPECT_FALSE(speech->isEnabled());
  EXPECT_EQ(why->text(), "Not available: There is no engine.");
  emit voice()->lookedFor({});
  EXPECT_TRUE(speech->isEnabled());
  EXPECT_TRUE(why->isHidden());
}

class ViewCommandsTest : public PresenterTest {};

TEST_F(ViewCommandsTest, GSwapsTheViewsAndTheNextStartRemembers) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  auto* dock = find<CardDock>("graphDock");
  auto* patch = window_->findChild<PatchView*>();
  auto* graph = window_->findChild<GraphView*>();
  ASSERT_TRUE(dock->isAncestorOf(graph));
  press(Qt::Key_G);
  EXPECT_TRUE(dock->isAncestorOf(patch));
  EXPECT_FALSE(dock->isAncestorOf(graph));
  EXPECT_TRUE(graph->isVisible());
  EXPECT_EQ(dock->windowTitle(), "Skin patch");
  // Both still draw: what they show in their middle differs from their corner.
  ASSERT_TRUE(waitUntil([&] { return patch->width() > 100 && graph->width() > 100; }));
  ASSERT_TRUE(waitUntil([&] { return patch->isUpToDate(); }));
  keepPicture(window_->picture(), "swapped-light");
  EXPECT_GT(coloursIn(patch->screenshot()), 50U) << "the patch is not drawn";
  ASSERT_NO_FATAL_FAILURE(clickCellInGraph(CellId(7)));
  EXPECT_EQ(window_->selection().cell(), CellId(7));

  reopenWindow();
  EXPECT_TRUE(find<CardDock>("graphDock")->isAncestorOf(window_->findChild<PatchView*>()));
  press(Qt::Key_G);
  EXPECT_TRUE(find<CardDock>("graphDock")->isAncestorOf(window_->findChild<GraphView*>()));
}

TEST_F(ViewCommandsTest, StepsAboveGiveWayToOneThatDoesNotFitBelowThemUntilSomebodyScrolls) {
  window_->resize(1280, 800);
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  auto* panel = find<StepPanel>("stepPanel");
  const auto is_seen = [panel](const QWidget* part) {
    return panel->viewport()->rect().contains(QRect(part->mapTo(panel->viewport(), QPoint()), part->size()));
  };
  panel->openStep(2);
  const auto* skip = find<QAbstractButton>("captureSkip");
  // As high as the step needs and half of the one before it, whatever the font.
  const auto top_of = [panel](const QWidget* part) { return part->mapTo(panel->widget(), QPoint()).y(); };
  const auto* head = find<QAbstractButton>("stepHead3");
  ASSERT_TRUE(waitUntil([&] { return skip->isVisible() && top_of(skip) > top_of(head); }));
  const int needed = top_of(skip) + skip->height() - top_of(head) + find<QAbstractButton>("stepHead2")->height() / 2;
  const int high = window_->height() + needed - panel->viewport()->height();
  window_->resize(1280, high);
  ASSERT_TRUE(waitUntil([&] { return panel->viewport()->height() == needed; }));
  panel->openStep(0);
  panel->openStep(2);
  EXPECT_TRUE(waitUntil([&] { return is_seen(find<QAbstractButton>("stepHead3")) && is_seen(skip); }));
  EXPECT_FALSE(is_seen(find<QAbstractButton>("stepHead1")));

  panel->verticalScrollBar()->setValue(0);
  const int height = panel->height();
  window_->resize(1280, window_->height() + 30);
  ASSERT_TRUE(waitUntil([&] { return panel->height() > height; }));
  QCoreApplication::processEvents();
  EXPECT_EQ(panel->verticalScrollBar()->value(), 0);
  panel->openStep(0);
  EXPECT_TRUE(waitUntil([&] { return is_seen(find<QAbstractButton>("stepHead1")); }));
}

}  // namespace
}  // namespace hexoderm
