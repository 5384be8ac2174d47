#include "widgets/plot/plot_view.h"

#include "tests/support/app_theme.h"
#include "tests/support/kept_picture.h"
#include "tests/support/qt_wait.h"
#include "tests/widgets/plot/growing_sheet.h"

#include <gmock/gmock.h>
#include <qwt_plot.h>

namespace hexoderm {
namespace {

class PlotViewTest : public testing::Test {
 protected:
  PlotViewTest() : view_(&selection_) {
    view_.resize(520, 360);
    view_.setChoice({PlotSubject::Cells, std::nullopt, Coloring::PositionUncertainty, false});
    view_.setReconstruction(growingSheet());
    view_.show();
    EXPECT_TRUE(test::waitUntilExposed(view_));
    canvas_ = view_.plot()->canvas();
  }
  QImage keep(const QString& name) { return keepPicture(view_.grab().toImage(), name); }
  /// A rectangle about these points of the plot.
  void dragAbout(std::size_t first, std::size_t last, Qt::KeyboardModifiers keys = {}) {
    const QPoint a = view_.positionOf(first);
    const QPoint b = view_.positionOf(last);
    test::dragMouse(canvas_, QPoint(std::min(a.x(), b.x()) - 6, std::max(a.y(), b.y()) + 6),
                    QPoint(std::max(a.x(), b.x()) + 6, std::min(a.y(), b.y()) - 6), keys);
  }
  QString summary() { return view_.findChild<QLabel*>("plotSummary")->text(); }
  QComboBox* box(const char* name) { return view_.findChild<QComboBox*>(QLatin1String(name)); }
  static std::vector<CellId> cells(std::initializer_list<std::uint32_t> ids) {
    std::vector<CellId> result;
    for (const std::uint32_t id : ids) result.emplace_back(id);
    return result;
  }

  test::AppTheme theme_;
  Selection selection_;
  PlotView view_;
  QWidget* canvas_ = nullptr;
};

TEST_F(PlotViewTest, ShowsAPointForEachCellWithinTheScales) {
  ASSERT_EQ(view_.data().points.size(), 12U);
  for (std::size_t k = 0; k < 12; ++k) EXPECT_TRUE(canvas_->rect().contains(view_.positionOf(k))) << k;
  EXPECT_LT(view_.positionOf(0).x(), view_.positionOf(11).x());
  EXPECT_GT(view_.positionOf(0).y(), view_.positionOf(11).y()) << "larger values are higher";
  EXPECT_TRUE(summary().startsWith("12 cells"));
  EXPECT_TRUE(box("plotUp")->currentText().endsWith(", mm"));
  keep("plot-light");
}

TEST_F(PlotViewTest, AClickPicksTheCellAndOneBesideAllClears) {
  QTest::mouseClick(canvas_, Qt::LeftButton, {}, view_.positionOf(6));
  EXPECT_EQ(selection_.cell(), CellId(7));
  const QImage picked = keep("plot-picked");
  QTest::mouseClick(canvas_, Qt::LeftButton, {}, view_.positionOf(0) - QPoint(0, 60));
  EXPECT_EQ(selection_.cell(), std::nullopt);
  EXPECT_NE(view_.grab().toImage(), picked);
}

TEST_F(PlotViewTest, WhatIsPickedElsewhereIsMarked) {
  const QImage before = view_.grab().toImage();
  selection_.selectCell(CellId(5));
  EXPECT_NE(view_.grab().toImage(), before);
  EXPECT_TRUE(canvas_->accessibleDescription().startsWith("Cell 5"));
  selection_.selectCell(CellId(99));
  EXPECT_EQ(view_.grab().toImage(), before) << "a cell that is not plotted";
}

TEST_F(PlotViewTest, ARectangleBrushesTheCellsInItAndShiftAdds) {
  dragAbout(2, 4);
  EXPECT_EQ(selection_.brushed(), cells({3, 4, 5}));
  EXPECT_EQ(selection_.cell(), std::nullopt);
  EXPECT_TRUE(summary().contains("3 marked"));
  keep("plot-brushed");
  dragAbout(8, 9, Qt::ShiftModifier);
  EXPECT_EQ(selection_.brushed(), cells({3, 4, 5, 9, 10}));
  dragAbout(0, 0);
  EXPECT_EQ(selection_.brushed(), cells({1}));
}

TEST_F(PlotViewTest, KeysGoFromPointToPointAndShiftBrushesOnTheWay) {
  view_.activateWindow();
  ASSERT_TRUE(test::waitUntilActive(view_));
  canvas_->setFocus();
  QTest::keyClick(canvas_, Qt::Key_Home);
  EXPECT_EQ(selection_.cell(), CellId(1));
  QTest::keyClick(canvas_, Qt::Key_Right);
  QTest::keyClick(canvas_, Qt::Key_Right);
  EXPECT_EQ(selection_.cell(), CellId(3));
  EXPECT_TRUE(selection_.brushed().empty());
  QTest::keyClick(canvas_, Qt::Key_Right, Qt::ShiftModifier);
  QTest::keyClick(canvas_, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_EQ(selection_.cell(), CellId(5));
  EXPECT_EQ(selection_.brushed(), cells({3, 4, 5}));
  QTest::keyClick(canvas_, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(selection_.brushed(), cells({3, 4}));
  QTest::keyClick(canvas_, Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(selection_.brushed().size(), 12U);
  QTest::keyClick(canvas_, Qt::Key_Escape);
  EXPECT_TRUE(selection_.brushed().empty());
  EXPECT_EQ(selection_.cell(), CellId(4)) << "Esc takes the marks first";
  QTest::keyClick(canvas_, Qt::Key_Escape);
  EXPECT_EQ(selection_.cell(), std::nullopt);
}

TEST_F(PlotViewTest, AHistogramIsBrushedBarByBar) {
  view_.setChoice({PlotSubject::Cells, Coloring::PositionUncertainty, std::nullopt, true});
  view_.activateWindow();
  ASSERT_TRUE(test::waitUntilActive(view_));
  canvas_->setFocus();
  const std::vector<ValueBin> bins = view_.data().bins;
  ASSERT_GE(bins.size(), 3U);
  QTest::keyClick(canvas_, Qt::Key_Home);
  EXPECT_EQ(selection_.brushed().size(), bins[0].count);
  QTest::keyClick(canvas_, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_EQ(selection_.brushed().size(), bins[0].count + bins[1].count);
  keep("plot-histogram");
  test::dragMouse(canvas_, QPoint(1, 10), QPoint(canvas_->width() - 2, 30));
  EXPECT_EQ(selection_.brushed().size(), 12U);
  const auto middle =
      static_cast<int>(view_.plot()->transform(QwtPlot::xBottom, 0.5 * (bins.back().lower + bins.back().upper)));
  QTest::mouseClick(canvas_, Qt::LeftButton, {}, QPoint(middle, canvas_->height() / 2));
  EXPECT_EQ(selection_.brushed().size(), bins.back().count);
}

TEST_F(PlotViewTest, LinksArePickedAsLinksAndBrushBothTheirCells) {
  box("plotSubject")->setCurrentIndex(1);
  EXPECT_EQ(view_.choice().subject, PlotSubject::Links);
  ASSERT_FALSE(view_.data().points.empty());
  canvas_->setFocus();
  QTest::keyClick(canvas_, Qt::Key_Home);
  ASSERT_TRUE(selection_.link().has_value());
  const auto picked = std::ranges::find(view_.data().points, selection_.link(), &PlotPoint::link);
  ASSERT_NE(picked, view_.data().points.end());
  EXPECT_EQ(picked->x, view_.data().bounds(false).low) << "the first along the plot";
  QTest::keyClick(canvas_, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_GE(selection_.brushed().size(), 3U);
}

TEST_F(PlotViewTest, TheBoxesChooseTheAxes) {
  QComboBox* up = box("plotUp");
  EXPECT_EQ(up->currentText(), "position uncertainty (95 %), mm");
  up->setCurrentIndex(0);
  EXPECT_TRUE(view_.choice().is_histogram);
  EXPECT_FALSE(view_.data().bins.empty());
  box("plotAcross")->setCurrentIndex(box("plotAcross")->findText("orientation uncertainty (95 %), °"));
  EXPECT_EQ(view_.choice().x, PlotFigure(Coloring::OrientationUncertainty));
  EXPECT_TRUE(view_.choice().is_histogram);
}

TEST_F(PlotViewTest, AFigureThatNoCellHasSaysWhy) {
  const QComboBox* across = box("plotAcross");
  const int row = across->findText("temperature, °C");
  ASSERT_GE(row, 0);
  EXPECT_FALSE(qobject_cast<QStandardItemModel*>(across->model())->item(row)->isEnabled());
  EXPECT_FALSE(across->itemData(row, Qt::ToolTipRole).toString().isEmpty());
  auto readings = std::make_shared<CellReadings>();
  readings->temperature_c[CellId(3)] = 30;
  view_.setReadings(readings);
  EXPECT_TRUE(test::waitUntil([&] {
    return qobject_cast<QStandardItemModel*>(across->model())->item(across->findText("temperature, °C"))->isEnabled();
  }));
}

TEST_F(PlotViewTest, WhatIsHiddenIsGatheredWhenItIsShown) {
  view_.hide();
  view_.setReconstruction(growingSheet(2, 2));
  EXPECT_EQ(view_.data().points.size(), 12U);
  view_.show();
  EXPECT_EQ(view_.data().points.size(), 4U);
  view_.setReconstruction(nullptr);
  EXPECT_TRUE(view_.data().points.empty());
  keep("plot-empty");
}

TEST_F(PlotViewTest, ThousandsOfPointsAreDrawnAndThemesDiffer) {
  view_.setReconstruction(growingSheet(50, 60));
  std::vector<CellId> some;
  for (std::uint32_t k = 1000; k < 1400; ++k) some.emplace_back(k);
  selection_.brush(some);
  const QImage light = keep("plot-many-light");
  theme_.set(Theme::Dark);
  const QImage dark = keep("plot-many-dark");
  EXPECT_LT(qGray(dark.pixel(dark.width() - 40, 60)), qGray(light.pixel(light.width() - 40, 60)));
}

}  // namespace
}  // namespace hexoderm
