// The tables, residuals and checks of a calibration in the real window.

#include "app/window/session/verification.h"
#include "hexoderm/base/units.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/app/window/window_test.h"
#include "widgets/verify/verify_panel.h"

namespace hexoderm {
namespace {

class WindowVerifyTest : public WindowTest {
 protected:
  VerifyPanel& panel() { return *window_->findChild<VerifyPanel*>(); }
  QString sentence(const char* section) { return labelText((std::string(section) + "Sentence").c_str()); }
  bool waitForSentence(const char* section, const QString& part) {
    const bool came = waitUntil([&] { return sentence(section).contains(part); });
    if (!came) std::cout << section << ": " << sentence(section).toStdString() << '\n';
    return came;
  }
  QString writeCalibration(const QString& name, const Session& session) {
    const QString path = pathTo(name);
    writeCalibrationJson(*reconstruct(*session.snapshot()), path.toStdString());
    return path;
  }
  void click(const char* name) {
    activateWindow();
    auto* button = find<QPushButton>(name);
    ASSERT_TRUE(button->isEnabled()) << name;
    find<QScrollArea>("checksArea")->ensureWidgetVisible(button);
    QCoreApplication::processEvents();
    WindowTest::click(button);
  }
  void showPanel() {
    openStep(GuideStep::Verify);
    ASSERT_TRUE(waitUntil([&] { return panel().isVisible(); }));
  }
};

TEST_F(WindowVerifyTest, LoopsSurfaceAndTheTrueRadiusAreJudgedAsPosesCome) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(3));
  ASSERT_NO_FATAL_FAILURE(showPanel());
  ASSERT_TRUE(waitForSentence("loops", "No loop in this patch"));
  // The wheel over a field of the panel changes nothing.
  auto* kind = find<QComboBox>("surfaceKind");
  const int first_kind = kind->currentIndex();
  test::turnWheel(kind, kind->rect().center(), -120);
  EXPECT_EQ(kind->currentIndex(), first_kind);
  std::optional<SurfaceEvaluation> drawn;
  int fits = 0;
  QObject::connect(&panel(), &VerifyPanel::surfaceShown, [&](const std::optional<SurfaceEvaluation>& surface) {
    drawn = surface;
    ++fits;
  });
  kind->setCurrentText("Cylinder");
  ASSERT_TRUE(waitForSentence("surface", "Cylinder, radius"));
  ASSERT_TRUE(drawn && drawn->radius_m);
  EXPECT_NEAR(*drawn->radius_m, 0.0501, 0.005);
  find<QDoubleSpinBox>("surfaceRadius")->setValue(50.1);
  ASSERT_TRUE(waitForSentence("surface", "off the true one"));
  EXPECT_NEAR(drawn->delta_m.value_or(1), *drawn->radius_m - 0.0501, 1e-12);

  // With another pose it is fitted again.
  const int before = fits;
  const double radius = *drawn->radius_m;
  ASSERT_NO_FATAL_FAILURE(takeNextPose());
  ASSERT_TRUE(waitUntil([&] { return fits > before; }));
  EXPECT_NE(*drawn->radius_m, radius);
  kind->setCurrentText("None");
  EXPECT_FALSE(drawn.has_value());
  EXPECT_EQ(sentence("surface"), "");
}

TEST_F(WindowVerifyTest, AnOpenRingsGapIsFoundWithoutBeingAskedFor) {
  SimulatedSkinOptions options;
  options.patch = "ring8";
  std::optional<LoopEvaluation> drawn;
  QObject::connect(&panel(), &VerifyPanel::loopShown, [&](const std::optional<LoopEvaluation>& loop) { drawn = loop; });
  ASSERT_NO_FATAL_FAILURE(openSession("ring.session.json", simulated(3, options, 100)));
  ASSERT_TRUE(waitForSentence("loops", "One open loop; its gap is")) << sentence("loops").toStdString();
  ASSERT_TRUE(drawn.has_value());
  EXPECT_NEAR(drawn->loop_length_m, 0.22228, 1e-5);
}

TEST_F(WindowVerifyTest, ComparesWithAnEarlierCalibrationAndSaysWhatIsWrongWithAFile) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(3));
  const QString path = pathTo("earlier.calibration.json");
  controller().resultFiles().exportTo({std::nullopt, path, {}});
  ASSERT_TRUE(waitForMessage("Exported to " + path));
  ASSERT_NO_FATAL_FAILURE(takeNextPose());
  ASSERT_NO_FATAL_FAILURE(showPanel());
  std::vector<Comparison> drawn;
  QObject::connect(&panel(), &VerifyPanel::comparisonShown,
                   [&](const std::vector<Comparison>& comparisons) { drawn = comparisons; });
  ASSERT_NO_FATAL_FAILURE(click("comparisonChoose"));
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("comparisonDialog", path));
  ASSERT_TRUE(waitForSentence("comparison", "Against earlier.calibration.json"));
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_EQ(drawn[0].cells.size(), 17U);
  EXPECT_GT(drawn[0].position_rms_m, 0);
  EXPECT_EQ(find<QTableView>("comparisonTable")->model()->rowCount(), 17);

  panel().compareWith(writeFile("broken.calibration.json", "{\"format\": "));
  ASSERT_TRUE(waitForSentence("comparison", "broken.calibration.json"));
  EXPECT_EQ(find<QTableView>("comparisonTable")->model()->rowCount(), 0);
  EXPECT_TRUE(drawn.empty());
  ASSERT_TRUE(find<QPushButton>("comparisonRemove")->isVisible());
  find<QPushButton>("comparisonRemove")->click();
  EXPECT_EQ(sentence("comparison"), "");
  ASSERT_NO_FATAL_FAILURE(takeNextPose());
  EXPECT_EQ(sentence("comparison"), "") << "the file that can't be read is not read again";
}

TEST_F(WindowVerifyTest, AnOldCalibrationIsComparedWithThePosesOfToday) {
  const QString calibration = writeCalibration("arm.calibration.json", simulated(4, {}, 100));
  const QByteArray before = contentOf(calibration);
  SimulatedSkinOptions changed;
  changed.faults = {{SkinFault::Yawed, CellId(5)}, {SkinFault::Dead, CellId(7)}};
  ASSERT_NO_FATAL_FAILURE(openSession("today.session.json", simulated(2, changed, 100)));
  ASSERT_NO_FATAL_FAILURE(showPanel());
  ASSERT_NO_FATAL_FAILURE(click("oldCalibrationChoose"));
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("oldCalibrationDialog", calibration));
  ASSERT_TRUE(waitForSentence("oldCalibration", "Not as calibrated: cells 5 and 7."));
  EXPECT_TRUE(sentence("oldCalibration").contains("Compared with arm.calibration.json: poses 1 and 2."));
  EXPECT_THAT(sentence("oldCalibration"), HasText("calibrate anew"));
  keepPicture(window_->picture(), "old-calibration-light");

  // It is compared anew when the session changes, without poses that the operator disabled.
  controller().setPoseDisabled(1, true);
  ASSERT_TRUE(waitForSentence("oldCalibration", "Compared with arm.calibration.json: pose 1."));
  ASSERT_NO_FATAL_FAILURE(click("oldCalibrationRemove"));
  EXPECT_EQ(sentence("oldCalibration"), "");
  EXPECT_FALSE(find<QTableView>("oldCalibrationTable")->isVisible());
  EXPECT_EQ(contentOf(calibration), before) << "a check never changes a calibration";
  EXPECT_EQ(controller().session()->poses().size(), 2U);
}

TEST_F(WindowVerifyTest, AnOldCalibrationThatHoldsIsSaidToHoldWhetherFromACalibrationOrASession) {
  ASSERT_NO_FATAL_FAILURE(openSession("today.session.json", simulated(2, {}, 100)));
  ASSERT_NO_FATAL_FAILURE(showPanel());
  const QString holds = "All 17 cells are as calibrated, as far as these poses show. The calibration still holds";
  panel().checkOldCalibration(writeCalibration("arm.calibration.json", simulated(4, {}, 100)));
  ASSERT_TRUE(waitForSentence("oldCalibration", holds));
  panel().checkOldCalibration(writeSession("earlier.session.json", simulated(4, {}, 100)));
  ASSERT_TRUE(waitForSentence("oldCalibration", "earlier.session.json"));
  EXPECT_THAT(sentence("oldCalibration"), BeginsWith(holds));

  // Another skin is open, and what was chosen for this one says nothing about it.
  ASSERT_NO_FATAL_FAILURE(openSession("other.session.json", simulated(3, {}, 100)));
  EXPECT_EQ(sentence("oldCalibration"), "");
  EXPECT_FALSE(find<QPushButton>("oldCalibrationRemove")->isVisible());
}

TEST_F(WindowVerifyTest, AFileThatIsNoCalibrationOfThisSkinGetsASentenceThatSaysWhy) {
  const Session today = simulated(2, {}, 100);
  ASSERT_NO_FATAL_FAILURE(openSession("today.session.json", today));
  ASSERT_NO_FATAL_FAILURE(showPanel());
  Reconstruction imported = *reconstruct(*today.snapshot());
  imported.solver = "imported";
  writeCalibrationJson(imported, pathTo("imported.calibration.json").toStdString());
  const std::vector<std::pair<QString, QString>> files = {
      {pathTo("imported.calibration.json"), "was imported"},
      {pathTo("missing.calibration.json"), "missing.calibration.json"}};
  for (const auto& [path, why] : files) {
    panel().checkOldCalibration(path);
    ASSERT_TRUE(waitForSentence("oldCalibration", why));
    EXPECT_THAT(sentence("oldCalibration"), HasText(QFileInfo(path).fileName()));
    EXPECT_EQ(find<QTableView>("oldCalibrationTable")->model()->rowCount(), 0);
  }
  // After all of them, the right one.
  panel().checkOldCalibration(writeCalibration("arm.calibration.json", simulated(4, {}, 100)));
  ASSERT_TRUE(waitForSentence("oldCalibration", "All 17 cells"));
  for (std::size_t k = 0; k < 2; ++k) controller().setPoseDisabled(k, true);
  ASSERT_TRUE(waitForSentence("oldCalibration", "there is no pose to check the calibration with"));
  // Nor has a calibration that is open any.
  controller().undoStack()->setClean();
  ASSERT_NO_FATAL_FAILURE(openFile(pathTo("arm.calibration.json")));
  EXPECT_FALSE(find<QPushButton>("oldCalibrationChoose")->isEnabled());
  EXPECT_THAT(sentence("oldCalibration"), HasText("open a session with the poses of today"));
}

TEST_F(WindowVerifyTest, OfASessionThatGoesOnTheNewestPosesAreChecked) {
  // Cell 9 comes loose before the fifth pose, after the calibration.
  SimulatedSkinOptions options;
  options.hand_held = false;
  options.faults = {{SkinFault::Reglued, CellId(9)}};
  options.reglued_before = 4;
  const QString path = writeCalibration("arm.calibration.json", simulated(4, options, 100));
  const Session today = simulated(6, options, 100);
  Verification verification;
  std::optional<CalibrationCheck> checked;
  bool running = false;
  QObject::connect(&verification, &Verification::oldCalibrationChecked,
                   [&](const CalibrationCheck& check, const QString&) { checked = check; });
  QObject::connect(&verification, &Verification::runningChanged, [&](VerifyCheck check, bool now) {
    if (check == VerifyCheck::OldCalibration) running = now;
  });
  verification.checkOldCalibration(path, 2);
  EXPECT_FALSE(running) << "there is neither a skin nor a session";
  verification.setReconstruction(reconstruct(*today.snapshot()));
  verification.setToday(today.snapshot());
  EXPECT_TRUE(running);
  ASSERT_TRUE(waitUntil([&] { return checked.has_value(); }));
  EXPECT_THAT(checked->poses, ElementsAre(PoseId(5), PoseId(6)));
  const auto changeOf9 = [&] { return std::ranges::find(checked->cells, CellId(9), &CheckedCell::cell)->change; };
  EXPECT_THAT(changeOf9(), testing::AnyOf(CellChange::Turned, CellChange::TurnedOrDrifted));
  checked.reset();
  verification.checkOldCalibration(path, std::nullopt);
  ASSERT_TRUE(waitUntil([&] { return checked.has_value(); }));
  EXPECT_EQ(checked->poses.size(), 6U);
  EXPECT_EQ(changeOf9(), CellChange::Broken) << "no one turn explains poses before and after it";
}

TEST_F(WindowVerifyTest, TheTableOfCellsPicksAndIsSavedAsItIsSorted) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(3));
  showTab("Cells");
  auto* view = find<QTableView>("cellView");
  ASSERT_TRUE(view->isVisible());
  view->sortByColumn(0, Qt::DescendingOrder);
  clickRow("cellView", 0);
  EXPECT_EQ(window_->selection().cell(), CellId(17));
  clickCellInGraph(CellId(16));
  EXPECT_EQ(view->currentIndex().row(), 1);

  view->findChild<QAction*>("actionSaveCsv")->trigger();
  const QString path = pathTo("cells.csv");
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", path));
  ASSERT_TRUE(waitForMessage("Exported to " + path));
  const QList<QByteArray> lines = contentOf(path).split('\n');
  EXPECT_TRUE(lines.at(0).startsWith("Cell,Patch,X mm,"));
  EXPECT_TRUE(lines.at(1).startsWith("17,1,"));
}

TEST_F(WindowVerifyTest, ResidualsPickLinkAndPoseInTheWholeWindow) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(4));
  showTab("Residuals");
  auto* matrix = find<QTableView>("residualMatrix");
  ASSERT_TRUE(matrix->isVisible());
  QTest::mouseClick(matrix->viewport(), Qt::LeftButton, Qt::NoModifier,
                    matrix->visualRect(matrix->model()->index(1, 3)).center());
  ASSERT_TRUE(window_->selection().link().has_value());
  EXPECT_EQ(find<QTableView>("poseView")->currentIndex().row(), 2);
  EXPECT_EQ(find<QTableView>("linkView")->currentIndex().row(), 1);
  QTest::keyClick(matrix, Qt::Key_Right);
  EXPECT_EQ(find<QTableView>("poseView")->currentIndex().row(), 3);
}

TEST_F(WindowVerifyTest, SortedTablesStillMeanTheRowThatIsSeen) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(3));
  auto* poses = find<QTableView>("poseView");
  poses->sortByColumn(0, Qt::DescendingOrder);
  ASSERT_NO_FATAL_FAILURE(disablePose(0));
  EXPECT_TRUE(controller().session()->poses()[2].disabled);
  EXPECT_FALSE(controller().session()->poses()[0].disabled);

  showTab("Links");
  auto* links = find<QTableView>("linkView");
  links->sortByColumn(2, Qt::DescendingOrder);
  clickRow("linkView", 0);
  const auto& all = controller().reconstruction()->patches[0].links;
  const auto worst = std::ranges::max_element(all, {}, &LinkEstimate::residual_rad);
  EXPECT_EQ(window_->selection().link(), Selection::Link(worst->source, worst->target));
}

TEST_F(WindowVerifyTest, TheNewestRequestWinsAndACancelledOneSaysNothing) {
  const auto snapshot = simulated(5).snapshot();
  Verification verification;
  std::vector<PoseId> results;
  QObject::connect(&verification, &Verification::heldOut,
                   [&](const HoldOutResult& result) { results.push_back(result.pose); });
  bool running = false;
  QObject::connect(&verification, &Verification::runningChanged, [&](VerifyCheck check, bool now) {
    if (check == VerifyCheck::HoldOut) running = now;
  });
  verification.setReconstruction(reconstruct(*snapshot));
  for (std::uint32_t pose = 1; pose <= 4; ++pose) verification.runHoldOut(snapshot, PoseId(pose));
  EXPECT_TRUE(running);
  ASSERT_TRUE(waitUntil([&] { return !running; }));
  EXPECT_THAT(results, ElementsAre(PoseId(4)));
  verification.runHoldOut(snapshot, PoseId(1));
  verification.cancel(VerifyCheck::HoldOut);
  EXPECT_FALSE(running);
  verification.runHoldOut(snapshot, PoseId(5));
  ASSERT_TRUE(waitUntil([&] { return results.size() > 1; }));
  EXPECT_THAT(results, ElementsAre(PoseId(4), PoseId(5)));
}

TEST_F(WindowVerifyTest, WhatIsVerifiedIsTheSolverThatWasUsed) {
  const Session session = simulated(5);
  const QString path = writeSession("same.session.json", session);
  SolverOptions options;
  options.solver = Solver::Tree;
  Verification verification;
  std::optional<HoldOutResult> held_out;
  std::vector<Comparison> comparisons;
  QObject::connect(&verification, &Verification::heldOut, [&](const HoldOutResult& result) { held_out = result; });
  QObject::connect(&verification, &Verification::compared,
                   [&](const std::vector<Comparison>& compared) { comparisons = compared; });
  verification.setReconstruction(reconstruct(*session.snapshot(), options));
  verification.runHoldOut(session.snapshot(), PoseId(3));
  verification.compareWith(path);
  ASSERT_TRUE(waitUntil([&] { return held_out && !comparisons.empty(); }));
  EXPECT_EQ(held_out->rms_rad, evaluateHoldOut(*session.snapshot(), PoseId(3), options).rms_rad);
  EXPECT_NE(held_out->rms_rad, evaluateHoldOut(*session.snapshot(), PoseId(3)).rms_rad);
  EXPECT_LT(comparisons[0].position_rms_m, 1e-12) << "the same session, solved in the same way";

  // The session is solved again when the solver is another.
  comparisons.clear();
  verification.setReconstruction(reconstruct(*session.snapshot()));
  ASSERT_TRUE(waitUntil([&] { return !comparisons.empty(); }));
  EXPECT_NEAR(comparisons[0].position_rms_m, 0, 1e-9);
}

}  // namespace
}  // namespace hexoderm
