// The step "Place on the robot": from two patches to the robot's URDF with the skin on it; robots and joint angles,
// from files, typed and pasted; and what the operator says of one patch, by its link, by points and by hand.

#include "hexoderm/io/calibration_json.h"
#include "tests/app/window/window_place_fixture.h"
#include "widgets/tables/joint_table_view.h"

namespace hexoderm {
namespace {

TEST_F(WindowPlaceTest, TwoPatchesArePlacedByTheKeyboardAndOnToTheRobotsUrdfWithTheSkinOnIt) {
  window_->openFile(pathTo("arm.session.json"));
  ASSERT_TRUE(waitForPoses(8));
  key(Qt::Key_6, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([this] { return panel().isVisible(); }));
  EXPECT_FALSE(robotView()->isVisible());
  EXPECT_FALSE(find<QPushButton>("placeChooseJoints")->isEnabled()) << "the robot comes first";
  ASSERT_NO_FATAL_FAILURE(tabTo("placeChooseRobot"));
  key(Qt::Key_Space);
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("robotDialog", HEXODERM_DEMO_ROBOT));
  ASSERT_NO_FATAL_FAILURE(comeBack());
  ASSERT_TRUE(waitForWork());
  EXPECT_TRUE(robotView()->isVisible()) << "it takes the place of the patch";
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
    const auto& drawn = robotView()->picture().patches;
    EXPECT_TRUE(std::ranges::any_of(drawn, &RobotPicture::Patch::is_proposal));
    ASSERT_NO_FATAL_FAILURE(tabTo("placePlaceList"));
    key(Qt::Key_Home);
    key(Qt::Key_Return);
    ASSERT_TRUE(waitUntil([this] { return stand().place == 0; })) << stand().place_says.text.toStdString();
    ASSERT_TRUE(waitForWork());
  }
  ASSERT_NO_FATAL_FAILURE(expectPlacedWell());
  EXPECT_TRUE(std::ranges::none_of(robotView()->picture().patches, &RobotPicture::Patch::is_proposal));

  // The robot is turned by keys too.
  if (robotView()->canDraw()) {
    const QImage before = robotView()->screenshot();
    ASSERT_NO_FATAL_FAILURE(tabTo("robotView"));
    key(Qt::Key_Left);
    EXPECT_NE(robotView()->screenshot(), before);
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
  EXPECT_FALSE(robotView()->isVisible());
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
  const bool draws = robotView()->canDraw();
  robotView()->fit();
  const QImage whole = draws ? robotView()->screenshot() : QImage();
  openStep(GuideStep::Export);
  ASSERT_TRUE(waitUntil([this] { return robotView()->isVisible(); }));
  EXPECT_EQ(robotView()->picture().patches.size(), 1U);
  EXPECT_FALSE(robotView()->picture().movable) << "nothing is moved here";
  if (draws) {
    EXPECT_NE(robotView()->screenshot(), whole) << "the camera goes up to the skin";
  }
  keepPicture(window_->picture(), "place-before-export-light");
}

TEST_F(WindowPlaceTest, TheDemoBeginsAtTheStepWithItsRobot) {
  action("actionRobotDemo")->trigger();
  ASSERT_TRUE(waitUntil([this] { return controller().session() && controller().session()->robot(); }));
  ASSERT_TRUE(waitForWork());
  EXPECT_EQ(window_->findChild<StepPanel*>()->openIndex(), static_cast<int>(GuideStep::Place));
  EXPECT_TRUE(robotView()->isVisible());
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
  EXPECT_TRUE(robotView()->isVisible());
  EXPECT_TRUE(waitUntil([this] { return robotView()->picture().patches.size() == 1; }));
}

TEST_F(WindowPlaceTest, AnglesAreTypedAndPastedIntoTheTableOfPoses) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  ASSERT_NO_FATAL_FAILURE(chooseRobot(HEXODERM_DEMO_ROBOT));
  auto* table = find<JointTableView>("placeJointTable");
  window_->findChild<StepPanel*>()->ensureWidgetVisible(table);
  const std::vector<RobotJoint> joints = stand().sheet.joints;
  ASSERT_EQ(joints.size(), robot_->robot().freeJointNames().size());
  ASSERT_EQ(table->model()->rowCount(), 8);
  // One by the keyboard.
  const auto column = std::ranges::find(joints, "elbow", &RobotJoint::name) - joints.begin();
  table->setFocus();
  table->setCurrentIndex(table->model()->index(0, static_cast<int>(column)));
  keys("200");
  key(Qt::Key_Return);
  ASSERT_TRUE(waitUntil([&] { return table->currentIndex().row() == 1; })) << "the pose below is next";
  const auto elbow = [this](std::size_t pose) -> std::optional<double> {
    const auto& positions = controller().session()->poses()[pose].joint_angles.positions;
    const auto found = positions.find("elbow");
    return found == positions.end() ? std::nullopt : std::optional(found->second);
  };
  ASSERT_TRUE(elbow(0));
  EXPECT_DOUBLE_EQ(*elbow(0), 200 * kDegree);
  EXPECT_EQ(stand().joints.tone, Tone::Caution);
  EXPECT_THAT(stand().joints.text.toStdString(), AllOf(HasSubstr("1 of 8 poses"), HasSubstr("its limits are")));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([&] { return !elbow(0); }));

  // All of them from a spreadsheet, in one step.
  QString block;
  for (const JointAnglesRow& row : angles_.rows) {
    QStringList line;
    for (const RobotJoint& joint : joints) {
      const double position = row.angles.positions.at(joint.name);
      line << QString::number(joint.type == JointType::Prismatic ? toMillimetres(position) : toDegrees(position), 'g',
                              17);
    }
    block += line.join('\t') + '\n';
  }
  table->setFocus();
  table->setCurrentIndex(table->model()->index(0, 0));
  QApplication::clipboard()->setText("x");
  key(Qt::Key_V, Qt::ControlModifier);
  EXPECT_THAT(stand().joints.text.toStdString(), HasSubstr("is no number"));
  QApplication::clipboard()->setText(block);
  const int steps = controller().undoStack()->count();
  key(Qt::Key_V, Qt::ControlModifier);
  ASSERT_TRUE(waitForWork());
  EXPECT_EQ(controller().undoStack()->index(), steps);  // in place of the one that was undone
  EXPECT_THAT(stand().joints.text.toStdString(), HasSubstr("8 of 8 poses"));
  EXPECT_EQ(stand().link.toStdString(), mounted(CellId(stand().patch)).link) << "as with the angles of a file";
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([&] { return controller().session()->poses()[7].joint_angles.positions.empty(); }));
  EXPECT_TRUE(waitUntil([&] { return controller().session()->poses()[0].joint_angles.positions.empty(); }));
}

TEST_F(WindowPlaceTest, AFileThatIsDroppedIsTakenByTheStep) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  dropFile(pathTo("arm.csv"));
  EXPECT_THAT(stand().robot.text.toStdString(), HasSubstr("Choose the robot first"));
  dropFile(HEXODERM_DEMO_ROBOT);
  ASSERT_TRUE(waitForWork());
  EXPECT_TRUE(stand().has_robot);
  dropFile(pathTo("arm.csv"));
  ASSERT_TRUE(waitForWork());
  EXPECT_THAT(stand().joints.text.toStdString(), HasSubstr("8 of 8 poses"));
}

TEST_F(WindowPlaceTest, ARobotThatCannotBeReadIsSaidAndTheOneBeforeStays) {
  ASSERT_NO_FATAL_FAILURE(openWithRobot());
  const int steps = controller().undoStack()->count();
  const QString loop = writeFile("loop.urdf", R"(<robot name="loop"><link name="a"/><link name="b"/>
    <joint name="ab" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
    <joint name="ba" type="revolute"><parent link="b"/><child link="a"/><axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>)");
  ASSERT_NO_FATAL_FAILURE(chooseRobot(loop));
  EXPECT_THAT(stand().robot.text.toStdString(), AllOf(HasSubstr("loop.urdf"), HasSubstr("form a loop")));
  EXPECT_TRUE(stand().has_robot);
  EXPECT_THAT(stand().robot.text.toStdString(), HasSubstr("demo_arm"));
  ASSERT_NO_FATAL_FAILURE(chooseRobot(writeFile("no.urdf", "this is no XML")));
  EXPECT_THAT(stand().robot.text.toStdString(), HasSubstr("no.urdf"));
  EXPECT_EQ(controller().undoStack()->count(), steps);
  EXPECT_EQ(controller().session()->robot()->urdf, HEXODERM_DEMO_ROBOT);
  EXPECT_FALSE(stand().link.isEmpty());
}

TEST_F(WindowPlaceTest, ARobotWhoseMeshesAreMissingOrHostileIsOfUseForLinksAndSaysWhatIsWrong) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  QString text = robotText();
  text.replace("meshes/forearm.obj", HEXODERM_TEST_DATA "/../fuzz/corpus/mesh/selfnode.dae");
  ASSERT_NO_FATAL_FAILURE(chooseRobot(writeFile("bare.urdf", text.toUtf8())));
  EXPECT_TRUE(stand().has_robot);
  EXPECT_EQ(stand().robot.tone, Tone::Bad);
  EXPECT_THAT(stand().robot.text.toStdString(), AllOf(HasSubstr("selfnode.dae"), HasSubstr("upper_arm.obj")));
  ASSERT_NO_FATAL_FAILURE(chooseJoints(pathTo("arm.csv")));
  EXPECT_FALSE(stand().link.isEmpty()) << stand().link_says.text.toStdString();
  EXPECT_FALSE(stand().has_surface);
  EXPECT_FALSE(find<QPushButton>("placeMove")->isEnabled());
  EXPECT_TRUE(stand().places.isEmpty());
  ASSERT_NO_FATAL_FAILURE(typePoints(CellId(stand().patch)));
  EXPECT_FALSE(stand().places.isEmpty()) << "points say where it lies: " << stand().place_says.text.toStdString();
}

TEST_F(WindowPlaceTest, AMeshInMillimetresIsNoticedByItsSize) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  QString text = robotText();
  const QString meshes = QFileInfo(HEXODERM_DEMO_ROBOT).absolutePath() + "/meshes/";
  text.replace("filename=\"meshes/", "scale=\"1000 1000 1000\" filename=\"" + meshes);
  ASSERT_NO_FATAL_FAILURE(chooseRobot(writeFile("large.urdf", text.toUtf8())));
  EXPECT_TRUE(stand().has_robot) << stand().robot.text.toStdString();
  EXPECT_EQ(stand().robot.tone, Tone::Caution);
  EXPECT_THAT(stand().robot.text.toStdString(), HasSubstr("millimetre"));
}

TEST_F(WindowPlaceTest, ATableWithoutAJointOrWithTheWrongUnitIsSaid) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  ASSERT_NO_FATAL_FAILURE(chooseRobot(HEXODERM_DEMO_ROBOT));
  ASSERT_NO_FATAL_FAILURE(chooseJoints(writeFile("one.csv", "pose,elbow[deg]\n1,10\n")));
  EXPECT_THAT(stand().joints.text.toStdString(), AllOf(HasSubstr("one.csv"), HasSubstr("have no column")));
  EXPECT_TRUE(controller().session()->poses()[0].joint_angles.positions.empty());

  // Degrees under titles that say rad.
  JointAnglesTable degrees = angles_;
  for (JointAnglesRow& row : degrees.rows) {
    for (auto& [joint, position] : row.angles.positions) position = toDegrees(position);
  }
  writeFileAtomically(pathTo("degrees.csv").toStdString(), jointAnglesCsv(degrees, robot_->robot()));
  ASSERT_NO_FATAL_FAILURE(chooseJoints(pathTo("degrees.csv")));
  EXPECT_EQ(stand().joints.tone, Tone::Bad);
  EXPECT_THAT(stand().joints.text.toStdString(), HasSubstr("probably degrees that were read as rad"));
}

TEST_F(WindowPlaceTest, APatchOnNoLinkIsSaidAndNothingIsTaken) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  ASSERT_NO_FATAL_FAILURE(chooseRobot(HEXODERM_DEMO_ROBOT));
  // The angles of other poses.
  JointAnglesTable mixed = angles_;
  for (std::size_t k = 0; k < mixed.rows.size(); ++k) {
    mixed.rows[k].angles = angles_.rows[(k + 3) % angles_.rows.size()].angles;
  }
  writeFileAtomically(pathTo("mixed.csv").toStdString(), jointAnglesCsv(mixed, robot_->robot()));
  ASSERT_NO_FATAL_FAILURE(chooseJoints(pathTo("mixed.csv")));
  EXPECT_TRUE(stand().link.isEmpty());
  EXPECT_EQ(stand().link_says.tone, Tone::Bad);
  EXPECT_THAT(stand().link_says.text.toStdString(), HasSubstr("fits no link"));
  EXPECT_FALSE(stand().links.empty()) << "the nearest is shown";
  EXPECT_TRUE(stand().places.isEmpty());
  EXPECT_TRUE(controller().session()->placements().empty());
}

TEST_F(WindowPlaceTest, AnotherLinkCanBeChosenAndIsSaidNotToFit) {
  ASSERT_NO_FATAL_FAILURE(openWithRobot());
  const std::string right = stand().link.toStdString();
  auto* box = find<QComboBox>("placeOtherLink");
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Home);
  const QString wrong = right == "forearm" ? "upper_arm" : "forearm";
  for (int k = 0; k < box->count() && box->currentText() != wrong; ++k) QTest::keyClick(box, Qt::Key_Down);
  QTest::keyClick(box, Qt::Key_Return);
  ASSERT_TRUE(waitUntil([&] { return stand().link == wrong; }));
  ASSERT_TRUE(waitForWork());
  EXPECT_EQ(stand().link_says.tone, Tone::Bad);
  EXPECT_THAT(stand().link_says.text.toStdString(), HasSubstr("doesn't fit"));
  ASSERT_EQ(controller().session()->placements().size(), 1U);
  EXPECT_TRUE(controller().session()->placements()[0].link_chosen);
}

TEST_F(WindowPlaceTest, ThePatchIsMovedByHandAndTheFitBeginsThere) {
  ASSERT_NO_FATAL_FAILURE(openWithRobot());
  RobotView* view = robotView();
  ASSERT_TRUE(view->canDraw()) << "no OpenGL";
  // The upper arm is a box with rounded edges, along which its patch can slide.
  if (mounted(CellId(stand().patch)).link != "upper_arm") {
    QTest::keyClick(find<QComboBox>("placePatchList"), Qt::Key_Down);
    ASSERT_TRUE(waitForWork());
  }
  const CellId origin(stand().patch);
  ASSERT_EQ(mounted(origin).link, "upper_arm");
  ASSERT_NO_FATAL_FAILURE(typePoints(origin));
  ASSERT_NO_FATAL_FAILURE(clickRowOf(find<QListWidget>("placePlaceList"), 0));
  ASSERT_TRUE(waitForWork());
  const auto placed = [&] { return controller().session()->findPlacement(origin)->place; };
  ASSERT_TRUE(placed());
  const SE3 before = placed()->T_l_o;
  const int steps = controller().undoStack()->index();
  const auto drawn = [&] {
    const RobotPicture& picture = view->picture();
    return picture.movable ? std::optional(picture.patches[*picture.movable]) : std::nullopt;
  };
  ASSERT_TRUE(drawn());

  // From before it, so that the ways on the screen are ways along the surface.
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeLook"));
  // The keyboard: 10 mm along the screen and 5 degrees about the normal, and left alone.
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeMove"));
  EXPECT_TRUE(view->hasFocus());
  EXPECT_THAT(stand().place_says.text.toStdString(), HasSubstr("Return lays it there"));
  key(Qt::Key_Right, Qt::ShiftModifier);
  ASSERT_TRUE(drawn());
  EXPECT_TRUE(drawn()->is_proposal);
  EXPECT_NEAR((drawn()->T_l_o.t - before.t).norm(), 0.010, 0.003);
  EXPECT_EQ(placed()->T_l_o.t, before.t) << "nothing is decided yet";
  for (int k = 0; k < 4; ++k) key(Qt::Key_PageUp, Qt::ShiftModifier);
  EXPECT_THAT(stand().place_says.text.toStdString(), HasSubstr("against what gravity says"));
  key(Qt::Key_Escape);
  EXPECT_FALSE(find<QPushButton>("placeMove")->isChecked());
  EXPECT_EQ(drawn()->T_l_o.t, before.t);
  EXPECT_EQ(controller().undoStack()->index(), steps);

  // Again, and laid: known points hold the patch, so that the fit brings it back to where it was.
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeMove"));
  key(Qt::Key_Right, Qt::ShiftModifier);
  key(Qt::Key_Return);
  ASSERT_TRUE(waitForWork());
  ASSERT_TRUE(placed());
  EXPECT_LT((placed()->T_l_o.t - before.t).norm(), 0.002);

  // Without them, the mouse pulls it to the other end of what is open, and it stays there.
  for (int k = 0; k < 2; ++k) {
    find<QListWidget>("placeKnownList")->setCurrentRow(0);
    ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeRemoveKnown"));
    ASSERT_TRUE(waitForWork());
  }
  const int without = controller().undoStack()->index();
  ASSERT_TRUE(placed());
  const Eigen::Vector3d unheld = placed()->T_l_o.t;
  const Eigen::Vector3d below = drawn()->T_l_o.t;
  emit view->gripped(below);
  emit view->pulledTo(below + Eigen::Vector3d(0, 0, 0.02));
  ASSERT_TRUE(drawn());
  EXPECT_TRUE(drawn()->is_proposal);
  const SE3 pulled = drawn()->T_l_o;
  EXPECT_NEAR(pulled.t.z() - below.z(), 0.02, 0.006);
  emit view->released();
  ASSERT_TRUE(waitForWork());
  ASSERT_TRUE(waitUntil([&] { return controller().undoStack()->index() == without + 1; }))
      << stand().place_says.text.toStdString();
  EXPECT_TRUE(std::ranges::any_of(stand().places, [](const QString& text) { return text.contains("put by hand"); }));
  EXPECT_GE(stand().place, 0) << "it is among the places, and chosen";
  EXPECT_NEAR(placed()->T_l_o.t.z(), pulled.t.z(), 0.004) << "where nothing holds it, it stays where it was put";
  EXPECT_TRUE(placed()->cov_t_r.has_value());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([&] { return placed() && placed()->T_l_o.t == unheld; }));
}

TEST_F(WindowPlaceTest, APointIsPickedOnTheRobotAndWaitsToBeAdded) {
  ASSERT_NO_FATAL_FAILURE(openWithRobot());
  ASSERT_TRUE(robotView()->canDraw()) << "no OpenGL";
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placePick"));
  const RobotPicture& picture = robotView()->picture();
  ASSERT_TRUE(picture.link);
  emit robotView()->pointPicked(*picture.link, Eigen::Vector3d(0.01, -0.02, 0.03));
  EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("placePointX")->value(), 10);
  EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("placePointY")->value(), -20);
  EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("placePointZ")->value(), 30);
  EXPECT_FALSE(find<QPushButton>("placePick")->isChecked());
  EXPECT_TRUE(stand().known.points.empty()) << "nothing is decided by the picking";
  const std::size_t other = *picture.link == 0 ? 1 : 0;
  emit robotView()->pointPicked(other, Eigen::Vector3d::Zero());
  EXPECT_THAT(stand().known_fault.toStdString(), HasSubstr("pick a point of that link"));
}

TEST_F(WindowPlaceTest, PointsAndDistancesOfWrongCellsAreRefusedText) {
  ASSERT_NO_FATAL_FAILURE(openWithRobot());
  const std::size_t steps = static_cast<std::size_t>(controller().undoStack()->count());
  find<QSpinBox>("placePointCell")->setValue(999);
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeAddPoint"));
  EXPECT_THAT(stand().known_fault.toStdString(), HasSubstr("Cell 999 is none of this patch"));
  const CellId origin(stand().patch);
  find<QSpinBox>("placeFromCell")->setValue(static_cast<int>(origin.value()));
  find<QDoubleSpinBox>("placeDistance")->setValue(50);
  find<QSpinBox>("placeToCell")->setValue(static_cast<int>(mounted(origin).cells.back().value()));
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeAddDistance"));
  EXPECT_THAT(stand().known_fault.toStdString(), HasSubstr("of no other patch"));
  const MountedPatch& other = robot_->patches()[&mounted(origin) == &robot_->patches()[0] ? 1 : 0];
  find<QSpinBox>("placeToCell")->setValue(static_cast<int>(other.cells.front().value()));
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeAddDistance"));
  EXPECT_THAT(stand().known_fault.toStdString(), HasSubstr("depends on the joints"));
  EXPECT_EQ(controller().undoStack()->count(), static_cast<int>(steps));
}

}  // namespace
}  // namespace hexoderm
