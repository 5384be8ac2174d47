#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace hexoderm {

/// At most `most` of `count` things that lie far apart: `first`, and then each time the one whose distance to the
/// nearest of those before is largest; ties: the first. `distance(a, b)`: of two of them, by their indices.
template <class Distance>
std::vector<std::size_t> farthestFirst(std::size_t count, std::size_t most, std::size_t first, Distance distance) {
  std::vector<std::size_t> chosen = {first};
  std::vector<double> away(count, std::numeric_limits<double>::infinity());
  while (chosen.size() < std::min(most, count)) {
    for (std::size_t k = 0; k < count; ++k) away[k] = std::min(away[k], distance(k, chosen.back()));
    away[chosen.back()] = -1;  // also where others are at the same place
    chosen.push_back(static_cast<std::size_t>(std::ranges::max_element(away) - away.begin()));
  }
  return chosen;
}

}  // namespace hexoderm
