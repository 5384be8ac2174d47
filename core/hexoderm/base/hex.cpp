#include "hexoderm/base/hex.h"

#include <fmt/ranges.h>

namespace hexoderm {

std::string hexDigits(std::span<const std::uint8_t> bytes) { return fmt::format("{:02x}", fmt::join(bytes, "")); }

}  // namespace hexoderm
