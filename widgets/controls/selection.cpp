#include "widgets/controls/selection.h"

namespace hexoderm {

void Selection::selectCell(CellId cell) { set(cell, std::nullopt); }

void Selection::selectLink(LinkEnd a, LinkEnd b) { set(std::nullopt, linkOf(a, b)); }

void Selection::seekCell(CellId cell) {
  selectCell(cell);
  emit sought();
}

void Selection::seekLink(LinkEnd a, LinkEnd b) {
  selectLink(a, b);
  emit sought();
}

void Selection::clear() {
  set(std::nullopt, std::nullopt);
  brush({});
}

bool Selection::isBrushed(CellId cell) const { return std::ranges::binary_search(brushed_, cell); }

void Selection::brush(std::vector<CellId> cells) {
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  if (cells == brushed_) return;
  brushed_ = std::move(cells);
  emit brushedChanged();
}

void Selection::set(std::optional<CellId> cell, std::optional<Link> link) {
  if (cell == cell_ && link == link_) return;
  cell_ = cell;
  link_ = link;
  emit changed();
}

}  // namespace hexoderm
