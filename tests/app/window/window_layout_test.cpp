// Nothing in the window jumps, everything fits, and what is shown says when it is not what it usually is.

#include "app/window/settings/preferences.h"
#include "app/window/settings/translation.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/app/window/fake_device.h"
#include "tests/app/window/window_test.h"
#include "tests/screenshots/text_fit.h"
#include "widgets/controls/card_dock.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/view_mark.h"
#include "widgets/patch/patch_view.h"
#include "widgets/verify/verify_panel.h"

#include <condition_variable>
#include <map>
#include <mutex>
#include <string_view>

namespace hexoderm {
namespace {

const char* const kDocks[] = {"stepsDock", "graphDock", "coverageDock", "poseDock", "detailsDock"};

class WindowLayoutTest : public WindowTest {
 protected:
  std::map<std::string, QRect> places() {
    test::letTurnsPass();
    std::map<std::string, QRect> found;
    for (const char* name : kDocks) {
      const auto* dock = find<QWidget>(name);
      found[name] = dock->isVisible() ? QRect(dock->mapTo(window_.get(), QPoint()), dock->size()) : QRect();
    }
    const auto* middle = window_->findChild<PatchView*>();
    found["middle"] = QRect(middle->mapTo(window_.get(), QPoint()), middle->size());
    return found;
  }
  /// Panels that share a column may differ by what rounding leaves.
  static void expectAlike(const std::map<std::string, QRect>& found, const std::map<std::string, QRect>& expected) {
    constexpr int kRounding_px = 3;
    for (const auto& [name, place] : expected) {
      const QRect& now = found.at(name);
      EXPECT_EQ(now.isEmpty(), place.isEmpty()) << name;
      EXPECT_NEAR(now.left(), place.left(), kRounding_px) << name;
      EXPECT_NEAR(now.top(), place.top(), kRounding_px) << name;
      EXPECT_NEAR(now.width(), place.width(), kRounding_px) << name;
      EXPECT_NEAR(now.height(), place.height(), kRounding_px) << name;
    }
  }
  const std::optional<ViewMark::Content>& middleMark() { return find<ViewMark>("middleMark")->content(); }
};

TEST_F(WindowLayoutTest, NeitherAnotherStepNorALongNoticeOrVerdictMovesThePanels) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  const auto before = places();
  for (const GuideStep step : {GuideStep::Connect, GuideStep::Check, GuideStep::Capture, GuideStep::Review,
                               GuideStep::Place, GuideStep::Export}) {
    openStep(step);
    const auto now = places();
    for (const char* name : kDocks) {
      EXPECT_EQ(now.at(name), before.at(name)) << name << " in step " << static_cast<int>(step);
    }
  }

  const auto quiet = places();
  const QSize size = window_->size();
  auto* notice = find<MessageBar>("messageBar");
  notice->showMessage(Tone::Bad, QStringLiteral("The file with a rather long name could not be written. ").repeated(9),
                      "Try again");
  EXPECT_EQ(places(), quiet);
  EXPECT_TRUE(notice->isVisible());
  auto* sentence = find<QLabel>("bannerSentence");
  sentence->setText(QStringLiteral("A verdict that has a lot to say of many cells, links and poses. ").repeated(9));
  for (const char* name : kDocks) find<CardDock>(name)->setRemark(QStringLiteral("a remark that is long ").repeated(9));
  find<QLabel>("sessionName")->setText(QStringLiteral("a name that is long ").repeated(20));
  EXPECT_EQ(places(), quiet);
  EXPECT_EQ(window_->size(), size);
  notice->hide();
  EXPECT_EQ(places(), quiet);
}

TEST_F(WindowLayoutTest, VerifyHasTheWidthOfTheWindowWhileItIsOpen) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  find<QDockWidget>("coverageDock")->close();
  const auto before = places();
  const QWidget* panel = window_->findChild<VerifyPanel*>();
  EXPECT_FALSE(panel->isVisible());
  openStep(GuideStep::Verify);
  test::letTurnsPass();
  ASSERT_TRUE(panel->isVisible());
  EXPECT_GT(panel->width(), window_->width() * 2 / 5);
  EXPECT_TRUE(window_->findChild<PatchView*>()->isVisible()) << "the checks draw in it";
  for (const char* name : {"graphDock", "coverageDock", "poseDock", "detailsDock"}) {
    EXPECT_FALSE(find<QWidget>(name)->isVisible()) << name;
  }
  EXPECT_EQ(places().at("stepsDock"), before.at("stepsDock"));
  openStep(GuideStep::Review);
  EXPECT_FALSE(panel->isVisible());
  expectAlike(places(), before);

  // What the next start finds are the panels, and not the room that the checks had.
  openStep(GuideStep::Verify);
  controller().undoStack()->setClean();
  window_->close();
  openWindow();
  EXPECT_TRUE(find<QWidget>("graphDock")->isVisible());
  EXPECT_FALSE(find<QWidget>("coverageDock")->isVisible());
}

TEST_F(WindowLayoutTest, AfterTheChecksTheTabInFrontIsInFrontAgain) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  action("actionPlot")->trigger();
  auto* plot = find<QDockWidget>("plotDock");
  auto* coverage = find<QDockWidget>("coverageDock");
  for (QDockWidget* front : {coverage, plot}) {
    front->raise();
    const auto before = places();
    ASSERT_FALSE(front->visibleRegion().isEmpty());
    openStep(GuideStep::Verify);
    test::letTurnsPass();
    EXPECT_FALSE(front->isVisible());
    openStep(GuideStep::Review);
    expectAlike(places(), before);
    EXPECT_FALSE(front->visibleRegion().isEmpty()) << front->objectName().toStdString();
  }
}

TEST_F(WindowLayoutTest, ResetLayoutBringsEverythingBackToItsPlaceWhereTablesHaveRoom) {
  window_->resize(1440, 900);
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  action("actionResetLayout")->trigger();
  const auto first = places();
  for (const auto& [tab, name] :
       {std::pair("Links", "linkView"), std::pair("Cells", "cellView"), std::pair("Findings", "poseView")}) {
    showTab(tab);
    test::letTurnsPass();
    const auto* table = find<QTableView>(name);
    EXPECT_GE(table->viewport()->height() / table->verticalHeader()->defaultSectionSize(), 8) << name;
  }
  auto* panels = find<QMainWindow>("panels");
  find<QDockWidget>("graphDock")->close();
  find<QDockWidget>("poseDock")->setFloating(true);
  panels->addDockWidget(Qt::LeftDockWidgetArea, find<QDockWidget>("detailsDock"));
  press(Qt::Key_G);
  EXPECT_NE(places(), first);
  action("actionResetLayout")->trigger();
  expectAlike(places(), first);
  EXPECT_FALSE(find<QDockWidget>("poseDock")->isFloating());
  EXPECT_EQ(panels->dockWidgetArea(find<QDockWidget>("detailsDock")), Qt::BottomDockWidgetArea);
  EXPECT_FALSE(find<CardDock>("graphDock")->isAncestorOf(window_->findChild<PatchView*>()));

  // Where there is little room, the findings have it all.
  const auto* card = find<QWidget>("findingsCard");
  EXPECT_TRUE(waitUntil([&] { return card->isVisible(); }));
  window_->resize(window_->minimumSizeHint().width(), 768);
  EXPECT_TRUE(waitUntil([&] { return !card->isVisible(); }));
}

/// Language and size of the text; sizes that everything must fit into.
class WindowFits : public WindowLayoutTest, public testing::WithParamInterface<std::tuple<const char*, double>> {
 protected:
  void SetUp() override {
    font_ = QApplication::font();
    installTranslations(*qApp, std::get<0>(GetParam()));
    applyTextFactor(std::get<1>(GetParam()));
    WindowTest::SetUp();
  }
  void TearDown() override {
    window_.reset();
    QApplication::setFont(font_);
    installTranslations(*qApp, "en");
  }

  QFont font_;
};

TEST_P(WindowFits, SmallSizesWithoutScrollingSidewaysOrTextsThatAreCutOff) {
  const double factor = std::get<1>(GetParam());
  // The lower ones are those of screens less a title bar. At the largest text and on the smallest screen the window may
  // be larger.
  const bool is_largest = factor > 1.5;
  const QSize smallest(1024, 600);
  const bool is_english = std::string_view(std::get<0>(GetParam())) == "en";  // the tour looks for German texts
  const std::vector<QSize> sizes = factor > 1
                                       ? std::vector{QSize(1440, 863), QSize(1280, 800)}
                                       : std::vector{QSize(1366, 731), QSize(1280, 800), QSize(1024, 731), smallest};
  const auto expectFits = [&](const std::string& when, const std::vector<const char*>& parts = {}) {
    for (const QSize& size : sizes) {
      SCOPED_TRACE(when + " at " + std::to_string(size.width()) + "x" + std::to_string(size.height()));
      window_->resize(size);
      test::letTurnsPass();
      for (const char* part : is_english ? parts : std::vector<const char*>()) {
        EXPECT_EQ(findCutTexts(*find<QWidget>(part)), QStringList()) << part;
      }
      if (is_largest || size == smallest) continue;
      EXPECT_EQ(window_->size(), size);
      EXPECT_EQ(findSidewaysScrolling(*window_), QStringList());
    }
  };
  expectFits("empty", {"welcomePanel"});
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  expectFits("demo", {"banner", "stepContent"});
  for (int step = 0; step <= static_cast<int>(GuideStep::Export); ++step) {
    openStep(static_cast<GuideStep>(step));
    expectFits("step " + std::to_string(step + 1));
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, WindowFits,
                         testing::Values(std::tuple("en", 1.0), std::tuple("de", 1.0), std::tuple("en", 1.5),
                                         std::tuple("de", 1.5), std::tuple("en", 2.0)));

TEST_F(WindowLayoutTest, ALostDeviceIsUnmistakableAndSaysWhatToCheck) {
  FakeDevice device;
  window_->connectTo({device.address(), pathTo("arm.hexo"), false});
  ASSERT_NO_FATAL_FAILURE(device.accept());
  device.introduce();
  ASSERT_TRUE(waitUntil([this] { return controller().liveSession().isLive(); }));
  device.hold(3, Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(waitForPoses(1));
  EXPECT_FALSE(middleMark().has_value());
  const auto before = places();
  device.unplug();
  ASSERT_TRUE(waitUntil([this] { return middleMark().has_value(); }));
  EXPECT_EQ(middleMark()->tone, Tone::Bad);
  EXPECT_TRUE(middleMark()->has_frame);
  for (const QString& said : {middleMark()->words, labelText("bannerSentence")}) {
    EXPECT_THAT(said, HasTexts({"cable", "power", "address"}));
  }
  EXPECT_EQ(places(), before) << "the strip lies over the content";
  EXPECT_TRUE(find<QWidget>("liveStrip")->isVisible());
  keepPicture(window_->picture(), "lost-device");
  device.plugIn();
  ASSERT_NO_FATAL_FAILURE(device.accept());
  device.introduce();
  ASSERT_TRUE(waitUntil([this] { return !middleMark(); }));
  device.hold(3, Eigen::Vector3d::UnitX());
  ASSERT_TRUE(waitForPoses(2)) << "the work goes on";
  device.unplug();
  ASSERT_TRUE(waitUntil([this] { return middleMark().has_value(); }));
  action("actionDisconnect")->trigger();
  EXPECT_TRUE(waitUntil([this] { return !middleMark(); }));
}

/// Solves as ever, but not before it is let, nor if it is stopped first.
class HeldSolve {
 public:
  ReconstructionWorker::Solve solve() {
    return [this](const SessionSnapshot& snapshot, const SolverOptions& options,
                  const std::stop_token& stop) -> std::shared_ptr<const Reconstruction> {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return is_free_; })) return nullptr;
      lock.unlock();
      return reconstruct(snapshot, options, nullptr, stop);
    };
  }
  void setFree(bool is_free) {
    const std::lock_guard lock(mutex_);
    is_free_ = is_free;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool is_free_ = true;
};

class LongSolveTest : public WindowLayoutTest {
 protected:
  void SetUp() override {
    WindowLayoutTest::SetUp();
    controller().setSolve(held_.solve());
    ASSERT_NO_FATAL_FAILURE(restWithDemoPoses(2));
  }
  void TearDown() override {
    held_.setFree(true);
    window_.reset();
  }
  void changeForLong(bool disables_pose = true) {
    held_.setFree(false);
    controller().setPoseDisabled(1, disables_pose);
    ASSERT_TRUE(waitUntil([this] { return find<QWidget>("workNotice")->isVisible(); }));
  }
  HeldSolve held_;
};

TEST_F(LongSolveTest, WhatIsDoneIsSaidOverAnOldPictureThatIsMarkedAsOld) {
  EXPECT_FALSE(find<QWidget>("workNotice")->isVisible());
  const auto before = places();
  ASSERT_NO_FATAL_FAILURE(changeForLong());
  EXPECT_THAT(labelText("workText"), BeginsWith("Working out the result of 1 pose: "));
  EXPECT_NE(find<QWidget>("workNotice")->findChild<QProgressBar*>(), nullptr);
  ASSERT_TRUE(middleMark().has_value());
  EXPECT_EQ(middleMark()->words, "from before: 2 poses");
  EXPECT_TRUE(middleMark()->is_muted);
  EXPECT_EQ(posesShown(), 2U) << "the old picture stays";
  EXPECT_EQ(places(), before);
  keepPicture(window_->picture(), "solving-long");
  held_.setFree(true);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_FALSE(find<QWidget>("workNotice")->isVisible());
  EXPECT_FALSE(middleMark().has_value());
  EXPECT_TRUE(controller().isCurrent());
}

TEST_F(LongSolveTest, CancelKeepsTheOldResultAndSaysSoUntilItIsWorkedOutAfterAllOrSomethingElseIsChanged) {
  ASSERT_NO_FATAL_FAILURE(changeForLong());
  click(find<QPushButton>("workCancel"));
  ASSERT_TRUE(waitUntil([this] { return !find<QWidget>("workNotice")->isVisible(); }));
  EXPECT_FALSE(controller().isSolving());
  EXPECT_FALSE(controller().isCurrent());
  ASSERT_TRUE(middleMark().has_value());
  EXPECT_EQ(middleMark()->words, "from before: 2 poses");
  EXPECT_THAT(labelText("bannerSentence"), HasText("stopped"));
  expectDisabled("actionExport", "stopped");

  held_.setFree(true);
  clickBanner();
  ASSERT_TRUE(waitUntil([this] { return controller().isCurrent(); }));
  window_->showChanges();
  EXPECT_FALSE(middleMark().has_value());
  EXPECT_TRUE(action("actionExport")->isEnabled());
  EXPECT_FALSE(action("actionSolveAgain")->isEnabled());

  ASSERT_NO_FATAL_FAILURE(changeForLong(false));
  action("actionCancelSolving")->trigger();
  EXPECT_TRUE(controller().wasCancelled());
  held_.setFree(true);
  controller().undoStack()->undo();
  ASSERT_TRUE(waitUntil([this] { return controller().isCurrent(); }));
  window_->showChanges();
  EXPECT_FALSE(controller().wasCancelled());
  EXPECT_FALSE(middleMark().has_value());
}

}  // namespace
}  // namespace hexoderm
