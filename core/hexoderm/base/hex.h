#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace hexoderm {

/// The bytes as hexadecimal digits, two a byte, the high one first.
std::string hexDigits(std::span<const std::uint8_t> bytes);

}  // namespace hexoderm
