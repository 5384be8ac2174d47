// The step "Place on the robot": robots and joint angles, from files, typed and pasted, and what is said of those that
// are of no use.

#include "tests/app/window/window_place_fixture.h"
#include "widgets/tables/joint_table_view.h"

namespace hexoderm {
namespace {

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
  QApplication::clipboard()->setText(block);
  table->setFocus();
  table->setCurrentIndex(table->model()->index(0, 0));
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

}  // namespace
}  // namespace hexoderm
