#pragma once

#include "hexoderm/device/skinwire/codec.h"
#include "hexoderm/device/skinwire/crc32c.h"
#include "hexoderm/device/skinwire/framing.h"
#include "tests/fuzz/fuzz_input.h"

#include <cstddef>
#include <cstdint>

namespace hexoderm::fuzz {

inline void append(ByteView bytes, skinwire::Bytes& out) { out.insert(out.end(), bytes.begin(), bytes.end()); }

/// The low bytes of a number, little-endian.
inline void putNumber(std::uint64_t value, std::size_t size, skinwire::Bytes& out) {
  for (std::size_t k = 0; k < size; ++k) out.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
}

/// The next body of an input, with its CRC: type, length of 16 bits, so many bytes of protobuf.
inline skinwire::Bytes nextBody(FuzzInput& input) {
  skinwire::Bytes body = {skinwire::kMajor, input.byte()};
  append(input.piece(), body);
  putNumber(skinwire::crc32c(body), 4, body);
  return body;
}

/// Puts a body behind its length, or into COBS.
inline void appendFrame(skinwire::Framing framing, const skinwire::Bytes& body, skinwire::Bytes& out) {
  if (framing == skinwire::Framing::Cobs) {
    append(skinwire::encodeCobs(body), out);
    out.push_back(0);
  } else {
    putNumber(body.size(), 4, out);
    append(body, out);
  }
}

}  // namespace hexoderm::fuzz
