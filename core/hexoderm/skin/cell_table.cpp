#include "hexoderm/skin/cell_table.h"

#include <algorithm>
#include <limits>

namespace hexoderm {
namespace {

constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

}  // namespace

CellTable::CellTable(const std::vector<CellId>& ids) {
  if (ids.empty()) return;
  const auto [least, most] = std::ranges::minmax(ids);
  first_ = least.value();
  const std::size_t range = most.value() - first_ + 1;
  constexpr std::size_t kMaxPerCell = 8;
  if (range <= kMaxPerCell * ids.size()) {
    by_id_.assign(range, kNowhere);
    for (std::size_t k = ids.size(); k-- > 0;) by_id_[ids[k].value() - first_] = static_cast<std::uint32_t>(k);
  } else {
    for (const CellId id : ids) sorted_.emplace_back(id, static_cast<std::uint32_t>(sorted_.size()));
    std::ranges::sort(sorted_);
  }
}

std::optional<std::size_t> CellTable::find(CellId id) const {
  if (!by_id_.empty()) {
    const std::size_t at = id.value() - first_;  // beyond the end for one that is less than the first
    if (at >= by_id_.size() || by_id_[at] == kNowhere) return std::nullopt;
    return by_id_[at];
  }
  const auto found = std::ranges::lower_bound(sorted_, id, {}, &std::pair<CellId, std::uint32_t>::first);
  if (found == sorted_.end() || found->first != id) return std::nullopt;
  return found->second;
}

}  // namespace hexoderm
