#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hexoderm::fuzz {

using ByteView = std::span<const std::uint8_t>;

/// Takes an input apart from its front. At the end there are zeros and empty pieces: every input means something.
class FuzzInput {
 public:
  explicit FuzzInput(ByteView bytes) : rest_(bytes) {}

  [[nodiscard]] bool atEnd() const { return rest_.empty(); }
  std::uint8_t byte() {
    const ByteView one = bytes(1);
    return one.empty() ? std::uint8_t{0} : one.front();
  }
  /// 16 bits, little-endian.
  std::uint16_t shortNumber() {
    const unsigned low = byte();
    return static_cast<std::uint16_t>(low | static_cast<unsigned>(byte()) << 8U);
  }
  /// So many, or what is left.
  ByteView bytes(std::size_t count) {
    const ByteView piece = rest_.first(std::min(count, rest_.size()));
    rest_ = rest_.subspan(piece.size());
    return piece;
  }
  /// A length of 16 bits and so many bytes.
  ByteView piece() { return bytes(shortNumber()); }
  ByteView rest() { return bytes(rest_.size()); }

 private:
  ByteView rest_;
};

}  // namespace hexoderm::fuzz
