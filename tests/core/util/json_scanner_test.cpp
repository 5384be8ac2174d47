#include "hexoderm/util/json_scanner.h"

#include "hexoderm/util/error.h"
#include "hexoderm/util/json_reader.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <random>

namespace hexoderm {
namespace {

/// What `take` takes of a whole text; nullopt where the scanner leaves it to others.
template <class Take>
auto scanned(std::string_view text, Take take) -> std::optional<decltype(take(std::declval<JsonScanner&>()))> {
  try {
    JsonScanner scanner(text);
    auto value = take(scanner);
    scanner.finish();
    return value;
  } catch (const JsonScanner::Unusual&) {
    return std::nullopt;
  } catch (const FormatError&) {
    return std::nullopt;
  }
}

std::optional<double> scannedNumber(std::string_view text) {
  return scanned(text, [](JsonScanner& scanner) { return scanner.number(); });
}

/// As the thorough reader takes it.
std::optional<double> readNumber(const std::string& text) {
  try {
    const nlohmann::json json = parseJson(text, "f.json");
    return JsonReader(json, "f.json").number();
  } catch (const FormatError&) {
    return std::nullopt;
  }
}

TEST(JsonScanner, ReadsNumbersToTheLastBitAsTheThoroughReaderDoes) {
  std::mt19937_64 random(1);
  std::vector<std::string> texts = {"0",
                                    "-0",
                                    "0.0",
                                    "-0.0",
                                    "1",
                                    "-1",
                                    "1e5",
                                    "1E+5",
                                    "1e-5",
                                    "0e0",
                                    "-0e0",
                                    "1.25",
                                    "0.1",
                                    "5e-324",
                                    "1e308",
                                    "9007199254740993",
                                    "18446744073709551615",
                                    "18446744073709551616",
                                    "-9223372036854775808",
                                    "-9223372036854775809",
                                    "123456789012345678901234567890",
                                    "2.2250738585072011e-308",
                                    "0.30000000000000004",
                                    "1.00000000000000011102230246251565"};
  for (int k = 0; k < 20'000; ++k) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) texts.push_back(nlohmann::json(value).dump());
  }
  for (const std::string& text : texts) {
    const std::optional<double> number = scannedNumber(text);
    ASSERT_TRUE(number) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*number), std::bit_cast<std::uint64_t>(readNumber(text).value())) << text;
  }
}

TEST(JsonScanner, TakesNoNumberThatIsNone) {
  for (const char* text :
       {"",    "-",   "+1",  "01",  "-01", "1.",   ".5",    "-.5", "1e",  "1e+",   "1.e5",  "0x10", "inf",  "-inf",
        "nan", "NaN", "1 2", "1,2", "1x",  "1e5x", "1.5.5", "--1", "1_0", "1e999", "\"1\"", "null", "true", "[1]"}) {
    EXPECT_FALSE(scannedNumber(text)) << text;
  }
}

TEST(JsonScanner, TakesWhatTheThoroughReaderTakesAsAWholeNumber) {
  const auto whole = [](std::string_view text) {
    return scanned(text, [](JsonScanner& scanner) { return scanner.unsignedInteger(1, 4'294'967'294); });
  };
  EXPECT_EQ(whole("1"), 1U);
  EXPECT_EQ(whole(" 4294967294 "), 4'294'967'294U);
  for (const char* text :
       {"0", "4294967295", "4294967296", "99999999999999999999", "01", "-1", "1.0", "1e0", "", "x"}) {
    EXPECT_FALSE(whole(text)) << text;
  }
}

TEST(JsonScanner, ReadsTextsAsTheyAre) {
  const auto text = [](std::string_view json) { return scanned(json, [](JsonScanner& s) { return s.string(); }); };
  EXPECT_EQ(text(R"("plain")"), "plain");
  EXPECT_EQ(text(R"("")"), "");
  EXPECT_EQ(text(R"("\"\\\n\u00fc\ud83d\ude00")"), "\"\\\nü😀");
  EXPECT_EQ(text("\"ümläut\""), "ümläut");
  for (const char* json :
       {"\"", "\"a", "\"a\\\"", "\"a\\", "\"line\nbreak\"", "\"\\x\"", "\"\\ud800\"", "\"\xff\"", "1"}) {
    EXPECT_FALSE(text(json)) << json;
  }
}

/// Member "a" and, where it is there, "b".
std::optional<std::array<double, 2>> membersOf(std::string_view text) {
  return scanned(text, [](JsonScanner& scanner) {
    std::array<double, 2> values{};
    scanner.object(member("a", [&] { values[0] = scanner.number(); }),
                   optionalMember("b", [&] { values[1] = scanner.number(); }));
    return values;
  });
}

TEST(JsonScanner, TakesTheMembersOfAnObjectInAnyOrder) {
  EXPECT_EQ(membersOf(R"({"a": 1})"), (std::array{1.0, 0.0}));
  EXPECT_EQ(membersOf(" {\"b\":2 ,\n\"a\"\t:\r1 } "), (std::array{1.0, 2.0}));
}

TEST(JsonScanner, LeavesObjectsToOthersThatAreNotAsExpected) {
  for (const char* text :
       {"{}", R"({"b": 2})", R"({"a": 1, "a": 1})", R"({"a": 1, "c": 1})", R"({"a": 1, "\u0062": 1})", R"({"a": 1,})",
        R"({,"a": 1})", R"({"a" 1})", R"({"a": 1 "b": 2})", R"({"a": 1)", R"({"a": 1]})", R"({"a": 1}})",
        R"({"a": 1} 1)", R"(["a", 1])", R"({a: 1})", R"({"a": null})", R"({"a": })", "{\"a\n\": 1}",
        R"({"a": 1,, "b": 2})"}) {
    EXPECT_FALSE(membersOf(text)) << text;
  }
}

std::optional<std::size_t> countOf(std::string_view text) {
  return scanned(text, [](JsonScanner& scanner) {
    std::size_t count = 0;
    scanner.beginArray();
    for (; scanner.nextItem(); ++count) {
      if (!scanner.isNull()) static_cast<void>(scanner.boolean());
    }
    return count;
  });
}

TEST(JsonScanner, TakesTheItemsOfAnArray) {
  EXPECT_EQ(countOf("[]"), 0U);
  EXPECT_EQ(countOf(" [ true ,\nfalse,null ] "), 3U);
  for (const char* text : {"", "[", "]", "[true", "[true,", "[true,]", "[,]", "[,true]", "[true true]", "[true}",
                           "[tru]", "[truefalse]", "[nul]", "[nulll]", "[True]", "[true]]", "[1]"}) {
    EXPECT_FALSE(countOf(text)) << text;
  }
}

TEST(JsonScanner, TakesExactlySoManyNumbers) {
  const auto three = [](std::string_view text) {
    return scanned(text, [](JsonScanner& scanner) {
      std::array<double, 3> values{};
      scanner.numbers(values);
      return values;
    });
  };
  EXPECT_EQ(three("[1, 2.5,-3]"), (std::array{1.0, 2.5, -3.0}));
  for (const char* text : {"[1, 2]", "[1, 2, 3, 4]", "[]", "[1, 2, null]", "[1, 2, 3,]", "1, 2, 3"}) {
    EXPECT_FALSE(three(text)) << text;
  }
}

TEST(JsonScanner, KeepsOtherMembersAsDocuments) {
  const auto kept = [](std::string_view text) {
    return scanned(text, [](JsonScanner& scanner) {
      nlohmann::json rest = nlohmann::json::object();
      scanner.objectWith([&](std::string_view key) { scanner.keep(key, rest); },
                         member("a", [&] { rest["taken"] = scanner.number(); }));
      return rest;
    });
  };
  EXPECT_EQ(kept(R"({"x": [1, {"y": "}],\""}], "a": 1, "z" : "text" , "t":true,"e":{} })"),
            nlohmann::json::parse(R"({"taken": 1.0, "x": [1, {"y": "}],\""}], "z": "text", "t": true, "e": {}})"));
  for (const char* text :
       {R"({"a": 1, "x": })", R"({"a": 1, "x": [})", R"({"a": 1, "x": [1, }]})", R"({"a": 1, "x": 1 2})",
        R"({"a": 1, "x": 1, "x": 1})", R"({"a": 1, "x": {"y": 1, "y": 1}})", R"({"a": 1, "x": nan})",
        R"({"a": 1, "x": 1e999})", R"({"a": 1, "x": "})", R"({"a": 1, "x": [1})"}) {
    EXPECT_FALSE(kept(text)) << text;
  }
}

TEST(JsonScanner, HasTheLimitsOfTheThoroughReader) {
  const auto nested = [](std::size_t levels) {
    return "{\"x\": " + std::string(levels - 1, '[') + std::string(levels - 1, ']') + "}";
  };
  const auto is_taken = [](const std::string& text) {
    return scanned(text,
                   [](JsonScanner& scanner) {
                     nlohmann::json rest = nlohmann::json::object();
                     scanner.objectWith([&](std::string_view key) { scanner.keep(key, rest); });
                     return true;
                   })
        .has_value();
  };
  EXPECT_NO_THROW(parseJson(nested(kMostJsonLevels), "f.json"));
  EXPECT_TRUE(is_taken(nested(kMostJsonLevels)));
  EXPECT_THROW(parseJson(nested(kMostJsonLevels + 1), "f.json"), FormatError);
  EXPECT_FALSE(is_taken(nested(kMostJsonLevels + 1)));
  EXPECT_FALSE(is_taken("{\"x\": " + std::string(1'000'000, '[')));
}

TEST(JsonScanner, CountsValuesToALimit) {
  const auto is_taken = [](std::size_t numbers) {
    std::string text(2 * numbers + 1, '0');
    for (std::size_t k = 0; k < text.size(); k += 2) text[k] = ',';
    text.front() = '[';
    text.back() = ']';
    return scanned(text,
                   [](JsonScanner& scanner) {
                     scanner.beginArray();
                     while (scanner.nextItem()) static_cast<void>(scanner.number());
                     return true;
                   })
        .has_value();
  };
  EXPECT_TRUE(is_taken(kMostScannedValues - 1)) << "with the array itself";
  EXPECT_FALSE(is_taken(kMostScannedValues));
}

}  // namespace
}  // namespace hexoderm
