#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace hexoderm {

/// The names of the values of an enumeration, in their order, as files and command lines have them.
template <class Enum, std::size_t Count>
struct EnumNames {
  std::array<std::string_view, Count> names;

  [[nodiscard]] constexpr std::string_view of(Enum value) const { return names.at(static_cast<std::size_t>(value)); }
  /// Nothing for a name that is none.
  [[nodiscard]] constexpr std::optional<Enum> find(std::string_view name) const {
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? std::nullopt : std::optional(static_cast<Enum>(found - names.begin()));
  }
};

}  // namespace hexoderm
