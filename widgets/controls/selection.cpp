#include "widgets/controls/selection.h"

namespace hexoderm {

Selection::Selection(QObject* parent) : QObject(parent) {}

void Selection::selectCell(CellId cell) { set(cell, std::nullopt); }

void Selection::selectLink(LinkEnd a, LinkEnd b) { set(std::nullopt, a < b ? Link(a, b) : Link(b, a)); }

void Selection::seekCell(CellId cell) {
  selectCell(cell);
  emit sought();
}

void Selection::seekLink(LinkEnd a, LinkEnd b) {
  selectLink(a, b);
  emit sought();
}

void Selection::clear() { set(std::nullopt, std::nullopt); }

void Selection::set(std::optional<CellId> cell, std::optional<Link> link) {
  if (cell == cell_ && link == link_) return;
  cell_ = cell;
  link_ = link;
  emit changed();
}

}  // namespace hexoderm
