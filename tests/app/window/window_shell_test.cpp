// What surrounds the steps: log, recent and unsaved sessions, preferences, keys, welcome.

#include "app/window/main_window/window_shell.h"

#include "app/window/files/session_paths.h"
#include "app/window/log/bug_report.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/error.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/card_dock.h"
#include "widgets/controls/step_panel.h"
#include "widgets/patch/patch_view.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QProcess>
#include <QScrollBar>
#include <QStandardPaths>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <set>

namespace hexoderm {
namespace {

class WindowShellTest : public WindowTest {
 protected:
  void SetUp() override {
    QDir(unsavedFolder()).removeRecursively();
    QDir(logFolder()).removeRecursively();
    WindowTest::SetUp();
  }
  void TearDown() override { QDir(unsavedFolder()).removeRecursively(); }

  WindowShell& shell() { return window_->shell(); }
  void reopenWindow() {
    window_->close();
    window_.reset();
    openWindow();
  }
  static QString writeSession(const QString& path, std::size_t poses) {
    SimulatedSkin skin(builtInCellModel("hex-bma150"), SimulatedSkinOptions());
    QDir().mkpath(QFileInfo(path).absolutePath());
    writeSessionStore(simulateSession(skin, poses, 20), path.toStdString());
    return path;
  }
  QString logText() {
    QString text;
    for (const LogLine& line : shell().log().linesAfter(0)) text += asFileLine(line) + '\n';
    return text;
  }
  QToolButton* recentButton(const QString& file_name) {
    for (auto* button : window_->findChildren<QToolButton*>("recentOpen")) {
      if (button->isVisible() && QFileInfo(button->property("recentPath").toString()).fileName() == file_name) {
        return button;
      }
    }
    return nullptr;
  }
  template <class T>
  T* visible(const char* name) {
    for (auto* widget : window_->findChildren<T*>(QLatin1String(name))) {
      if (widget->isVisible()) return widget;
    }
    return nullptr;
  }
};

TEST_F(WindowShellTest, TheLogTellsWhatHappenedAndCanBeSearched) {
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
      waitUntil([&] { return table->model()->rowCount() == static_cast<int>(shell().log().linesAfter(0).size()); }));
  keepPicture(window_->picture(), "log-light");
  auto* text = find<QLineEdit>("logText");
  QTest::keyClicks(text, "solved");
  EXPECT_TRUE(waitUntil([&] { return table->model()->rowCount() == logText().count("Solved: "); }));
  EXPECT_LT(table->model()->rowCount(), static_cast<int>(shell().log().linesAfter(0).size()));
  text->clear();
  find<QComboBox>("logSeverity")->setCurrentIndex(2);
  EXPECT_EQ(table->model()->rowCount(), 0) << logText().toStdString();
  shell().log().add(Severity::Error, "the disk is full");
  EXPECT_TRUE(waitUntil([&] { return table->model()->rowCount() == 1; }));
}

TEST_F(WindowShellTest, AReportHoldsVersionsAndLinesAndNoHome) {
  const QString secret = QDir::homePath() + "/secret-project/arm.hexo";
  shell().log().add(Severity::Info, "Saved to " + secret);
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  for (int k = 0; k < 250; ++k) shell().log().add(Severity::Info, QStringLiteral("line %1").arg(k));
  action("actionCopyReport")->trigger();
  EXPECT_TRUE(message().contains("Copied")) << message().toStdString();
  QString report = QGuiApplication::clipboard()->text();
  for (const char* part :
       {"Hexoderm: 0", "Qt: 5", "VTK: 9", "OpenGL", "System: ", "Screen: ", "17 cells", "line 249"}) {
    EXPECT_TRUE(report.contains(part)) << part << '\n' << report.toStdString();
  }
  EXPECT_TRUE(report.contains("line 100\n"));
  EXPECT_FALSE(report.contains("line 20\n")) << "more than the last lines";
  EXPECT_FALSE(report.contains(QDir::homePath()));
  EXPECT_EQ(withoutHome("in " + secret, QDir::homePath()), "in ~/secret-project/arm.hexo");
  EXPECT_EQ(withoutHome("in /home/me2/arm.hexo and /home/me", "/home/me"), "in /home/me2/arm.hexo and ~");
  EXPECT_EQ(withoutHome("in /x", "/"), "in /x");
}

/// Counts how often a widget is painted.
class PaintCounter : public QObject {
 public:
  explicit PaintCounter(QWidget* watched) { watched->installEventFilter(this); }
  [[nodiscard]] int count() const { return count_; }

 protected:
  bool eventFilter(QObject* /*watched*/, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++count_;
    return false;
  }

 private:
  int count_ = 0;
};

TEST_F(WindowShellTest, AWindowThatHasTheKeyboardIsNotPaintedAnewWhenADialogTakesIt) {
  QTest::mouseClick(find<QWidget>("topBar"), Qt::LeftButton);
  ASSERT_TRUE(waitUntil([this] { return QApplication::focusWidget() == window_.get(); }));
  QTest::qWait(50);
  auto* sentence = find<QLabel>("bannerSentence");
  const PaintCounter painted(sentence);
  QMessageBox box(window_.get());
  box.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&box));
  QTest::qWait(50);
  EXPECT_EQ(painted.count(), 0);
  sentence->update();
  EXPECT_TRUE(waitUntil([&] { return painted.count() > 0; }));
}

TEST_F(WindowShellTest, StartsWithAWelcomeThatGoesWhenSomethingIsOpen) {
  auto* welcome = find<QWidget>("welcomePanel");
  EXPECT_TRUE(welcome->isVisible());
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  QPushButton* demo = nullptr;
  for (auto* button : welcome->findChildren<QPushButton*>()) {
    if (button->text() == "Start the demo skin") demo = button;
  }
  ASSERT_NE(demo, nullptr);
  keepPicture(window_->picture(), "welcome-light");
  action("actionThemeDark")->trigger();
  keepPicture(window_->picture(), "welcome-dark");
  click(demo);
  EXPECT_TRUE(waitUntil([&] { return !welcome->isVisible(); }));
  EXPECT_TRUE(waitUntilIdle());
}

TEST_F(WindowShellTest, RemembersRecentFilesAcrossStarts) {
  const QString first = writeSession(pathTo("first.hexo"), 2);
  const QString second = writeSession(pathTo("second.hexo"), 3);
  window_->openFile(first);
  ASSERT_TRUE(waitForPoses(2));
  window_->openFile(second);
  ASSERT_TRUE(waitForPoses(3));
  reopenWindow();
  ASSERT_EQ(shell().recentFiles().files().size(), 2U);
  EXPECT_EQ(shell().recentFiles().files()[0].title, "second.hexo");
  EXPECT_EQ(shell().recentFiles().files()[0].poses, 3);
  EXPECT_TRUE(describeRecent(shell().recentFiles().files()[0]).contains("3 poses"));
  QMenu* menu = window_->actions().recent;
  ASSERT_GE(menu->actions().size(), 2);
  EXPECT_TRUE(menu->actions()[1]->text().contains("first.hexo"));
  menu->actions()[1]->trigger();
  ASSERT_TRUE(waitForPoses(2));
  EXPECT_EQ(controller().file().name(), "first.hexo");
  EXPECT_EQ(shell().recentFiles().files()[0].title, "first.hexo");
}

TEST_F(WindowShellTest, RecentFilesWithLongNamesLeaveTheStepsAsNarrowAsTheyAre) {
  const int narrow = find<QWidget>("stepsDock")->width();
  const QString file = writeSession(pathTo("left-forearm-of-the-second-robot-after-repair.hexo"), 2);
  window_->openFile(file);
  ASSERT_TRUE(waitForPoses(2));
  reopenWindow();
  press(Qt::Key_1, Qt::ControlModifier);
  ASSERT_TRUE(
      waitUntil([this] { return recentButton(QStringLiteral("left-forearm-of-the-second-robot-after-repair.hexo")); }));
  window_->openFile(file);
  ASSERT_TRUE(waitForPoses(2));
  EXPECT_EQ(find<QWidget>("stepsDock")->width(), narrow);
  keepPicture(window_->picture(), "recent-light");
  press(Qt::Key_1, Qt::ControlModifier);
  QTest::qWait(300);
  EXPECT_EQ(find<QWidget>("stepsDock")->width(), narrow);
  keepPicture(window_->picture(), "recent-step-light");
}

TEST_F(WindowShellTest, ARecentFileThatIsGoneSaysSoAndLeavesTheListByDel) {
  const QString gone = writeSession(pathTo("gone.hexo"), 1);
  const QString there = writeSession(pathTo("there.hexo"), 1);
  shell().recentFiles().note(there, 1);
  shell().recentFiles().note(gone, 1);
  ASSERT_TRUE(QFile::remove(gone));
  reopenWindow();
  ASSERT_TRUE(waitUntil([&] { return !shell().recentFiles().files()[0].problem.isEmpty(); }));
  QToolButton* button = recentButton("gone.hexo");
  ASSERT_NE(button, nullptr);
  EXPECT_TRUE(button->accessibleDescription().contains("not there"));
  EXPECT_TRUE(waitUntil([&] { return !window_->actions().recent->actions()[0]->isEnabled(); }));
  click(button);
  EXPECT_TRUE(controller().work().activity().isEmpty()) << "nothing to open";
  button->setFocus();
  QTest::keyClick(button, Qt::Key_Delete);
  EXPECT_EQ(shell().recentFiles().files().size(), 1U);
  QToolButton* other = recentButton("there.hexo");
  ASSERT_NE(other, nullptr);
  EXPECT_TRUE(other->hasFocus());
  QTest::keyClick(other, Qt::Key_Return);
  ASSERT_TRUE(waitForPoses(1));
}

TEST_F(WindowShellTest, TheMenuOfRecentFilesIsClearedFromWithin) {
  shell().recentFiles().note(pathTo("a.hexo"), 1);
  QMenu* menu = window_->actions().recent;
  menu->popup(window_->mapToGlobal(QPoint(100, 100)));
  ASSERT_TRUE(waitUntil([&] { return menu->isVisible() && menu->actions().size() == 3; }));
  QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(menu->actions().back()).center());
  EXPECT_TRUE(shell().recentFiles().files().empty());
  EXPECT_TRUE(waitUntil([&] { return menu->actions().size() == 2; }));
}

TEST_F(WindowShellTest, KeepsTenRecentFilesAtMost) {
  for (int k = 0; k < 14; ++k) shell().recentFiles().note(pathTo(QStringLiteral("%1.hexo").arg(k)), k);
  shell().recentFiles().note(pathTo("9.hexo"), -1);
  ASSERT_EQ(shell().recentFiles().files().size(), RecentFiles::kMost);
  EXPECT_EQ(shell().recentFiles().files()[0].title, "9.hexo");
  EXPECT_EQ(shell().recentFiles().files()[0].poses, 9) << "what was known stays";
}

TEST_F(WindowShellTest, FindsUnsavedSessionsThatNobodyHasOpen) {
  const QString folder = pathTo("unsaved");
  const QString left = writeSession(folder + "/left.hexo", 3);
  writeSession(folder + "/empty.hexo", 0);
  const QString in_use = writeSession(folder + "/used.hexo", 2);
  writeFile("unsaved/broken.hexo", "no session");
  const SessionStore user = SessionStore::open(in_use.toStdString());
  const std::vector<UnsavedSession> found = findUnsavedSessions(folder);
  ASSERT_EQ(found.size(), 2U);
  const auto& whole = found[0].problem.isEmpty() ? found[0] : found[1];
  const auto& broken = found[0].problem.isEmpty() ? found[1] : found[0];
  EXPECT_EQ(whole.path, left);
  EXPECT_EQ(whole.poses, 3U);
  EXPECT_EQ(whole.cells, 17U);
  EXPECT_TRUE(describeUnsaved(whole).contains("3 poses of 17 cells was not saved"));
  EXPECT_TRUE(broken.path.endsWith("broken.hexo"));
  EXPECT_TRUE(findUnsavedSessions(pathTo("no such folder")).empty());
}

TEST_F(WindowShellTest, WhatIsDiscardedCanBeTakenBackForAWeek) {
  const QString folder = pathTo("unsaved");
  const QString path = writeSession(folder + "/left.hexo", 1);
  const QString discarded = discardUnsaved(path);
  EXPECT_FALSE(QFile::exists(path));
  EXPECT_TRUE(findUnsavedSessions(folder).empty());
  removeOldDiscarded(folder);
  EXPECT_TRUE(QFile::exists(discarded));
  EXPECT_EQ(restoreDiscarded(discarded), path);
  EXPECT_EQ(findUnsavedSessions(folder).size(), 1U);

  const QString again = discardUnsaved(path);
  {
    QFile file(again);
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    ASSERT_TRUE(file.setFileTime(QDateTime::currentDateTime().addDays(-8), QFileDevice::FileModificationTime));
  }
  removeOldDiscarded(folder);
  EXPECT_FALSE(QFile::exists(again));

  const QString in_use = writeSession(folder + "/used.hexo", 1);
  const SessionStore user = SessionStore::open(in_use.toStdString());
  EXPECT_THROW(discardUnsaved(in_use), Error);
  EXPECT_TRUE(QFile::exists(in_use));
}

TEST_F(WindowShellTest, OffersAnUnsavedSessionAndRecoversIt) {
  writeSession(unsavedFolder() + "/one.hexo", 3);
  writeSession(unsavedFolder() + "/two.hexo", 2);
  reopenWindow();
  ASSERT_TRUE(waitUntil([&] { return visible<QPushButton>("recoverButton") != nullptr; }));
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  keepPicture(window_->picture(), "recovery-light");
  ASSERT_EQ(shell().unsavedSessions().all().size(), 2U);
  const std::size_t poses = shell().unsavedSessions().all()[0].poses;

  click(visible<QPushButton>("discardButton"));
  ASSERT_TRUE(waitUntil([&] { return visible<QPushButton>("undoDiscardButton") != nullptr; }));
  click(visible<QPushButton>("undoDiscardButton"));
  ASSERT_TRUE(waitUntil([&] { return visible<QPushButton>("undoDiscardButton") == nullptr; }));
  click(visible<QPushButton>("recoverButton"));
  ASSERT_TRUE(waitForPoses(poses));
  EXPECT_EQ(shell().unsavedSessions().all().size(), 1U);
  EXPECT_TRUE(shell().recentFiles().files().empty()) << "a scratch file is no recent file";
}

TEST_F(WindowShellTest, AnUnsavedSessionStaysInTheListUntilItIsOpen) {
  writeSession(unsavedFolder() + "/one.hexo", 3);
  reopenWindow();
  ASSERT_TRUE(waitUntil([&] { return shell().unsavedSessions().all().size() == 1; }));
  const QString path = shell().unsavedSessions().all()[0].path;
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));

  shell().unsavedSessions().recover(path);
  auto* box = waitForDialog<QMessageBox>("unsavedBox");
  ASSERT_NE(box, nullptr);
  click(box->button(QMessageBox::Cancel));
  ASSERT_TRUE(waitUntil([&] { return !window_->findChild<QMessageBox*>("unsavedBox"); }));
  EXPECT_EQ(shell().unsavedSessions().all().size(), 1U) << "nothing was opened";

  // It is not there for a moment: it can't be opened, and can be tried again.
  ASSERT_TRUE(QFile::rename(path, path + ".away"));
  shell().unsavedSessions().recover(path);
  box = waitForDialog<QMessageBox>("unsavedBox");
  ASSERT_NE(box, nullptr);
  click(box->button(QMessageBox::Discard));
  ASSERT_TRUE(waitForMessage("one.hexo")) << message().toStdString();
  EXPECT_EQ(shell().unsavedSessions().all().size(), 1U);
  ASSERT_TRUE(QFile::rename(path + ".away", path));
  ASSERT_TRUE(waitUntil([&] { return !window_->findChild<QMessageBox*>("unsavedBox"); }));
  shell().unsavedSessions().recover(path);
  box = waitForDialog<QMessageBox>("unsavedBox");
  ASSERT_NE(box, nullptr);
  click(box->button(QMessageBox::Discard));
  ASSERT_TRUE(waitForPoses(3)) << message().toStdString();
  EXPECT_TRUE(shell().unsavedSessions().all().empty());
}

TEST_F(WindowShellTest, RecoversWhatAKilledProgramLeft) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  const QTemporaryDir home;
  environment.insert("XDG_CONFIG_HOME", home.path());
  environment.insert("XDG_DATA_HOME", home.path());
  process.setProcessEnvironment(environment);
  QSettings(home.filePath("Hexoderm/hexoderm.conf"), QSettings::IniFormat)
      .setValue("demo/source", QStringLiteral("sim:x17?speed=20"));
  process.start(QStringLiteral(HEXODERM_PROGRAM), {"--demo", "--poses", "4"});
  ASSERT_TRUE(process.waitForStarted(test::kPatience_ms));
  // Until it has taken two poses that nobody has saved.
  const QString its_folder = home.filePath("Hexoderm/hexoderm/unsaved");
  QString scratch;
  ASSERT_TRUE(waitUntil([&] {
    const QStringList files = QDir(its_folder).entryList({"*.hexo"}, QDir::Files);
    if (files.isEmpty()) return false;
    scratch = QDir(its_folder).filePath(files.front());
    try {
      return readSessionStore(scratch.toStdString()).poses().size() >= 2;
    } catch (const Error&) {
      return false;  // it is being made
    }
  })) << process.readAllStandardError().toStdString();
  EXPECT_TRUE(isSessionStoreInUse(scratch.toStdString()));
  EXPECT_TRUE(findUnsavedSessions(its_folder).empty()) << "somebody works on it";
  process.kill();
  ASSERT_TRUE(process.waitForFinished(test::kPatience_ms));
  const std::vector<UnsavedSession> left = findUnsavedSessions(its_folder);
  ASSERT_EQ(left.size(), 1U);

  QDir().mkpath(unsavedFolder());
  for (const QFileInfo& file : QDir(its_folder).entryInfoList(QDir::Files)) {
    ASSERT_TRUE(QFile::copy(file.absoluteFilePath(), QDir(unsavedFolder()).filePath(file.fileName())));
  }
  reopenWindow();
  ASSERT_TRUE(waitUntil([&] { return visible<QPushButton>("recoverButton") != nullptr; }));
  activateWindow();
  click(visible<QPushButton>("recoverButton"));
  ASSERT_TRUE(waitForPoses(left[0].poses));
  EXPECT_TRUE(QFile::exists(QDir(unsavedFolder()).filePath(QFileInfo(scratch).fileName()))) << "until it is saved";
  EXPECT_FALSE(controller().file().isKept());
}

TEST_F(WindowShellTest, PreferencesActAtOnceAndAreRemembered) {
  press(Qt::Key_Comma, Qt::ControlModifier);
  auto* dialog = waitForDialog<QDialog>("preferencesDialog");
  ASSERT_NE(dialog, nullptr);
  EXPECT_FALSE(dialog->isModal());
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  QSignalSpy solver(&shell().preferences(), &Preferences::solverOptionsChanged);
  QSignalSpy recorder(&shell().preferences(), &Preferences::recorderOptionsChanged);
  QSignalSpy tone(&shell().preferences(), &Preferences::toneChanged);
  auto* tabs = dialog->findChild<QTabWidget*>("preferencesTabs");
  keepPicture(dialog->grab().toImage(), "preferences-appearance-light");

  auto* theme = dialog->findChild<QComboBox*>("preferenceTheme");
  EXPECT_EQ(theme->currentIndex(), 1);
  QTest::keyClick(theme, Qt::Key_Down);
  EXPECT_EQ(window_->theme(), Theme::Dark);

  tabs->setCurrentIndex(2);
  keepPicture(dialog->grab().toImage(), "preferences-solver-dark");
  auto* method = dialog->findChild<QComboBox*>("preferenceSolver");
  QTest::keyClick(method, Qt::Key_Down);
  ASSERT_EQ(solver.size(), 1);
  EXPECT_EQ(solver[0][0].value<SolverOptions>().solver, Solver::Tree);
  auto* gap = dialog->findChild<QComboBox*>("preferenceGapModel");
  QTest::keyClick(gap, Qt::Key_Down);
  EXPECT_EQ(shell().preferences().solverOptions().gap_model, GapModel::Arc);

  tabs->setCurrentIndex(1);
  keepPicture(dialog->grab().toImage(), "preferences-capture-dark");
  auto* excess = dialog->findChild<QDoubleSpinBox*>("preferenceExcess");
  EXPECT_DOUBLE_EQ(excess->value(), 30);
  excess->setFocus();
  excess->selectAll();
  QTest::keyClicks(excess, "45");
  EXPECT_TRUE(recorder.empty()) << "not at every digit";
  QTest::keyClick(excess, Qt::Key_Tab);
  ASSERT_EQ(recorder.size(), 1);
  EXPECT_DOUBLE_EQ(shell().preferences().recorderOptions().stillness.excess_limit_g, 0.045);
  EXPECT_DOUBLE_EQ(shell().preferences().recorderOptions().stillness.drift_limit_rad_s,
                   PoseRecorderOptions().stillness.drift_limit_rad_s);
  QTest::mouseClick(dialog->findChild<QCheckBox*>("preferenceTone"), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
  EXPECT_EQ(tone.size(), 1);
  EXPECT_FALSE(shell().preferences().tone());
  QTest::keyClick(dialog, Qt::Key_Escape);
  ASSERT_TRUE(waitUntil([&] { return window_->findChild<QDialog*>("preferencesDialog") == nullptr; }));

  reopenWindow();
  EXPECT_EQ(shell().preferences().solverOptions().solver, Solver::Tree);
  EXPECT_EQ(window_->theme(), Theme::Dark);
  press(Qt::Key_Comma, Qt::ControlModifier);
  dialog = waitForDialog<QDialog>("preferencesDialog");
  ASSERT_NE(dialog, nullptr);
  click(dialog->findChild<QPushButton*>("preferencesDefaults"));
  EXPECT_EQ(shell().preferences().solverOptions().solver, Solver::Global);
  EXPECT_TRUE(shell().preferences().tone());
  EXPECT_DOUBLE_EQ(dialog->findChild<QDoubleSpinBox*>("preferenceExcess")->value(), 30);
}

TEST_F(WindowShellTest, SettingsThatMakeNoSenseAreAsByDefault) {
  QSettings settings;
  settings.setValue("solver/gap_model", "rubber");
  settings.setValue("solver/class_threshold", -1);
  settings.setValue("capture/hold_s", 100);
  settings.setValue("view/text_factor", "huge");
  settings.setValue("view/language", "xx");
  const Preferences preferences;
  EXPECT_EQ(preferences.solverOptions().gap_model, GapModel::Fit);
  EXPECT_DOUBLE_EQ(preferences.solverOptions().class_threshold, 0.5);
  EXPECT_DOUBLE_EQ(preferences.recorderOptions().stillness.hold_s, 0.5);
  EXPECT_DOUBLE_EQ(preferences.textFactor(), 1);
  EXPECT_EQ(preferences.language(), "system");
}

TEST_F(WindowShellTest, TextGrowsByItsFactorAndGoesBack) {
  const double size = QApplication::font().pointSizeF();
  shell().preferences().setTextFactor(1.5);
  EXPECT_NEAR(QApplication::font().pointSizeF(), 1.5 * size, 0.1);
  keepPicture(window_->picture(), "welcome-text-150");
  shell().preferences().setTextFactor(1);
  EXPECT_NEAR(QApplication::font().pointSizeF(), size, 0.1);
}

TEST_F(WindowShellTest, GSwapsTheViewsAndTheNextStartRemembers) {
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
  const QImage scene = patch->screenshot();
  std::set<QRgb> colors;
  for (int x = 0; x < scene.width(); x += 3) {
    for (int y = 0; y < scene.height(); y += 3) colors.insert(scene.pixel(x, y));
  }
  EXPECT_GT(colors.size(), 50U) << "the patch is not drawn";
  ASSERT_NO_FATAL_FAILURE(clickCellInGraph(CellId(7)));
  EXPECT_EQ(window_->selection().cell(), CellId(7));

  reopenWindow();
  EXPECT_TRUE(find<CardDock>("graphDock")->isAncestorOf(window_->findChild<PatchView*>()));
  press(Qt::Key_G);
  EXPECT_TRUE(find<CardDock>("graphDock")->isAncestorOf(window_->findChild<GraphView*>()));
}

TEST_F(WindowShellTest, StepsAboveGiveWayToOneThatDoesNotFitBelowThemUntilSomebodyScrolls) {
  window_->resize(1280, 800);
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  auto* panel = find<StepPanel>("stepPanel");
  const auto is_seen = [panel](const QWidget* part) {
    return panel->viewport()->rect().contains(QRect(part->mapTo(panel->viewport(), QPoint()), part->size()));
  };
  panel->openStep(2);
  const auto* skip = find<QAbstractButton>("captureSkip");
  EXPECT_TRUE(waitUntil([&] { return is_seen(find<QAbstractButton>("stepHead3")) && is_seen(skip); }));
  EXPECT_FALSE(is_seen(find<QAbstractButton>("stepHead1")));

  panel->verticalScrollBar()->setValue(0);
  const int height = panel->height();
  window_->resize(1280, 740);
  ASSERT_TRUE(waitUntil([&] { return panel->height() < height; }));
  QCoreApplication::processEvents();
  EXPECT_EQ(panel->verticalScrollBar()->value(), 0);
  panel->openStep(0);
  EXPECT_TRUE(waitUntil([&] { return is_seen(find<QAbstractButton>("stepHead1")); }));
}

TEST_F(WindowShellTest, KeysGoToTheSteps) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  press(Qt::Key_1, Qt::ControlModifier);
  EXPECT_TRUE(find<QAbstractButton>("stepHead1")->hasFocus());
  press(Qt::Key_4, Qt::ControlModifier);
  EXPECT_TRUE(find<QAbstractButton>("stepHead4")->hasFocus());
  EXPECT_TRUE(action("actionStep4")->text().contains("Review"));
}

TEST_F(WindowShellTest, TheListOfKeysIsSearched) {
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
