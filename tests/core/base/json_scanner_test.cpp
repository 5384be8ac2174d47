#include "hexoderm/base/json_scanner.h"

#include "hexoderm/base/json_reader.h"
#include "hexoderm/base/text.h"
#include "tests/support/testing.h"

#include <bit>

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
  std::vector<std::string> texts = split(
      "0 -0 0.0 -0.0 1 -1 1e5 1E+5 1e-5 0e0 -0e0 1.25 0.1 5e-324 1e308 9007199254740993 18446744073709551615 "
      "18446744073709551616 -9223372036854775808 -9223372036854775809 123456789012345678901234567890 "
      "2.2250738585072011e-308 0.30000000000000004 1.00000000000000011102230246251565",
      ' ');
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
  EXPECT_NO_THROW(parseJson(nested(kMaxJsonLevels), "f.json"));
  EXPECT_TRUE(is_taken(nested(kMaxJsonLevels)));
  EXPECT_THROW(parseJson(nested(kMaxJsonLevels + 1), "f.json"), FormatError);
  EXPECT_FALSE(is_taken(nested(kMaxJsonLevels + 1)));
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
  EXPECT_TRUE(is_taken(kMaxScannedValues - 1)) << "with the array itself";
  EXPECT_FALSE(is_taken(kMaxScannedValues));
}

}  // namespace
}  // namespace hexoderm
