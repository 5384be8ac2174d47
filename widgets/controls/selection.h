#pragma once

#include "hexoderm/util/ids.h"

#include <QObject>
#include <optional>
#include <utility>

namespace hexoderm {

/// The picked cell or link, shared by all views: one that is picked anywhere is picked everywhere. At most one of the
/// two.
class Selection : public QObject {
  Q_OBJECT

 public:
  using Link = std::pair<LinkEnd, LinkEnd>;  ///< ordered: the smaller (ID, port) first

  explicit Selection(QObject* parent = nullptr);

  [[nodiscard]] std::optional<CellId> cell() const { return cell_; }
  [[nodiscard]] std::optional<Link> link() const { return link_; }

  void selectCell(CellId cell);
  void selectLink(LinkEnd a, LinkEnd b);
  void clear();
  /// Picks, and asks the views to turn to it: the operator wants to see where it is.
  void seekCell(CellId cell);
  void seekLink(LinkEnd a, LinkEnd b);

 signals:
  void changed();
  /// What is picked now is to be seen. After changed(), and also where the same was picked before.
  void sought();

 private:
  void set(std::optional<CellId> cell, std::optional<Link> link);

  std::optional<CellId> cell_;
  std::optional<Link> link_;
};

}  // namespace hexoderm
