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

}  // namespace
}  // namespace hexoderm
