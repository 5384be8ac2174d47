#include "hexoderm/util/text.h"

#include "hexoderm/util/error.h"
#include "hexoderm/util/ids.h"
#include "tests/support/error_matchers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hexoderm {
namespace {

using test::messageOf;
using test::saysAll;

TEST(FormatFixed, RoundsToTheDecimalsAskedFor) {
  EXPECT_EQ(formatFixed(1.25, 1), "1.2");  // ties to even
  EXPECT_EQ(formatFixed(-3.14159, 3), "-3.142");
  EXPECT_EQ(formatFixed(59.99999999999999, 0), "60");
  EXPECT_EQ(formatFixed(1e300, 0).size(), 301U);
}

TEST(FormatFixed, NeverWritesANegativeZero) {
  EXPECT_EQ(formatFixed(-0.001, 2), "0.00");
  EXPECT_EQ(formatFixed(-0.0, 0), "0");
  EXPECT_EQ(formatFixed(-0.006, 2), "-0.01");
}

TEST(FormatExact, ReadsBackAsTheSameDouble) {
  for (const double value : {0.1, -1.0 / 3.0, 5e-324, 1.7976931348623157e308, 123456789.125, 0.0}) {
    EXPECT_EQ(parseNumber(formatExact(value), "value"), value);
  }
  EXPECT_EQ(formatExact(0.1), "0.1");
}

TEST(ParseNumber, TakesTheWholeTextOnly) {
  EXPECT_EQ(parseNumber("-2.5e-3", "radius"), -2.5e-3);
  for (const char* text : {"", " 1", "1 ", "1mm", "0x10", "one", "1,5", "1e999"}) {
    EXPECT_THAT(messageOf<InvalidArgument>([&] { parseNumber(text, "radius"); }),
                saysAll("radius", "expected a number", "\"" + std::string(text) + "\""));
  }
}

TEST(ParseNumber, RefusesWhatIsNotFinite) {
  for (const char* text : {"nan", "inf", "-inf"}) {
    EXPECT_THAT(messageOf<InvalidArgument>([&] { parseNumber(text, "radius"); }), saysAll("radius", "finite"));
  }
}

TEST(ParseUnsigned, TakesThirtyTwoBits) {
  EXPECT_EQ(parseUnsigned("4294967295", "cell"), 4294967295U);
  EXPECT_EQ(parseUnsigned("0", "cell"), 0U);
  for (const char* text : {"", "-1", "+1", "1.0", "4294967296", "7a"}) {
    EXPECT_THAT(messageOf<InvalidArgument>([&] { parseUnsigned(text, "cell"); }),
                saysAll("cell", "expected a whole number"));
  }
}

TEST(Split, KeepsEmptyParts) {
  EXPECT_EQ(split("a,b,,c", ','), (std::vector<std::string>{"a", "b", "", "c"}));
  EXPECT_EQ(split("", ','), std::vector<std::string>{""});
  EXPECT_EQ(split("a,", ','), (std::vector<std::string>{"a", ""}));
}

TEST(ListInWords, JoinsAsOneWouldSayIt) {
  EXPECT_EQ(listInWords(std::vector<CellId>{}), "");
  EXPECT_EQ(listInWords(std::vector{CellId(1)}), "1");
  EXPECT_EQ(listInWords(std::vector{CellId(1), CellId(2)}), "1 and 2");
  EXPECT_EQ(listInWords(std::vector{CellId(1), CellId(2), CellId(3)}), "1, 2 and 3");
}

}  // namespace
}  // namespace hexoderm
