#pragma once

#include "hexoderm/base/ids.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// Where cells are in a list, by their IDs; of equal ones the first.
class CellTable {
 public:
  CellTable() = default;                                           ///< of an empty list
  explicit CellTable(const std::vector<CellId>& ids);              ///< of a list
  [[nodiscard]] std::optional<std::size_t> find(CellId id) const;  ///< nothing for a cell that is not in the list

 private:
  std::size_t first_ = 0;                                 ///< the smallest ID
  std::vector<std::uint32_t> by_id_;                      ///< from there on; empty where IDs are far apart
  std::vector<std::pair<CellId, std::uint32_t>> sorted_;  ///< empty where they are not
};

}  // namespace hexoderm
