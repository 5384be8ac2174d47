// The checks against other calibrations: whether a result repeats, and whether the skin still is as it was calibrated.

#include "tests/widgets/tables/table_texts.h"
#include "tests/widgets/verify/verify_panel_fixture.h"

#include <cstddef>

namespace hexoderm::verify_panel_test {
namespace {

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
  int wanted = 0;
  int dropped = 0;
  QObject::connect(panel_, &VerifyPanel::oldCalibrationWanted, [&] { ++wanted; });
  QObject::connect(
      panel_, &VerifyPanel::oldCalibrationRequested,
      [&](const QString& path, std::optional<std::size_t> poses) { asked.emplace_back(path.toStdString(), poses); });
  QObject::connect(panel_, &VerifyPanel::oldCalibrationDropped, [&] { ++dropped; });
  auto* choose = find<QPushButton>("oldCalibrationChoose");
  auto* poses = find<QComboBox>("oldCalibrationPoses");
  auto* remove = find<QPushButton>("oldCalibrationRemove");
  EXPECT_FALSE(choose->isEnabled());
  EXPECT_EQ(choose->toolTip().toStdString(), "There is no skin yet.");
  panel_->setReconstruction(skin());
  panel_->setHasReadings(false);
  EXPECT_FALSE(choose->isEnabled());
  EXPECT_FALSE(poses->isEnabled());
  EXPECT_THAT(sentence("oldCalibration"), testing::HasSubstr("open a session with the poses of today"));
  panel_->setHasReadings(true);
  EXPECT_EQ(sentence("oldCalibration"), "");
  ASSERT_TRUE(choose->isEnabled());
  choose->setFocus();
  QTest::keyClick(choose, Qt::Key_Space);
  EXPECT_EQ(wanted, 1);
  EXPECT_FALSE(remove->isVisible());

  poses->setFocus();
  QTest::keyClick(poses, Qt::Key_Up);
  QTest::keyClick(poses, Qt::Key_Down);
  EXPECT_TRUE(asked.empty()) << "no file is chosen yet";
  panel_->checkOldCalibration("arm.calibration.json");
  QTest::keyClick(poses, Qt::Key_Up);
  QTest::keyClick(poses, Qt::Key_End);
  EXPECT_THAT(asked, testing::ElementsAre(Asked("arm.calibration.json", 2), Asked("arm.calibration.json", 1),
                                          Asked("arm.calibration.json", std::nullopt)));
  panel_->showOldCalibration(changedSkin(), "arm.calibration.json");
  ASSERT_TRUE(remove->isVisible());
  remove->setFocus();
  QTest::keyClick(remove, Qt::Key_Space);
  EXPECT_EQ(dropped, 1);
  EXPECT_EQ(sentence("oldCalibration"), "");
  EXPECT_FALSE(find<QTableView>("oldCalibrationTable")->isVisible());
  EXPECT_FALSE(remove->isVisible());
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
  EXPECT_EQ(test::text(model, 0, 0), "5");
  EXPECT_EQ(test::text(model, 0, 1), "turned by 20.0° +- 0.5°");
  EXPECT_EQ(test::text(model, 0, 2), "20.00");
  EXPECT_EQ(test::text(model, 1, 1), "dead: it reads no gravity");
  EXPECT_EQ(test::text(model, 2, 0), "99");
  EXPECT_EQ(test::text(model, 3, 0), "9");
  EXPECT_EQ(test::text(model, 4, 1), "as calibrated");
  EXPECT_EQ(test::text(model, 4, 4), "4.00");
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

TEST_F(VerifyPanelTest, AnOldCalibrationThatFailsOrIsCancelledShowsNoEarlierCells) {
  panel_->setReconstruction(skin());
  auto* table = find<QTableView>("oldCalibrationTable");
  panel_->checkOldCalibration("other.calibration.json");
  panel_->showOldCalibration(changedSkin(), "arm.calibration.json");
  ASSERT_TRUE(table->isVisible());
  panel_->showFailure(VerifyCheck::OldCalibration, "other.calibration.json: the calibration is of another skin");
  EXPECT_EQ(sentence("oldCalibration"), "other.calibration.json: the calibration is of another skin");
  EXPECT_FALSE(table->isVisible());
  EXPECT_TRUE(find<QPushButton>("oldCalibrationRemove")->isVisible());

  panel_->showOldCalibration(changedSkin(), "arm.calibration.json");
  std::vector<VerifyCheck> cancelled;
  QObject::connect(panel_, &VerifyPanel::cancelRequested, [&](VerifyCheck check) {
    cancelled.push_back(check);
    panel_->setRunning(check, false);
  });
  panel_->setRunning(VerifyCheck::OldCalibration, true);
  auto* cancel = find<QPushButton>("oldCalibrationCancel");
  ASSERT_TRUE(test::waitUntil([&] { return cancel->isVisible(); }));
  cancel->setFocus();
  QTest::keyClick(cancel, Qt::Key_Space);
  EXPECT_THAT(cancelled, testing::ElementsAre(VerifyCheck::OldCalibration));
  EXPECT_EQ(sentence("oldCalibration"), "Cancelled.");
  EXPECT_FALSE(table->isVisible());
}

}  // namespace
}  // namespace hexoderm::verify_panel_test
