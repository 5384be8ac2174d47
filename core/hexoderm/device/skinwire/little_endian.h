#pragma once

// Private to skinwire/.

#include "hexoderm/device/skinwire/codec.h"

#include <cstddef>
#include <cstdint>

namespace hexoderm::skinwire {

/// The number in the first four bytes, of which there must be as many.
inline std::uint32_t littleEndian(ByteView bytes) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < sizeof(value); ++k) value |= std::uint32_t{bytes[k]} << (8 * k);
  return value;
}

}  // namespace hexoderm::skinwire
