#include "widgets/tables/finding_table.h"

#include "tests/support/hand_made_skins.h"
#include "tests/widgets/tables/table_texts.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

using test::headers;
using test::rowTexts;
using test::text;

class FindingTableTest : public testing::Test {
 protected:
  FindingTableTest() { QApplication::setPalette(qtPalette(Theme::Light)); }
};

TEST_F(FindingTableTest, FindingsAreSortedWorstFirstAndKeepTheirOrderOtherwise) {
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

TEST_F(FindingTableTest, ToolTipsDoNotTakeTextsFromFilesForMarkup) {
  auto reconstruction = sampleTwoPatches();
  reconstruction->findings[0].message = Message::verbatim("<img src=x> & more");
  FindingTable table;
  table.setReconstruction(reconstruction);
  EXPECT_THAT(text(table, 3, 1, Qt::ToolTipRole), testing::HasSubstr("&lt;img src=x&gt; &amp; more"));
}

TEST_F(FindingTableTest, NamesOnlyTheFirstFewOfManyCells) {
  auto reconstruction = sampleTwoPatches();
  reconstruction->findings.resize(1);
  reconstruction->findings[0].cells.assign(40, CellId(8));
  FindingTable table;
  table.setReconstruction(reconstruction);
  EXPECT_EQ(text(table, 0, 2), "cells 8, 8, 8, 8, 8, 8 and 34 more");
}

}  // namespace
}  // namespace hexoderm
