// The step "Place on the robot": by mouse, by keyboard from two patches to the robot's URDF with the skin on it, and
// what of it is kept, undone and shown elsewhere.

#include "hexoderm/io/calibration_json.h"
#include "tests/app/window/window_place_fixture.h"

namespace hexoderm {
namespace {

TEST_F(WindowPlaceTest, TwoPatchesArePlacedByTheKeyboardAndOnToTheRobotsUrdfWithTheSkinOnIt) {
  window_->openFile(pathTo("arm.session.json"));
  ASSERT_TRUE(waitForPoses(8));
  key(Qt::Key_6, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([this] { return panel().isVisible(); }));
  EXPECT_FALSE(window_->robotView()->isVisible());
  EXPECT_FALSE(find<QPushButton>("placeChooseJoints")->isEnabled()) << "the robot comes first";
  ASSERT_NO_FATAL_FAILURE(tabTo("placeChooseRobot"));
  key(Qt::Key_Space);
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("robotDialog", HEXODERM_DEMO_ROBOT));
  ASSERT_NO_FATAL_FAILURE(comeBack());
  ASSERT_TRUE(waitForWork());
  EXPECT_TRUE(window_->robotView()->isVisible()) << "it takes the place of the patch";
  EXPECT_THAT(stand().joints.text.toStdString(), HasSubstr("No pose has joint angles"));
  ASSERT_NO_FATAL_FAILURE(tabTo("placeChooseJoints"));
  key(Qt::Key_Space);
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("jointsDialog", pathTo("arm.csv")));
  ASSERT_NO_FATAL_FAILURE(comeBack());
  ASSERT_TRUE(waitForWork());
  ASSERT_EQ(stand().patches.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_NO_FATAL_FAILURE(tabTo("placePatchList", k == 0 ? Qt::Key_Tab : Qt::Key_Backtab));
    key(k == 0 ? Qt::Key_Home : Qt::Key_End);
    ASSERT_TRUE(waitForWork());
    const CellId origin(stand().patch);
    ASSERT_EQ(origin.value(), stand().patches[k].id);
    const MountedPatch& patch = mounted(origin);
    EXPECT_EQ(stand().link.toStdString(), patch.link) << "the only link that fits is taken";
    EXPECT_EQ(stand().link_says.tone, Tone::Good) << stand().link_says.text.toStdString();
    for (const CellId cell : {patch.cells.front(), patch.cells.back()}) {
      const Eigen::Vector3d x_mm = trueCell(cell).t / kMillimetre;
      const auto type = [this](const char* field, const QString& text, int code = Qt::Key_Tab) {
        ASSERT_NO_FATAL_FAILURE(tabTo(field, code));
        key(Qt::Key_A, Qt::ControlModifier);
        keys(text);
      };
      // For the second point, back from the button.
      const int to_cell = cell == patch.cells.front() ? Qt::Key_Tab : Qt::Key_Backtab;
      ASSERT_NO_FATAL_FAILURE(type("placePointCell", QString::number(cell.value()), to_cell));
      ASSERT_NO_FATAL_FAILURE(type("placePointX", QString::number(x_mm.x(), 'f', 1)));
      ASSERT_NO_FATAL_FAILURE(type("placePointY", QString::number(x_mm.y(), 'f', 1)));
      ASSERT_NO_FATAL_FAILURE(type("placePointZ", QString::number(x_mm.z(), 'f', 1)));
      ASSERT_NO_FATAL_FAILURE(tabTo("placeAddPoint"));
      key(Qt::Key_Space);
      ASSERT_TRUE(waitForWork());
    }
    ASSERT_FALSE(stand().places.isEmpty()) << stand().place_says.text.toStdString();
    // It is shown before it is chosen.
    const auto& drawn = window_->robotView()->picture().patches;
    EXPECT_TRUE(std::ranges::any_of(drawn, &RobotPicture::Patch::is_proposal));
    ASSERT_NO_FATAL_FAILURE(tabTo("placePlaceList"));
    key(Qt::Key_Home);
    key(Qt::Key_Return);
    ASSERT_TRUE(waitUntil([this] { return stand().place == 0; })) << stand().place_says.text.toStdString();
    ASSERT_TRUE(waitForWork());
  }
  ASSERT_NO_FATAL_FAILURE(expectPlacedWell());
  EXPECT_TRUE(std::ranges::none_of(window_->robotView()->picture().patches, &RobotPicture::Patch::is_proposal));

  // The robot is turned by keys too.
  if (window_->robotView()->canDraw()) {
    const QImage before = window_->robotView()->screenshot();
    ASSERT_NO_FATAL_FAILURE(tabTo("robotView"));
    key(Qt::Key_Left);
    EXPECT_NE(window_->robotView()->screenshot(), before);
  }
  key(Qt::Key_E, Qt::ControlModifier);
  auto* dialog = waitForDialog("exportDialog");
  auto* formats = dialog->findChild<QListWidget*>("exportFormats");
  ASSERT_NO_FATAL_FAILURE(tabTo("exportFormats"));
  key(Qt::Key_Home);
  for (int k = 0; k < formats->count() && formats->currentItem()->text() != "ROBOT-URDF"; ++k) key(Qt::Key_Down);
  EXPECT_EQ(dialog->findChild<QLineEdit*>("export-robot")->text(), HEXODERM_DEMO_ROBOT) << "the robot is known";
  ASSERT_NO_FATAL_FAILURE(tabTo("exportPath"));
  key(Qt::Key_A, Qt::ControlModifier);
  keys(pathTo("merged.urdf"));
  key(Qt::Key_Return);
  ASSERT_TRUE(waitForMessage("Exported to " + pathTo("merged.urdf")));
  const RobotModel merged = RobotModel::read(pathTo("merged.urdf").toStdString());
  EXPECT_GT(merged.links().size(), robot_->robot().links().size() + 33) << "34 cells are on it";
  for (const RobotLink& link : robot_->robot().links()) EXPECT_TRUE(merged.findLink(link.name)) << link.name;
}

TEST_F(WindowPlaceTest, EveryDecisionCanBeUndoneAndIsKept) {
  ASSERT_NO_FATAL_FAILURE(openPlaced());
  ASSERT_TRUE(stand().is_placed);
  const std::uint64_t solved = controller().submittedRevision();
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([this] { return !stand().is_placed; }));
  EXPECT_EQ(stand().known.points.size(), 2U);
  press(Qt::Key_Z, Qt::ControlModifier);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([this] { return stand().known.points.empty(); }));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([this] { return controller().session()->poses()[0].joint_angles.positions.empty(); }));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([this] { return !stand().has_robot; }));
  EXPECT_FALSE(window_->robotView()->isVisible());
  for (int k = 0; k < 5; ++k) press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(waitForWork());
  EXPECT_TRUE(stand().is_placed);
  EXPECT_EQ(controller().submittedRevision(), solved) << "nothing of the skin is solved anew for it";

  // The session has it, and so does the calibration.
  controller().file().saveSession(pathTo("kept.hexo"));
  ASSERT_TRUE(waitForMessage("Saved to"));
  controller().resultFiles().exportTo({std::nullopt, pathTo("kept.calibration.json"), {}});
  ASSERT_TRUE(waitForMessage("Exported to"));
  EXPECT_EQ(placedPatches(*readCalibrationJson(pathTo("kept.calibration.json").toStdString())).size(), 1U);
  const PatchOnLink before = placedPatches(*controller().reconstruction()).at(0);
  window_->openFile(pathTo("arm.session.json"));
  ASSERT_TRUE(waitUntil([this] { return controller().session()->placements().empty(); }));
  window_->openFile(pathTo("kept.hexo"));
  ASSERT_TRUE(waitUntil([this] { return !controller().session()->placements().empty(); }));
  ASSERT_NO_FATAL_FAILURE(openPlace());
  ASSERT_TRUE(waitForWork());
  EXPECT_TRUE(stand().has_robot);
  ASSERT_EQ(placedPatches(*controller().reconstruction()).size(), 1U);
  EXPECT_EQ(placedPatches(*controller().reconstruction())[0].T_l_o.t, before.T_l_o.t);
}

TEST_F(WindowPlaceTest, BeforeTheExportTheCellsAreLookedAtWithTheirNumbers) {
  ASSERT_NO_FATAL_FAILURE(openPlaced());
  const bool draws = window_->robotView()->canDraw();
  window_->robotView()->fit();
  const QImage whole = draws ? window_->robotView()->screenshot() : QImage();
  openStep(GuideStep::Export);
  ASSERT_TRUE(waitUntil([this] { return window_->robotView()->isVisible(); }));
  EXPECT_EQ(window_->robotView()->picture().patches.size(), 1U);
  EXPECT_FALSE(window_->robotView()->picture().movable) << "nothing is moved here";
  if (draws) {
    EXPECT_NE(window_->robotView()->screenshot(), whole) << "the camera goes up to the skin";
  }
  keepPicture(window_->picture(), "place-before-export-light");
}

TEST_F(WindowPlaceTest, TheDemoBeginsAtTheStepWithItsRobot) {
  action("actionRobotDemo")->trigger();
  ASSERT_TRUE(waitUntil([this] { return controller().session() && controller().session()->robot(); }));
  ASSERT_TRUE(waitForWork());
  EXPECT_EQ(window_->findChild<StepPanel*>()->openIndex(), static_cast<int>(GuideStep::Place));
  EXPECT_TRUE(window_->robotView()->isVisible());
  EXPECT_EQ(stand().patches.size(), 2U);
  EXPECT_FALSE(stand().link.isEmpty()) << stand().link_says.text.toStdString();
  EXPECT_FALSE(controller().file().hasUnsavedChanges());
  keepPicture(window_->picture(), "place-demo-light");
}

TEST_F(WindowPlaceTest, ACalibrationShowsItsPlacesButDecidesNothing) {
  ASSERT_NO_FATAL_FAILURE(openPlaced());
  controller().resultFiles().exportTo({std::nullopt, pathTo("arm.calibration.json"), {}});
  ASSERT_TRUE(waitForMessage("Exported to"));
  controller().undoStack()->setClean();
  window_->openFile(pathTo("arm.calibration.json"));
  ASSERT_TRUE(waitUntil([this] { return controller().session() == nullptr; }));
  ASSERT_NO_FATAL_FAILURE(openPlace());
  ASSERT_TRUE(waitForWork());
  EXPECT_THAT(stand().why_not.toStdString(), HasSubstr("A calibration is open"));
  EXPECT_FALSE(find<QPushButton>("placeChooseRobot")->isEnabled());
  EXPECT_TRUE(window_->robotView()->isVisible());
  EXPECT_TRUE(waitUntil([this] { return window_->robotView()->picture().patches.size() == 1; }));
}

}  // namespace
}  // namespace hexoderm
