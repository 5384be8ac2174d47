#include "hexoderm/device/skinwire/codec.h"

#include "hexoderm/base/file.h"
#include "hexoderm/device/skinwire/crc32c.h"
#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/support/paths.h"
#include "tests/support/testing.h"

#include <sstream>

namespace hexoderm::skinwire {
namespace {

Bytes bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

TEST(Crc32c, HasThePublishedCheckValue) {
  EXPECT_EQ(crc32c(bytesOf("123456789")), 0xE3069283U);
  EXPECT_EQ(crc32cByTable(bytesOf("123456789")), 0xE3069283U);
  EXPECT_EQ(crc32c({}), 0U);
  EXPECT_EQ(crc32c(Bytes(32, 0)), 0x8A9136AAU);  // RFC 3720, B.4
}

TEST(Crc32c, IsTheSameByTableAndByInstructionForEveryLength) {
  Bytes bytes;
  for (std::uint32_t k = 0; k < 100; ++k) {
    EXPECT_EQ(crc32c(bytes), crc32cByTable(bytes)) << k;
    bytes.push_back(static_cast<std::uint8_t>(k * 37 + 11));
  }
}

TEST(SkinWireCodec, LinesOfEveryMessageReadBack) {
  for (const Message& message : everyMessage()) {
    const std::string line = encodeLine(message);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    for (const char* end : {"", "\r"}) {
      const Decoded decoded = decodeLine(line + end);
      ASSERT_EQ(decoded.outcome, DecodeOutcome::Understood) << line << decoded.reason();
      EXPECT_EQ(decoded.message, message) << line;
    }
  }
}

// The vectors were made with protoc --encode and a CRC-32C in Python, from the values in the .json files.
TEST(SkinWireCodec, TestVectorsDecodeAndEncodeAgain) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(HEXODERM_TEST_DATA "/skinwire")) {
    if (entry.path().extension() != ".hex") continue;
    ++count;
    Bytes body;
    std::istringstream digits(readFile(entry.path()));
    for (std::string byte; digits >> byte;) body.push_back(static_cast<std::uint8_t>(std::stoul(byte, nullptr, 16)));
    std::string line = readFile(std::filesystem::path(entry.path()).replace_extension(".json"));
    ASSERT_TRUE(line.ends_with('\n'));
    line.pop_back();

    const Decoded from_body = decodeBody(body);
    const Decoded from_line = decodeLine(line);
    ASSERT_EQ(from_body.outcome, DecodeOutcome::Understood) << entry.path() << from_body.reason();
    ASSERT_EQ(from_line.outcome, DecodeOutcome::Understood) << entry.path() << from_line.reason();
    EXPECT_EQ(from_body.message, from_line.message) << entry.path();
    EXPECT_EQ(encodeBody(from_line.message), body) << entry.path();
    EXPECT_EQ(encodeLine(from_body.message), line) << entry.path();
  }
  EXPECT_GE(count, 12);
}

TEST(SkinWireCodec, LineFieldsMayBeWrittenInEitherProtoSpellingAndTimesAsNumbers) {
  const Decoded decoded = decodeLine(
      R"({"samples": {"timeUs": 2000000, "cells": [1], "accelerationG": [0.25, -0.5, 0.75], "later_field": {"x": 1}}})");
  ASSERT_EQ(decoded.outcome, DecodeOutcome::Understood) << decoded.reason();
  EXPECT_EQ(decoded.message, Message(floatSamples()));
}

TEST(SkinWireCodec, EveryShortenedBodyIsBroken) {
  for (const Message& message : everyMessage()) {
    const Bytes good = encodeBody(message);
    for (std::size_t size = 0; size < good.size(); ++size) {
      EXPECT_EQ(decodeBody(ByteView(good).first(size)).outcome, DecodeOutcome::Broken) << size;
    }
  }
}

TEST(SkinWireCodec, SkipsTypesAndFieldsThatItDoesNotKnow) {
  EXPECT_EQ(decodeBody(bodyOf(99, {1, 2, 3})).outcome, DecodeOutcome::UnknownType);
  EXPECT_EQ(decodeBody(bodyOf(0, {})).outcome, DecodeOutcome::UnknownType);
  EXPECT_EQ(decodeLine(R"({"later_message": {"x": [1, 2]}})").outcome, DecodeOutcome::UnknownType);
  EXPECT_EQ(decodeLine("{}").outcome, DecodeOutcome::UnknownType);

  // Field 1000, a text, behind a Status.
  const Decoded decoded = decodeBody(bodyOf(4, {0x0A, 0x01, 'x', 0xC2, 0x3E, 0x02, 'h', 'i'}));
  ASSERT_EQ(decoded.outcome, DecodeOutcome::Understood) << decoded.reason();
  EXPECT_EQ(std::get<Status>(decoded.message).text, "x");
  EXPECT_EQ(decoded.reason().english(), "Status has no field with the number 1000");
}

TEST(SkinWireCodec, RefusesLinesThatAreNoMessages) {
  const std::string deep(100'000, '[');
  for (const std::string& line :
       {std::string("hello"), std::string("[1]"), std::string("{\"hello\": 3}"),
        std::string("{\"hello\": {\"rate_hz\": \"NaN\", \"cell_model\": \"m\"}}"),
        std::string("{\"samples\": {\"cells\": [-1]}}"), std::string("{\"samples\": {\"cells\": [4294967296]}}"),
        std::string("{\"samples\": {\"cells\": [1], \"acceleration_g\": [0, 0, 1e999]}}"), std::string("{\"samples\""),
        "{\"hello\": " + deep, std::string("\0\0\0", 3)}) {
    const Decoded decoded = decodeLine(line);
    EXPECT_EQ(decoded.outcome, DecodeOutcome::Broken) << line.substr(0, 80);
    EXPECT_FALSE(decoded.reason().empty());
    EXPECT_LT(decoded.reason().english().size(), 300U);
  }
}

TEST(SkinWireCodec, TellsOtherDialectsAndChecksumsFromNoise) {
  const auto kindOf = [](const Bytes& body) { return decodeBody(body).offences.at(0).kind; };
  const std::string line = encodeLine(helloMessage());
  EXPECT_EQ(kindOf(Bytes(line.begin(), line.end())), ProtocolViolationKind::WrongDialect);
  const Bytes good = encodeBody(helloMessage());
  EXPECT_EQ(kindOf(joined({{static_cast<std::uint8_t>(good.size()), 0, 0, 0}, good})),
            ProtocolViolationKind::WrongDialect);
  Bytes swapped = good;
  std::reverse(swapped.end() - 4, swapped.end());
  EXPECT_THAT(decodeBody(swapped).reason().english(), HasSubstr("big-endian"));
  Bytes noise = good;
  noise[5] ^= 1U;
  EXPECT_EQ(decodeBody(noise).reason().english(), "the CRC is wrong");
}

TEST(SkinWireCodec, ExcerptsAreShortAndPrintable) {
  const Decoded decoded = decodeLine("\x1b[31m" + std::string(100'000, '\x07'));
  ASSERT_FALSE(decoded.offences.empty());
  for (const ProtocolViolation& offence : decoded.offences) {
    EXPECT_LE(offence.excerpt.size(), 83U);
    EXPECT_EQ(offence.excerpt.substr(0, 12), "\\x1b[31m\\x07");
  }
  EXPECT_LT(decodeLine("{\"" + std::string(100'000, 'k') + "\": 1}").reason().english().size(), 300U);
}

TEST(SkinWireCodec, RefusesToSendWhatDoesNotFitAFrame) {
  Samples samples{.cells = {1}};
  samples.acceleration_g.assign(3 * 100'000, 1.5F);
  samples.period_us = 1000;
  EXPECT_TRUE(complaint(samples).empty());
  EXPECT_THROW(encodeBody(samples), InvalidArgument);
  EXPECT_THROW(encodeLine(samples), InvalidArgument);
}

// A message that has something wrong, and what must be said of it.
struct BadSamples {
  const char* what;
  std::function<void(Samples&)> spoil;
};

TEST(SkinWireCodec, RefusesSamplesThatMakeNoSense) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<BadSamples> bad_raw = {
      {"exactly one", [](Samples& s) { s.acceleration_g.assign(6, 0); }},
      {"exactly one", [](Samples& s) { s.raw_lsb.clear(); }},
      {"samples.cells: expected the IDs", [](Samples& s) { s.cells.clear(); }},
      {"multiple of 3", [](Samples& s) { s.raw_lsb.pop_back(); }},
      {"multiple of 3",
       [](Samples& s) {
         s.cells.insert(s.cells.end(), {9, 10, 11});
       }},
      {"belong to mean_g", [](Samples& s) { s.count.assign(2, 1); }},
      {"period_us", [](Samples& s) { s.period_us = 0; }},
      {"time_us", [](Samples& s) { s.time_us = kMaxTime_us; }},
      {"time_us", [](Samples& s) { s.time_us = UINT64_MAX; }},
      {"sequence", [](Samples& s) { s.sequence = UINT64_MAX; }},
      {"temperature_c", [](Samples& s) { s.temperature_c = {1}; }},
  };
  const std::vector<BadSamples> bad_means = {
      {"mean_g", [](Samples& s) { s.mean_g.pop_back(); }},
      {"variance_g2", [](Samples& s) { s.variance_g2.clear(); }},
      {"count", [](Samples& s) { s.count.pop_back(); }},
      {"count", [](Samples& s) { s.count[0] = 0; }},
      {"finite", [=](Samples& s) { s.mean_g[1] = kNan; }},
      {"finite", [](Samples& s) { s.variance_g2[1] = std::numeric_limits<float>::infinity(); }},
      {"at least 0", [](Samples& s) { s.variance_g2[0] = -1; }},
      {"temperature_c", [=](Samples& s) { s.temperature_c[0] = kNan; }},
  };
  const auto check = [](const Samples& good, const std::vector<BadSamples>& cases) {
    ASSERT_TRUE(complaint(good).empty());
    for (const BadSamples& bad : cases) {
      Samples samples = good;
      bad.spoil(samples);
      EXPECT_THAT(complaint(samples).reason.english(), HasSubstr(bad.what));
      EXPECT_THROW(encodeBody(samples), InvalidArgument);
    }
  };
  check(rawSamples(0, 1000), bad_raw);
  check(meanSamples(), bad_means);
}

TEST(SkinWireCodec, RefusesOtherMessagesThatMakeNoSense) {
  EXPECT_TRUE(complaint(Joints{0, {}, {1}}).empty());
  const std::vector<std::pair<Message, const char*>> messages = {
      {helloWith(&Hello::rate_hz, std::nan("")), "rate_hz"},
      {helloWith(&Hello::cell_model, std::string(65'537, '{')), "cell_model"},
      {helloWith(&Hello::cell_model, ""), "cell_model"},
      {helloWith(&Hello::device, std::string(1001, 'x')), "device"},
      {Topology{1, 2, 2, {}}, "part"},
      {Topology{1, 0, UINT32_MAX, {}}, "parts"},
      {Command{1, TurnTo{1, {0, 0, 2}}}, "unit vector"},
      {Command{1, SetRate{-5}}, "rate_hz"},
      {Ack{1, true, "", true}, "working"},
      {Joints{0, {}, {}}, "joints.position"},
      {Joints{0, {"a"}, {1, 2}}, "joints.position"},
      {Joints{0, {"a", "a"}, {1, 2}}, "each joint once"},
      {Joints{0, {""}, {1}}, "joints.names"},
      {Joints{0, {"a"}, {std::nan("")}}, "finite"},
      {Joints{kMaxTime_us + 1, {"a"}, {1}}, "2^53"},
  };
  for (const auto& [message, words] : messages) EXPECT_THAT(complaint(message).reason.english(), HasSubstr(words));
}

TEST(Codec, LetsTheLibraryBelowSayNothing) {
  testing::internal::CaptureStderr();
  const Bytes no_utf8 = {0x12, 0x02, 0xff, 0xfe};  // Hello.device
  EXPECT_EQ(decodeBody(bodyOf(1, no_utf8)).outcome, DecodeOutcome::Broken);
  decodeLine("{\"hello\": {\"device\": \"\xff\xfe\"}}");
  try {
    encodeBody(Hello{0, "\xff\xfe"});
    encodeLine(Hello{0, "\xff\xfe"});
  } catch (const InvalidArgument&) {  // a refusal is none of its words either
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace hexoderm::skinwire
