#pragma once

// The texts and bytes of mesh files, from front to back. Nothing is read beyond their end, and
// nothing depends on the locale.

#include "hexoderm/robots/mesh_builder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace hexoderm {

/// Takes the next word from the front of a text; empty at its end.
std::string_view takeWord(std::string_view& text);

/// A number as mesh files write it: also "+1", and 0 for one that is too small for a double. It may be infinite or NaN.
std::optional<double> meshNumber(std::string_view word);
/// A whole number of at least 0.
std::optional<std::uint32_t> meshIndex(std::string_view word);

/// A text of lines and words. A backslash at the end of a line joins it with the next.
class MeshText {
 public:
  /// `mesh` names the file in errors.
  MeshText(std::string_view text, const MeshBuilder& mesh) : rest_(text), mesh_(mesh) {}

  /// The next word of this line; empty at its end.
  std::string_view wordInLine();
  /// The next word of this line or a later one; empty at the end of the text.
  std::string_view word();
  /// Leaves the line; false at the end of the text.
  bool nextLine();

  double number();          ///< the next word, a number
  Eigen::Vector3d point();  ///< three numbers
  /// The next three words of this line, which have to be numbers.
  Eigen::Vector3d pointInLine();
  [[nodiscard]] std::string_view rest() const { return rest_; }

  /// Throws FormatError naming file and line.
  [[noreturn]] void fail(Message why) const;
  /// The same: something else was expected than this word.
  [[noreturn]] void failAt(std::string_view word, const Message& expected) const;

 private:
  std::string_view rest_;
  const MeshBuilder& mesh_;
  std::size_t line_ = 1;
};

/// Binary numbers.
class MeshBytes {
 public:
  MeshBytes(std::string_view bytes, const MeshBuilder& mesh, std::endian order = std::endian::little)
      : rest_(bytes), mesh_(mesh), order_(order) {}

  /// Throws FormatError if there are fewer.
  std::string_view take(std::uint64_t count);
  template <class Number>
  Number number() {
    std::array<char, sizeof(Number)> bytes{};
    std::ranges::copy(take(bytes.size()), bytes.begin());
    if (order_ != std::endian::native) std::ranges::reverse(bytes);
    return std::bit_cast<Number>(bytes);
  }
  [[nodiscard]] bool atEnd() const { return rest_.empty(); }

 private:
  std::string_view rest_;
  const MeshBuilder& mesh_;
  std::endian order_;
};

/// Throws FormatError: the file is shorter than it says.
[[noreturn]] void failTruncated(const MeshBuilder& mesh);
/// What is wrong with a corner that is none of the points.
Message noSuchPoint(std::int64_t index, std::size_t points);

}  // namespace hexoderm
