// The step "Place on the robot": from two patches to the robot's URDF with the skin on it, by mouse and by keyboard,
// and what is said of files that are of no use.

#include "app/window/guide/guide.h"
#include "hexoderm/device/simulation/simulated_robot.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/kinematics/joint_angles_csv.h"
#include "hexoderm/kinematics/robot_model.h"
#include "hexoderm/reconstruction/result/patch_placements.h"
#include "hexoderm/session/session_joint_angles.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/units.h"
#include "tests/app/window/keyboard.h"
#include "widgets/controls/step_panel.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/robot_view.h"
#include "widgets/tables/joint_table_view.h"

#include <QClipboard>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMimeData>
#include <QSpinBox>
#include <QUrl>
#include <numeric>

namespace hexoderm {
namespace {

using testing::HasSubstr;

class WindowPlaceTest : public KeyboardTest {
 protected:
  void SetUp() override {
    KeyboardTest::SetUp();
    SimulatedRobotOptions options;
    options.mounts = demoMounts();
    robot_.emplace(builtInCellModel("hex-bma150"), RobotModel::read(HEXODERM_DEMO_ROBOT), options);
    const SimulatedRobotSession simulated = simulateRobotSession(*robot_, 8, 50);
    angles_ = jointAnglesOf(simulated.session);
    Session without = simulated.session;
    for (std::size_t k = 0; k < without.poses().size(); ++k) without.setJointAngles(k, {});
    writeSessionJson(without, pathTo("arm.session.json").toStdString());
    writeFileAtomically(pathTo("arm.csv").toStdString(), jointAnglesCsv(angles_, robot_->robot()));
  }

  PlacePanel& panel() { return *window_->placePanel(); }
  const PlaceStand& stand() { return panel().stand(); }
  template <class T>
  T* inPanel(const char* name) {
    T* widget = panel().findChild<T*>(QLatin1String(name));
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  bool isWorking() {
    for (const PlaceWork work : {PlaceWork::Robot, PlaceWork::Joints, PlaceWork::Links, PlaceWork::Places}) {
      if (panel().isRunning(work)) return true;
    }
    return false;
  }
  bool waitForWork() {
    return waitUntilIdle() && waitUntil([this] {
             window_->showChanges();
             return !isWorking();
           });
  }
  void openStep() {
    window_->findChild<StepPanel*>()->openStep(static_cast<int>(GuideStep::Place));
    ASSERT_TRUE(waitUntil([this] { return panel().isVisible(); }));
  }
  void openSession() {
    window_->openFile(pathTo("arm.session.json"));
    ASSERT_TRUE(waitForPoses(8)) << message().toStdString();
    openStep();
  }
  /// Scrolls to it first, as a person does.
  template <class T>
  void pressInPanel(const char* name) {
    auto* widget = inPanel<T>(name);
    ASSERT_TRUE(widget->isEnabled()) << name << ": " << widget->toolTip().toStdString();
    window_->findChild<StepPanel*>()->ensureWidgetVisible(widget);
    QCoreApplication::processEvents();
    click(widget);
  }
  void clickRowOf(QListWidget* list, int row) {
    window_->findChild<StepPanel*>()->ensureWidgetVisible(list);
    list->scrollToItem(list->item(row));
    QCoreApplication::processEvents();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(list->item(row)).center());
  }
  void chooseRobot(const QString& path) {
    ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeChooseRobot"));
    ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("robotDialog", path));
    ASSERT_TRUE(waitUntil([this] { return window_->findChild<QDialog*>("robotDialog") == nullptr; }));
    ASSERT_TRUE(waitForWork());
  }
  void chooseJoints(const QString& path) {
    ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeChooseJoints"));
    ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("jointsDialog", path));
    ASSERT_TRUE(waitUntil([this] { return window_->findChild<QDialog*>("jointsDialog") == nullptr; }));
    ASSERT_TRUE(waitForWork());
  }
  void openWithRobot() {
    ASSERT_NO_FATAL_FAILURE(openSession());
    ASSERT_NO_FATAL_FAILURE(chooseRobot(HEXODERM_DEMO_ROBOT));
    ASSERT_TRUE(stand().has_robot) << stand().robot.text.toStdString();
    ASSERT_NO_FATAL_FAILURE(chooseJoints(pathTo("arm.csv")));
  }
  void choosePatch(quint32 origin) {
    auto* box = inPanel<QComboBox>("placePatchList");
    const int index = box->findData(origin);
    ASSERT_GE(index, 0);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int k = 0; k < box->count() && box->currentIndex() != index; ++k) QTest::keyClick(box, Qt::Key_Down);
    ASSERT_EQ(stand().patch, origin);
    ASSERT_TRUE(waitForWork());
  }
  /// Of the patch that holds a cell.
  [[nodiscard]] const MountedPatch& mounted(CellId cell) const {
    for (const MountedPatch& patch : robot_->patches()) {
      if (std::ranges::find(patch.cells, cell) != patch.cells.end()) return patch;
    }
    throw std::logic_error("no patch holds the cell");
  }
  [[nodiscard]] SE3 trueCell(CellId cell) const {
    const MountedPatch& patch = mounted(cell);
    const auto found = std::ranges::find(patch.cells, cell);
    return patch.T_l_u[static_cast<std::size_t>(found - patch.cells.begin())];
  }
  /// Adds two cells as known points, far apart: with these there is one place.
  void typePoints(CellId origin) {
    const MountedPatch& patch = mounted(origin);
    for (const CellId cell : {patch.cells.front(), patch.cells.back()}) {
      const Eigen::Vector3d x_mm = trueCell(cell).t / kMillimetre;
      inPanel<QSpinBox>("placePointCell")->setValue(static_cast<int>(cell.value()));
      inPanel<QDoubleSpinBox>("placePointX")->setValue(x_mm.x());
      inPanel<QDoubleSpinBox>("placePointY")->setValue(x_mm.y());
      inPanel<QDoubleSpinBox>("placePointZ")->setValue(x_mm.z());
      ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeAddPoint"));
      ASSERT_TRUE(waitForWork());
    }
  }
  void expectPlacedWell() {
    const std::vector<PatchOnLink> placed = placedPatches(*controller().reconstruction());
    ASSERT_EQ(placed.size(), 2U);
    for (const PatchOnLink& place : placed) {
      EXPECT_EQ(place.link, mounted(place.origin).link);
      // The points were typed to a tenth of a millimetre, and the surface is exact: what is left is the patch's shape.
      EXPECT_LT((place.T_l_o.t - trueCell(place.origin).t).norm(), 0.010);
      EXPECT_TRUE(place.cov_t_r.has_value());
    }
  }
  QString robotText() { return QString::fromStdString(readFile(HEXODERM_DEMO_ROBOT)); }

  std::optional<SimulatedRobot> robot_;
  JointAnglesTable angles_;
};

TEST_F(WindowPlaceTest, FromTwoPatchesToTheRobotsUrdfWithTheSkinOnItByMouse) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  EXPECT_FALSE(window_->robotView()->isVisible());
  EXPECT_FALSE(inPanel<QPushButton>("placeChooseJoints")->isEnabled()) << "the robot comes first";
  ASSERT_NO_FATAL_FAILURE(chooseRobot(HEXODERM_DEMO_ROBOT));
  EXPECT_THAT(stand().robot.text.toStdString(), HasSubstr("demo_arm"));
  EXPECT_TRUE(window_->robotView()->isVisible()) << "it takes the place of the patch";
  EXPECT_THAT(stand().joints.text.toStdString(), HasSubstr("No pose has joint angles"));
  ASSERT_NO_FATAL_FAILURE(chooseJoints(pathTo("arm.csv")));
  EXPECT_THAT(stand().joints.text.toStdString(), HasSubstr("8 of 8 poses"));

  ASSERT_EQ(stand().patches.size(), 2U);
  for (const PlaceStand::Choice& choice : std::vector(stand().patches)) {
    ASSERT_NO_FATAL_FAILURE(choosePatch(choice.id));
    EXPECT_EQ(stand().link.toStdString(), mounted(CellId(choice.id)).link) << "the only link that fits is taken";
    EXPECT_EQ(stand().link_says.tone, Tone::Good) << stand().link_says.text.toStdString();
    EXPECT_EQ(controller().session()->placements().size(), 0U + (choice.id == stand().patches[0].id ? 0U : 1U));
    ASSERT_NO_FATAL_FAILURE(typePoints(CellId(choice.id)));
    ASSERT_FALSE(stand().places.isEmpty()) << stand().place_says.text.toStdString();
    // It is shown before it is chosen.
    const auto& drawn = window_->robotView()->picture().patches;
    EXPECT_TRUE(std::ranges::any_of(drawn, &RobotPicture::Patch::is_proposal));
    ASSERT_NO_FATAL_FAILURE(clickRowOf(inPanel<QListWidget>("placePlaceList"), 0));
    ASSERT_TRUE(waitForWork());
    EXPECT_EQ(stand().place, 0);
  }
  ASSERT_NO_FATAL_FAILURE(expectPlacedWell());
  const auto& picture = window_->robotView()->picture();
  EXPECT_EQ(picture.patches.size(), 2U);
  EXPECT_TRUE(std::ranges::none_of(picture.patches, &RobotPicture::Patch::is_proposal));
  keepPicture(window_->picture(), "place-light");
  window_->setThemeChoice(ThemeChoice::Dark, false);
  keepPicture(window_->picture(), "place-dark");

  press(Qt::Key_E, Qt::ControlModifier);
  auto* dialog = waitForDialog<QDialog>("exportDialog");
  ASSERT_NE(dialog, nullptr);
  auto* formats = dialog->findChild<QListWidget*>("exportFormats");
  const QList<QListWidgetItem*> found = formats->findItems("ROBOT-URDF", Qt::MatchFixedString);
  ASSERT_EQ(found.size(), 1);
  formats->setCurrentItem(found[0]);
  EXPECT_EQ(dialog->findChild<QLineEdit*>("export-robot")->text(), QStringLiteral(HEXODERM_DEMO_ROBOT))
      << "the robot is known";
  typeInto(dialog->findChild<QLineEdit*>("exportPath"), pathTo("merged.urdf"));
  click(dialog->findChild<QPushButton*>("exportButton"));
  ASSERT_TRUE(waitForMessage("Exported to " + pathTo("merged.urdf"))) << message().toStdString();
  const RobotModel merged = RobotModel::read(pathTo("merged.urdf").toStdString());
  EXPECT_GT(merged.links().size(), robot_->robot().links().size() + 33) << "34 cells are on it";
  for (const RobotLink& link : robot_->robot().links()) EXPECT_TRUE(merged.findLink(link.name)) << link.name;
}

TEST_F(WindowPlaceTest, TheSameByTheKeyboard) {
  window_->openFile(pathTo("arm.session.json"));
  ASSERT_TRUE(waitForPoses(8)) << message().toStdString();
  key(Qt::Key_6, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([this] { return panel().isVisible(); }));
  ASSERT_NO_FATAL_FAILURE(tabTo("placeChooseRobot"));
  key(Qt::Key_Space);
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("robotDialog", HEXODERM_DEMO_ROBOT));
  ASSERT_NO_FATAL_FAILURE(comeBack());
  ASSERT_TRUE(waitForWork());
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
    ASSERT_NO_FATAL_FAILURE(tabTo("placePlaceList"));
    key(Qt::Key_Home);
    key(Qt::Key_Return);
    ASSERT_TRUE(waitUntil([this] { return stand().place == 0; })) << stand().place_says.text.toStdString();
    ASSERT_TRUE(waitForWork());
  }
  ASSERT_NO_FATAL_FAILURE(expectPlacedWell());

  // The robot is turned by keys too.
  if (window_->robotView()->canDraw()) {
    const QImage before = window_->robotView()->screenshot();
    ASSERT_NO_FATAL_FAILURE(tabTo("robotView"));
    key(Qt::Key_Left);
    EXPECT_NE(window_->robotView()->screenshot(), before);
  }
  key(Qt::Key_E, Qt::ControlModifier);
  auto* dialog = waitForDialog<QDialog>("exportDialog");
  ASSERT_NE(dialog, nullptr);
  auto* formats = dialog->findChild<QListWidget*>("exportFormats");
  ASSERT_NO_FATAL_FAILURE(tabTo("exportFormats"));
  key(Qt::Key_Home);
  for (int k = 0; k < formats->count() && formats->currentItem()->text() != "ROBOT-URDF"; ++k) key(Qt::Key_Down);
  ASSERT_NO_FATAL_FAILURE(tabTo("exportPath"));
  key(Qt::Key_A, Qt::ControlModifier);
  keys(pathTo("merged.urdf"));
  key(Qt::Key_Return);
  ASSERT_TRUE(waitForMessage("Exported to " + pathTo("merged.urdf"))) << message().toStdString();
  EXPECT_NO_THROW(RobotModel::read(pathTo("merged.urdf").toStdString()));
}

TEST_F(WindowPlaceTest, EveryDecisionCanBeUndoneAndIsKept) {
  ASSERT_NO_FATAL_FAILURE(openWithRobot());
  const CellId origin(stand().patch);
  ASSERT_NO_FATAL_FAILURE(typePoints(origin));
  ASSERT_NO_FATAL_FAILURE(clickRowOf(inPanel<QListWidget>("placePlaceList"), 0));
  ASSERT_TRUE(waitForWork());
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
  ASSERT_NO_FATAL_FAILURE(openStep());
  ASSERT_TRUE(waitForWork());
  EXPECT_TRUE(stand().has_robot);
  ASSERT_EQ(placedPatches(*controller().reconstruction()).size(), 1U);
  EXPECT_EQ(placedPatches(*controller().reconstruction())[0].T_l_o.t, before.T_l_o.t);
}

TEST_F(WindowPlaceTest, AnglesAreTypedAndPastedIntoTheTableOfPoses) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  ASSERT_NO_FATAL_FAILURE(chooseRobot(HEXODERM_DEMO_ROBOT));
  auto* table = inPanel<JointTableView>("placeJointTable");
  window_->findChild<StepPanel*>()->ensureWidgetVisible(table);
  const std::vector<RobotJoint> joints = stand().sheet.joints;
  ASSERT_EQ(joints.size(), robot_->robot().freeJointNames().size());
  ASSERT_EQ(table->model()->rowCount(), 8);
  // One by the keyboard.
  const auto column = std::ranges::find(joints, "elbow", &RobotJoint::name) - joints.begin();
  table->setFocus();
  table->setCurrentIndex(table->model()->index(0, static_cast<int>(column)));
  keys(QStringLiteral("200"));
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
  keys(QStringLiteral("1-2"));
  key(Qt::Key_Return);
  ASSERT_TRUE(waitUntil([&] { return table->currentIndex().row() == 2; }));
  EXPECT_THAT(stand().joints.text.toStdString(), HasSubstr("\"1-2\" is no number"));
  EXPECT_FALSE(elbow(1));
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

TEST_F(WindowPlaceTest, AnotherLinkCanBeChosenAndIsSaidNotToFit) {
  ASSERT_NO_FATAL_FAILURE(openWithRobot());
  const std::string right = stand().link.toStdString();
  auto* box = inPanel<QComboBox>("placeOtherLink");
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
  RobotView* view = window_->robotView();
  ASSERT_TRUE(view->canDraw()) << "no OpenGL";
  // The upper arm is a box with rounded edges, along which its patch can slide.
  for (const PlaceStand::Choice& choice : std::vector(stand().patches)) {
    if (mounted(CellId(choice.id)).link != "upper_arm") continue;
    ASSERT_NO_FATAL_FAILURE(choosePatch(choice.id));
  }
  const CellId origin(stand().patch);
  ASSERT_NO_FATAL_FAILURE(typePoints(origin));
  ASSERT_NO_FATAL_FAILURE(clickRowOf(inPanel<QListWidget>("placePlaceList"), 0));
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
  EXPECT_FALSE(inPanel<QPushButton>("placeMove")->isChecked());
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
    inPanel<QListWidget>("placeKnownList")->setCurrentRow(0);
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

TEST_F(WindowPlaceTest, BeforeTheExportTheCellsAreLookedAtWithTheirNumbers) {
  ASSERT_NO_FATAL_FAILURE(openWithRobot());
  ASSERT_NO_FATAL_FAILURE(typePoints(CellId(stand().patch)));
  ASSERT_NO_FATAL_FAILURE(clickRowOf(inPanel<QListWidget>("placePlaceList"), 0));
  ASSERT_TRUE(waitForWork());
  const bool draws = window_->robotView()->canDraw();
  window_->robotView()->fit();
  const QImage whole = draws ? window_->robotView()->screenshot() : QImage();
  window_->findChild<StepPanel*>()->openStep(static_cast<int>(GuideStep::Export));
  ASSERT_TRUE(waitUntil([this] { return window_->robotView()->isVisible(); }));
  EXPECT_EQ(window_->robotView()->picture().patches.size(), 1U);
  EXPECT_FALSE(window_->robotView()->picture().movable) << "nothing is moved here";
  if (draws) {
    EXPECT_NE(window_->robotView()->screenshot(), whole) << "the camera goes up to the skin";
  }
  keepPicture(window_->picture(), "place-before-export-light");
}

TEST_F(WindowPlaceTest, APointIsPickedOnTheRobotAndWaitsToBeAdded) {
  ASSERT_NO_FATAL_FAILURE(openWithRobot());
  ASSERT_TRUE(window_->robotView()->canDraw()) << "no OpenGL";
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placePick"));
  const RobotPicture& picture = window_->robotView()->picture();
  ASSERT_TRUE(picture.link);
  emit window_->robotView()->pointPicked(*picture.link, Eigen::Vector3d(0.01, -0.02, 0.03));
  EXPECT_DOUBLE_EQ(inPanel<QDoubleSpinBox>("placePointX")->value(), 10);
  EXPECT_DOUBLE_EQ(inPanel<QDoubleSpinBox>("placePointY")->value(), -20);
  EXPECT_DOUBLE_EQ(inPanel<QDoubleSpinBox>("placePointZ")->value(), 30);
  EXPECT_FALSE(inPanel<QPushButton>("placePick")->isChecked());
  EXPECT_TRUE(stand().known.points.empty()) << "nothing is decided by the picking";
  const std::size_t other = *picture.link == 0 ? 1 : 0;
  emit window_->robotView()->pointPicked(other, Eigen::Vector3d::Zero());
  EXPECT_THAT(stand().known_fault.toStdString(), HasSubstr("pick a point of that link"));
}

TEST_F(WindowPlaceTest, PointsAndDistancesOfWrongCellsAreRefusedInWords) {
  ASSERT_NO_FATAL_FAILURE(openWithRobot());
  const std::size_t steps = static_cast<std::size_t>(controller().undoStack()->count());
  inPanel<QSpinBox>("placePointCell")->setValue(999);
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeAddPoint"));
  EXPECT_THAT(stand().known_fault.toStdString(), HasSubstr("Cell 999 is none of this patch"));
  const CellId origin(stand().patch);
  inPanel<QSpinBox>("placeFromCell")->setValue(static_cast<int>(origin.value()));
  inPanel<QDoubleSpinBox>("placeDistance")->setValue(50);
  inPanel<QSpinBox>("placeToCell")->setValue(static_cast<int>(mounted(origin).cells.back().value()));
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeAddDistance"));
  EXPECT_THAT(stand().known_fault.toStdString(), HasSubstr("of no other patch"));
  const MountedPatch& other = robot_->patches()[&mounted(origin) == &robot_->patches()[0] ? 1 : 0];
  inPanel<QSpinBox>("placeToCell")->setValue(static_cast<int>(other.cells.front().value()));
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeAddDistance"));
  EXPECT_THAT(stand().known_fault.toStdString(), HasSubstr("depends on the joints"));
  EXPECT_EQ(controller().undoStack()->count(), static_cast<int>(steps));
}

TEST_F(WindowPlaceTest, AFileThatIsDroppedIsTakenByTheStep) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  const auto drop = [this](const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &event);
    EXPECT_TRUE(event.isAccepted());
  };
  drop(pathTo("arm.csv"));
  EXPECT_THAT(stand().robot.text.toStdString(), HasSubstr("Choose the robot first"));
  drop(HEXODERM_DEMO_ROBOT);
  ASSERT_TRUE(waitForWork());
  EXPECT_TRUE(stand().has_robot);
  drop(pathTo("arm.csv"));
  ASSERT_TRUE(waitForWork());
  EXPECT_THAT(stand().joints.text.toStdString(), HasSubstr("8 of 8 poses"));
}

TEST_F(WindowPlaceTest, TheDemoBeginsAtTheStepWithItsRobot) {
  action("actionRobotDemo")->trigger();
  ASSERT_TRUE(waitUntil([this] { return controller().session() && controller().session()->robot(); }))
      << message().toStdString();
  ASSERT_TRUE(waitForWork());
  EXPECT_EQ(window_->findChild<StepPanel*>()->openIndex(), static_cast<int>(GuideStep::Place));
  EXPECT_TRUE(window_->robotView()->isVisible());
  EXPECT_EQ(stand().patches.size(), 2U);
  EXPECT_FALSE(stand().link.isEmpty()) << stand().link_says.text.toStdString();
  EXPECT_FALSE(controller().file().hasUnsavedChanges());
  keepPicture(window_->picture(), "place-demo-light");
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

TEST_F(WindowPlaceTest, ARobotWithoutItsMeshesIsOfUseForLinksAndSaysWhatIsMissing) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  ASSERT_NO_FATAL_FAILURE(chooseRobot(writeFile("bare.urdf", robotText().toUtf8())));
  EXPECT_TRUE(stand().has_robot);
  EXPECT_EQ(stand().robot.tone, Tone::Bad);
  EXPECT_THAT(stand().robot.text.toStdString(), AllOf(HasSubstr("forearm.obj"), HasSubstr("upper_arm.obj")));
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

  // Poses that the session does not have.
  ASSERT_NO_FATAL_FAILURE(
      chooseJoints(writeFile("others.csv", QByteArray::fromStdString(readFile(pathTo("arm.csv").toStdString()))
                                               .replace("\n1,", "\n101,")
                                               .replace("\n2,", "\n102,"))));
  EXPECT_EQ(controller().session()->poses().size(), 8U);
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

TEST_F(WindowPlaceTest, ACalibrationShowsItsPlacesButDecidesNothing) {
  ASSERT_NO_FATAL_FAILURE(openWithRobot());
  ASSERT_NO_FATAL_FAILURE(typePoints(CellId(stand().patch)));
  ASSERT_NO_FATAL_FAILURE(clickRowOf(inPanel<QListWidget>("placePlaceList"), 0));
  ASSERT_TRUE(waitForWork());
  controller().resultFiles().exportTo({std::nullopt, pathTo("arm.calibration.json"), {}});
  ASSERT_TRUE(waitForMessage("Exported to"));
  controller().undoStack()->setClean();
  window_->openFile(pathTo("arm.calibration.json"));
  ASSERT_TRUE(waitUntil([this] { return controller().session() == nullptr; }));
  ASSERT_NO_FATAL_FAILURE(openStep());
  ASSERT_TRUE(waitForWork());
  EXPECT_THAT(stand().why_not.toStdString(), HasSubstr("A calibration is open"));
  EXPECT_FALSE(inPanel<QPushButton>("placeChooseRobot")->isEnabled());
  EXPECT_TRUE(window_->robotView()->isVisible());
  EXPECT_EQ(window_->robotView()->picture().patches.size(), 1U);
}

}  // namespace
}  // namespace hexoderm
