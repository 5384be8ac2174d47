#pragma once

#include <cstddef>

namespace hexoderm {

/// How many items of a list are said to a person: all, or of a long one the first, and how many others there are. A
/// list that ends with "and 2 others" would as well say these two.
inline std::size_t saidOf(std::size_t items) {
  constexpr std::size_t kMax = 24;
  constexpr std::size_t kFirst = 20;
  return items <= kMax ? items : kFirst;
}

}  // namespace hexoderm
