#pragma once

#include "hexoderm/device/skinwire/messages.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace hexoderm::skinwire {

using Bytes = std::vector<std::uint8_t>;         ///< bytes on the wire
using ByteView = std::span<const std::uint8_t>;  ///< bytes on the wire of somebody else's

/// Why a body or line gave no message.
enum class DecodeOutcome {
  Understood,
  Broken,       ///< too short or long, CRC, syntax, or a complaint
  OtherMajor,   ///< whole, but of another major version
  UnknownType,  ///< whole, but of a type that this version does not know: to be skipped
};

/// What was read of a body.
struct Decoded {
  DecodeOutcome outcome = DecodeOutcome::Broken;
  Message message{};        ///< valid if outcome is Understood
  std::uint32_t major = 0;  ///< 0: not known, because length or CRC are wrong
  /// The faults, that which the others may follow from first; at least one unless the outcome is Understood. A message
  /// that was understood all the same may have fields that are not known.
  std::vector<ProtocolViolation> offences{};

  /// The first fault; empty if there is none.
  [[nodiscard]] hexoderm::Message reason() const {
    return offences.empty() ? hexoderm::Message() : offences.front().reason;
  }
};

/// A piece of a stream that gave no message, whose beginning is given.
Decoded brokenPiece(ProtocolViolationKind kind, hexoderm::Message reason, ByteView beginning = {});

/// major, type, protobuf payload, CRC-32C: what every framing of bytes carries. Throws InvalidArgument if the message
/// has a complaint or its body would be longer than kMaxBody.
Bytes encodeBody(const Message& message);

/// Never throws for what is in the body. Does not allocate more than a small multiple of the body's own length.
Decoded decodeBody(ByteView body);

/// One line of the line dialect without the line feed. Throws as encodeBody does.
std::string encodeLine(const Message& message);

/// Accepts a line with or without "\r"; fields that are not known are ignored, and are among the offences. Never throws
/// for what is in the line.
Decoded decodeLine(std::string_view line);

}  // namespace hexoderm::skinwire
