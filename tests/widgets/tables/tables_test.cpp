#include "widgets/tables/tables.h"

#include "tests/widgets/sample_reconstruction.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"

#include <QAbstractItemModelTester>
#include <QBrush>
#include <QIcon>
#include <QSignalSpy>

namespace hexoderm {
namespace {

std::string text(const QAbstractItemModel& model, int row, int column, int role = Qt::DisplayRole) {
  return model.index(row, column).data(role).toString().toStdString();
}

std::vector<std::string> rowTexts(const QAbstractItemModel& model, int row) {
  std::vector<std::string> texts;
  for (int column = 0; column < model.columnCount(); ++column) texts.push_back(text(model, row, column));
  return texts;
}

std::vector<std::string> headers(const QAbstractItemModel& model) {
  std::vector<std::string> texts;
  for (int column = 0; column < model.columnCount(); ++column) {
    texts.push_back(model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().toStdString());
  }
  return texts;
}

bool isGrey(const QAbstractItemModel& model, int row) {
  return model.index(row, 0).data(Qt::ForegroundRole).value<QBrush>() ==
         QBrush(QApplication::palette().color(QPalette::PlaceholderText));
}

class TablesTest : public testing::Test {
 protected:
  TablesTest() { QApplication::setPalette(qtPalette(Theme::Light)); }
};

TEST_F(TablesTest, AreEmptyWithoutAReconstructionAndKeepTheContractOfItemModels) {
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

TEST(Words, KeepFiguresToTheirUnits) {
  EXPECT_EQ(unbroken(QStringLiteral("±2.1 mm (95 %), 4 poses, 3 mg of 1 g")),
            QStringLiteral("±2.1\u00a0mm (95\u00a0%), 4 poses, 3\u00a0mg of 1\u00a0g"));
  EXPECT_EQ(unbroken(QStringLiteral("cell 7 sends, 3 messages")), QStringLiteral("cell 7 sends, 3 messages"));
}

TEST_F(TablesTest, PosesShowWhatWasMeasuredAndADashWhereNothingIsKnown) {
  PoseTable table;
  table.setReconstruction(sampleX17());
  ASSERT_EQ(table.rowCount(), 4);
  EXPECT_THAT(headers(table), testing::ElementsAre("Pose", "Label", "Cells", "Noise mg", "New by", "Residual"));
  EXPECT_THAT(rowTexts(table, 0), testing::ElementsAre("1", "standing", "17/17", "1.4", "–", "0.4°"));
  EXPECT_THAT(rowTexts(table, 1), testing::ElementsAre("2", "on its side", "17/17", "2.2", "86°", "0.5°"));
  EXPECT_THAT(rowTexts(table, 3), testing::ElementsAre("4", "–", "17/17", "–", "64°", "0.4°"));
}

TEST_F(TablesTest, DisabledPosesAreGreyAndSaySo) {
  PoseTable table;
  table.setReconstruction(sampleX17());
  EXPECT_FALSE(isGrey(table, 0));
  EXPECT_TRUE(isGrey(table, 2));
  EXPECT_EQ(text(table, 0, 0, Qt::AccessibleTextRole), "Pose 1, used");
  EXPECT_EQ(text(table, 2, 0, Qt::AccessibleTextRole), "Pose 3, disabled");
  EXPECT_THAT(text(table, 2, 0, Qt::ToolTipRole), testing::HasSubstr("disabled"));
  const auto mark = [&](int row) {
    return table.index(row, 0).data(Qt::DecorationRole).value<QIcon>().pixmap(16, 16).toImage();
  };
  EXPECT_EQ(mark(0), mark(1));
  EXPECT_NE(mark(0), mark(2));
}

TEST_F(TablesTest, FiguresStandAtTheRightWordsAtTheLeft) {
  PoseTable table;
  table.setReconstruction(sampleX17());
  for (int column = 0; column < table.columnCount(); ++column) {
    const int expected = (column < 2 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter;
    EXPECT_EQ(table.index(0, column).data(Qt::TextAlignmentRole).toInt(), expected);
    EXPECT_EQ(table.headerData(column, Qt::Horizontal, Qt::TextAlignmentRole).toInt(), expected);
    EXPECT_FALSE(table.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
  }
}

TEST_F(TablesTest, LinksOfAllPatchesAreListedWithTheirFigures) {
  LinkTable table;
  table.setReconstruction(sampleTwoPatches());
  ASSERT_EQ(table.rowCount(), 7);
  EXPECT_THAT(headers(table),
              testing::ElementsAre("Link", "Quality", "Residual", "Predicted", "Bend", "Twist", "Yaw", "State"));
  EXPECT_THAT(rowTexts(table, 0), testing::ElementsAre("1:1 – 2:4", "over-defined", "0.3°", "0.7°", "12.1°", "−0.4°",
                                                       "0.0°", "used, in tree"));
  EXPECT_EQ(text(table, 0, 0, Qt::AccessibleTextRole), "Link 1 · port 1 — 2 · port 4");
  EXPECT_THAT(text(table, 0, 0, Qt::ToolTipRole), testing::HasSubstr("Residual 0.3°, predicted deviation 0.7°"));
}

TEST_F(TablesTest, MutedLinksAreGreyGiveTheReasonAndNoInventedFigures) {
  LinkTable table;
  table.setReconstruction(sampleTwoPatches());
  const int row = table.rowOf({CellId(21), PortNumber(4)}, {CellId(3), PortNumber(1)});
  ASSERT_EQ(row, 4);
  EXPECT_THAT(rowTexts(table, row), testing::ElementsAre("3:1 – 21:4", "–", "–", "–", "–", "–", "–", "muted"));
  EXPECT_TRUE(isGrey(table, row));
  EXPECT_FALSE(isGrey(table, 0));
  EXPECT_THAT(text(table, row, 0, Qt::ToolTipRole), testing::HasSubstr("Only one of two cells reports the link"));
}

TEST_F(TablesTest, LinksAreFoundFromEitherEnd) {
  LinkTable table;
  table.setReconstruction(sampleX17());
  const LinkEnd a{CellId(5), PortNumber(3)};
  const LinkEnd b{CellId(9), PortNumber(2)};
  const int row = table.rowOf(b, a);
  EXPECT_EQ(row, table.rowOf(a, b));
  EXPECT_EQ(table.linkAt(row).source, a);
  EXPECT_EQ(table.linkAt(row).target, b);
  EXPECT_EQ(table.rowOf(a, {CellId(9), PortNumber(1)}), -1);
}

TEST_F(TablesTest, FindingsAreSortedWorstFirstAndKeepTheirOrderOtherwise) {
  FindingTable table;
  table.setReconstruction(sampleTwoPatches());
  ASSERT_EQ(table.rowCount(), 4);
  EXPECT_THAT(headers(table), testing::ElementsAre("Severity", "What", "Where"));
  EXPECT_EQ(table.findingAt(0).code, FindingCode::DeadSensor);
  EXPECT_EQ(table.findingAt(1).code, FindingCode::OneSidedLink);
  EXPECT_EQ(table.findingAt(2).code, FindingCode::NoPoses);
  EXPECT_EQ(table.findingAt(3).code, FindingCode::InterfaceLink);
  EXPECT_THAT(rowTexts(table, 0),
              testing::ElementsAre("Error", "Cell 22 reads nothing like gravity.", "cell 22; pose 1"));
  EXPECT_EQ(text(table, 1, 2), "cells 3, 21");
  EXPECT_EQ(text(table, 2, 2), "–");
  EXPECT_THAT(text(table, 0, 1, Qt::ToolTipRole), testing::HasSubstr("dead-sensor"));
}

TEST_F(TablesTest, ToolTipsDoNotTakeTextsFromFilesForMarkup) {
  auto reconstruction = sampleTwoPatches();
  reconstruction->findings[0].message = Message::verbatim("<img src=x> & more");
  FindingTable table;
  table.setReconstruction(reconstruction);
  EXPECT_THAT(text(table, 3, 1, Qt::ToolTipRole), testing::HasSubstr("&lt;img src=x&gt; &amp; more"));
}

TEST_F(TablesTest, NamesOnlyTheFirstFewOfManyCells) {
  auto reconstruction = sampleTwoPatches();
  reconstruction->findings.resize(1);
  reconstruction->findings[0].cells.assign(40, CellId(8));
  FindingTable table;
  table.setReconstruction(reconstruction);
  EXPECT_EQ(text(table, 0, 2), "cells 8, 8, 8, 8, 8, 8 and 34 more");
}

}  // namespace
}  // namespace hexoderm
