#pragma once

#include "hexoderm/device/skinwire/codec.h"

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>

namespace hexoderm::skinwire {

/// The number in the first bytes, of which there must be as many.
template <class Number = std::uint32_t>
Number littleEndian(ByteView bytes) {
  return boost::endian::endian_load<Number, sizeof(Number), boost::endian::order::little>(bytes.data());
}
template <class Number>
void appendLittleEndian(Number value, Bytes& bytes) {
  for (std::size_t k = 0; k < sizeof(value); ++k) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
}

}  // namespace hexoderm::skinwire
