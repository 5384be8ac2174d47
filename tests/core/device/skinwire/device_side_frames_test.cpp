// The frames that skinwire.h, the device's side in C, makes, against the library, which is the host's side.

#include "tests/core/device/skinwire/device_side_fixture.h"
#include "tests/core/device/skinwire/random_messages.h"
#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/support/slow_build.h"

namespace hexoderm::skinwire {
namespace {

TEST(DeviceSide, MakesTheSameBytesAsTheHost) {
  for (const Message& message : everyMessage()) {
    if (std::holds_alternative<Command>(message)) continue;
    EXPECT_EQ(framed(message, SKINWIRE_DATAGRAM), encodeBody(message)) << "kind " << message.index();
    EXPECT_EQ(framed(message, SKINWIRE_COBS), encodeFrame(Framing::Cobs, message)) << "kind " << message.index();
    EXPECT_EQ(framed(message, SKINWIRE_LENGTH), encodeFrame(Framing::Length, message)) << "kind " << message.index();
  }
}

TEST(DeviceSide, RandomMessagesAreDecodedToTheSameValuesAndWrongOnesNotSent) {
  RandomMessages random(1);
  int sent = 0;
  int refused = 0;
  constexpr int kMessages = test::kSlowBuild ? 1000 : 20'000;
  for (int k = 0; k < kMessages; ++k) {
    const Message message = random.device();
    const auto [framing, decoder] = kFramings.at(random.upTo(2));
    const Bytes frame = framed(message, framing);
    const ValidationError why = complaint(message);
    const bool is_too_long = why.empty() && framing == SKINWIRE_DATAGRAM && encodeBody(message).size() > kMaxDatagram;
    ASSERT_EQ(frame.empty(), !why.empty() || is_too_long) << k << ", kind " << message.index() << ": " << why.reason;
    ++(frame.empty() ? refused : sent);
    if (frame.empty()) continue;
    const Decoded decoded = decodeFrame(frame, decoder);
    ASSERT_EQ(decoded.outcome, DecodeOutcome::Understood) << k << ": " << decoded.reason();
    ASSERT_EQ(decoded.message, message) << k << ", kind " << message.index();
    ASSERT_TRUE(decoded.offences.empty()) << k << ": " << decoded.reason();
  }
  EXPECT_GT(sent, 3 * kMessages / 4);
  EXPECT_GT(refused, kMessages / 20);
}

TEST(DeviceSide, ABufferThatIsTooSmallIsNeverOverrun) {
  RandomMessages random(2);
  for (int k = 0; k < 300; ++k) {
    const Message message = random.device();
    const auto [framing, decoder] = kFramings.at(random.upTo(2));
    const Bytes whole = framed(message, framing);
    if (whole.empty()) continue;
    EXPECT_EQ(framed(message, framing, whole.size()), whole);
    for (std::size_t capacity = 0; capacity < whole.size(); capacity += 1 + random.upTo(whole.size() / 20)) {
      constexpr std::uint8_t kGuard = 0xA5;
      Bytes bytes(capacity + 8, kGuard);
      skinwire_frame frame = skinwire_frame_in(bytes.data(), capacity, framing);
      ASSERT_EQ(put(frame, message), 0U) << capacity << " of " << whole.size();
      ASSERT_EQ(frame.fault, SKINWIRE_NO_ROOM);
      ASSERT_EQ(Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(capacity), bytes.end()), Bytes(8, kGuard));
    }
  }
}

TEST(DeviceSide, BlocksOfCobsEndWhereTheHostEndsThem) {
  for (std::size_t size = 1; size <= 1000; ++size) {
    const Message status = Status{std::string(size, 'x'), false, 0, 0};
    ASSERT_EQ(framed(status), encodeFrame(Framing::Cobs, status)) << size;
  }
}

/// One cell, many ticks, in a body of so many bytes.
Samples samplesOfBody(std::size_t size) {
  Samples samples{.period_us = 1, .cells = {1}};
  samples.raw_lsb.assign(size / 3 * 3 - 60, 0);
  const std::size_t missing = size - encodeBody(samples).size();
  samples.raw_lsb.resize(samples.raw_lsb.size() + missing / 3 * 3, 0);
  // A value of two bytes in place of one.
  for (std::size_t k = 0; encodeBody(samples).size() < size; ++k) samples.raw_lsb.at(k) = 100;
  EXPECT_EQ(encodeBody(samples).size(), size);
  return samples;
}

TEST(DeviceSide, TheLongestFramesArriveAndLongerOnesAreRefused) {
  for (const auto& [framing, decoder] : kFramings) {
    const std::size_t longest = framing == SKINWIRE_DATAGRAM ? kMaxDatagram : kMaxBody;
    Samples samples = samplesOfBody(longest);
    const Bytes frame = framed(samples, framing, SKINWIRE_FRAME_SIZE(longest));
    ASSERT_FALSE(frame.empty());
    const Decoded decoded = decodeFrame(frame, decoder);
    ASSERT_EQ(decoded.outcome, DecodeOutcome::Understood) << decoded.reason();
    EXPECT_EQ(decoded.message, Message(samples));
    samples.raw_lsb.back() = 100;
    EXPECT_TRUE(framed(samples, framing, 2 * longest).empty());
  }
}

TEST(DeviceSide, BuffersOfTheStatedSizesAreEnoughAtWorst) {
  for (const std::size_t cells : {1, 7, 100}) {
    for (const std::size_t ticks : {1, 5, 50}) {
      Samples raw{.sequence = kMaxTime_us, .time_us = kMaxTime_us / 2, .period_us = UINT32_MAX};
      raw.cells.assign(cells, UINT32_MAX);
      raw.raw_lsb.assign(3 * cells * ticks, INT16_MIN);
      EXPECT_FALSE(framed(raw, SKINWIRE_COBS, SKINWIRE_FRAME_SIZE(SKINWIRE_RAW_BODY(cells, ticks))).empty());
    }
    Samples means{.sequence = kMaxTime_us, .time_us = kMaxTime_us, .period_us = UINT32_MAX};
    means.cells.assign(cells, UINT32_MAX);
    means.mean_g.assign(3 * cells, 1.7F);
    means.variance_g2.assign(3 * cells, 1.7F);
    means.count.assign(cells, UINT32_MAX);
    EXPECT_FALSE(framed(means, SKINWIRE_LENGTH, SKINWIRE_FRAME_SIZE(SKINWIRE_MEANS_BODY(cells))).empty());
  }
}

}  // namespace
}  // namespace hexoderm::skinwire
