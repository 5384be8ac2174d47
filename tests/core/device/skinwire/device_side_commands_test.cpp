// How skinwire.h reads the commands of a host, and what is none, which comes over the same wire.

#include "tests/core/device/skinwire/commands_in_c.h"
#include "tests/core/device/skinwire/device_side_fixture.h"
#include "tests/core/device/skinwire/random_messages.h"
#include "tests/core/device/skinwire/wire_messages.h"

#include <variant>

namespace hexoderm::skinwire {
namespace {

struct Received {
  std::vector<skinwire_event> events;  ///< all but SKINWIRE_NOTHING
  std::vector<skinwire_command> commands;
};

Received receive(ByteView bytes, skinwire_framing framing, std::size_t capacity = SKINWIRE_COMMAND_SIZE) {
  // On the heap, where a sanitizer sees a byte beyond its end.
  Bytes buffer(capacity);
  buffer.shrink_to_fit();
  skinwire_receiver receiver = skinwire_receiver_in(buffer.data(), buffer.size(), framing);
  Received received;
  for (const std::uint8_t byte : bytes) {
    skinwire_command command{};
    const skinwire_event event = skinwire_receive(&receiver, byte, &command);
    if (event != SKINWIRE_NOTHING) received.events.push_back(event);
    if (event == SKINWIRE_COMMAND) received.commands.push_back(command);
  }
  return received;
}

TEST(DeviceSide, UnderstandsEveryCommandOfAHost) {
  RandomMessages random(5);
  for (int k = 0; k < 5000; ++k) {
    const Message message = random.command();
    for (const auto& [framing, encoder] : kFramings) {
      skinwire_command command{};
      if (!encoder) {
        const Bytes body = encodeBody(message);
        ASSERT_LE(body.size(), std::size_t{SKINWIRE_COMMAND_SIZE});
        ASSERT_EQ(skinwire_read_body(body.data(), body.size(), &command), SKINWIRE_COMMAND);
      } else {
        const Received received = receive(encodeFrame(*encoder, message), framing);
        ASSERT_EQ(received.events, std::vector{SKINWIRE_COMMAND}) << k;
        command = received.commands.front();
      }
      EXPECT_TRUE(isSame(command, std::get<Command>(message)));
    }
  }
}

constexpr std::uint8_t kCommand = 5;

skinwire_event eventOf(const Bytes& body, skinwire_command& command) {
  return skinwire_read_body(body.data(), body.size(), &command);
}

TEST(DeviceSide, ReadsWhatALaterVersionMaySend) {
  skinwire_command command{};
  // A request with the number 9; fields with unknown numbers of every kind, also within a request.
  EXPECT_EQ(eventOf(bodyOf(kCommand, {0x08, 7, 0x4A, 2, 1, 2}), command), SKINWIRE_COMMAND);
  EXPECT_EQ(command.number, 7U);
  EXPECT_EQ(command.request, SKINWIRE_UNKNOWN);
  EXPECT_EQ(eventOf(bodyOf(kCommand, {0x08, 7, 0x78, 0x96, 0x01, 0x79, 1,    2, 3, 4, 5, 6, 7, 8, 0x7D, 1, 2, 3, 4,  //
                                      0x1A, 6, 0x08, 5,    0x10, 9,    0x28, 1}),
                    command),
            SKINWIRE_COMMAND);
  EXPECT_EQ(command.request, SKINWIRE_SET_LED);
  EXPECT_EQ(command.of.set_led.cell, 5U);
  EXPECT_EQ(command.of.set_led.red, 9);
  EXPECT_EQ(eventOf(bodyOf(kCommand, {0x08, 7}, 2), command), SKINWIRE_SKIPPED) << "major version 2";
  EXPECT_EQ(eventOf(bodyOf(8, {0x08, 7}), command), SKINWIRE_SKIPPED) << "a message of type 8";
  EXPECT_EQ(eventOf(bodyOf(kCommand, {0x08}), command), SKINWIRE_BROKEN) << "a number that is cut off";
  EXPECT_EQ(eventOf(bodyOf(kCommand, {0x1A, 2, 0x08}), command), SKINWIRE_BROKEN) << "a request that is cut off";
  EXPECT_EQ(eventOf(bodyOf(kCommand, {0x1A, 3, 0x10, 0x80, 0x02}), command), SKINWIRE_BROKEN) << "red of 256";
  EXPECT_EQ(eventOf(bodyOf(kCommand, {0x22, 2, 0x08, 1}), command), SKINWIRE_BROKEN) << "a turn to nowhere";
}

TEST(DeviceSide, TakesTheLastOfSeveralRequestsAsProtobufDoes) {
  // Up is (0, 0, 1) in the frame of cell 9.
  Bytes turn = {0x22, 28, 0x08, 9, 0x12, 24};
  turn.resize(turn.size() + 22, 0);
  turn.insert(turn.end(), {0xF0, 0x3F});
  const Bytes light = {0x1A, 2, 0x08, 5};
  const Bytes more_light = {0x1A, 2, 0x10, 100};
  const auto expectAsTheLibrary = [](const std::vector<Bytes>& pieces) {
    Bytes payload = {0x08, 7};
    for (const Bytes& piece : pieces) payload.insert(payload.end(), piece.begin(), piece.end());
    const Bytes body = bodyOf(kCommand, payload);
    const Decoded decoded = decodeBody(body);
    ASSERT_EQ(decoded.outcome, DecodeOutcome::Understood) << decoded.reason();
    skinwire_command command{};
    ASSERT_EQ(eventOf(body, command), SKINWIRE_COMMAND);
    EXPECT_TRUE(isSame(command, std::get<Command>(decoded.message)));
  };
  expectAsTheLibrary({light, more_light});
  expectAsTheLibrary({turn, light});
  expectAsTheLibrary({turn, light, turn});
  expectAsTheLibrary({light, turn, more_light});
  expectAsTheLibrary({{0x32, 2, 0x08, 3}, light, {0x32, 0}});
}

TEST(DeviceSide, BelievesNoLengthThatReachesBeyondTheBody) {
  // With each number the CRC behind the payload is another one, and now and then looks like the field that is missing.
  for (std::uint8_t number = 1; number < 128; ++number) {
    for (const Bytes& request : {Bytes{0x32, 0, 0x08, 3}, Bytes{0x1A, 0, 0x08, 5}, Bytes{0x2A, 0}, Bytes{0x4A, 0}}) {
      for (const std::size_t too_much : {1, 2, 3, 4, 5, 100}) {
        Bytes payload = joined({{0x08, number}, request});
        payload.at(3) = static_cast<std::uint8_t>(request.size() - 2 + too_much);
        skinwire_command command{};
        ASSERT_EQ(eventOf(bodyOf(kCommand, payload), command), SKINWIRE_BROKEN) << testing::PrintToString(payload);
        payload.at(3) = static_cast<std::uint8_t>(request.size() - 2);
        ASSERT_EQ(eventOf(bodyOf(kCommand, payload), command), SKINWIRE_COMMAND);
      }
    }
  }
}

TEST(DeviceSide, FindsTheNextCommandAfterGarbage) {
  RandomMessages random(6);
  const Bytes good = encodeFrame(Framing::Cobs, Command{77, SetLed{3, 1, 2, 3}});
  for (int k = 0; k < 20'000; ++k) {
    const Received received = receive(joined({random.garbage(300), {0}, good}), SKINWIRE_COBS);
    ASSERT_FALSE(received.events.empty());
    ASSERT_EQ(received.events.back(), SKINWIRE_COMMAND) << k;
    EXPECT_TRUE(isSame(received.commands.back(), Command{77, SetLed{3, 1, 2, 3}}));
  }
}

TEST(DeviceSide, LeavesOutCommandsThatAreLongerThanItsBuffer) {
  const Message good = Command{77, ExploreAgain{}};
  Bytes long_payload = {0x08, 7, 0x4A, 100};
  long_payload.resize(long_payload.size() + 100, 1);
  const Bytes long_body = bodyOf(kCommand, long_payload);
  const Bytes cobs = joined({encodeCobs(long_body), {0}, encodeFrame(Framing::Cobs, good)});
  EXPECT_EQ(receive(cobs, SKINWIRE_COBS).events, (std::vector{SKINWIRE_BROKEN, SKINWIRE_COMMAND}));
  EXPECT_EQ(receive(cobs, SKINWIRE_COBS, 200).events, (std::vector{SKINWIRE_COMMAND, SKINWIRE_COMMAND}));

  const Bytes by_length =
      joined({{static_cast<std::uint8_t>(long_body.size()), 0, 0, 0}, long_body, encodeFrame(Framing::Length, good)});
  EXPECT_EQ(receive(by_length, SKINWIRE_LENGTH).events, (std::vector{SKINWIRE_BROKEN, SKINWIRE_COMMAND}));
}

TEST(DeviceSide, SaysThatAStreamWithLengthsIsLost) {
  const Bytes good = encodeFrame(Framing::Length, Command{77, ExploreAgain{}});
  Bytes bad = good;
  bad.at(6) ^= 1U;
  const Received received = receive(joined({bad, good}), SKINWIRE_LENGTH);
  ASSERT_FALSE(received.events.empty());
  for (const skinwire_event event : received.events) EXPECT_EQ(event, SKINWIRE_LOST);
  EXPECT_EQ(receive(Bytes{5, 0, 0, 0}, SKINWIRE_LENGTH).events, std::vector{SKINWIRE_LOST});
  EXPECT_EQ(receive(Bytes{1, 0, 16, 0}, SKINWIRE_LENGTH).events, std::vector{SKINWIRE_LOST});
}

}  // namespace
}  // namespace hexoderm::skinwire
