// The whole demo by the keyboard alone, and what makes that possible: an order of Tab that follows the eye, F6 from
// part to part, a focus that is seen.

#include "hexoderm/base/units.h"
#include "hexoderm/io/calibration_json.h"
#include "tests/app/window/keyboard.h"

namespace hexoderm {
namespace {

class DemoByKeys : public KeyboardTest {
 protected:
  void SetUp() override {
    KeyboardTest::SetUp();
    qApp->installEventFilter(&mouse_);
  }
  void TearDown() override {
    qApp->removeEventFilter(&mouse_);
    EXPECT_EQ(mouse_.events, 0) << "this is a run without a mouse";
  }

  bool isStillAndNew() {
    const Stillness& still = controller().liveSession().source().hold().stillness;
    return still.armed && still.blocker == Blocker::None;
  }
  void startDemo();
  void checkSkin();
  void capturePoses();
  void review();
  void verify();
  void exportIt();

  /// Opens a page of the panel below, by its name.
  void openPage(const QString& name) {
    ASSERT_NO_FATAL_FAILURE(tabTo("detailTabs"));
    auto* tabs = find<QTabBar>("detailTabs");
    for (int k = 0; k < tabs->count() && tabs->currentIndex() > 0; ++k) key(Qt::Key_Left);
    for (int k = 0; k < tabs->count() && !tabs->tabText(tabs->currentIndex()).startsWith(name); ++k) key(Qt::Key_Right);
    ASSERT_TRUE(tabs->tabText(tabs->currentIndex()).startsWith(name)) << name.toStdString();
  }
  /// Goes to a row of the table that has the focus.
  void goToRow(int row) {
    auto* table = qobject_cast<QTableView*>(QApplication::focusWidget());
    ASSERT_NE(table, nullptr) << focusName().toStdString();
    key(Qt::Key_Home, Qt::ControlModifier);
    for (int k = 0; k < row; ++k) key(Qt::Key_Down);
    if (!table->selectionModel()->isRowSelected(row, {})) key(Qt::Key_Return);
    ASSERT_TRUE(table->selectionModel()->isRowSelected(row, {})) << table->objectName().toStdString();
  }
  /// Types into the field of a file dialog, which has the keyboard when it opens.
  void typePath(const char* dialog_name, const QString& path) {
    waitForDialog(dialog_name);
    ASSERT_EQ(QApplication::focusWidget()->objectName(), "fileNameEdit") << focusName().toStdString();
    key(Qt::Key_A, Qt::ControlModifier);
    keys(path);
    key(Qt::Key_Return);
    ASSERT_NO_FATAL_FAILURE(comeBack());
  }

  struct CountMouse : QObject {
    int events = 0;
    bool eventFilter(QObject* /*watched*/, QEvent* event) override {
      if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease) ++events;
      return false;
    }
  } mouse_;
};

void DemoByKeys::startDemo() {
  EXPECT_TRUE(find<QWidget>("welcomePanel")->isVisible());
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  ASSERT_NO_FATAL_FAILURE(pressButton("Start the demo skin"));
  ASSERT_TRUE(waitUntil([this] { return controller().liveSession().isLive(); }));
  ASSERT_TRUE(waitForPoses(1)) << "it takes the first one where it lies";
  EXPECT_TRUE(waitUntil([this] { return !find<QWidget>("welcomePanel")->isVisible(); }));
  key(Qt::Key_A);
  EXPECT_FALSE(controller().liveSession().isAutomatic());
}

void DemoByKeys::checkSkin() {
  key(Qt::Key_1, Qt::ControlModifier);
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "stepHead1");
  key(Qt::Key_2, Qt::ControlModifier);
  EXPECT_EQ(labelText("stepBecause2"), "✓ Ready: Every cell sends.");
  // A cell is picked by arrows, and by its number; its light follows.
  ASSERT_NO_FATAL_FAILURE(tabTo("graphView"));
  key(Qt::Key_Right);
  ASSERT_TRUE(window_->selection().cell().has_value());
  const CellId first = *window_->selection().cell();
  key(Qt::Key_L, Qt::ControlModifier);
  EXPECT_EQ(controller().liveSession().litCell(), first);
  keys("7");
  EXPECT_EQ(window_->selection().cell(), CellId(7));
  key(Qt::Key_Return);
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "graphView") << "back from the field";
  EXPECT_EQ(controller().liveSession().litCell(), CellId(7));
  key(Qt::Key_2, Qt::ControlModifier);
  ASSERT_NO_FATAL_FAILURE(pressButton("Switch the light of cell 7 off"));
  EXPECT_EQ(controller().liveSession().litCell(), std::nullopt);
}

void DemoByKeys::capturePoses() {
  key(Qt::Key_3, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([this] { return action("actionSkipPose")->isEnabled(); }));
  const Eigen::Vector3d advised = controller().liveSession().nextPose()->up;
  key(Qt::Key_N);
  ASSERT_TRUE(waitUntil([&] { return !controller().liveSession().nextPose()->up.isApprox(advised); }))
      << "another one is advised";
  EXPECT_LT(controller().liveSession().nextPose()->up.dot(advised), std::cos(29.9 * kDegree));
  // By the buttons of the step: another one, turned to where the next pose helps, and taken when it is still.
  ASSERT_TRUE(waitUntil([this] { return action("actionSkipPose")->isEnabled(); }));
  const Eigen::Vector3d second = controller().liveSession().nextPose()->up;
  ASSERT_NO_FATAL_FAILURE(tabTo("captureSkip"));
  key(Qt::Key_Space);
  ASSERT_TRUE(waitUntil([&] { return !controller().liveSession().nextPose()->up.isApprox(second); }));
  ASSERT_TRUE(waitUntil([this] { return action("actionTurn")->isEnabled(); }));
  ASSERT_NO_FATAL_FAILURE(tabTo("captureTurnForMe"));
  key(Qt::Key_Space);
  ASSERT_TRUE(waitUntil([this] { return isStillAndNew(); }));
  ASSERT_NO_FATAL_FAILURE(tabTo("captureNow"));
  key(Qt::Key_Space);
  ASSERT_TRUE(waitForPoses(2));
  // The robot takes what is still wanted.
  key(Qt::Key_B);
  EXPECT_TRUE(controller().liveSession().isRobotOn());
  ASSERT_TRUE(waitUntil([this] { return !controller().liveSession().isRobotOn(); }));
  ASSERT_TRUE(waitUntilIdle());
  ASSERT_GE(posesShown(), 3U);
  // One more than the result asks for, so that one can be held out later.
  const std::size_t enough = posesShown();
  ASSERT_TRUE(waitUntil([this] { return action("actionTurn")->isEnabled(); }));
  key(Qt::Key_T);
  ASSERT_TRUE(waitForPoses(enough + 1));
  ASSERT_NO_FATAL_FAILURE(tabTo("captureAutomatic"));
  key(Qt::Key_Space);
  EXPECT_FALSE(controller().liveSession().isAutomatic());
  key(Qt::Key_Space);
  EXPECT_TRUE(controller().liveSession().isAutomatic());
  key(Qt::Key_A);
  EXPECT_FALSE(controller().liveSession().isAutomatic());
  ASSERT_TRUE(waitUntilIdle());
}

void DemoByKeys::review() {
  const std::size_t poses = posesShown();
  key(Qt::Key_4, Qt::ControlModifier);
  ASSERT_NO_FATAL_FAILURE(tabTo("poseView"));
  ASSERT_NO_FATAL_FAILURE(goToRow(2));
  key(Qt::Key_Delete);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_TRUE(controller().session()->poses()[2].disabled);
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_FALSE(controller().session()->poses()[2].disabled);
  key(Qt::Key_Delete, Qt::ShiftModifier);
  ASSERT_TRUE(waitForPoses(poses - 1));
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitForPoses(poses));

  ASSERT_NO_FATAL_FAILURE(openPage("Links"));
  ASSERT_NO_FATAL_FAILURE(tabTo("linkView"));
  ASSERT_NO_FATAL_FAILURE(goToRow(3));
  ASSERT_TRUE(window_->selection().link().has_value());
  key(Qt::Key_M);
  ASSERT_TRUE(waitUntil([this] { return controller().reconstruction()->patches.size() == 2; }));
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([this] { return controller().reconstruction()->patches.size() == 1; }));
  ASSERT_NO_FATAL_FAILURE(openPage("Cells"));
  ASSERT_NO_FATAL_FAILURE(tabTo("cellView"));
  ASSERT_NO_FATAL_FAILURE(goToRow(11));
  EXPECT_EQ(window_->selection().cell(), CellId(12));
  for (const auto& [page, part] : {std::pair("Residuals", "residualMatrix"), std::pair("Log", "logTable")}) {
    ASSERT_NO_FATAL_FAILURE(openPage(page));
    ASSERT_NO_FATAL_FAILURE(tabTo(part));
  }
}

void DemoByKeys::verify() {
  key(Qt::Key_5, Qt::ControlModifier);
  ASSERT_NO_FATAL_FAILURE(tabTo("holdOutPose"));
  key(Qt::Key_Home);
  EXPECT_EQ(find<QComboBox>("holdOutPose")->currentIndex(), 0);
  ASSERT_NO_FATAL_FAILURE(tabTo("holdOutRun"));
  key(Qt::Key_Space);
  ASSERT_TRUE(waitUntil([this] { return labelText("holdOutSentence").contains("predict pose 1"); }));
  ASSERT_NO_FATAL_FAILURE(tabTo("holdOutTable"));
  ASSERT_NO_FATAL_FAILURE(tabTo("surfaceKind"));
  key(Qt::Key_Down);  // the most probable one
  ASSERT_TRUE(waitUntil([this] { return labelText("surfaceSentence").startsWith("Cylinder, radius"); }));
}

void DemoByKeys::exportIt() {
  key(Qt::Key_7, Qt::ControlModifier);
  ASSERT_NO_FATAL_FAILURE(pressButton("Export…"));
  waitForDialog("exportDialog");
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "exportPath");
  ASSERT_NO_FATAL_FAILURE(tabTo("exportFormats", Qt::Key_Backtab));
  keys("urdf");
  ASSERT_NO_FATAL_FAILURE(tabTo("exportPath"));
  key(Qt::Key_A, Qt::ControlModifier);
  keys(pathTo("arm.urdf"));
  ASSERT_NO_FATAL_FAILURE(tabTo("export-parent"));
  key(Qt::Key_A, Qt::ControlModifier);
  keys("elbow");
  key(Qt::Key_Return);
  ASSERT_NO_FATAL_FAILURE(comeBack());
  ASSERT_TRUE(waitForMessage("Exported to " + pathTo("arm.urdf")));

  ASSERT_NO_FATAL_FAILURE(pressButton("Save calibration…"));
  ASSERT_NO_FATAL_FAILURE(typePath("saveDialog", pathTo("arm.calibration.json")));
  ASSERT_TRUE(waitForMessage("Exported to " + pathTo("arm.calibration.json")));
  EXPECT_EQ(readCalibrationJson(pathTo("arm.calibration.json").toStdString())->cellCount(), 17U);
  // The message itself is reached, and closed.
  ASSERT_NO_FATAL_FAILURE(tabTo("messageClose"));
  key(Qt::Key_Space);
  EXPECT_FALSE(find<QWidget>("messageBar")->isVisible());

  key(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  // The first report asks for its title.
  waitForDialog("reportTitleDialog");
  keys("elbow");
  key(Qt::Key_Return);
  ASSERT_NO_FATAL_FAILURE(typePath("saveDialog", pathTo("arm.pdf")));
  ASSERT_TRUE(waitForMessage("Exported to " + pathTo("arm.pdf")));
  EXPECT_GT(QFileInfo(pathTo("arm.pdf")).size(), 10000);
  key(Qt::Key_S, Qt::ControlModifier);
  ASSERT_NO_FATAL_FAILURE(typePath("saveDialog", pathTo("arm.session.json")));
  ASSERT_TRUE(waitForMessage("Saved to " + pathTo("arm.session.json")));
}

TEST_F(DemoByKeys, LeadFromTheStartThroughEveryStepToFilesAndOut) {
  ASSERT_NO_FATAL_FAILURE(startDemo());
  ASSERT_NO_FATAL_FAILURE(checkSkin());
  ASSERT_NO_FATAL_FAILURE(capturePoses());
  ASSERT_NO_FATAL_FAILURE(review());
  ASSERT_NO_FATAL_FAILURE(verify());
  ASSERT_NO_FATAL_FAILURE(exportIt());
  key(Qt::Key_Q, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([this] { return !window_->isVisible(); })) << "all is saved";
  EXPECT_GE(readSessionJson(pathTo("arm.session.json").toStdString()).poses().size(), 4U);
}

/// A session that rests, so that nothing but the focus changes the picture.
class KeyboardOnASession : public KeyboardTest {
 protected:
  void SetUp() override {
    KeyboardTest::SetUp();
    SimulatedSkinOptions options;
    options.faults = {{SkinFault::Dead, CellId(7)}};
    ASSERT_NO_FATAL_FAILURE(openSession("arm.hexo", simulated(4, options)));
    activateWindow();
  }
  /// The part of the window that a widget is in.
  [[nodiscard]] static QString partOf(const QWidget* widget) {
    for (; widget; widget = widget->parentWidget()) {
      const QString name = widget->objectName();
      if (name == "banner" || name == "messageBar" || name.endsWith("Dock")) return name;
      if (name.isEmpty() && widget->property("card").toBool()) return "centre";
    }
    return "none";
  }
};

TEST_F(KeyboardOnASession, TabGoesThroughTheWindowAsItIsReadAndShiftTabTheSameWayBack) {
  for (int step = 1; step <= 6; ++step) {
    key(Qt::Key_0 + step, Qt::ControlModifier);
    window_->setFocus();
    QStringList parts;
    QString order;
    int lowest = 0;
    for (QWidget* stop : tabStops()) {
      const QString part = partOf(stop);
      order += nameOf(stop) + " in " + part + '\n';
      if (parts.isEmpty() || parts.last() != part) parts << part;
      if (part != "stepsDock") continue;
      // Downwards: the open step's own controls come between its head and the next one's.
      const int y = stop->mapTo(find<QWidget>("stepContent"), QPoint(0, 0)).y();
      EXPECT_GE(y, lowest) << nameOf(stop).toStdString();
      lowest = y;
    }
    QStringList expected{"banner", "stepsDock", "centre"};
    // The checks of the step Verify are in the middle, and have the room of the other panels.
    if (step != 5) expected << QStringList({"graphDock", "coverageDock", "poseDock", "detailsDock"});
    EXPECT_EQ(parts, expected) << "step " << step << '\n' << order.toStdString();
  }
  // The focus is on the first again.
  const std::vector<QWidget*> forth = tabStops();
  ASSERT_GT(forth.size(), 10U);
  for (std::size_t k = forth.size(); k-- > 0;) {
    key(Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_EQ(QApplication::focusWidget(), forth[k]) << nameOf(forth[k]).toStdString();
  }
}

TEST_F(KeyboardOnASession, TheFocusIsSeenWhereverItIsAndTabChangesNothing) {
  QSet<QWidget*> seen;
  auto* tabs = find<QTabBar>("detailTabs");
  const auto look = [&](const QString& where) {
    for (QWidget* stop : tabStops()) {
      if (seen.contains(stop)) continue;
      seen << stop;
      stop->setFocus(Qt::TabFocusReason);
      QCoreApplication::processEvents();
      const QImage with = stop->grab().toImage();
      window_->setFocus(Qt::OtherFocusReason);
      QCoreApplication::processEvents();
      EXPECT_NE(stop->grab().toImage(), with) << where.toStdString() << ": " << nameOf(stop).toStdString();
    }
  };
  for (int step = 1; step <= 6; ++step) {
    key(Qt::Key_0 + step, Qt::ControlModifier);
    look(QStringLiteral("step %1").arg(step));
  }
  window_->selection().selectCell(CellId(5));
  for (int page = 0; page < tabs->count(); ++page) {
    tabs->setCurrentIndex(page);
    look(tabs->tabText(page));
    EXPECT_EQ(window_->selection().cell(), CellId(5)) << tabs->tabText(page).toStdString();
  }
  EXPECT_GT(seen.size(), 25);
  EXPECT_EQ(controller().undoStack()->count(), 0);
  EXPECT_TRUE(find<QTableView>("poseView")->selectionModel()->selectedRows().isEmpty());
}

TEST_F(KeyboardOnASession, F6GoesFromPartToPartAndAltWithALetterOpensAMenu) {
  key(Qt::Key_F, Qt::AltModifier);
  ASSERT_TRUE(waitUntil([] { return QApplication::activePopupWidget() != nullptr; }));
  key(Qt::Key_Escape);
  key(Qt::Key_Escape);
  EXPECT_TRUE(waitUntil([] { return QApplication::activePopupWidget() == nullptr; }));
  EXPECT_TRUE(window_->isVisible()) << "Esc cancels and never quits";
  window_->setFocus();
  const QStringList expected = {"banner",       "stepsDock", "centre",     "graphDock",
                                "coverageDock", "poseDock",  "detailsDock"};
  for (const QString& part : expected) {
    key(Qt::Key_F6);
    EXPECT_EQ(partOf(QApplication::focusWidget()), part) << focusName().toStdString();
    expectFocusIsSeen();
  }
  key(Qt::Key_F6);
  EXPECT_EQ(partOf(QApplication::focusWidget()), "banner") << "round";
  key(Qt::Key_F6, Qt::ShiftModifier);
  EXPECT_EQ(partOf(QApplication::focusWidget()), "detailsDock");
  ASSERT_NO_FATAL_FAILURE(tabTo("stepHead5"));
  key(Qt::Key_F6);
  key(Qt::Key_F6, Qt::ShiftModifier);
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "stepHead5");
  // A part that is closed is passed over.
  find<QWidget>("coverageDock")->hide();
  for (int k = 0; k < 3; ++k) key(Qt::Key_F6);
  EXPECT_EQ(partOf(QApplication::focusWidget()), "poseDock");
  // The only row of a table is picked by Return.
  ASSERT_NO_FATAL_FAILURE(openSession("one.hexo", simulated(1)));
  ASSERT_NO_FATAL_FAILURE(tabTo("poseView"));
  EXPECT_FALSE(action("actionTogglePose")->isEnabled());
  key(Qt::Key_Return);
  EXPECT_TRUE(action("actionTogglePose")->isEnabled());
  key(Qt::Key_Delete);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_TRUE(controller().session()->poses()[0].disabled);
}

}  // namespace
}  // namespace hexoderm
