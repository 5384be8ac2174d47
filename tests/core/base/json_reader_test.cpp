#include "hexoderm/base/json_reader.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

/// The complaint of a reader of the value at key "k".
template <class Read>
std::string complaint(const std::string& value, Read read) {
  const JsonDocument document = parseJson("{\"k\": " + value + "}", "f.json");
  return messageOf<FormatError>([&] { static_cast<void>(read(JsonReader(document).at("k"))); });
}

TEST(ParseJson, SaysWhereTheTextIsNotJson) {
  const std::string message = messageOf<FormatError>([] { parseJson("{\"a\": 1,\n \"b\": [1, ?]}", "f.json"); });
  EXPECT_THAT(message, saysAll("f.json", "line 2, column 11", "at b[1]", "not JSON"));
}

TEST(ParseJson, SaysThatAFileIsTruncated) {
  EXPECT_THAT(messageOf<FormatError>([] { parseJson("{\"a\": {\"b\": [1, 2,", "f.json"); }),
              saysAll("f.json", "at a.b[2]", "ends in the middle"));
  EXPECT_THAT(messageOf<FormatError>([] { parseJson(" \n", "f.json"); }), saysAll("f.json", "empty"));
}

TEST(ParseJson, NamesTheKeyPathOfNumbersThatAreNotFinite) {
  for (const char* number : {"NaN", "nan", "Infinity", "-Infinity", "inf", "1e999", "-1e999"}) {
    const std::string text = "{\"a\": [{\"b\": 1}, {\"b\": " + std::string(number) + "}]}";
    EXPECT_THAT(messageOf<FormatError>([&] { parseJson(text, "f.json"); }),
                saysAll("f.json: a[1].b: expected a finite number", "found " + std::string(number)));
  }
}

TEST(ParseJson, RefusesAKeyThatIsThereTwiceAndSaysWhere) {
  EXPECT_THAT(messageOf<FormatError>([] { parseJson(R"({"a": 1, "a": 1})", "f.json"); }),
              saysAll("f.json: a: is there twice, expected each key once"));
  EXPECT_THAT(
      messageOf<FormatError>([] { parseJson(R"({"c": [{"x": {}}, {"x": {"y": [], "z": 2, "y": 3}}]})", "f.json"); }),
      saysAll("f.json: c[1].x.y: is there twice"));
  EXPECT_THAT(messageOf<FormatError>([] { parseJson(R"({"x": 1, "\u0078": 2})", "f.json"); }),
              saysAll("x: is there twice"));
  EXPECT_NO_THROW(parseJson(R"({"a": {"a": {"a": 1}}, "b": [{"a": 1}, {"a": 1}]})", "f.json"));
}

TEST(ParseJson, GivesTheValuesOfTheLibrarysOwnParser) {
  for (const char* text :
       {"null", "true", "-3", "18446744073709551615", "1.5", "\"x\"", "[]", "{}", "[[], {}, [1, [2]], {\"a\": {}}]",
        R"({"b": [1, -2, 3.5, null, false, "t"], "a": {"c": {"d": []}, "e": ""}})"}) {
    EXPECT_EQ(parseJson(text, "f.json").root, nlohmann::json::parse(text)) << text;
  }
}

TEST(ParseJson, ReadsToALimitOfLevelsAndValues) {
  const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  EXPECT_NO_THROW(parseJson(nested(kMaxJsonLevels), "f.json"));
  EXPECT_THAT(messageOf<FormatError>([&] { parseJson(nested(kMaxJsonLevels + 1), "f.json"); }),
              saysAll("f.json: [0][0]", "nested too deeply, at most 100 levels"));
  EXPECT_THROW(parseJson(std::string(1'000'000, '['), "f.json"), FormatError);
  EXPECT_NO_THROW(parseJson("[1, {\"a\": 2}]", "f.json", 4));
  EXPECT_THAT(messageOf<FormatError>([] { parseJson("[1, {\"a\": 2}]", "f.json", 3); }),
              saysAll("f.json: [1].a: the file has too many values, at most 3 are read"));
}

TEST(ParseJson, SaysNoMoreOfAKeyThanAPersonReads) {
  const std::string text = "{\"" + std::string(100'000, 'k') + "\": ?}";
  EXPECT_LT(messageOf<FormatError>([&] { parseJson(text, "f.json"); }).size(), 300U);
}

TEST(FindJsonFormat, GoesNoDeeperThanDocumentsDo) {
  EXPECT_EQ(findJsonFormat("{\"a\": " + std::string(1'000'000, '[')), std::nullopt);
}

TEST(FindJsonFormat, FindsTheTopLevelKeyOnly) {
  EXPECT_EQ(findJsonFormat(R"({"a": {"format": "inner"}, "format": "outer", "b": )"), "outer");
  EXPECT_EQ(findJsonFormat(R"({"a": {"format": "inner"}})"), std::nullopt);
  EXPECT_EQ(findJsonFormat(R"({"format": 1})"), std::nullopt);
  EXPECT_EQ(findJsonFormat("nonsense"), std::nullopt);
  EXPECT_EQ(findJsonFormat(""), std::nullopt);
}

TEST(JsonReader, NamesTheKeyPathOfAMissingKey) {
  EXPECT_THAT(complaint(R"([{"x": 1}])", [](const JsonReader& k) { return k.items().at(0).at("y"); }),
              saysAll("f.json: k[0].y", "missing"));
  EXPECT_THAT(
      complaint(R"([[], [1, {"x": {"y": [2, null]}}]])",
                [](const JsonReader& k) { return k.items()[1].items()[1].at("x").at("y").items()[1].number(); }),
      saysAll("f.json: k[1][1].x.y[1]: expected a number, found null"));
  EXPECT_THAT(complaint("3", [](const JsonReader& k) { return k.at("y"); }),
              saysAll("k", "expected an object, found 3"));
}

TEST(JsonReader, TakesNullForAbsent) {
  const JsonDocument document = parseJson(R"({"a": null, "b": 2})", "f.json");
  const JsonReader reader(document);
  EXPECT_FALSE(reader.find("a").has_value());
  EXPECT_FALSE(reader.find("c").has_value());
  ASSERT_TRUE(reader.find("b").has_value());
  EXPECT_EQ(reader.find("b")->number(), 2);
}

TEST(JsonReader, ChecksNumbers) {
  EXPECT_THAT(complaint("\"1\"", [](const JsonReader& k) { return k.number(); }),
              saysAll("k: expected a number", "\"1\""));
  EXPECT_THAT(complaint("0", [](const JsonReader& k) { return k.positiveNumber(); }),
              saysAll("k: expected a number above 0"));
  EXPECT_THAT(complaint("-0.5", [](const JsonReader& k) { return k.nonNegativeNumber(); }),
              saysAll("at least 0, found -0.5"));
  EXPECT_THAT(complaint("true", [](const JsonReader& k) { return k.number(); }), saysAll("k: expected a number"));
}

TEST(JsonReader, ChecksWholeNumbers) {
  for (const char* value :
       {"-1", "4294967296", "1.0", "1.5", "\"1\"", "18446744073709551615", "99999999999999999999"}) {
    EXPECT_THAT(complaint(value, [](const JsonReader& k) { return k.unsignedInteger(); }),
                saysAll("f.json: k: expected a whole number from 0 to 4294967295"))
        << value;
  }
  EXPECT_THAT(complaint("0", [](const JsonReader& k) { return k.unsignedInteger(1, 7); }),
              saysAll("from 1 to 7, found 0"));
  EXPECT_EQ(JsonReader(parseJson("4294967295", "f.json")).unsignedInteger(), 4294967295U);
}

TEST(JsonReader, RefusesWhatIsNoRotation) {
  const auto rotation = [](const JsonReader& k) { return k.rotation(); };
  EXPECT_THAT(complaint("[1,0,0, 0,1,0, 0,0,1.001]", rotation), saysAll("k: expected a rotation matrix"));
  EXPECT_THAT(complaint("[1,0,0, 0,1,0, 0,0,-1]", rotation), saysAll("k: expected a rotation matrix"));
  EXPECT_THAT(complaint("[1e200,0,0, 0,1,0, 0,0,1]", rotation), saysAll("k: expected a rotation matrix"));
  EXPECT_THAT(complaint("[1, 1, 0, 0]", [](const JsonReader& k) { return k.unitQuaternion(); }),
              saysAll("unit quaternion"));
}

TEST(JsonReader, ReadsMatricesRowByRow) {
  const Eigen::Matrix3d R = JsonReader(parseJson("[0,-1,0, 1,0,0, 0,0,1]", "f.json")).rotation();
  EXPECT_EQ(R * Eigen::Vector3d::UnitX(), Eigen::Vector3d(Eigen::Vector3d::UnitY()));
}

TEST(RequireFormat, WantsFormatAndVersion) {
  const auto require = [](const char* text) {
    return messageOf<FormatError>([&] { JsonReader(parseJson(text, "f.json")).requireFormat("hexoderm-x", 1); });
  };
  EXPECT_THAT(require("{}"), saysAll("format: expected \"hexoderm-x\"", "there is none"));
  EXPECT_THAT(require(R"({"format": "hexoderm-x"})"), saysAll("version: is missing"));
  EXPECT_THAT(require(R"({"format": "hexoderm-x", "version": "1"})"), saysAll("version: expected a whole number"));
  EXPECT_THAT(require(R"({"format": "hexoderm-x", "version": 0})"), saysAll("version: expected a whole number"));
  EXPECT_THAT(require("[]"), saysAll("top level: expected an object"));
}

TEST(QuaternionWxyz, HasANonNegativeW) {
  // Three quarters of a turn about z: the same as a quarter backwards.
  const Eigen::Matrix3d R = Eigen::AngleAxisd(4.71238898038469, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const std::array<double, 4> q = quaternionWxyz(R);
  EXPECT_NEAR(q[0], 0.70710678118654757, 1e-15);
  EXPECT_NEAR(q[3], -0.70710678118654757, 1e-15);
}

}  // namespace
}  // namespace hexoderm
