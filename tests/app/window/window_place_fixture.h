#pragma once

#include "hexoderm/base/file.h"
#include "hexoderm/base/units.h"
#include "hexoderm/io/session_joint_angles.h"
#include "hexoderm/robots/joint_angles_csv.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/sim/simulated_robot.h"
#include "hexoderm/solve/result/patch_placements.h"
#include "tests/app/window/keyboard.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/robot_view.h"

#include <array>
#include <cstddef>

namespace hexoderm {

/// The step "Place on the robot" in the window, with a session of the demo's robot, without its joint angles, and a
/// table of these.
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

  PlacePanel& panel() { return *window_->findChild<PlacePanel*>(); }
  RobotView* robotView() { return window_->findChild<RobotView*>(); }
  const PlaceStand& stand() { return panel().stand(); }
  bool waitForWork() {
    static constexpr std::array kWorks = {PlaceWork::Robot, PlaceWork::Joints, PlaceWork::Links, PlaceWork::Places};
    return waitUntilIdle() && waitUntil([this] {
             window_->showChanges();
             return std::ranges::none_of(kWorks, [this](PlaceWork work) { return panel().isRunning(work); });
           });
  }
  void openPlace() {
    openStep(GuideStep::Place);
    ASSERT_TRUE(waitUntil([this] { return panel().isVisible(); }));
  }
  void openSession() {
    ASSERT_NO_FATAL_FAILURE(openFile(pathTo("arm.session.json")));
    openPlace();
  }
  /// Scrolls to it first, as a person does.
  template <class T>
  void pressInPanel(const char* name) {
    auto* widget = find<T>(name);
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
  void chooseFile(const char* button, const char* dialog, const QString& path) {
    ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>(button));
    ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog(dialog, path));
    ASSERT_TRUE(waitUntilGone(dialog));
    ASSERT_NO_FATAL_FAILURE(activateWindow());
    ASSERT_TRUE(waitForWork());
  }
  void chooseRobot(const QString& path) { chooseFile("placeChooseRobot", "robotDialog", path); }
  void chooseJoints(const QString& path) { chooseFile("placeChooseJoints", "jointsDialog", path); }
  void openWithRobot() {
    ASSERT_NO_FATAL_FAILURE(openSession());
    ASSERT_NO_FATAL_FAILURE(chooseRobot(HEXODERM_DEMO_ROBOT));
    ASSERT_TRUE(stand().has_robot) << stand().robot.text.toStdString();
    ASSERT_NO_FATAL_FAILURE(chooseJoints(pathTo("arm.csv")));
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
      find<QSpinBox>("placePointCell")->setValue(static_cast<int>(cell.value()));
      find<QDoubleSpinBox>("placePointX")->setValue(x_mm.x());
      find<QDoubleSpinBox>("placePointY")->setValue(x_mm.y());
      find<QDoubleSpinBox>("placePointZ")->setValue(x_mm.z());
      ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placeAddPoint"));
      ASSERT_TRUE(waitForWork());
    }
  }
  /// With the robot, its angles and the points of one patch: takes the first place that is offered for it.
  void openPlaced() {
    ASSERT_NO_FATAL_FAILURE(openWithRobot());
    ASSERT_NO_FATAL_FAILURE(typePoints(CellId(stand().patch)));
    ASSERT_NO_FATAL_FAILURE(clickRowOf(find<QListWidget>("placePlaceList"), 0));
    ASSERT_TRUE(waitForWork());
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

}  // namespace hexoderm
