#include "hexoderm/base/csv.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

TEST(CsvQuoted, QuotesWhatNeedsIt) {
  const std::pair<const char*, const char*> texts[] = {
      // Plain texts, and numbers, stay as they are.
      {"", ""},
      {"left arm", "left arm"},
      {"−0.5 ° ±", "−0.5 ° ±"},
      {"-1.5", "-1.5"},
      {"+2", "+2"},
      {"-3e-7", "-3e-7"},
      {"-0", "-0"},
      {"1", "1"},
      // Separators, line breaks, spaces at the ends and quotes.
      {"a,b", "\"a,b\""},
      {"a\nb", "\"a\nb\""},
      {"a\rb", "\"a\rb\""},
      {" a", "\" a\""},
      {"a ", "\"a \""},
      {"say \"x\"", "\"say \"\"x\"\"\""},
      // No spreadsheet runs a formula.
      {"=1+1", "'=1+1"},
      {"+1+1", "'+1+1"},
      {"-1+1", "'-1+1"},
      {"@SUM(A1)", "'@SUM(A1)"},
      {"\t=1", "'\t=1"},
      {"\r=1", "\"'\r=1\""},
      {"\n=1", "\"'\n=1\""},
      {"=HYPERLINK(\"http://x\",\"y\")", "\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\""},
      {"-", "'-"},
      {"-inf", "'-inf"},
      {"-1 mm", "'-1 mm"},
  };
  for (const auto& [text, quoted] : texts) EXPECT_EQ(csvQuoted(text), quoted);
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
