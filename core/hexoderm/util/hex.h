#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace hexoderm {

enum class HexCase { Lower, Upper };

/// The bytes as hexadecimal digits, two a byte, the high one first.
std::string hexDigits(std::span<const std::uint8_t> bytes, HexCase letters = HexCase::Lower);

}  // namespace hexoderm
