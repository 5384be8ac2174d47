// The legend over the 3D view: its scale, pointed at by mouse and keys, and its range, fixed by a click or typed.
#include "widgets/patch/patch_legend_view.h"

#include "tests/widgets/patch/patch_view_fixture.h"

namespace hexoderm {
namespace {

class PatchLegendViewTest : public PatchViewFixture {
 protected:
  PatchLegendViewTest() : PatchViewFixture({720, 480}) { view.setScaleRanges(&ranges); }
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(PatchViewFixture::SetUp());
    ASSERT_NO_FATAL_FAILURE(activate());
    view.setReconstruction(skin());
    view.setColoring(Coloring::PositionUncertainty);
  }
  /// Cells known to 0.39 mm and less often more the further out, one to 11.8 mm; and one of which nothing is known.
  static std::shared_ptr<const Reconstruction> skin() {
    Reconstruction demo = demoReconstruction();
    for (CellPlacement& cell : demo.patches[0].cells) {
      const double sigma_m = 0.0002 * static_cast<double>(demo.patches[0].pathTo(cell.cell).size());
      cell.cov_t_r = Matrix6d::Identity() * sigma_m * sigma_m;
    }
    demo.patches[0].cells[7].cov_t_r = Matrix6d::Identity() * 36e-6;
    demo.patches[0].cells[12].cov_t_r = std::nullopt;
    return shared(demo);
  }

  PatchLegendView& legend() { return *view.findChild<PatchLegendView*>(); }
  QString said() { return legend().accessibleDescription(); }
  QToolButton* button() { return legend().findChild<QToolButton*>("scaleRange"); }
  template <class T>
  T* inPopup(const char* name) {
    return test::part<T>(legend(), QLatin1String(name));
  }
  void key(int key) { QTest::keyClick(&legend(), Qt::Key(key)); }
  /// In the middle of the bar.
  QPoint bar() { return {legend().width() / 2, legend().height() - 36}; }
};

TEST_F(PatchLegendViewTest, SaysRangeUnitGoalAndWhatLiesBeyond) {
  EXPECT_TRUE(legend().isVisible());
  EXPECT_TRUE(legend().accessibleName().contains("position uncertainty (95 %), mm"));
  EXPECT_THAT(said(), HasTexts({"range fitted to what is shown", "more than 2.00 mm: 1 cell", "not known: 1 cell"}));
  EXPECT_EQ(button()->text(), "fitted range ▾");
  EXPECT_TRUE(view.rect().contains(legend().geometry()));
  EXPECT_TRUE(legend().rect().contains(button()->geometry()));
  // In a narrow view the title has lines of its own.
  const int wide = legend().height();
  view.resize(400, 400);
  ASSERT_TRUE(test::waitUntil([&] { return legend().height() > wide; }));
  EXPECT_TRUE(view.rect().contains(legend().geometry()));
  EXPECT_TRUE(legend().rect().contains(button()->geometry()));
}

TEST_F(PatchLegendViewTest, WhereNothingIsKnownThereIsNoRange) {
  ASSERT_TRUE(button()->isVisible());
  Reconstruction unknown = *skin();
  for (CellPlacement& cell : unknown.patches[0].cells) cell.cov_t_r = std::nullopt;
  view.setReconstruction(shared(unknown));
  EXPECT_TRUE(legend().isVisible());
  EXPECT_FALSE(button()->isVisible());
  EXPECT_THAT(said(), testing::Not(HasText("from")));
}

TEST_F(PatchLegendViewTest, ArrowKeysWalkThroughTheScale) {
  legend().setFocus();
  key(Qt::Key_Home);
  EXPECT_TRUE(said().contains(QRegularExpression("^0.35 to 0.42 mm: 1 cell$"))) << qPrintable(said());
  key(Qt::Key_Left);
  EXPECT_TRUE(said().startsWith("0.35 to")) << "nothing lies below";
  key(Qt::Key_Right);
  EXPECT_THAT(said(), HasText("0 cells"));
  key(Qt::Key_End);
  EXPECT_EQ(said(), "more than 2.00 mm: 1 cell");
  key(Qt::Key_Right);
  EXPECT_EQ(said(), "more than 2.00 mm: 1 cell");
  button()->setFocus();
  EXPECT_TRUE(said().contains("coloured by")) << "left, it says what it is again";
}

TEST_F(PatchLegendViewTest, TheMouseReadsTheScale) {
  const QImage before = legend().grab().toImage();
  test::moveMouse(&legend(), bar());
  EXPECT_THAT(said(), HasText(" mm: "));
  EXPECT_NE(legend().grab().toImage(), before);
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&legend(), &leave);
  EXPECT_EQ(legend().grab().toImage(), before);
}

TEST_F(PatchLegendViewTest, AClickOrEnterFixesTheRangeAndTheNextReleasesIt) {
  const QImage fitted = view.screenshot();
  QTest::mouseClick(&legend(), Qt::LeftButton, {}, bar());
  ASSERT_TRUE(ranges.fixed(Coloring::PositionUncertainty).has_value());
  EXPECT_NEAR(ranges.fixed(Coloring::PositionUncertainty)->high, 1.96, 0.05);
  EXPECT_EQ(button()->text(), "fixed range ▾");
  EXPECT_NE(view.screenshot(), fitted) << "the picture says so, too";
  legend().setFocus();
  key(Qt::Key_Return);
  EXPECT_EQ(ranges.fixed(Coloring::PositionUncertainty), std::nullopt);
  EXPECT_EQ(view.screenshot(), fitted);
}

TEST_F(PatchLegendViewTest, ARangeIsChosenOrTypedInThePopup) {
  QTest::mouseClick(button(), Qt::LeftButton);
  auto* popup = inPopup<QFrame>("rangePopup");
  ASSERT_TRUE(popup->isVisible());
  EXPECT_TRUE(inPopup<QRadioButton>("rangeFitted")->isChecked());
  QTest::mouseClick(inPopup<QRadioButton>("rangeUsual"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_EQ(ranges.fixed(Coloring::PositionUncertainty), (ColorRange{0, 6}));
  auto* high = inPopup<QDoubleSpinBox>("rangeHigh");
  high->setValue(2.5);
  EXPECT_EQ(ranges.fixed(Coloring::PositionUncertainty), (ColorRange{0, 2.5}));
  EXPECT_TRUE(inPopup<QRadioButton>("rangeTyped")->isChecked());
  inPopup<QDoubleSpinBox>("rangeLow")->setValue(3);
  EXPECT_EQ(ranges.fixed(Coloring::PositionUncertainty), (ColorRange{0, 2.5})) << "that is no range";
  inPopup<QDoubleSpinBox>("rangeLow")->setValue(1);
  EXPECT_EQ(ranges.fixed(Coloring::PositionUncertainty), (ColorRange{1, 2.5}));
  QTest::mouseClick(inPopup<QRadioButton>("rangeFitted"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_EQ(ranges.fixed(Coloring::PositionUncertainty), std::nullopt);
  QTest::keyClick(popup, Qt::Key_Escape);
  EXPECT_FALSE(popup->isVisible());
  EXPECT_TRUE(view.isVisible()) << "Esc closes the popup alone";
}

TEST_F(PatchLegendViewTest, PointsAtThePickedCellsValueOrAtTheOneThatIsGiven) {
  EXPECT_EQ(legend().markedValue(), std::nullopt);
  selection.selectCell(CellId(1));
  EXPECT_NEAR(legend().markedValue().value_or(0), 0.392, 1e-3);
  view.setMarkedValue(1.2, "cell 9: 1.20 mm");
  EXPECT_EQ(legend().markedValue(), 1.2);
  selection.selectCell(CellId(2));
  EXPECT_EQ(legend().markedValue(), 1.2) << "what is pointed at comes first";
  view.setMarkedValue(std::nullopt);
  EXPECT_NEAR(legend().markedValue().value_or(0), 0.784, 1e-3);
  view.setColoring(Coloring::Patch);
  EXPECT_EQ(legend().markedValue(), std::nullopt);
  view.setColoring(Coloring::PositionUncertainty);
  selection.selectCell(CellId(13));
  EXPECT_EQ(legend().markedValue(), std::nullopt) << "nothing is known of it";
  selection.clear();
  EXPECT_EQ(legend().markedValue(), std::nullopt);
}

TEST_F(PatchLegendViewTest, ALegendOfClassesIsNoObstacleAndHasNoRange) {
  view.setColoring(Coloring::LinkQuality);
  EXPECT_TRUE(legend().testAttribute(Qt::WA_TransparentForMouseEvents));
  EXPECT_EQ(legend().focusPolicy(), Qt::NoFocus);
  EXPECT_FALSE(button()->isVisible());
  EXPECT_TRUE(legend().isVisible());
  view.setReconstruction(nullptr);
  EXPECT_FALSE(legend().isVisible());
}

TEST_F(PatchLegendViewTest, SignsOnCellsAreExplainedWhereThereAreAny) {
  EXPECT_FALSE(said().contains("crossed"));
  Reconstruction faulty = *skin();
  faulty.patches[0].cells[4].placed_by = PlacedBy::Links;
  faulty.findings = {makeFinding(FindingCode::TurnedSensor, Message::verbatim("turned"), {CellId(5)})};
  const int height = legend().height();
  view.setReconstruction(shared(faulty));
  EXPECT_TRUE(said().contains("crossed cells: an error was found in their readings"));
  EXPECT_TRUE(said().contains("hatched cells: placed through their links alone"));
  EXPECT_FALSE(said().contains("triangle"));
  EXPECT_GT(legend().height(), height);
}

}  // namespace
}  // namespace hexoderm
