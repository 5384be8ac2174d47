#include "hexoderm/device/skinwire/framing.h"

#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/support/testing.h"

namespace hexoderm::skinwire {
namespace {

constexpr Framing kFramings[] = {Framing::Length, Framing::Cobs, Framing::Lines};

Bytes asBytes(std::string_view text) { return {text.begin(), text.end()}; }

Bytes encodeFrames(Framing framing, const std::vector<Message>& messages) {
  Bytes stream;
  for (const Message& message : messages) stream = joined({stream, encodeFrame(framing, message)});
  return stream;
}

struct Outcome {
  std::vector<Message> messages;
  int broken = 0;
};

void drain(FrameDecoder& decoder, Outcome& outcome) {
  while (auto decoded = decoder.next()) {
    if (decoded->outcome == DecodeOutcome::Understood) {
      outcome.messages.push_back(std::move(decoded->message));
    } else {
      ++outcome.broken;
    }
  }
}

Outcome decodeAll(FrameDecoder& decoder, ByteView stream, std::size_t piece) {
  Outcome outcome;
  for (std::size_t k = 0; k < stream.size(); k += piece) {
    decoder.feed(stream.subspan(k, std::min(piece, stream.size() - k)));
    drain(decoder, outcome);
  }
  return outcome;
}

TEST(Cobs, ReadsBackBytesOfEveryLengthAroundABlock) {
  for (const std::size_t zero_every : {0U, 1U, 2U, 7U, 254U, 255U}) {
    for (std::size_t size = 0; size < 800; ++size) {
      Bytes bytes(size);
      for (std::size_t k = 0; k < size; ++k) {
        bytes[k] = zero_every != 0 && k % zero_every == 0 ? 0 : static_cast<std::uint8_t>(1 + k % 255);
      }
      const Bytes coded = encodeCobs(bytes);
      ASSERT_EQ(std::ranges::count(coded, 0), 0);
      ASSERT_LE(coded.size(), bytes.size() + bytes.size() / 254 + 1);
      const std::optional<Bytes> back = decodeCobs(coded);
      ASSERT_TRUE(back.has_value());
      ASSERT_EQ(*back, bytes) << size << " bytes, zero every " << zero_every;
    }
  }
}

TEST(Cobs, HasThePublishedExamples) {
  // Cheshire and Baker, "Consistent Overhead Byte Stuffing", and the common ones.
  EXPECT_EQ(encodeCobs(Bytes{}), (Bytes{1}));
  EXPECT_EQ(encodeCobs(Bytes{0}), (Bytes{1, 1}));
  EXPECT_EQ(encodeCobs(Bytes{0, 0}), (Bytes{1, 1, 1}));
  EXPECT_EQ(encodeCobs(Bytes{0x11, 0x22, 0, 0x33}), (Bytes{3, 0x11, 0x22, 2, 0x33}));
  EXPECT_EQ(encodeCobs(Bytes{0x11, 0, 0, 0}), (Bytes{2, 0x11, 1, 1, 1}));
}

TEST(Cobs, RefusesWhatNoEncoderWrites) {
  EXPECT_FALSE(decodeCobs(Bytes{5, 1, 2}).has_value());
  EXPECT_FALSE(decodeCobs(Bytes{0}).has_value());
  EXPECT_FALSE(decodeCobs(Bytes{3, 0, 1}).has_value());
}

TEST(FrameDecoder, ReadsEveryFramingInPiecesOfAnySize) {
  for (const Framing framing : kFramings) {
    const Bytes stream = encodeFrames(framing, everyMessage());
    for (const std::size_t piece : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{64}, stream.size()}) {
      FrameDecoder decoder(framing);
      const Outcome outcome = decodeAll(decoder, stream, piece);
      EXPECT_EQ(outcome.messages, everyMessage()) << piece;
      EXPECT_EQ(outcome.broken, 0);
      EXPECT_EQ(decoder.buffered(), 0U);
    }
  }
}

TEST(FrameDecoder, ALengthThatBeginsLikeALineIsStillALength) {
  // '{' is 0x7B = 123: a device name makes the frame just that long.
  const std::size_t shorter = encodeBody(helloWith(&Hello::device, "")).size() + 2;
  const Hello hello = helloWith(&Hello::device, std::string('{' - shorter, 'x'));
  const Bytes frame = encodeFrame(Framing::Length, hello);
  ASSERT_EQ(frame[0], '{');
  FrameDecoder decoder(std::nullopt);
  EXPECT_EQ(decodeAll(decoder, frame, 1).messages, std::vector<Message>{hello});
  EXPECT_EQ(decoder.framing(), Framing::Length);
}

TEST(FrameDecoder, NoFlippedBitLetsAWrongMessageThrough) {
  const Bytes before = encodeBody(Status{"before", false, 0, 0});
  for (const Framing framing : {Framing::Length, Framing::Cobs}) {
    const std::vector<Message> sent = {rawSamples(0, 1000), meanSamples(), helloMessage()};
    const Bytes good = encodeFrames(framing, sent);
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
      Bytes bad = good;
      bad[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
      FrameDecoder decoder(framing);
      const Outcome outcome = decodeAll(decoder, bad, bad.size());
      EXPECT_LT(outcome.messages.size(), sent.size()) << bit;
      for (const Message& message : outcome.messages) {
        EXPECT_TRUE(std::ranges::find(sent, message) != sent.end()) << bit;
      }
      // A broken length is noticed at the latest when the frame that it announces should be over.
      EXPECT_TRUE(outcome.broken > 0 || decoder.buffered() > 0) << bit;
    }
  }
}

TEST(FrameDecoder, RecognizesTheFramingOfASerialPortOnTcp) {
  const Bytes stream =
      joined({{0}, encodeFrames(Framing::Cobs, {helloMessage(), rawSamples(0, 1000), rawSamples(4, 2000)})});
  std::size_t said = 0;
  for (std::size_t begin = 0; begin + 60 < stream.size(); ++begin) {  // a bridge begins anywhere
    SCOPED_TRACE(begin);
    FrameDecoder decoder(std::nullopt);
    decoder.feed(ByteView(stream).subspan(begin));
    std::optional<ProtocolViolation> offence;
    while (const auto decoded = decoder.next()) {
      if (!decoded->offences.empty()) offence = decoded->offences.front();
    }
    if (const auto waiting = decoder.complaintOfWaiting()) offence = waiting;
    EXPECT_FALSE(offence && offence->reason.english().find("big-endian") != std::string::npos);
    if (!offence || offence->reason.english().find("serial port (COBS)") == std::string::npos) continue;
    EXPECT_EQ(offence->kind, ProtocolViolationKind::WrongDialect);
    ++said;
  }
  EXPECT_GT(said, (stream.size() - 60) * 9 / 10);
}

TEST(FrameDecoder, GoesOnAtTheNextLineAfterABrokenOne) {
  FrameDecoder decoder(Framing::Lines);
  const Bytes broken = asBytes("{\"hello\": oops}\n\n   \r\nwhat is this\n");
  const Outcome outcome = decodeAll(decoder, joined({broken, encodeFrame(Framing::Lines, helloMessage())}), 5);
  EXPECT_EQ(outcome.messages, std::vector<Message>{helloMessage()});
  EXPECT_EQ(outcome.broken, 2);
}

TEST(FrameDecoder, SkipsWhatIsTooLongAndHoldsNoMoreThanALimit) {
  for (const Framing framing : {Framing::Cobs, Framing::Lines}) {
    FrameDecoder decoder(framing);
    Outcome outcome;
    const Bytes piece(100'000, '1');
    for (int k = 0; k < 50; ++k) {
      decoder.feed(piece);
      drain(decoder, outcome);
      ASSERT_LE(decoder.buffered(), kMaxBody + kMaxBody / 254 + 1 + piece.size());
    }
    EXPECT_EQ(outcome.broken, 1);
    const Bytes end = {static_cast<std::uint8_t>(framing == Framing::Lines ? '\n' : 0)};
    const Bytes rest = joined({end, encodeFrame(framing, helloMessage())});
    const Outcome after = decodeAll(decoder, rest, rest.size());
    EXPECT_EQ(after.messages, std::vector<Message>{helloMessage()});
    EXPECT_EQ(after.broken, 0);
  }
}

TEST(FrameDecoder, ABadLengthOrCrcEndsAStreamOfLengths) {
  const Bytes good = encodeFrame(Framing::Length, helloMessage());
  Bytes wrong_crc = good;
  wrong_crc.back() ^= 1U;
  for (const Bytes& bad : {Bytes{0, 0, 0x10, 1}, Bytes{1, 0, 0x10, 0}, Bytes{0, 0, 0, 0}, wrong_crc}) {
    FrameDecoder decoder(Framing::Length);
    const Bytes stream = joined({good, bad, good});
    const Outcome outcome = decodeAll(decoder, stream, stream.size());
    EXPECT_EQ(outcome.messages.size(), 1U);
    EXPECT_EQ(outcome.broken, 1);
    EXPECT_FALSE(decoder.stuck().empty());
    decoder.feed(good);
    EXPECT_FALSE(decoder.next().has_value());
    EXPECT_EQ(decoder.buffered(), 0U);
  }
}

TEST(FrameDecoder, NamesWhatWouldWaitForEver) {
  const std::string line = encodeLine(helloMessage());
  const auto complaintOf = [](std::optional<Framing> framing, const std::string& text) {
    FrameDecoder decoder(framing);
    Outcome outcome = decodeAll(decoder, asBytes(text), 7);
    return decoder.complaintOfWaiting();
  };
  EXPECT_FALSE(complaintOf(std::nullopt, line)) << "the rest may come";
  EXPECT_FALSE(complaintOf(Framing::Cobs, line));
  for (const std::string& filling : {std::string(), std::string("\r"), std::string(" "), std::string(1, '\0')}) {
    const auto complaint = complaintOf(std::nullopt, line + filling + line);
    ASSERT_TRUE(complaint) << filling;
    EXPECT_EQ(complaint->kind, ProtocolViolationKind::NoLineFeed);
  }
  const auto on_serial = complaintOf(Framing::Cobs, line + "\n");
  ASSERT_TRUE(on_serial);
  EXPECT_EQ(on_serial->kind, ProtocolViolationKind::WrongDialect);
}

}  // namespace
}  // namespace hexoderm::skinwire
