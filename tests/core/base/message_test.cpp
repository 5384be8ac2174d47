#include "hexoderm/base/message.h"
#include "hexoderm/base/message_json.h"
#include "hexoderm/base/system_reason.h"
#include "hexoderm/base/units.h"
#include "tests/support/testing.h"

#include <cerrno>
#include <new>
#include <stdexcept>
#include <system_error>

namespace hexoderm {
namespace {

Message everyKind() {
  return message("{} of {}: {}, {}, {}, {}, {}, {}; {}; {}", CellId(7), 100000U, Number{-1.25, 1}, Number{1e-6},
                 Degrees{0.4 * kDegree}, Millimetres{0.0012}, MilliG{-0.0444}, Seconds{0.5, 2},
                 std::vector{CellId(1), CellId(2), CellId(3)}, message("joins {} and {}", "hand", std::string("arm")));
}
constexpr char kEveryKind[] = "7 of 100000: -1.2, 1e-06, 0.4°, 1.2 mm, -44 mg, 0.50 s; 1, 2 and 3; joins hand and arm";

TEST(Message, SaysEveryKindOfArgument) { EXPECT_EQ(everyKind().english(), kEveryKind); }

TEST(Message, WithoutWordsIsEmpty) {
  EXPECT_TRUE(Message().empty());
  EXPECT_EQ(Message().english(), "");
  EXPECT_TRUE(Message::verbatim("").empty());
  EXPECT_TRUE(inRow({}).empty());
}

TEST(Message, TakesAVerbatimTextAsItIs) {
  const Message text = Message::verbatim("a {0} {b} }{");
  EXPECT_EQ(text.english(), "a {0} {b} }{");
  EXPECT_TRUE(text.isVerbatim());
  EXPECT_FALSE(message("a").isVerbatim());
}

TEST(Message, IsAValue) {
  EXPECT_EQ(everyKind(), everyKind());
  EXPECT_NE(message("cell {}", CellId(7)), message("cell {}", CellId(8)));
  EXPECT_NE(message("cell {}", 7), message("pose {}", 7));
  EXPECT_NE(message("{}", Number{1, 1}), message("{}", Number{1, 2})) << "said with another precision";
  EXPECT_NE(message("a"), Message::verbatim("a")) << "one is translated, the other is not";
}

TEST(Message, StandsInARowWithOthers) {
  const Message row = inRow({message("One."), Message(), message("Two {}.", 3)});
  EXPECT_EQ(row.english(), "One. Two 3.");
  EXPECT_EQ(inRow({message("1 cell"), message("{} links", 2)}, ", ").english(), "1 cell, 2 links");
  EXPECT_EQ(inRow({Message(), message("One.")}), message("One.")) << "a row of one is that one";
  EXPECT_EQ(located("a.json", message("is missing")).english(), "a.json: is missing");
}

TEST(Message, ListsItems) {
  const auto listed = [](std::vector<CellId> cells) { return message("cells {}", cells).english(); };
  EXPECT_EQ(listed({}), "cells ");
  EXPECT_EQ(listed({CellId(1)}), "cells 1");
  EXPECT_EQ(listed({CellId(1), CellId(2)}), "cells 1 and 2");
}

TEST(Message, OfALongListTheFirstItemsAreSaidAndAllAreKept) {
  std::vector<CellId> cells;
  for (std::uint32_t id = 1; id <= 24; ++id) cells.emplace_back(id);
  EXPECT_THAT(message("{}", cells).english(), ::testing::EndsWith("22, 23 and 24"));
  for (std::uint32_t id = 25; id <= 400; ++id) cells.emplace_back(id);
  const Message many = message("{}", cells);
  EXPECT_THAT(many.english(), ::testing::StartsWith("1, 2, 3"));
  EXPECT_THAT(many.english(), ::testing::EndsWith("18, 19, 20 and 380 others"));
  EXPECT_EQ(std::get<MessageArgument::List>(many.arguments().front().value).size(), 400U);
}

TEST(Template, HasAPlaceholderForEachArgument) {
  EXPECT_TRUE(isTemplate("", 0));
  EXPECT_TRUE(isTemplate("{} {}", 2));
  EXPECT_TRUE(isTemplate("{1} {0} {1}", 2));
  EXPECT_TRUE(isTemplate("{{}} {}", 1));
  for (const char* bad : {"", "{", "}", "{} {}", "{0} {}", "{1}", "{:d}", "{x}", "{99999}", "{0", "{}}"}) {
    EXPECT_FALSE(isTemplate(bad, 1)) << bad;
    EXPECT_THROW(fillTemplate(bad, std::vector<std::string>{"a"}), std::logic_error) << bad;
  }
}

TEST(Template, OfATranslationMayReorder) {
  EXPECT_EQ(fillTemplate("{1} vor {0}", std::vector<std::string>{"a", "b"}), "b vor a");
}

/// An object with the message as its text, as files have it.
nlohmann::json documentOf(const Message& said) {
  std::string text;
  JsonWriter writer([&](std::string_view piece) { text += piece; });
  writer.beginObject();
  writeMessage(writer, "text", said);
  writer.endObject();
  writer.finish();
  return nlohmann::json::parse(text);
}

TEST(MessageJson, ComesBackAsItWas) {
  for (const Message& said : {everyKind(), message("plain"), inRow({message("One."), message("Two {}.", 3)})}) {
    const nlohmann::json document = documentOf(said);
    EXPECT_EQ(document.at("text"), said.english());
    EXPECT_EQ(readMessage(JsonReader({document, "a.json"}), "text"), said) << document;
  }
}

TEST(MessageJson, HasOnlyTheTextOfAVerbatimMessage) {
  const nlohmann::json document = documentOf(Message::verbatim("a name"));
  EXPECT_EQ(document.dump(), R"({"text":"a name"})");
  EXPECT_EQ(readMessage(JsonReader({document, "a.json"}), "text"), Message::verbatim("a name"));
}

TEST(MessageJson, SaysANumberThatJsonDoesNotHave) {
  const auto document = documentOf(message("misfit {}", Number{std::numeric_limits<double>::infinity(), 1}));
  EXPECT_EQ(readMessage(JsonReader({document, "a.json"}), "text").english(), "misfit inf");
}

TEST(MessageJson, TheTextCountsWhereSomebodyEditedIt) {
  nlohmann::json document = documentOf(message("cell {}", 7));
  document["text"] = "my own words";
  EXPECT_EQ(readMessage(JsonReader({document, "a.json"}), "text"), Message::verbatim("my own words"));
}

TEST(MessageJson, MalformedIsAFormatErrorThatNamesThePlace) {
  const auto refused = [](const std::string& whole) {
    const nlohmann::json json = nlohmann::json::parse(R"({"text": "cell 7", "text_message": )" + whole + "}");
    return test::messageOf<FormatError>([&] { readMessage(JsonReader({json, "a.json"}), "text"); });
  };
  EXPECT_THAT(refused("5"), HasSubstr("a.json: text_message: expected an object"));
  EXPECT_THAT(refused(R"({"arguments": []})"), HasSubstr("template: is missing"));
  EXPECT_THAT(refused(R"({"template": "cell {}", "arguments": []})"), HasSubstr("expected a text with a {}"));
  EXPECT_THAT(refused(R"({"template": "cell {", "arguments": [7]})"), HasSubstr("expected a text with a {}"));
  EXPECT_THAT(refused(R"({"template": "cell {}", "arguments": 7})"), HasSubstr("expected an array"));
  EXPECT_THAT(refused(R"({"template": "cell {}", "arguments": [true]})"), HasSubstr("arguments[0]"));
  for (const std::string unit : {"ft", "none", ""}) {
    EXPECT_THAT(refused(R"({"template": "{}", "arguments": [{"value": 1, "unit": ")" + unit + "\"}]}"),
                HasSubstr("unit"));
  }
  EXPECT_THAT(refused(R"({"template": "{}", "arguments": [{"value": 1, "decimals": 99}]})"), HasSubstr("decimals"));
  std::string deep = "1";
  for (int k = 0; k < 50; ++k) deep = "[" + deep + "]";
  EXPECT_THAT(refused(R"({"template": "{}", "arguments": [)" + deep + "]}"), HasSubstr("depth"));
}

TEST(Error, CarriesItsMessage) {
  const FormatError error(located("a.json", message("is missing")));
  EXPECT_STREQ(error.what(), "a.json: is missing");
  EXPECT_EQ(error.message(), located("a.json", message("is missing")));
  EXPECT_EQ(hexoderm::messageOf(error), error.message());
  EXPECT_EQ(hexoderm::messageOf(std::bad_alloc()), Message::verbatim(std::bad_alloc().what()));
  EXPECT_EQ(InvalidArgument("foreign {}").message(), Message::verbatim("foreign {}"));
}

TEST(SystemReason, IsTheSystemsOwnWords) {
  for (const int number : {ENOENT, EACCES, EROFS, ENOSPC, EISDIR, ENOTDIR, EIO, ENODEV, EBUSY, ECONNREFUSED, ECONNRESET,
                           ETIMEDOUT, EHOSTUNREACH, ENETUNREACH, E2BIG}) {
    EXPECT_EQ(systemReason(number).english(), std::generic_category().message(number));
  }
  EXPECT_FALSE(systemReason(ENOENT).isVerbatim()) << "people meet it, so it has a translation";
  EXPECT_TRUE(systemReason(E2BIG).isVerbatim());
  EXPECT_EQ(systemReason(std::make_error_code(std::errc::no_such_file_or_directory)), systemReason(ENOENT));
}

}  // namespace
}  // namespace hexoderm
