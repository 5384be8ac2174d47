#include "widgets/tables/link_table.h"

#include "tests/support/hand_made_skins.h"
#include "tests/widgets/tables/table_texts.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

using test::headers;
using test::isGrey;
using test::rowTexts;
using test::text;

class LinkTableTest : public testing::Test {
 protected:
  LinkTableTest() { QApplication::setPalette(qtPalette(Theme::Light)); }
};

TEST_F(LinkTableTest, LinksOfAllPatchesAreListedWithTheirFigures) {
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

TEST_F(LinkTableTest, MutedLinksAreGreyGiveTheReasonAndNoInventedFigures) {
  LinkTable table;
  table.setReconstruction(sampleTwoPatches());
  const int row = table.rowOf({CellId(21), PortNumber(4)}, {CellId(3), PortNumber(1)});
  ASSERT_EQ(row, 4);
  EXPECT_THAT(rowTexts(table, row), testing::ElementsAre("3:1 – 21:4", "–", "–", "–", "–", "–", "–", "muted"));
  EXPECT_TRUE(isGrey(table, row));
  EXPECT_FALSE(isGrey(table, 0));
  EXPECT_THAT(text(table, row, 0, Qt::ToolTipRole), testing::HasSubstr("Only one of two cells reports the link"));
}

TEST_F(LinkTableTest, LinksAreFoundFromEitherEnd) {
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

}  // namespace
}  // namespace hexoderm
