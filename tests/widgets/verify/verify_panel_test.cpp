// The panel of checks: poses that are held out, the shape of the skin, and other calibrations.

#include "widgets/verify/verify_panel.h"
#include "hexoderm/base/units.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/panel_on_screen.h"
#include "tests/widgets/tables/table_texts.h"

#include <cstddef>

namespace hexoderm {
namespace {

HoldOutResult heldOut(HoldOutAgreement agreement, double rms_deg) {
  HoldOutResult result;
  result.outcome = HoldOutOutcome::Evaluated;
  result.pose = PoseId(3);
  result.other_poses = 5;
  for (std::uint32_t id = 1; id <= 17; ++id) {
    result.cells.push_back({CellId(id), (id == 8 ? 3 : 1) * rms_deg * kDegree, 0.5 * kDegree});
  }
  result.links.push_back({{CellId(1), PortNumber(1)}, {CellId(2), PortNumber(4)}, 0.7 * kDegree, 0.6 * kDegree});
  result.rms_rad = rms_deg * kDegree;
  result.expected_rms_rad = 0.5 * kDegree;
  result.agreement = agreement;
  return result;
}

FoundLoop loop(bool closed, double length_m) {
  FoundLoop loop;
  loop.closed = closed;
  loop.cells = {CellId(1), CellId(2), CellId(5), CellId(4)};
  loop.closure.first = {CellId(1), PortNumber(3)};
  loop.closure.second = {CellId(4), PortNumber(2)};
  loop.closure.gap_m = {length_m, 0, 0};
  loop.closure.length_m = length_m;
  loop.closure.loop_length_m = 0.2;
  loop.closure.percent = 500 * length_m;
  loop.limit_m = 0.0075;
  return loop;
}

SurfaceEvaluation cylinder() {
  SurfaceEvaluation surface;
  surface.kind = SurfaceKind::Cylinder;
  surface.radius_m = 0.0503;
  for (std::uint32_t id = 1; id <= 17; ++id) {
    surface.cells.emplace_back(id);
    surface.distance_m.push_back(id == 12 ? -0.0009 : 0.0003);
    surface.tilt_rad.push_back(1 * kDegree);
  }
  surface.rms_m = 0.00042;
  surface.tilt_rms_rad = 1 * kDegree;
  return surface;
}

CheckedCell checked(std::uint32_t id, CellChange change, Message words) {
  CheckedCell cell;
  cell.cell = CellId(id);
  cell.change = change;
  cell.words = std::move(words);
  cell.poses = 2;
  if (change == CellChange::None) cell.noticed_turn_rad = 4 * kDegree;
  return cell;
}

/// Two poses against a calibration of five cells: cell 5 turned, 7 is dead, 9 can't be told, 99 is gone.
CalibrationCheck changedSkin() {
  CalibrationCheck check;
  check.poses = {PoseId(4), PoseId(5)};
  check.cells = {
      checked(1, CellChange::None, message("as calibrated")),
      checked(5, CellChange::Turned, message("turned by {} +- {}", Degrees{20 * kDegree}, Degrees{0.5 * kDegree})),
      checked(7, CellChange::Broken, message("dead: it reads no gravity")),
      checked(9, CellChange::NotTold, message("can't be told: its calibration is too uncertain")),
      checked(99, CellChange::Broken, message("gone: it is no longer among the skin's cells"))};
  check.cells[1].turn = {20 * kDegree, 0.5 * kDegree, false};
  check.summary = Message::verbatim("Not as calibrated: cells 5, 7 and 99.");
  check.advice = Message::verbatim("See that it sits firmly.");
  check.remarks = {Message::verbatim("A link is no longer reported.")};
  check.changed = true;
  check.compared = true;
  return check;
}

class VerifyPanelTest : public test::PanelOnScreen<VerifyPanel> {
 protected:
  VerifyPanelTest() : PanelOnScreen({262, 640}) {}
  std::shared_ptr<Reconstruction> skin() {
    auto reconstruction = sampleX17();
    reconstruction->assessment.position_95_m = 0.0012;
    reconstruction->poses.push_back(reconstruction->poses.front());
    reconstruction->poses.back().pose = PoseId(5);
    return reconstruction;
  }
  std::string sentence(const char* section) {
    auto* label = panel_->findChild<QLabel*>(QString(section) + "Sentence");
    return label->isVisible() ? label->text().toStdString() : "";
  }
};

TEST_F(VerifyPanelTest, SaysWhyAPoseCannotBeHeldOut) {
  auto* run = find<QPushButton>("holdOutRun");
  EXPECT_FALSE(run->isEnabled());
  EXPECT_EQ(sentence("holdOut"), "There is no skin yet.");
  EXPECT_EQ(run->toolTip().toStdString(), "There is no skin yet.");
  panel_->setAwaited("Opening arm.hexo…");
  EXPECT_EQ(sentence("holdOut"), "Opening arm.hexo…");
  panel_->setAwaited({});
  EXPECT_EQ(sentence("holdOut"), "There is no skin yet.");
  panel_->setReconstruction(skin());
  panel_->setHasReadings(false);
  EXPECT_FALSE(run->isEnabled());
  EXPECT_THAT(sentence("holdOut"), testing::HasSubstr("A calibration file holds no readings"));
  auto none = skin();
  none->poses.clear();
  panel_->setHasReadings(true);
  panel_->setReconstruction(none);
  EXPECT_FALSE(find<QComboBox>("holdOutPose")->isEnabled());
  EXPECT_EQ(sentence("holdOut"), "Takes 4 poses that are not disabled, and there is none yet.");
  // Of four poses one is disabled: it can be predicted from the three others, but none of these from two.
  auto four = skin();
  four->poses.pop_back();
  panel_->setReconstruction(four);
  EXPECT_FALSE(run->isEnabled());
  EXPECT_THAT(sentence("holdOut"), testing::HasSubstr("besides this one there are 2"));
  auto* pose = find<QComboBox>("holdOutPose");
  ASSERT_TRUE(pose->isEnabled()) << "another one may do";
  pose->setFocus();
  QTest::keyClick(pose, Qt::Key_Up);
  EXPECT_EQ(pose->currentData().toUInt(), 3U);
  EXPECT_TRUE(run->isEnabled());
  panel_->setReconstruction(skin());
  EXPECT_TRUE(run->isEnabled());
}

TEST_F(VerifyPanelTest, AsksForThePoseThatIsChosenAndKeepsTheChoice) {
  panel_->setReconstruction(skin());
  std::vector<PoseId> asked;
  QObject::connect(panel_, &VerifyPanel::holdOutRequested, [&](PoseId pose) { asked.push_back(pose); });
  auto* pose = find<QComboBox>("holdOutPose");
  EXPECT_EQ(pose->itemText(0).toStdString(), "Pose 1 · standing");
  EXPECT_EQ(pose->itemText(2).toStdString(), "Pose 3 · facing wall · disabled");
  pose->setCurrentIndex(1);
  panel_->setReconstruction(skin());
  QTest::mouseClick(find<QPushButton>("holdOutRun"), Qt::LeftButton);
  EXPECT_THAT(asked, testing::ElementsAre(PoseId(2)));
}

TEST_F(VerifyPanelTest, HoldOutHasAVerdictAndMetricsThatPick) {
  panel_->setReconstruction(skin());
  panel_->showHoldOut(heldOut(HoldOutAgreement::AsStated, 0.4));
  EXPECT_EQ(sentence("holdOut"),
            "As good as stated. The other 5 poses predict pose 3 to 0.40° (rms over 17 cells); 0.50° were expected.");
  HoldOutResult coarse = heldOut(HoldOutAgreement::AsStated, 0.4);
  coarse.detectable_rad = 5 * kDegree;
  coarse.coarse = true;
  panel_->showHoldOut(coarse);
  EXPECT_THAT(sentence("holdOut"), testing::StartsWith("As good as stated, but a coarse check"));
  EXPECT_THAT(sentence("holdOut"), testing::HasSubstr("bent by less than about 5.00° would not show"));
  HoldOutResult turned = heldOut(HoldOutAgreement::FarWorse, 0.4);
  turned.turning_rad_s2 = 10;
  turned.turned = true;
  turned.expected_turning_rad_s2 = 1.7;
  panel_->showHoldOut(turned);
  EXPECT_THAT(sentence("holdOut"), testing::HasSubstr("turned while it was read: 10.0 rad/s², of a still hand 1.7"));
  panel_->showHoldOut(heldOut(HoldOutAgreement::FarWorse, 2));
  EXPECT_THAT(sentence("holdOut"), testing::Not(testing::HasSubstr("turned")));
  EXPECT_THAT(sentence("holdOut"), testing::StartsWith("Far worse than stated"));
  EXPECT_THAT(sentence("holdOut"), testing::HasSubstr("Worst: cell 8, 6.00°."));
  auto* table = find<QTableView>("holdOutTable");
  ASSERT_TRUE(table->isVisible());
  EXPECT_EQ(table->model()->rowCount(), 17);
  table->selectRow(4);
  EXPECT_EQ(selection_.cell(), CellId(5));
  QTest::mouseClick(find<QToolButton>("holdOutByLink"), Qt::LeftButton);
  EXPECT_EQ(table->model()->rowCount(), 1);
  table->selectRow(0);
  EXPECT_TRUE(selection_.link().has_value());

  panel_->setReconstruction(skin());
  EXPECT_EQ(sentence("holdOut"), "The session has changed since: run it again.");
  EXPECT_FALSE(table->isVisible());
}

TEST_F(VerifyPanelTest, LongWorkShowsItselfAndCanBeCancelled) {
  panel_->setReconstruction(skin());
  panel_->showOldCalibration(changedSkin(), "arm.calibration.json");
  std::vector<VerifyCheck> cancelled;
  QObject::connect(panel_, &VerifyPanel::cancelRequested, [&](VerifyCheck check) {
    cancelled.push_back(check);
    panel_->setRunning(check, false);
  });
  for (const auto& [check, name] :
       {std::pair(VerifyCheck::HoldOut, "holdOut"), std::pair(VerifyCheck::OldCalibration, "oldCalibration")}) {
    panel_->setRunning(check, true);
    auto* cancel = find<QPushButton>((name + std::string("Cancel")).c_str());
    ASSERT_TRUE(test::waitUntil([&] { return cancel->isVisible(); }));
    EXPECT_EQ(find<QPushButton>("holdOutRun")->isEnabled(), check != VerifyCheck::HoldOut);
    EXPECT_EQ(sentence(name), "");
    cancel->setFocus();
    QTest::keyClick(cancel, Qt::Key_Space);
    EXPECT_FALSE(cancel->isVisible());
  }
  EXPECT_EQ(sentence("oldCalibration"), "Cancelled.");
  EXPECT_FALSE(find<QTableView>("oldCalibrationTable")->isVisible());
  EXPECT_THAT(cancelled, testing::ElementsAre(VerifyCheck::HoldOut, VerifyCheck::OldCalibration));
  EXPECT_TRUE(find<QPushButton>("holdOutRun")->isEnabled());
  EXPECT_LE(panel_->minimumSizeHint().width(), std::max(280, 40 * panel_->fontMetrics().averageCharWidth()))
      << "it fits beside the 3D view of a small window";
}

TEST_F(VerifyPanelTest, WhatFailsTakesItsEarlierResultOutOfTheOtherViews) {
  panel_->setReconstruction(skin());
  std::optional<SurfaceEvaluation> surface;
  std::optional<LoopEvaluation> shown_loop;
  std::vector<Comparison> comparisons;
  QObject::connect(panel_, &VerifyPanel::surfaceShown, [&](const auto& shown) { surface = shown; });
  QObject::connect(panel_, &VerifyPanel::loopShown, [&](const auto& shown) { shown_loop = shown; });
  QObject::connect(panel_, &VerifyPanel::comparisonShown, [&](const auto& shown) { comparisons = shown; });
  panel_->showSurfaces({cylinder()}, {});
  panel_->showLoops({loop(false, 0.01)});
  panel_->showComparison({Comparison{}}, "earlier.hexo");
  ASSERT_TRUE(surface && shown_loop && comparisons.size() == 1);
  panel_->showFailure(VerifyCheck::Surface, "No.");
  panel_->showFailure(VerifyCheck::Loops, "No.");
  panel_->showFailure(VerifyCheck::Comparison, "No.");
  panel_->showOldCalibration(changedSkin(), "arm.calibration.json");
  panel_->showFailure(VerifyCheck::OldCalibration, "No.");
  EXPECT_EQ(sentence("oldCalibration"), "No.");
  EXPECT_FALSE(find<QTableView>("oldCalibrationTable")->isVisible());
  EXPECT_FALSE(surface);
  EXPECT_FALSE(shown_loop);
  EXPECT_TRUE(comparisons.empty());
}

TEST_F(VerifyPanelTest, SaysThatThereIsNoLoopOrHowTheyClose) {
  panel_->setReconstruction(skin());
  panel_->showLoops({});
  EXPECT_EQ(sentence("loops"), "No loop in this patch: nothing closes that could be checked.");
  EXPECT_FALSE(find<QTableView>("loopsTable")->isVisible());

  std::vector<std::optional<LoopEvaluation>> shown;
  QObject::connect(panel_, &VerifyPanel::loopShown,
                   [&](const std::optional<LoopEvaluation>& l) { shown.push_back(l); });
  panel_->showLoops({loop(false, 0.0034), loop(true, 0.0012), loop(true, 0.0003)});
  EXPECT_EQ(sentence("loops"),
            "One open loop; its gap is 3.40 mm, 1.7 % of its 200.00 mm. 2 closed loops close: the largest is left open "
            "by 1.20 mm (0.6 %), and a skin link may leave 7.50 mm.");
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_NEAR(shown[0]->length_m, 0.0034, 1e-12) << "the open loop is drawn";
  find<QTableView>("loopsTable")->selectRow(2);
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_NEAR(shown[1]->length_m, 0.0003, 1e-12);
  EXPECT_TRUE(selection_.link().has_value());
  panel_->showLoops({loop(true, 0.009)});
  EXPECT_THAT(sentence("loops"), testing::HasSubstr("more than the 7.50 mm a skin link may leave"));
}

TEST_F(VerifyPanelTest, AsksForTheSurfaceThatIsChosenWithItsRadius) {
  panel_->setReconstruction(skin());
  std::vector<std::pair<std::optional<SurfaceKind>, std::optional<double>>> asked;
  QObject::connect(
      panel_, &VerifyPanel::surfaceRequested,
      [&](std::optional<SurfaceKind> kind, std::optional<double> radius) { asked.emplace_back(kind, radius); });
  auto* kind = find<QComboBox>("surfaceKind");
  auto* radius = find<QDoubleSpinBox>("surfaceRadius");
  EXPECT_FALSE(radius->isEnabled());
  EXPECT_FALSE(radius->toolTip().isEmpty());
  kind->setCurrentText("Cylinder");
  EXPECT_TRUE(radius->isEnabled());
  // As a click into the text leaves it: nothing is picked.
  auto* line = test::part<QLineEdit>(*radius);
  QTest::mouseClick(line, Qt::LeftButton, Qt::NoModifier, QPoint(8, line->height() / 2));
  line->deselect();
  ASSERT_EQ(line->text(), "not known");
  QTest::keyClicks(radius, "50.1");
  QTest::keyClick(radius, Qt::Key_Return);
  EXPECT_NEAR(radius->value(), 50.1, 1e-9);
  kind->setCurrentText("Plane");
  kind->setCurrentText("Most probable");
  ASSERT_EQ(asked.size(), 4U);
  EXPECT_EQ(asked[0].first, SurfaceKind::Cylinder);
  EXPECT_FALSE(asked[0].second.has_value());
  EXPECT_NEAR(asked[1].second.value_or(0), 0.0501, 1e-12);
  EXPECT_EQ(asked[2].first, SurfaceKind::Plane);
  EXPECT_FALSE(asked[2].second.has_value()) << "a plane has no radius";
  EXPECT_FALSE(asked[3].first.has_value());
  kind->setCurrentText("Cylinder");
  radius->setValue(0);
  ASSERT_EQ(asked.size(), 6U);
  EXPECT_TRUE(asked[4].second.has_value());
  EXPECT_FALSE(asked[5].second.has_value()) << "it is not known after all";
}

TEST_F(VerifyPanelTest, ASurfaceThatTheCellsContradictIsNotTickedAlthoughTheyLieOnIt) {
  panel_->setReconstruction(skin());
  SurfaceEvaluation sphere = cylinder();
  sphere.kind = SurfaceKind::Sphere;
  sphere.radius_m = 0.0734;
  sphere.tilt_rms_rad = 36.8 * kDegree;
  panel_->showSurfaces({sphere}, {});
  EXPECT_THAT(sentence("surface"), testing::HasSubstr("That is within"));
  sphere.better = std::make_shared<const SurfaceEvaluation>(cylinder());
  panel_->showSurfaces({sphere}, {});
  EXPECT_THAT(sentence("surface"), testing::Not(testing::HasSubstr("That is within")));
  EXPECT_THAT(sentence("surface"), testing::HasSubstr("the cells are tilted against it by 36.80° (rms)"));
  EXPECT_THAT(sentence("surface"), testing::HasSubstr("Cylinder, radius 50.30 mm, with 1.00°"));
}

TEST_F(VerifyPanelTest, SurfacesAreJudgedByWhatIsStated) {
  panel_->setReconstruction(skin());
  std::optional<SurfaceEvaluation> shown;
  QObject::connect(panel_, &VerifyPanel::surfaceShown, [&](const std::optional<SurfaceEvaluation>& s) { shown = s; });
  SurfaceEvaluation surface = cylinder();
  surface.delta_m = 0.0002;
  surface.epsilon_m = 0.00047;
  panel_->showSurfaces({surface}, {});
  EXPECT_EQ(sentence("surface"),
            "Cylinder, radius 50.30 mm: 17 cell centres lie within 0.42 mm (rms) of it; the worst is cell 12, 0.90 mm. "
            "That is within the ±1.20 mm stated for positions (95 %). The radius is off the true one by Δ = 0.20 mm, "
            "and the cells lie ε = 0.47 mm (rms) off the true surface.");
  EXPECT_TRUE(shown.has_value());
  panel_->showFailure(VerifyCheck::Surface, "cylinder fit: the points lie in a plane");
  EXPECT_EQ(sentence("surface"), "cylinder fit: the points lie in a plane");
  EXPECT_FALSE(find<QTableView>("surfaceTable")->isVisible());
}

TEST_F(VerifyPanelTest, ADistanceByCaliperIsComparedWithTheEstimate) {
  EXPECT_FALSE(find<QDoubleSpinBox>("caliperDistance")->isEnabled());
  EXPECT_EQ(sentence("caliper"), "");
  const auto shown = skin();
  for (CellPlacement& cell : shown->patches.front().cells) {
    cell.T_o_u.t = Eigen::Vector3d(0.01 * cell.cell.value(), 0, 0);
    cell.cov_t_r = Matrix6d::Identity() * 1e-6;
  }
  panel_->setReconstruction(shown);
  EXPECT_THAT(sentence("caliper"), testing::StartsWith("Not measured yet"));
  auto* first = find<QSpinBox>("caliperFirst");
  auto* second = find<QSpinBox>("caliperSecond");
  const auto proposed = farApart(shown->patches.front());
  ASSERT_TRUE(proposed);
  EXPECT_EQ(first->value(), static_cast<int>(proposed->first.value()));
  EXPECT_EQ(second->value(), static_cast<int>(proposed->second.value()));

  const auto type = [](QAbstractSpinBox* field, const QString& text) {
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  };
  const double estimated_mm = 1e3 * distanceBetween(*shown, proposed->first, proposed->second)->length_m;
  auto* distance = find<QDoubleSpinBox>("caliperDistance");
  QTest::keyClicks(distance, QString::number(estimated_mm, 'f', 1));
  QTest::keyClick(distance, Qt::Key_Return);
  EXPECT_THAT(sentence("caliper"), testing::StartsWith("It agrees. Cells"));
  type(distance, QString::number(1.3 * estimated_mm, 'f', 1));
  EXPECT_THAT(sentence("caliper"), testing::StartsWith("It contradicts the result."));
  // Another result of the same skin is compared with what was measured.
  panel_->setReconstruction(std::make_shared<Reconstruction>(*shown));
  EXPECT_THAT(sentence("caliper"), testing::StartsWith("It contradicts the result."));
  type(second, "4711");
  EXPECT_EQ(sentence("caliper"), "there is no cell 4711");
  type(second, QString::number(first->value()));
  EXPECT_EQ(sentence("caliper"), "a distance is between two different cells");
}

TEST_F(VerifyPanelTest, ComparisonSaysWhetherItRepeatsAsStated) {
  panel_->setReconstruction(skin());
  Comparison comparison;
  for (std::uint32_t id = 2; id <= 17; ++id) {
    CellDifference cell;
    cell.cell = CellId(id);
    cell.position_m = {0.0005, 0, 0};
    cell.orientation_rad = 0.4 * kDegree;
    cell.sigma_t_m = 0.0006;
    cell.sigma_r_rad = 0.5 * kDegree;
    comparison.cells.push_back(cell);
  }
  comparison.position_rms_m = 0.0005;
  comparison.orientation_rms_rad = 0.4 * kDegree;
  panel_->showComparison({comparison}, "old.calibration.json");
  EXPECT_EQ(
      sentence("comparison"),
      "Within what was stated for 95 % of cells. Against old.calibration.json, after alignment: 0.50 mm and 0.40° "
      "rms over 16 cells. Of 16 cells, 16 have their position and 16 their orientation within what was "
      "stated with 95 %.");
  for (std::size_t k = 0; k < 3; ++k) comparison.cells[k].position_m *= 10;
  panel_->showComparison({comparison}, "old.calibration.json");
  EXPECT_THAT(sentence("comparison"), testing::StartsWith("Further apart than what was stated"));
  EXPECT_EQ(find<QTableView>("comparisonTable")->model()->rowCount(), 16);
  panel_->showComparison({}, "other.calibration.json");
  EXPECT_EQ(sentence("comparison"), "other.calibration.json has no cell in common with this calibration.");
}

TEST_F(VerifyPanelTest, AnOldCalibrationIsComparedWithTheNewestPoses) {
  using Asked = std::pair<std::string, std::optional<std::size_t>>;
  std::vector<Asked> asked;
  QObject::connect(
      panel_, &VerifyPanel::oldCalibrationRequested,
      [&](const QString& path, std::optional<std::size_t> poses) { asked.emplace_back(path.toStdString(), poses); });
  auto* choose = find<QPushButton>("oldCalibrationChoose");
  auto* poses = find<QComboBox>("oldCalibrationPoses");
  EXPECT_FALSE(choose->isEnabled());
  EXPECT_EQ(choose->toolTip().toStdString(), "There is no skin yet.");
  panel_->setReconstruction(skin());
  panel_->setHasReadings(false);
  EXPECT_FALSE(choose->isEnabled());
  EXPECT_FALSE(poses->isEnabled());
  EXPECT_THAT(sentence("oldCalibration"), testing::HasSubstr("open a session with the poses of today"));
  panel_->setHasReadings(true);
  EXPECT_EQ(sentence("oldCalibration"), "");
  EXPECT_TRUE(choose->isEnabled());
  poses->setFocus();
  QTest::keyClick(poses, Qt::Key_Up);
  QTest::keyClick(poses, Qt::Key_Down);
  EXPECT_TRUE(asked.empty()) << "no file is chosen yet";
  panel_->checkOldCalibration("arm.calibration.json");
  QTest::keyClick(poses, Qt::Key_Up);
  QTest::keyClick(poses, Qt::Key_End);
  EXPECT_THAT(asked, testing::ElementsAre(Asked("arm.calibration.json", 2), Asked("arm.calibration.json", 1),
                                          Asked("arm.calibration.json", std::nullopt)));
}

TEST_F(VerifyPanelTest, CellsThatAreNotAsCalibratedComeFirstAndCanBePicked) {
  panel_->setReconstruction(skin());
  panel_->showOldCalibration(changedSkin(), "arm.calibration.json");
  EXPECT_EQ(
      sentence("oldCalibration"),
      "Not as calibrated: cells 5, 7 and 99. See that it sits firmly. A link is no longer reported. Compared with "
      "arm.calibration.json: poses 4 and 5.");
  auto* table = find<QTableView>("oldCalibrationTable");
  ASSERT_TRUE(table->isVisible());
  const QAbstractItemModel& model = *table->model();
  EXPECT_THAT(test::headers(model), testing::ElementsAre("Cell", "Now", "Turned °", "Drift mg", "Noticed from °"));
  ASSERT_EQ(model.rowCount(), 5);
  using testing::_;
  EXPECT_THAT(test::rowTexts(model, 0), testing::ElementsAre("5", "turned by 20.0° +- 0.5°", "20.00", _, _));
  EXPECT_EQ(test::text(model, 1, 1), "dead: it reads no gravity");
  EXPECT_EQ(test::text(model, 2, 0), "99");
  EXPECT_EQ(test::text(model, 3, 0), "9");
  EXPECT_THAT(test::rowTexts(model, 4), testing::ElementsAre(_, "as calibrated", _, _, "4.00"));
  EXPECT_TRUE(model.index(0, 0).data(Qt::FontRole).value<QFont>().bold());
  EXPECT_FALSE(model.index(4, 0).data(Qt::FontRole).isValid());

  table->setFocus();
  QTest::keyClick(table, Qt::Key_Down);
  table->selectRow(1);
  EXPECT_EQ(selection_.cell(), CellId(7));
  QTest::keyClick(table, Qt::Key_Up);
  EXPECT_EQ(selection_.cell(), CellId(5));
  table->selectRow(2);
  EXPECT_EQ(selection_.cell(), CellId(5)) << "a cell that is gone is in no view";
}

TEST_F(VerifyPanelTest, ACalibrationThatHoldsIsTickedOnlyIfEveryTurnWouldShow) {
  panel_->setReconstruction(skin());
  CalibrationCheck holds;
  holds.poses = {PoseId(5)};
  holds.cells = {checked(1, CellChange::None, message("as calibrated"))};
  holds.compared = true;
  EXPECT_EQ(oldCalibrationText(holds, "a").tone, Tone::Good);
  EXPECT_EQ(oldCalibrationText(holds, "a").text.toStdString(), "Compared with a: pose 5.");
  CalibrationCheck blind = holds;
  blind.cells.front().noticed_turn_rad.reset();
  EXPECT_EQ(oldCalibrationText(blind, "a").tone, Tone::Caution);
  CalibrationCheck nothing = holds;
  nothing.cells.front().change = CellChange::NotTold;
  nothing.compared = false;
  EXPECT_EQ(oldCalibrationText(nothing, "a").tone, Tone::Caution);
  EXPECT_EQ(oldCalibrationText(changedSkin(), "a").tone, Tone::Bad);
}

}  // namespace
}  // namespace hexoderm
