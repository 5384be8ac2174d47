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
  [[nodiscard]] bool isBrushed(CellId cell) const;

  void selectCell(CellId cell);
  void selectLink(LinkEnd a, LinkEnd b);
  /// Nothing is picked or brushed any more.
  void clear();
  /// These are the brushed cells from now on, in any order.
  void brush(std::vector<CellId> cells);
  /// Picks, and asks the views to turn to it: the operator wants to see where it is.
  void seekCell(CellId cell);
  void seekLink(LinkEnd a, LinkEnd b);

 signals:
  /// Another cell or link is picked.
  void changed();
  void brushedChanged();
  /// What is picked now is to be seen. After changed(), and also where the same was picked before.
  void sought();

 private:
  void set(std::optional<CellId> cell, std::optional<Link> link);

  std::optional<CellId> cell_;
  std::optional<Link> link_;
  std::vector<CellId> brushed_;
};

}  // namespace hexoderm
