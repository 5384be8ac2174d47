#include "widgets/tables/sorted_table.h"

#include "widgets/tables/result_table.h"
#include "widgets/tables/table_csv.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

class SortedTableTest : public testing::Test {
 protected:
  SortedTableTest() {
    table_.setContent({{"Name", {}, {}, 0, true}, {"Length mm", "mm", {}, 2, false}, {"Angle °", "deg", {}, 1, false}},
                      {{{QStringLiteral("a, b"), 1.0 / 3, QVariant()}},
                       {{QStringLiteral("say \"x\"\nand go"), -2.5, 1e-7}},
                       {{QStringLiteral("cell 10"), 10.0, 2.0}},
                       {{QStringLiteral("cell 9"), 9.0, 3.0}}});
  }

  ResultTable table_;
};

TEST_F(SortedTableTest, SortsNumbersByValueNamesAsAPersonWouldAndTheUnknownLast) {
  SortedTable sorted(&table_);
  const auto names = [&] {
    QStringList result;
    for (int row = 0; row < sorted.rowCount(); ++row) result << sorted.index(row, 0).data().toString().left(7);
    return result.join('|').toStdString();
  };
  EXPECT_EQ(names(), "a, b|say \"x\"|cell 10|cell 9");
  sorted.sort(1, Qt::AscendingOrder);
  EXPECT_EQ(names(), "say \"x\"|a, b|cell 9|cell 10");
  sorted.sort(0, Qt::AscendingOrder);
  EXPECT_EQ(names(), "a, b|cell 9|cell 10|say \"x\"");
  sorted.sort(2, Qt::AscendingOrder);
  EXPECT_EQ(sorted.index(3, 0).data().toString(), "a, b");
  sorted.sort(2, Qt::DescendingOrder);
  EXPECT_EQ(sorted.index(3, 0).data().toString(), "a, b");
  EXPECT_EQ(sorted.index(0, 0).data().toString(), "cell 9");
  EXPECT_EQ(sorted.headerData(2, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("Angle ° ↓"));
  EXPECT_TRUE(tableAsCsv(sorted).startsWith("Name,Length mm,Angle (deg)\r\n")) << "files have no arrows";
}

}  // namespace
}  // namespace hexoderm
