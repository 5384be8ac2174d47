// The checks of the skin's shape: whether loops close, and by surfaces and distances that are known.

#include "tests/widgets/verify/verify_panel_fixture.h"

namespace hexoderm::verify_panel_test {
namespace {

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
  radius->setFocus();
  radius->selectAll();
  QTest::keyClicks(radius, "50.1");
  QTest::keyClick(radius, Qt::Key_Return);
  kind->setCurrentText("Plane");
  kind->setCurrentText("Most probable");
  int dropped = 0;
  QObject::connect(panel_, &VerifyPanel::surfaceDropped, [&] { ++dropped; });
  kind->setCurrentText("None");
  EXPECT_EQ(dropped, 1);
  ASSERT_EQ(asked.size(), 4U);
  EXPECT_EQ(asked[0].first, SurfaceKind::Cylinder);
  EXPECT_FALSE(asked[0].second.has_value());
  EXPECT_NEAR(asked[1].second.value_or(0), 0.0501, 1e-12);
  EXPECT_EQ(asked[2].first, SurfaceKind::Plane);
  EXPECT_FALSE(asked[2].second.has_value()) << "a plane has no radius";
  EXPECT_FALSE(asked[3].first.has_value());
}

TEST_F(VerifyPanelTest, AFieldThatSaysNotKnownTakesTheNumberThatIsTypedIntoIt) {
  panel_->setReconstruction(skin());
  std::optional<double> asked;
  QObject::connect(panel_, &VerifyPanel::surfaceRequested, [&](const auto& /*kind*/, auto radius) { asked = radius; });
  find<QComboBox>("surfaceKind")->setCurrentText("Cylinder");
  auto* radius = find<QDoubleSpinBox>("surfaceRadius");
  auto* line = radius->findChild<QLineEdit*>();
  // As a click into the text leaves it: nothing is picked.
  QTest::mouseClick(line, Qt::LeftButton, Qt::NoModifier, QPoint(8, line->height() / 2));
  line->deselect();
  ASSERT_EQ(line->text(), "not known");
  QTest::keyClicks(radius, "50.1");
  QTest::keyClick(radius, Qt::Key_Return);
  EXPECT_NEAR(radius->value(), 50.1, 1e-9);
  EXPECT_NEAR(asked.value_or(0), 0.0501, 1e-12);
  radius->selectAll();
  QTest::keyClicks(radius, "0");
  QTest::keyClick(radius, Qt::Key_Return);
  EXPECT_FALSE(asked.has_value());
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

}  // namespace
}  // namespace hexoderm::verify_panel_test
