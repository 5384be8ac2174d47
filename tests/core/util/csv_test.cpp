#include "hexoderm/util/csv.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

TEST(CsvQuoted, LeavesPlainTextsAsTheyAre) {
  EXPECT_EQ(csvQuoted(""), "");
  EXPECT_EQ(csvQuoted("left arm"), "left arm");
  EXPECT_EQ(csvQuoted("−0.5 ° ±"), "−0.5 ° ±");
}

TEST(CsvQuoted, QuotesSeparatorsLineBreaksAndSpacesAtTheEnds) {
  EXPECT_EQ(csvQuoted("a,b"), "\"a,b\"");
  EXPECT_EQ(csvQuoted("a\nb"), "\"a\nb\"");
  EXPECT_EQ(csvQuoted("a\rb"), "\"a\rb\"");
  EXPECT_EQ(csvQuoted(" a"), "\" a\"");
  EXPECT_EQ(csvQuoted("a "), "\"a \"");
}

TEST(CsvQuoted, DoublesQuotes) { EXPECT_EQ(csvQuoted("say \"x\""), "\"say \"\"x\"\"\""); }

TEST(CsvQuoted, LetsNoSpreadsheetRunAFormula) {
  EXPECT_EQ(csvQuoted("=1+1"), "'=1+1");
  EXPECT_EQ(csvQuoted("+1+1"), "'+1+1");
  EXPECT_EQ(csvQuoted("-1+1"), "'-1+1");
  EXPECT_EQ(csvQuoted("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csvQuoted("\t=1"), "'\t=1");
  EXPECT_EQ(csvQuoted("\r=1"), "\"'\r=1\"");
  EXPECT_EQ(csvQuoted("\n=1"), "\"'\n=1\"");
  EXPECT_EQ(csvQuoted("=HYPERLINK(\"http://x\",\"y\")"), "\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\"");
  EXPECT_EQ(csvQuoted("-"), "'-");
  EXPECT_EQ(csvQuoted("-inf"), "'-inf");
  EXPECT_EQ(csvQuoted("-1 mm"), "'-1 mm");
}

TEST(CsvQuoted, LeavesNumbersNumbers) {
  for (const char* number : {"-1.5", "+2", "-3e-7", "-0", "1"}) EXPECT_EQ(csvQuoted(number), number);
}

TEST(CsvFields, AreWhatWasQuoted) {
  const std::vector<std::string> fields{"", "a,b", "say \"x\"", " a ", "1.5", ""};
  std::string line;
  for (std::size_t k = 0; k < fields.size(); ++k) line += (k > 0 ? "," : "") + csvQuoted(fields[k]);
  EXPECT_EQ(csvFields(line), fields);
  EXPECT_EQ(csvFields(""), std::vector<std::string>{""});
  EXPECT_EQ(csvFields("a;\"b;c\"", ';'), (std::vector<std::string>{"a", "b;c"}));
}

TEST(CsvFields, AreNoneWhereAQuoteIsNotClosedOrFollowed) {
  EXPECT_EQ(csvFields("a,\"b"), std::nullopt);
  EXPECT_EQ(csvFields("\"a\"b,c"), std::nullopt);
  EXPECT_EQ(csvFields("\""), std::nullopt);
  EXPECT_EQ(csvFields("\"a\"\""), std::nullopt);
}

}  // namespace
}  // namespace hexoderm
