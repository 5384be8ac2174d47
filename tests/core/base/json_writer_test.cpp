#include "hexoderm/base/json_writer.h"

#include "tests/support/testing.h"

#include <nlohmann/json.hpp>

namespace hexoderm {
namespace {

using Json = nlohmann::ordered_json;

template <class Write>
std::string written(Write write) {
  std::string text;
  JsonWriter writer([&](std::string_view piece) { text += piece; });
  write(writer);
  writer.finish();
  return text;
}

bool isFlatArray(const Json& json) {
  return json.is_array() && std::ranges::none_of(json, [](const Json& item) { return item.is_structured(); });
}

bool isFlat(const Json& json) {
  return json.is_object() && std::ranges::all_of(json, [](const Json& item) {
           return !item.is_structured() || item.empty() || isFlatArray(item);
         });
}

std::string inOneLine(const Json& json) {
  if (!json.is_structured()) return json.dump();
  std::string text(1, json.is_object() ? '{' : '[');
  for (auto item = json.begin(); item != json.end(); ++item) {
    if (item != json.begin()) text += ", ";
    if (json.is_object()) text += Json(item.key()).dump() + ": ";
    text += inOneLine(*item);
  }
  return text + (json.is_object() ? '}' : ']');
}

/// The layout as it is meant, of a document that is looked at as often as it takes.
std::string laidOut(const Json& json, std::size_t indent = 0) {
  constexpr std::size_t kWidth = 120;
  const std::string line = inOneLine(json);
  if (!json.is_structured() || json.empty() || isFlatArray(json)) return line;
  if (isFlat(json) && indent + line.size() <= kWidth) return line;
  std::string text(1, json.is_object() ? '{' : '[');
  for (auto item = json.begin(); item != json.end(); ++item) {
    text += item == json.begin() ? "\n" : ",\n";
    text += std::string(indent + 1, ' ');
    if (json.is_object()) text += Json(item.key()).dump() + ": ";
    text += laidOut(*item, indent + 1);
  }
  return text + '\n' + std::string(indent, ' ') + (json.is_object() ? '}' : ']');
}

Json randomJson(std::mt19937& random, int depth) {
  const auto below = [&](int count) { return std::uniform_int_distribution(0, count - 1)(random); };
  const int kind = below(depth > 0 ? 9 : 6);
  if (kind == 0) return nullptr;
  if (kind == 1) return below(2) == 0;
  if (kind == 2) return below(100) - 50;
  if (kind == 3) return static_cast<unsigned>(below(1000));
  if (kind == 4) return (below(2'000'001) - 1'000'000) / 64.0;
  if (kind == 5) return std::string(static_cast<std::size_t>(below(30)), 'x') + (below(9) == 0 ? "\"ü\n" : "");
  Json json = kind == 6 ? Json::array() : kind == 7 ? Json::object() : Json::array();
  const int size = below(kind == 8 ? 3 : 8);
  for (int k = 0; k < size; ++k) {
    Json item = randomJson(random, kind == 8 ? 0 : depth - 1);
    if (json.is_array()) {
      json.push_back(std::move(item));
    } else {
      json["key " + std::to_string(k)] = std::move(item);
    }
  }
  return json;
}

TEST(JsonWriter, LaysOutAnyDocumentWithoutSeeingItFirst) {
  std::mt19937 random(1);
  std::size_t lines = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Json json = randomJson(random, 5);
    const std::string text = laidOut(json) + "\n";
    ASSERT_EQ(written([&](JsonWriter& writer) { writer.value(json); }), text);
    lines += static_cast<std::size_t>(std::ranges::count(text, '\n'));
  }
  EXPECT_GT(lines, 50'000U) << "the documents were large enough to say something";
}

TEST(JsonWriter, PutsAnObjectOnLinesThatIsOneCharacterTooLong) {
  for (std::size_t size = 80; size < 140; ++size) {
    for (const Json& json :
         {Json{{"a", std::string(size, 'x')}}, Json{{"a", 1}, {"b", std::string(size, 'x')}},
          Json{{"a", {{"b", std::string(size, 'x')}, {"c", Json::array()}}}},
          Json::array({Json{{"a", std::string(size, 'x')}, {"b", {1, 2}}, {"c", Json::object()}}})}) {
      ASSERT_EQ(written([&](JsonWriter& writer) { writer.value(json); }), laidOut(json) + "\n");
    }
  }
}

TEST(JsonWriter, WritesArraysOfNumbersAsItWritesTheirItems) {
  const std::vector<double> numbers = {1, -0.0, 0.1, 1e300, 5e-324};
  const auto at_once = [&](JsonWriter& writer) { writer.value(std::span<const double>(numbers)); };
  const auto one_by_one = [&](JsonWriter& writer) {
    writer.beginArray();
    for (const double number : numbers) writer.value(number);
    writer.endArray();
  };
  EXPECT_EQ(written(at_once), "[1.0, -0.0, 0.1, 1e+300, 5e-324]\n");
  EXPECT_EQ(written(one_by_one), written(at_once));
  const auto in_an_array = [&](JsonWriter& writer) {
    writer.beginArray();
    at_once(writer);
    one_by_one(writer);
    writer.endArray();
  };
  EXPECT_EQ(written(in_an_array), "[\n [1.0, -0.0, 0.1, 1e+300, 5e-324],\n [1.0, -0.0, 0.1, 1e+300, 5e-324]\n]\n");
}

TEST(JsonWriter, WritesNumbersThatReadBackAsTheSame) {
  for (const double number : {0.0, 0.1 + 0.2, 1.0 / 3, -5e-324, 1.7976931348623157e308, 123456789.0, 1e22}) {
    const nlohmann::json back = nlohmann::json::parse(written([&](JsonWriter& writer) { writer.value(number); }));
    EXPECT_TRUE(back.is_number_float()) << number;
    EXPECT_EQ(back.get<double>(), number);
  }
  EXPECT_EQ(written([](JsonWriter& writer) { writer.value(std::uint64_t{18'446'744'073'709'551'615U}); }),
            "18446744073709551615\n");
  EXPECT_EQ(written([](JsonWriter& writer) { writer.value(std::int64_t{-9'223'372'036'854'775'807}); }),
            "-9223372036854775807\n");
}

TEST(JsonWriter, WritesTextsAsNlohmannDoes) {
  for (const std::string text : {"", "plain", "\"quoted\"", "back\\slash", "line\nbreak", "\x01\x1f\x7f", "ümläut",
                                 "no UTF-8: \xff", "cut \xc3"}) {
    EXPECT_EQ(written([&](JsonWriter& writer) { writer.value(text); }),
              nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  }
}

TEST(JsonWriter, RefusesWhatIsNotFinite) {
  for (const double number : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(written([&](JsonWriter& writer) { writer.value(number); }), InvalidArgument);
    EXPECT_THROW(written([&](JsonWriter& writer) { writer.value(Eigen::Vector3d(0, number, 0)); }), InvalidArgument);
  }
}

TEST(JsonWriter, KeepsLittleOfALargeDocument) {
  std::size_t largest = 0;
  std::size_t whole = 0;
  JsonWriter writer([&](std::string_view piece) {
    largest = std::max(largest, piece.size());
    whole += piece.size();
  });
  writer.beginObject();
  writer.key("cells");
  writer.beginArray();
  for (unsigned k = 0; k < 50'000; ++k) {
    writer.beginObject();
    writer.member("id", k);
    writer.member("t_m", Eigen::Vector3d(0.1, 0.2, 0.3));
    writer.endObject();
  }
  writer.endArray();
  writer.endObject();
  writer.finish();
  EXPECT_GT(whole, 1'000'000U);
  EXPECT_LT(largest, 66'000U);
}

}  // namespace
}  // namespace hexoderm
