// The tables of poses, links and findings.

#include "widgets/tables/reconstruction_table.h"

#include "tests/support/hand_made_skins.h"
#include "tests/widgets/tables/table_texts.h"
#include "widgets/tables/finding_table.h"
#include "widgets/tables/link_table.h"
#include "widgets/tables/pose_table.h"

#include <gmock/gmock.h>
#include <QtTest>
#include <QtWidgets>

namespace hexoderm {
namespace {

using test::headers;
using test::isGrey;
using test::rowTexts;
using test::text;
using testing::ElementsAre;
using testing::HasSubstr;

class ReconstructionTableTest : public testing::Test {
 protected:
  ReconstructionTableTest() { QApplication::setPalette(qtPalette(Theme::Light)); }

  PoseTable poses_;
  LinkTable links_;
  FindingTable findings_;
};

TEST_F(ReconstructionTableTest, AreEmptyWithoutAReconstructionAndKeepTheContractOfItemModels) {
  for (ReconstructionTable* table : std::initializer_list<ReconstructionTable*>{&poses_, &links_, &findings_}) {
    const QAbstractItemModelTester tester(table, QAbstractItemModelTester::FailureReportingMode::Fatal);
    EXPECT_EQ(table->rowCount(), 0);
    QSignalSpy reset(table, &QAbstractItemModel::modelReset);
    table->setReconstruction(sampleTwoPatches());
    EXPECT_EQ(reset.count(), 1);
    table->setReconstruction(nullptr);
    EXPECT_EQ(table->rowCount(), 0);
  }
}

TEST_F(ReconstructionTableTest, PosesShowWhatWasMeasuredAndADashWhereNothingIsKnown) {
  poses_.setReconstruction(sampleX17());
  ASSERT_EQ(poses_.rowCount(), 4);
  EXPECT_THAT(headers(poses_), ElementsAre("Pose", "Label", "Cells", "Noise mg", "New by", "Residual"));
  EXPECT_THAT(rowTexts(poses_, 0), ElementsAre("1", "standing", "17/17", "1.4", "–", "0.4°"));
  EXPECT_THAT(rowTexts(poses_, 1), ElementsAre("2", "on its side", "17/17", "2.2", "86°", "0.5°"));
  EXPECT_THAT(rowTexts(poses_, 3), ElementsAre("4", "–", "17/17", "–", "64°", "0.4°"));
}

TEST_F(ReconstructionTableTest, DisabledPosesAreGreyAndSaySo) {
  poses_.setReconstruction(sampleX17());
  EXPECT_FALSE(isGrey(poses_, 0));
  EXPECT_TRUE(isGrey(poses_, 2));
  EXPECT_EQ(text(poses_, 0, 0, Qt::AccessibleTextRole), "Pose 1, used");
  EXPECT_EQ(text(poses_, 2, 0, Qt::AccessibleTextRole), "Pose 3, disabled");
  EXPECT_THAT(text(poses_, 2, 0, Qt::ToolTipRole), HasSubstr("disabled"));
  const auto mark = [&](int row) {
    return poses_.index(row, 0).data(Qt::DecorationRole).value<QIcon>().pixmap(16, 16).toImage();
  };
  EXPECT_EQ(mark(0), mark(1));
  EXPECT_NE(mark(0), mark(2));
  EXPECT_TRUE(poses_.index(0, 1).data(Qt::DecorationRole).isNull());
}

TEST_F(ReconstructionTableTest, ToolTipsOfPosesExplainTheRowOrElseTheColumn) {
  poses_.setReconstruction(sampleX17());
  constexpr int kResidualColumn = 5;
  EXPECT_EQ(text(poses_, 1, 1, Qt::ToolTipRole), "on its side");
  EXPECT_THAT(text(poses_, 0, PoseTable::kNewByColumn, Qt::ToolTipRole), HasSubstr("no earlier pose"));
  for (const int column : {PoseTable::kCellsColumn, PoseTable::kNewByColumn, kResidualColumn}) {
    EXPECT_FALSE(poses_.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
    EXPECT_EQ(poses_.index(1, column).data(Qt::ToolTipRole),
              poses_.headerData(column, Qt::Horizontal, Qt::ToolTipRole));
  }
}

TEST_F(ReconstructionTableTest, LinksOfAllPatchesAreListedWithTheirMetrics) {
  links_.setReconstruction(sampleTwoPatches());
  ASSERT_EQ(links_.rowCount(), 7);
  EXPECT_THAT(headers(links_),
              ElementsAre("Link", "Quality", "Residual", "Predicted", "Bend", "Twist", "Yaw", "State"));
  EXPECT_THAT(rowTexts(links_, 0),
              ElementsAre("1:1 – 2:4", "over-defined", "0.3°", "0.7°", "12.1°", "−0.4°", "0.0°", "used, in tree"));
  EXPECT_EQ(text(links_, 0, 0, Qt::AccessibleTextRole), "Link 1 · port 1 — 2 · port 4");
  EXPECT_THAT(text(links_, 0, 0, Qt::ToolTipRole), HasSubstr("Residual 0.3°, predicted deviation 0.7°"));
}

TEST_F(ReconstructionTableTest, MutedLinksAreGreyGiveTheReasonAndNoInventedMetrics) {
  links_.setReconstruction(sampleTwoPatches());
  const int row = links_.rowOf({CellId(21), PortNumber(4)}, {CellId(3), PortNumber(1)});
  ASSERT_EQ(row, 4);
  EXPECT_THAT(rowTexts(links_, row), ElementsAre("3:1 – 21:4", "–", "–", "–", "–", "–", "–", "muted"));
  EXPECT_TRUE(isGrey(links_, row));
  EXPECT_FALSE(isGrey(links_, 0));
  EXPECT_THAT(text(links_, row, 0, Qt::ToolTipRole), HasSubstr("Only one of two cells reports the link"));
}

TEST_F(ReconstructionTableTest, FindingsAreSortedWorstFirstAndKeepTheirOrderOtherwise) {
  findings_.setReconstruction(sampleTwoPatches());
  ASSERT_EQ(findings_.rowCount(), 4);
  EXPECT_THAT(headers(findings_), ElementsAre("Severity", "What", "Where"));
  EXPECT_EQ(findings_.findingAt(0).code, FindingCode::DeadSensor);
  EXPECT_EQ(findings_.findingAt(1).code, FindingCode::OneSidedLink);
  EXPECT_EQ(findings_.findingAt(2).code, FindingCode::NoPoses);
  EXPECT_EQ(findings_.findingAt(3).code, FindingCode::InterfaceLink);
  EXPECT_THAT(rowTexts(findings_, 0), ElementsAre("Error", "Cell 22 reads nothing like gravity.", "cell 22; pose 1"));
  EXPECT_EQ(text(findings_, 1, 2), "cells 3, 21");
  EXPECT_EQ(text(findings_, 2, 2), "–");
  EXPECT_THAT(text(findings_, 0, 1, Qt::ToolTipRole), HasSubstr("dead-sensor"));
}

TEST_F(ReconstructionTableTest, ToolTipsOfFindingsDoNotTakeTextsFromFilesForMarkup) {
  auto reconstruction = sampleTwoPatches();
  reconstruction->findings[0].message = Message::verbatim("<img src=x> & more");
  findings_.setReconstruction(reconstruction);
  EXPECT_THAT(text(findings_, 3, 1, Qt::ToolTipRole), HasSubstr("&lt;img src=x&gt; &amp; more"));
}

TEST_F(ReconstructionTableTest, FindingsNameOnlyTheFirstFewOfManyCells) {
  auto reconstruction = sampleTwoPatches();
  reconstruction->findings.resize(1);
  reconstruction->findings[0].cells.assign(40, CellId(8));
  findings_.setReconstruction(reconstruction);
  EXPECT_EQ(text(findings_, 0, 2), "cells 8, 8, 8, 8, 8, 8 and 34 more");
}

}  // namespace
}  // namespace hexoderm
