// How tables are sorted, and what of them goes to files and the clipboard.

#include "widgets/tables/table_csv.h"

#include "tests/support/hand_made_skins.h"
#include "tests/support/qt_wait.h"
#include "widgets/tables/link_table.h"
#include "widgets/tables/result_table.h"
#include "widgets/tables/sorted_table.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

class MetricsTableTest : public testing::Test {
 protected:
  MetricsTableTest() {
    table_.setContent({{"Name", {}, {}, 0, true}, {"Length mm", "mm", {}, 2, false}, {"Angle °", "deg", {}, 1, false}},
                      {{{"a, b", 1.0 / 3, QVariant()}},
                       {{"say \"x\"\nand go", -2.5, 1e-7}},
                       {{"cell 10", 10.0, 2.0}},
                       {{"cell 9", 9.0, 3.0}}});
  }
  ~MetricsTableTest() override { QLocale::setDefault(QLocale::system()); }

  ResultTable table_;
};

TEST_F(MetricsTableTest, CsvQuotesWhatMustBeAndKeepsAllDigits) {
  EXPECT_EQ(tableAsCsv(table_).toStdString(),
            "Name,Length mm,Angle (deg)\r\n"
            "\"a, b\",0.3333333333333333,\r\n"
            "\"say \"\"x\"\"\nand go\",-2.5,1e-07\r\n"
            "cell 10,10,2\r\n"
            "cell 9,9,3\r\n");
}

TEST_F(MetricsTableTest, CsvHasADecimalPointWhateverTheLocale) {
  const QByteArray before = tableAsCsv(table_);
  QLocale::setDefault(QLocale(QLocale::German));
  EXPECT_EQ(table_.index(1, 1).data().toString(), "−2,50") << "what is shown follows the locale";
  EXPECT_EQ(tableAsCsv(table_), before);
}

TEST_F(MetricsTableTest, CsvOfTheLinksHoldsWhatIsBehindTheTexts) {
  LinkTable links;
  links.setReconstruction(sampleTwoPatches());
  const QList<QByteArray> lines = tableAsCsv(links).split('\n');
  EXPECT_EQ(lines[0].trimmed().toStdString(),
            "Link,Quality,Residual (deg),Predicted (deg),Bend (deg),Twist (deg),Yaw (deg),State");
  const QList<QByteArray> fields = lines[1].trimmed().split(',');
  EXPECT_NEAR(fields[2].toDouble(), 0.3, 1e-12);
  EXPECT_NEAR(fields[6].toDouble(), -0.01, 1e-12) << "the table shows 0.0";
  EXPECT_TRUE(lines[5].trimmed().endsWith(",,,,,,muted")) << lines[5].toStdString();
}

TEST_F(MetricsTableTest, SortsNumbersByValueNamesAsAPersonWouldAndTheUnknownLast) {
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
  EXPECT_EQ(sorted.headerData(2, Qt::Horizontal, Qt::DisplayRole).toString(), "Angle ° ↓");
  EXPECT_TRUE(tableAsCsv(sorted).startsWith("Name,Length mm,Angle (deg)\r\n")) << "files have no arrows";
}

TEST_F(MetricsTableTest, CopiesWhatIsShownInItsOrder) {
  SortedTable sorted(&table_);
  QTableView view;
  view.setModel(&sorted);
  new CsvActions(&view, "table");
  sorted.sort(1, Qt::DescendingOrder);
  view.show();
  view.activateWindow();
  ASSERT_TRUE(test::waitUntilActive(view));
  view.setFocus();
  QTest::keyClick(&view, Qt::Key_C, Qt::ControlModifier);
  const QStringList lines = QApplication::clipboard()->text().split("\r\n");
  ASSERT_EQ(lines.size(), 6) << "header, four rows, and the end of the last";
  EXPECT_TRUE(lines[1].startsWith("cell 10,"));
}

}  // namespace
}  // namespace hexoderm
