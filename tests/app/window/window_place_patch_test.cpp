// The step "Place on the robot": what the operator says of one patch, by its link, by points and distances, and by
// hand.

#include "tests/app/window/window_place_fixture.h"

namespace hexoderm {
namespace {

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
  RobotView* view = window_->robotView();
  ASSERT_TRUE(view->canDraw()) << "no OpenGL";
  // The upper arm is a box with rounded edges, along which its patch can slide.
  for (const PlaceStand::Choice& choice : std::vector(stand().patches)) {
    if (mounted(CellId(choice.id)).link != "upper_arm") continue;
    ASSERT_NO_FATAL_FAILURE(choosePatch(choice.id));
  }
  const CellId origin(stand().patch);
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
  ASSERT_TRUE(window_->robotView()->canDraw()) << "no OpenGL";
  ASSERT_NO_FATAL_FAILURE(pressInPanel<QPushButton>("placePick"));
  const RobotPicture& picture = window_->robotView()->picture();
  ASSERT_TRUE(picture.link);
  emit window_->robotView()->pointPicked(*picture.link, Eigen::Vector3d(0.01, -0.02, 0.03));
  EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("placePointX")->value(), 10);
  EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("placePointY")->value(), -20);
  EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("placePointZ")->value(), 30);
  EXPECT_FALSE(find<QPushButton>("placePick")->isChecked());
  EXPECT_TRUE(stand().known.points.empty()) << "nothing is decided by the picking";
  const std::size_t other = *picture.link == 0 ? 1 : 0;
  emit window_->robotView()->pointPicked(other, Eigen::Vector3d::Zero());
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
