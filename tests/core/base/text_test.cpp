#include "hexoderm/base/text.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

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

TEST(ParseNumber, NamesTheRangeOfWhatIsBeyondIt) {
  EXPECT_EQ(parseNumberWithin("-1e6", "x", -1e6, 1e6), -1e6);
  EXPECT_EQ(parseNumberWithin("1e6", "x", -1e6, 1e6), 1e6);
  for (const std::string text : {"1000001", "-1e300", "1e999", "nan", "-inf", "", "one"}) {
    EXPECT_EQ(messageOf<InvalidArgument>([&] { parseNumberWithin(text, "x", -1e6, 1e6); }),
              "x: expected a number from -1000000 to 1000000, found \"" + text + "\"");
  }
  EXPECT_THAT(messageOf<InvalidArgument>([] { parseNumberWithin("0", "x", 0.001, 360); }),
              saysAll("from 0.001 to 360"));
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

TEST(Shortened, KeepsBeginningAndEndAndWholeCharacters) {
  EXPECT_EQ(shortened("short", 5), "short");
  EXPECT_EQ(shortened("0123456789", 9), "012...789");
  EXPECT_EQ(shortened("0123456789", 8), "012...89");
  EXPECT_EQ(shortened(std::string(1'000'000, 'x'), 2000).size(), 2000U);
  EXPECT_EQ(shortened("0123456789", 3), "...");
  const std::string umlauts = "äöüäöüäöü";
  for (std::size_t most = 3; most <= umlauts.size(); ++most) {
    const std::string text = shortened(umlauts, most);
    EXPECT_LE(text.size(), most);
    EXPECT_EQ(forTerminal(text), text) << "no half character";
  }
}

TEST(ForTerminal, LeavesWordsOfAllLanguagesAsTheyAre) {
  for (const char* text : {"", "left arm", "±0.5° – naïve 肌 𝛼", "C:\\n"}) EXPECT_EQ(forTerminal(text), text);
}

TEST(ForTerminal, EscapesWhatSteersTheTerminal) {
  EXPECT_EQ(forTerminal("\x1b[31mred\x1b[0m"), "\\u001b[31mred\\u001b[0m");
  EXPECT_EQ(forTerminal("a\nb\rc\td"), "a\\nb\\rc\\td");
  EXPECT_EQ(forTerminal(std::string("nul\0!", 5)), "nul\\u0000!");
  EXPECT_EQ(forTerminal("\x7f\xc2\x9b\xc2\x85"), "\\u007f\\u009b\\u0085") << "delete, CSI and NEL of eight bits";
  EXPECT_EQ(forTerminal("\xe2\x80\xae"
                        "gpj.exe"),
            "\\u202egpj.exe")
      << "written from right to left";
  EXPECT_EQ(forTerminal("\xe2\x80\xa8"), "\\u2028") << "a line separator";
}

TEST(ForTerminal, EscapesBytesThatAreNoUtf8) {
  EXPECT_EQ(forTerminal("\xff"), "\\xff");
  EXPECT_EQ(forTerminal("a\x9b"
                        "b"),
            "a\\x9bb");
  EXPECT_EQ(forTerminal("\xc3"), "\\xc3") << "cut off";
  EXPECT_EQ(forTerminal("\xc0\x9b"), "\\xc0\\x9b") << "an escape written with more bytes than it takes";
  EXPECT_EQ(forTerminal("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half a pair of UTF-16";
}

TEST(Error, SaysNoMoreThanAPersonReads) {
  const FormatError error(located("f.json", Message::verbatim(std::string(1'000'000, 'x') + " in the end")));
  const std::string what = error.what();
  EXPECT_LE(what.size(), 2000U);
  EXPECT_TRUE(what.starts_with("f.json: xxx")) << what;
  EXPECT_TRUE(what.ends_with("in the end")) << what;
  EXPECT_EQ(error.message().english(), what);
}

}  // namespace
}  // namespace hexoderm
