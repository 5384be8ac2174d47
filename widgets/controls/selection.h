#pragma once

#include "hexoderm/base/ids.h"

#include <QObject>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// The picked cell or link, shared by all views: one that is picked anywhere is picked everywhere. At most one of the
/// two. Beside it the brushed cells: any number of them that were marked together, for example in a plot, and are shown
/// marked everywhere.
class Selection : public QObject {
  Q_OBJECT

 public:
  using Link = std::pair<LinkEnd, LinkEnd>;  ///< ordered: the smaller (ID, port) first
  static Link linkOf(LinkEnd a, LinkEnd b) { return std::minmax(a, b); }

  using QObject::QObject;

  [[nodiscard]] std::optional<CellId> cell() const { return cell_; }
  [[nodiscard]] std::optional<Link> link() const { return link_; }

  /// Ascending, each once.
  [[nodiscard]] const std::vector<CellId>& brushed() const { return brushed_; }
  [[nodiscard]] bool isBrushed(CellId cell) const { return std::ranges::binary_search(brushed_, cell); }

  void selectCell(CellId cell) { set(cell, std::nullopt); }
  void selectLink(LinkEnd a, LinkEnd b) { set(std::nullopt, linkOf(a, b)); }

  /// Nothing is picked or brushed any more.
  void clear() {
    set(std::nullopt, std::nullopt);
    brush({});
  }

  /// These are the brushed cells from now on, in any order.
  void brush(std::vector<CellId> cells) {
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    if (cells == brushed_) return;
    brushed_ = std::move(cells);
    emit brushedChanged();
  }

  /// Picks, and asks the views to turn to it: the operator wants to see where it is.
  void seekCell(CellId cell) {
    selectCell(cell);
    emit sought();
  }

  void seekLink(LinkEnd a, LinkEnd b) {
    selectLink(a, b);
    emit sought();
  }

 signals:
  /// Another cell or link is picked.
  void changed();
  void brushedChanged();
  /// What is picked now is to be seen. After changed(), and also where the same was picked before.
  void sought();

 private:
  void set(std::optional<CellId> cell, std::optional<Link> link) {
    if (cell == cell_ && link == link_) return;
    cell_ = cell;
    link_ = link;
    emit changed();
  }

  std::optional<CellId> cell_;
  std::optional<Link> link_;
  std::vector<CellId> brushed_;
};

}  // namespace hexoderm
