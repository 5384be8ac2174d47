#include "hexoderm/device/skinwire/framing.h"

#include "hexoderm/base/text.h"
#include "hexoderm/device/skinwire/line_diagnosis.h"
#include "hexoderm/device/skinwire/little_endian.h"

#include <algorithm>
#include <string_view>

namespace hexoderm::skinwire {
namespace {

constexpr std::size_t kLengthBytes = 4;
constexpr std::size_t kBeginning = 100;  // bytes of a piece that are shown
constexpr std::size_t kCobsBlock = 254;  // bytes without a zero that one code byte can announce
constexpr std::size_t kMaxCobs = kMaxBody + kMaxBody / kCobsBlock + 1;

/// Whether a line is blank.
bool isBlank(ByteView piece) {
  return std::ranges::all_of(piece, [](std::uint8_t c) { return c == ' ' || c == '\t' || c == '\r'; });
}

/// Bytes that no terminal sends or takes, unlike those of its escape sequences.
bool isNoText(std::uint8_t byte) { return byte < 0x07; }

/// Whether bytes are those of a serial port: the first ones begin a frame in COBS, or some between two 0x00 are one.
bool looksLikeCobs(ByteView bytes) {
  constexpr std::uint8_t kMinCode = 3;  // the body begins with two bytes that are not 0
  constexpr std::uint8_t kMaxType = 7;
  const auto isZero = [](std::uint8_t byte) { return byte == 0; };
  auto at = std::ranges::find_if_not(bytes, isZero);
  if (bytes.end() - at >= 3 && at - bytes.begin() <= 1 && at[0] >= kMinCode && at[1] == kMajor && at[2] >= 1 &&
      at[2] <= kMaxType) {
    return true;
  }
  while (true) {
    const auto end = std::find(at, bytes.end(), 0);
    if (end == bytes.end()) return false;
    const std::optional<Bytes> body = decodeCobs(ByteView(at, end));
    if (body && decodeBody(*body).outcome == DecodeOutcome::Understood) return true;
    at = std::find_if_not(end, bytes.end(), isZero);
  }
}

hexoderm::Message cobsText() {
  return message(
      "this looks like the framing of a serial port (COBS), expected a frame that begins with its length; is there a "
      "bridge from a serial port? Make a pseudo-terminal of it, and use serial:");
}

}  // namespace

Bytes encodeCobs(ByteView bytes) {
  Bytes out;
  out.reserve(bytes.size() + bytes.size() / kCobsBlock + 1);
  std::size_t code_at = 0;
  out.push_back(0);  // becomes the first code: the distance to the next zero
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    if (bytes[k] != 0) out.push_back(bytes[k]);
    const std::size_t distance = out.size() - code_at;
    const bool full = distance == kCobsBlock + 1 && k + 1 < bytes.size();
    if (bytes[k] != 0 && !full) continue;
    out[code_at] = static_cast<std::uint8_t>(distance);
    code_at = out.size();
    out.push_back(0);
  }
  out[code_at] = static_cast<std::uint8_t>(out.size() - code_at);
  return out;
}

std::optional<Bytes> decodeCobs(ByteView bytes) {
  Bytes out;
  out.reserve(bytes.size());
  std::size_t k = 0;
  while (k < bytes.size()) {
    const std::size_t distance = bytes[k];
    if (distance == 0 || distance > bytes.size() - k) return std::nullopt;
    for (std::size_t i = k + 1; i < k + distance; ++i) {
      if (bytes[i] == 0) return std::nullopt;
      out.push_back(bytes[i]);
    }
    k += distance;
    if (distance <= kCobsBlock && k < bytes.size()) out.push_back(0);
  }
  return out;
}

Bytes encodeFrame(Framing framing, const Message& message) {
  if (framing == Framing::Lines) {
    const std::string line = encodeLine(message);
    Bytes frame(line.begin(), line.end());
    frame.push_back('\n');
    return frame;
  }
  const Bytes body = encodeBody(message);
  if (framing == Framing::Cobs) {
    Bytes frame = encodeCobs(body);
    frame.push_back(0);
    return frame;
  }
  Bytes frame;
  frame.reserve(kLengthBytes + body.size());
  for (std::size_t k = 0; k < kLengthBytes; ++k) frame.push_back(static_cast<std::uint8_t>(body.size() >> (8 * k)));
  frame.insert(frame.end(), body.begin(), body.end());
  return frame;
}

void FrameDecoder::feed(ByteView bytes) {
  if (!stuck_.empty()) return;
  if (begin_ > 0) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
    begin_ = 0;
  }
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

std::optional<Decoded> FrameDecoder::next() {
  if (!stuck_.empty()) return std::nullopt;
  if (!framing_) {
    if (std::optional<Decoded> neither = detect()) return neither;
  }
  if (!framing_) return std::nullopt;
  if (*framing_ == Framing::Length) return nextByLength();
  return *framing_ == Framing::Cobs ? nextByDelimiter(0, kMaxCobs) : nextByDelimiter('\n', kMaxBody);
}

std::optional<Decoded> FrameDecoder::detect() {
  if (rest().size() < kLengthBytes) return std::nullopt;
  const ByteView first = rest().first(kLengthBytes);
  framing_ = first.back() == 0 ? Framing::Length : Framing::Lines;
  if (*framing_ == Framing::Length || std::ranges::none_of(first, isNoText)) return std::nullopt;
  const ByteView beginning = rest().first(std::min(rest().size(), kBeginning));
  if (looksLikeCobs(rest())) return getStuck(brokenPiece(ProtocolViolationKind::WrongDialect, cobsText(), beginning));
  return getStuck(first.front() == 0
                      ? brokenPiece(ProtocolViolationKind::BrokenFrame,
                                    message("the length of a frame is big-endian, expected little-endian"), beginning)
                      : brokenPiece(ProtocolViolationKind::WrongDialect,
                                    message("this is neither a line of JSON nor a frame that begins with its length"),
                                    beginning));
}

Decoded FrameDecoder::getStuck(Decoded broken) {
  stuck_ = broken.reason();
  buffer_.clear();
  begin_ = 0;
  return broken;
}

Decoded FrameDecoder::wrongLength(std::uint32_t length) const {
  const ByteView bytes = rest();
  const ByteView beginning = bytes.first(std::min(bytes.size(), kBeginning));
  if (bytes[0] == 0xFF && bytes[1] == 0xFE) {
    return brokenPiece(ProtocolViolationKind::WrongDialect,
                       message("this is text in UTF-16, expected lines of JSON in UTF-8"), beginning);
  }
  if (looksLikeCobs(bytes)) return brokenPiece(ProtocolViolationKind::WrongDialect, cobsText(), beginning);
  return brokenPiece(ProtocolViolationKind::BrokenFrame,
                     message("a frame says that it is {} bytes long, the limit is {}", length, kMaxBody), beginning);
}

std::optional<Decoded> FrameDecoder::nextByLength() {
  if (rest().size() < kLengthBytes) return std::nullopt;
  const std::uint32_t length = littleEndian(rest());
  if (length == 0 || length > kMaxBody) return getStuck(wrongLength(length));
  if (rest().size() - kLengthBytes < length) return std::nullopt;
  Decoded decoded = decodeBody(rest().subspan(kLengthBytes, length));
  if (decoded.outcome == DecodeOutcome::Broken && decoded.major == 0) return getStuck(std::move(decoded));
  begin_ += kLengthBytes + length;
  return decoded;
}

Decoded FrameDecoder::decodePiece(ByteView piece) const {
  if (*framing_ == Framing::Lines) return decodeLine({reinterpret_cast<const char*>(piece.data()), piece.size()});
  if (const std::optional<Bytes> body = decodeCobs(piece)) return decodeBody(*body);
  return brokenPiece(ProtocolViolationKind::BrokenFrame, message("the bytes before a 0x00 are not COBS"), piece);
}

std::optional<ProtocolViolation> FrameDecoder::complaintOfWaiting() const {
  constexpr std::size_t kMaxSearched = 65'536;
  if (!framing_ || *framing_ == Framing::Length || skipping_) return std::nullopt;
  const ByteView waiting = rest().first(std::min(rest().size(), kMaxSearched));
  const std::string_view text(reinterpret_cast<const char*>(waiting.data()), waiting.size());
  if (*framing_ == Framing::Cobs && text.starts_with('{') && text.find('\n') != std::string_view::npos) {
    return ProtocolViolation{
        ProtocolViolationKind::WrongDialect,
        message("this looks like lines of JSON; on a serial port frames of bytes in COBS, each before a "
                "0x00, are expected"),
        excerptOf(text)};
  }
  if (*framing_ == Framing::Lines && looksLikeCobs(waiting)) {
    return ProtocolViolation{ProtocolViolationKind::WrongDialect, cobsText(), excerptOf(text)};
  }
  if (*framing_ == Framing::Lines && lacksLineFeeds(text)) {
    return ProtocolViolation{ProtocolViolationKind::NoLineFeed,
                             message("expected a line feed (0x0A) after every message"), excerptOf(text)};
  }
  return std::nullopt;
}

std::optional<Decoded> FrameDecoder::nextByDelimiter(std::uint8_t delimiter, std::size_t longest) {
  while (true) {
    const ByteView bytes = rest();
    const auto end = std::find(bytes.begin() + static_cast<std::ptrdiff_t>(searched_), bytes.end(), delimiter);
    const auto length = static_cast<std::size_t>(end - bytes.begin());
    const bool is_whole = end != bytes.end();
    if (!is_whole && length <= longest && !skipping_) {
      searched_ = length;
      return std::nullopt;
    }
    searched_ = 0;
    begin_ += length + (is_whole ? 1 : 0);
    if (skipping_) {
      // Reported when it got too long.
      if (!is_whole) return std::nullopt;
      skipping_ = false;
      continue;
    }
    if (length > longest) {
      skipping_ = !is_whole;
      return brokenPiece(ProtocolViolationKind::BrokenFrame, message("more than {} bytes without an end", longest),
                         bytes.first(kBeginning));
    }
    const ByteView piece = bytes.first(length);
    // Empty pieces are allowed: a sender may end what it began before with an end of its own.
    if (piece.empty() || (*framing_ == Framing::Lines && isBlank(piece))) continue;
    return decodePiece(piece);
  }
}

}  // namespace hexoderm::skinwire
