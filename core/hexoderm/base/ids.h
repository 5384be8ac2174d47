#pragma once

#if __cplusplus < 202002L
#error "Hexoderm needs C++20: -std=c++20, or in CMake target_compile_features(PROGRAM PRIVATE cxx_std_20)"
#endif

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

namespace hexoderm {

/// A number that names something and is not mixed up with another kind of number.
template <class Tag>
class StrongId {
 public:
  constexpr StrongId() = default;
  constexpr explicit StrongId(std::uint32_t value) : value_(value) {}     ///< the ID with this number
  [[nodiscard]] constexpr std::uint32_t value() const { return value_; }  ///< the number of the ID
  friend constexpr auto operator<=>(StrongId, StrongId) = default;
  friend std::ostream& operator<<(std::ostream& out, StrongId id) { return out << id.value_; }  ///< writes the number

 private:
  std::uint32_t value_ = 0;
};

using CellId = StrongId<struct CellIdTag>;          ///< 0 means "no neighbour" where a neighbour is listed
using PoseId = StrongId<struct PoseIdTag>;          ///< a held orientation of the body part
using PatchId = StrongId<struct PatchIdTag>;        ///< 0, 1, ... in the order of the patches' smallest cell
using PortNumber = StrongId<struct PortNumberTag>;  ///< as the cell model numbers its ports

/// The number as text.
template <class Tag>
std::string toString(StrongId<Tag> id) {
  return std::to_string(id.value());
}

/// One end of a link: a port of a cell.
struct LinkEnd {
  CellId cell;
  PortNumber port;
  friend constexpr auto operator<=>(const LinkEnd&, const LinkEnd&) = default;
};

}  // namespace hexoderm

/// That of its number.
template <class Tag>
struct std::hash<hexoderm::StrongId<Tag>> {
  /// That of the number.
  std::size_t operator()(hexoderm::StrongId<Tag> id) const noexcept { return std::hash<std::uint32_t>{}(id.value()); }
};
