#include "widgets/tables/cell_table.h"

#include "tests/support/hand_made_skins.h"
#include "tests/widgets/tables/table_texts.h"
#include "widgets/tables/table_cells.h"

#include <gmock/gmock.h>
#include <QAbstractItemModelTester>
#include <map>

namespace hexoderm {
namespace {

using testing::IsSupersetOf;
using testing::Pair;

/// What the row of a cell says, by its columns' heads.
std::map<std::string, std::string> textsOf(const CellTableModel& table, CellId cell) {
  const std::vector<std::string> heads = test::headers(table);
  const std::vector<std::string> said = test::rowTexts(table, table.rowOf(cell));
  std::map<std::string, std::string> texts;
  for (std::size_t k = 0; k < heads.size(); ++k) texts[heads[k]] = said[k];
  return texts;
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
  EXPECT_EQ(table.cellAt(table.rowOf(CellId(2))), CellId(2));
  EXPECT_EQ(textsOf(table, CellId(2)).at("± mm"), "3.92") << "1.96 times the worst axis' 2 mm";
  EXPECT_THAT(textsOf(table, CellId(2)),
              IsSupersetOf({Pair("Patch", "1"), Pair("X mm", "24.00"), Pair("Y mm", "−1.23"), Pair("Z mm", "0.00"),
                            Pair("Yaw °", "30.0"), Pair("± °", "1.12"), Pair("Worst residual °", "0.30"),
                            Pair("Offset mg", "50.0"), Pair("Scale %", "−3.00"), Pair("Placed by", "readings")}));
}

TEST(CellTableModel, SaysWhatIsNotKnownAndWhoIsPlacedByLinks) {
  CellTableModel table;
  table.setReconstruction(oneKnownCell());
  EXPECT_EQ(textsOf(table, CellId(1)).at("Placed by"), "origin");
  EXPECT_THAT(textsOf(table, CellId(22)),
              IsSupersetOf({Pair("Placed by", "links"), Pair("± mm", "–"), Pair("Offset mg", "–")}));
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
