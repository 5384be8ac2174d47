#include "widgets/tables/reconstruction_table.h"

#include "tests/support/hand_made_skins.h"
#include "tests/widgets/tables/table_texts.h"
#include "widgets/tables/finding_table.h"
#include "widgets/tables/link_table.h"
#include "widgets/tables/pose_table.h"

#include <gmock/gmock.h>
#include <QAbstractItemModelTester>
#include <QSignalSpy>

namespace hexoderm {
namespace {

class ReconstructionTableTest : public testing::Test {
 protected:
  ReconstructionTableTest() { QApplication::setPalette(qtPalette(Theme::Light)); }
};

TEST_F(ReconstructionTableTest, AreEmptyWithoutAReconstructionAndKeepTheContractOfItemModels) {
  PoseTable poses;
  LinkTable links;
  FindingTable findings;
  for (ReconstructionTable* table :
       {static_cast<ReconstructionTable*>(&poses), static_cast<ReconstructionTable*>(&links),
        static_cast<ReconstructionTable*>(&findings)}) {
    const QAbstractItemModelTester tester(table, QAbstractItemModelTester::FailureReportingMode::Fatal);
    EXPECT_EQ(table->rowCount(), 0);
    QSignalSpy reset(table, &QAbstractItemModel::modelReset);
    table->setReconstruction(sampleTwoPatches());
    EXPECT_EQ(reset.count(), 1);
    table->setReconstruction(nullptr);
    EXPECT_EQ(table->rowCount(), 0);
  }
}

}  // namespace
}  // namespace hexoderm
