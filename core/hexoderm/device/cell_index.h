#pragma once

// Cells are numbered 0, 1, ... in the order in which they were first seen.

#include "hexoderm/base/ids.h"

#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace hexoderm {

/// Numbers each cell when it is first seen. A device names its cells in the same order in every frame, so the next one
/// is nearly always the one after the last.
class CellIndex {
 public:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  /// Larger than any supported live skin (100,000 cells). Cells that a broken device invents beyond that get no number.
  static constexpr std::size_t kMaxCells = 200'000;

  explicit CellIndex(std::size_t most_cells = kMaxCells) : most_cells_(most_cells) {}

  /// Returns kNone for a new cell beyond the most.
  std::size_t of(CellId cell) {
    if (next_ >= ids_.size()) next_ = 0;
    if (next_ < ids_.size() && ids_[next_] == cell) return next_++;
    const auto [place, is_new] = numbers_.try_emplace(cell, ids_.size());
    if (is_new) {
      if (ids_.size() >= most_cells_) {
        numbers_.erase(place);
        return kNone;
      }
      ids_.push_back(cell);
    }
    next_ = place->second + 1;
    return place->second;
  }

  /// Returns kNone for a cell that has not been seen yet.
  [[nodiscard]] std::size_t find(CellId cell) const {
    const auto place = numbers_.find(cell);
    return place == numbers_.end() ? kNone : place->second;
  }

  [[nodiscard]] std::size_t size() const { return ids_.size(); }
  [[nodiscard]] CellId id(std::size_t index) const { return ids_[index]; }

 private:
  std::size_t most_cells_;
  std::vector<CellId> ids_;
  std::unordered_map<CellId, std::size_t> numbers_;
  std::size_t next_ = 0;
};

}  // namespace hexoderm
