#include "widgets/verify/residual_view.h"

#include "tests/support/app_theme.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/kept_picture.h"
#include "tests/support/qt_wait.h"
#include "widgets/controls/selection.h"
#include "widgets/style/color_maps.h"
#include "widgets/tables/sorted_table.h"
#include "widgets/tables/table_cells.h"
#include "widgets/tables/table_csv.h"
#include "widgets/verify/residual_plots.h"

#include <gmock/gmock.h>
#include <qwt_plot.h>

namespace hexoderm {
namespace {

class ResidualViewTest : public testing::Test {
 protected:
  ResidualViewTest() : view_(&selection_) {
    view_.resize(700, 220);
    view_.show();
    EXPECT_TRUE(test::waitUntilExposed(view_));
  }
  QImage keep(const QString& name) { return keepPicture(view_.grab().toImage(), name); }

  test::AppTheme theme_;
  Selection selection_;
  ResidualView view_;
};

TEST_F(ResidualViewTest, TheMatrixHasARowALinkAndAColumnAPose) {
  ResidualTable table;
  const QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::Fatal);
  table.setReconstruction(sheetWithPoses(3, 3, 4));
  EXPECT_EQ(table.rowCount(), 12);
  EXPECT_EQ(table.columnCount(), 5);
  EXPECT_EQ(table.headerData(0, Qt::Horizontal, Qt::DisplayRole).toString(), "All");
  EXPECT_EQ(table.headerData(2, Qt::Horizontal, Qt::DisplayRole).toString(), "Pose 2");
  EXPECT_EQ(table.headerData(0, Qt::Vertical, Qt::DisplayRole).toString(), "1:1 – 2:4");
  EXPECT_EQ(table.index(0, 3).data().toString(), "–") << "pose 3 is disabled";
  EXPECT_FALSE(table.index(0, 3).data(kRawRole).isValid());
  EXPECT_NEAR(table.index(0, 1).data(kRawRole).toDouble(), toDegrees(*table.linkAt(0).pose_residual_rad[0]), 1e-12);
  EXPECT_TRUE(table.index(0, 1).data(Qt::AccessibleTextRole).toString().contains("pose 1"));
  const QByteArray csv = tableAsCsv(table);
  EXPECT_TRUE(csv.startsWith("Link,All (deg),Pose 1 (deg),")) << csv.left(60).toStdString();
  EXPECT_TRUE(csv.contains("\r\n1:1 – 2:4,"));
}

TEST_F(ResidualViewTest, ALinkPickedElsewhereIsPickedHereAndDroppedAgain) {
  view_.setReconstruction(sheetWithPoses(3, 3, 4));
  selection_.selectLink({CellId(5), PortNumber(4)}, {CellId(4), PortNumber(1)});
  EXPECT_EQ(view_.matrix()->model()->headerData(view_.matrix()->currentIndex().row(), Qt::Vertical).toString(),
            "4:1 – 5:4");
  selection_.selectCell(CellId(1));
  EXPECT_FALSE(view_.matrix()->selectionModel()->hasSelection());
}

TEST_F(ResidualViewTest, AHeaderBringsTheWorstToTheTop) {
  view_.setReconstruction(sheetWithPoses(3, 3, 4));
  const QAbstractItemModel& model = *view_.matrix()->model();
  const auto valueAt = [&](int row) { return model.index(row, 0).data(kRawRole).toDouble(); };
  QHeaderView* header = view_.matrix()->horizontalHeader();
  const QPoint all(header->sectionViewportPosition(0) + 10, header->height() / 2);
  QTest::mouseClick(header->viewport(), Qt::LeftButton, Qt::NoModifier, all);
  if (header->sortIndicatorOrder() == Qt::AscendingOrder) {
    QTest::mouseClick(header->viewport(), Qt::LeftButton, Qt::NoModifier, all);
  }
  ASSERT_GT(model.rowCount(), 1);
  for (int row = 1; row < model.rowCount(); ++row) EXPECT_GE(valueAt(row - 1), valueAt(row));
}

TEST_F(ResidualViewTest, AClickInThePlotOfTheLinksPicksTheLink) {
  const auto reconstruction = sheetWithPoses(3, 3, 4);
  view_.setReconstruction(reconstruction);
  QTest::mouseClick(view_.findChild<QToolButton*>("residualPlotsButton"), Qt::LeftButton);
  auto* plots = view_.findChild<ResidualPlots*>();
  ASSERT_TRUE(plots->isVisible());
  QCoreApplication::processEvents();
  QTest::mouseClick(plots->linkPlot()->canvas(), Qt::LeftButton, Qt::NoModifier, plots->positionOfRank(0));
  const auto& links = reconstruction->patches[0].links;
  const auto worst = std::ranges::max_element(links, {}, &LinkEstimate::residual_rad);
  EXPECT_EQ(selection_.link(), Selection::Link(worst->source, worst->target));
}

TEST_F(ResidualViewTest, ColoursCanBeReadAndAreTheSameForEverySkin) {
  EXPECT_EQ(residualColor(0), viridis(0));
  EXPECT_EQ(residualColor(2), viridis(1));
  EXPECT_EQ(residualColor(30), viridis(1));
}

TEST_F(ResidualViewTest, MatrixAndPlotsAreDifferentPicturesInEachTheme) {
  view_.setReconstruction(sheetWithPoses(8, 8, 9));
  selection_.selectLink({CellId(2), PortNumber(1)}, {CellId(3), PortNumber(4)});
  std::vector<QImage> pictures;
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    theme_.set(theme);
    const QString name = theme == Theme::Light ? "light" : "dark";
    view_.showMatrix();
    QCoreApplication::processEvents();
    pictures.push_back(keep("residual-matrix-" + name));
    view_.showPlots();
    QCoreApplication::processEvents();
    pictures.push_back(keep("residual-plots-" + name));
  }
  for (std::size_t a = 0; a < pictures.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) EXPECT_NE(pictures[a], pictures[b]) << a << " and " << b;
  }
}

}  // namespace
}  // namespace hexoderm
