#include "widgets/tables/pose_table.h"

#include "tests/support/hand_made_skins.h"
#include "tests/widgets/tables/table_texts.h"

#include <gmock/gmock.h>
#include <QIcon>

namespace hexoderm {
namespace {

using test::headers;
using test::isGrey;
using test::rowTexts;
using test::text;

class PoseTableTest : public testing::Test {
 protected:
  PoseTableTest() { QApplication::setPalette(qtPalette(Theme::Light)); }
};

TEST_F(PoseTableTest, PosesShowWhatWasMeasuredAndADashWhereNothingIsKnown) {
  PoseTable table;
  table.setReconstruction(sampleX17());
  ASSERT_EQ(table.rowCount(), 4);
  EXPECT_THAT(headers(table), testing::ElementsAre("Pose", "Label", "Cells", "Noise mg", "New by", "Residual"));
  EXPECT_THAT(rowTexts(table, 0), testing::ElementsAre("1", "standing", "17/17", "1.4", "–", "0.4°"));
  EXPECT_THAT(rowTexts(table, 1), testing::ElementsAre("2", "on its side", "17/17", "2.2", "86°", "0.5°"));
  EXPECT_THAT(rowTexts(table, 3), testing::ElementsAre("4", "–", "17/17", "–", "64°", "0.4°"));
}

TEST_F(PoseTableTest, DisabledPosesAreGreyAndSaySo) {
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

TEST_F(PoseTableTest, FiguresStandAtTheRightWordsAtTheLeft) {
  PoseTable table;
  table.setReconstruction(sampleX17());
  ASSERT_GT(table.columnCount(), 2);
  for (int column = 0; column < table.columnCount(); ++column) {
    const int expected = (column < 2 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter;
    EXPECT_EQ(table.index(0, column).data(Qt::TextAlignmentRole).toInt(), expected);
    EXPECT_EQ(table.headerData(column, Qt::Horizontal, Qt::TextAlignmentRole).toInt(), expected);
    EXPECT_FALSE(table.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
  }
}

}  // namespace
}  // namespace hexoderm
