#pragma once

#include "hexoderm/device/skinwire/codec.h"

#include <cstdint>
#include <optional>

namespace hexoderm::skinwire {

/// The form of frames in a stream of bytes.
enum class Framing {
  Length,  ///< TCP: little-endian length of 32 bits, then the body
  Cobs,    ///< serial: the body with its zeros coded away (Cheshire and Baker 1999), then 0x00
  Lines,   ///< the line dialect: one JSON object a line
};

/// A message as it goes out on a stream: everything between two frames is in it.
Bytes encodeFrame(Framing framing, const Message& message);

Bytes encodeCobs(ByteView bytes);  ///< the bytes without a zero in them (COBS), without the zero that ends a frame
/// nullopt if the bytes, without the final 0x00, are no COBS coding.
std::optional<Bytes> decodeCobs(ByteView bytes);

/// Cuts a stream into frames and decodes them, however the bytes come in pieces.
///
///     decoder.feed(bytes);
///     while (const auto decoded = decoder.next()) ...
///
/// It never holds more than one feed and kMaxBody bytes, whatever lengths are claimed. After garbage, Cobs goes on at
/// the next 0x00 and Lines at the next line; Length can't be found again, so the decoder is then unusable (`stuck`),
/// and the connection has to be made again. A body with a wrong CRC means the same there, as it may be the length that
/// broke.
class FrameDecoder {
 public:
  /// nullopt: Length or Lines, whichever the peer begins with. The fourth byte of a length is 0, because it is at most
  /// kMaxBody; no text begins with four bytes of which the last is 0.
  explicit FrameDecoder(std::optional<Framing> framing) : framing_(framing) {}

  /// `bytes` are copied.
  void feed(ByteView bytes);
  /// The next whole frame or broken piece, nullopt when there is none yet.
  std::optional<Decoded> next();

  /// Known after the first bytes.
  [[nodiscard]] std::optional<Framing> framing() const { return framing_; }
  /// Why nothing more can be read; empty if it can.
  [[nodiscard]] const hexoderm::Message& stuck() const { return stuck_; }
  /// What is wrong with bytes that seem to wait for the rest of their frame, and would do so for ever: messages without
  /// the delimiter that they need.
  [[nodiscard]] std::optional<ProtocolViolation> complaintOfWaiting() const;
  /// Bytes that wait for the rest of their frame.
  [[nodiscard]] std::size_t buffered() const { return buffer_.size() - begin_; }

 private:
  std::optional<Decoded> nextByLength();
  std::optional<Decoded> nextByDelimiter(std::uint8_t delimiter, std::size_t longest);
  Decoded decodePiece(ByteView piece) const;
  [[nodiscard]] ByteView rest() const { return ByteView(buffer_).subspan(begin_); }
  Decoded getStuck(Decoded broken);
  [[nodiscard]] Decoded wrongLength(std::uint32_t length) const;
  std::optional<Decoded> detect();

  std::optional<Framing> framing_;
  Bytes buffer_;
  std::size_t begin_ = 0;     ///< start of the bytes that were not yet returned
  std::size_t searched_ = 0;  ///< bytes of rest() without a delimiter
  bool skipping_ = false;     ///< dropping an oversized frame, up to its delimiter
  hexoderm::Message stuck_;
};

}  // namespace hexoderm::skinwire
