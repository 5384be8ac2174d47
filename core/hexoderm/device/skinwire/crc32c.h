#pragma once

#include <cstdint>
#include <span>

namespace hexoderm::skinwire {

/// CRC-32C (Castagnoli: polynomial 0x1EDC6F41 reflected, start and final value 0xFFFFFFFF), as in iSCSI, RFC 3720. The
/// check value for "123456789" is 0xE3069283. Uses the processor's own instruction where there is one.
std::uint32_t crc32c(std::span<const std::uint8_t> bytes);

/// The same checksum computed by tables, on every processor.
std::uint32_t crc32cByTable(std::span<const std::uint8_t> bytes);

}  // namespace hexoderm::skinwire
