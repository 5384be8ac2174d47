#pragma once

// Private to device/.

#include "hexoderm/device/skinwire/codec.h"

#include <cstddef>
#include <cstdint>

namespace hexoderm::skinwire {

/// The number in the first bytes, of which there must be as many.
template <class Number = std::uint32_t>
Number littleEndian(ByteView bytes) {
  Number value = 0;
  for (std::size_t k = 0; k < sizeof(value); ++k) value |= Number{bytes[k]} << (8 * k);
  return value;
}
template <class Number>
void appendLittleEndian(Number value, Bytes& bytes) {
  for (std::size_t k = 0; k < sizeof(value); ++k) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
}

}  // namespace hexoderm::skinwire
