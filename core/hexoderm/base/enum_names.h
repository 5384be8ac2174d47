#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace hexoderm {

/// Whether a value of an enumeration has a name.
template <auto Value>
consteval bool isEnumerator() {
  // Compilers write a value that has no name as a cast: "(hexoderm::Severity)3".
  const std::string_view function = __PRETTY_FUNCTION__;
  return function.rfind("::") > function.rfind(')');
}

/// How many values an enumeration has, which counts from 0 without gaps.
template <class Enum, std::size_t From = 0>
consteval std::size_t enumeratorCount() {
  if constexpr (isEnumerator<static_cast<Enum>(From)>()) {
    return enumeratorCount<Enum, From + 1>();
  } else {
    return From;
  }
}

/// The names of the values of an enumeration, in their order, as files and command lines have them. Each value has one,
/// or it does not compile.
template <class Enum>
struct EnumNames {
  std::array<std::string_view, enumeratorCount<Enum>()> names;

  consteval EnumNames(const std::array<std::string_view, enumeratorCount<Enum>()>& in_order) : names(in_order) {
    if (std::ranges::find(names, "") != names.end()) throw std::logic_error("a value without a name");
  }

  [[nodiscard]] constexpr std::string_view of(Enum value) const { return names.at(static_cast<std::size_t>(value)); }
  /// Nothing for a name that is none.
  [[nodiscard]] constexpr std::optional<Enum> find(std::string_view name) const {
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? std::nullopt : std::optional(static_cast<Enum>(found - names.begin()));
  }
};

}  // namespace hexoderm
