#include "widgets/tables/cell_table.h"

#include "tests/support/hand_made_skins.h"
#include "widgets/tables/table_roles.h"

#include <gmock/gmock.h>
#include <QAbstractItemModelTester>

namespace hexoderm {
namespace {

std::string text(const CellTableModel& table, int row, const char* header) {
  for (int column = 0; column < table.columnCount(); ++column) {
    if (table.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString() == header) {
      return table.index(row, column).data().toString().toStdString();
    }
  }
  return "no such column";
}

std::shared_ptr<Reconstruction> oneKnownCell() {
  auto reconstruction = sampleTwoPatches();
  CellPlacement& cell = reconstruction->patches[0].cells[1];
  cell.T_o_u = {expSO3({0, 0, 30 * kDegree}), {0.024, -0.001234, 0}};
  cell.cov_t_r = Matrix6d::Zero();
  cell.cov_t_r->diagonal() << 1e-6, 4e-6, 1e-6, 1e-4, 1e-4, 1e-4;
  cell.accel_offset_g = Eigen::Vector3d(0.03, 0, -0.04);
  cell.accel_scale = Eigen::Vector3d(1.01, 0.97, 1);
  return reconstruction;
}

TEST(CellTableModel, KeepsTheContractOfItemModelsAndIsEmptyWithoutAReconstruction) {
  CellTableModel table;
  const QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::Fatal);
  EXPECT_EQ(table.rowCount(), 0);
  table.setReconstruction(oneKnownCell());
  EXPECT_EQ(table.rowCount(), 7);
  table.setReconstruction(nullptr);
  EXPECT_EQ(table.rowCount(), 0);
}

TEST(CellTableModel, ShowsWhereACellIsAndHowWellThatIsKnown) {
  CellTableModel table;
  table.setReconstruction(oneKnownCell());
  const int row = table.rowOf(CellId(2));
  EXPECT_EQ(table.cellAt(row), CellId(2));
  EXPECT_EQ(text(table, row, "Patch"), "1");
  EXPECT_EQ(text(table, row, "X mm"), "24.00");
  EXPECT_EQ(text(table, row, "Y mm"), "−1.23");
  EXPECT_EQ(text(table, row, "Z mm"), "0.00");
  EXPECT_EQ(text(table, row, "Yaw °"), "30.0");
  EXPECT_EQ(text(table, row, "± mm"), "3.92") << "1.96 times the worst axis' 2 mm";
  EXPECT_EQ(text(table, row, "± °"), "1.12");
  EXPECT_EQ(text(table, row, "Worst residual °"), "0.30");
  EXPECT_EQ(text(table, row, "Offset mg"), "50.0");
  EXPECT_EQ(text(table, row, "Scale %"), "−3.00");
  EXPECT_EQ(text(table, row, "Placed by"), "readings");
}

TEST(CellTableModel, SaysWhatIsNotKnownAndWhoIsPlacedByLinks) {
  CellTableModel table;
  table.setReconstruction(oneKnownCell());
  EXPECT_EQ(text(table, table.rowOf(CellId(1)), "Placed by"), "origin");
  EXPECT_EQ(text(table, table.rowOf(CellId(22)), "Placed by"), "links");
  EXPECT_EQ(text(table, table.rowOf(CellId(22)), "± mm"), "–");
  EXPECT_EQ(text(table, table.rowOf(CellId(22)), "Offset mg"), "–");
  EXPECT_EQ(table.rowOf(CellId(99)), -1);
}

TEST(CellTableModel, EveryColumnExplainsItselfAndHasAUnitForFiles) {
  CellTableModel table;
  ASSERT_GT(table.columnCount(), 0);
  for (int column = 0; column < table.columnCount(); ++column) {
    EXPECT_FALSE(table.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty()) << column;
    EXPECT_TRUE(table.headerData(column, Qt::Horizontal, kUnitRole).isValid()) << column;
  }
}

}  // namespace
}  // namespace hexoderm
