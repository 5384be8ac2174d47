#pragma once

#include "widgets/controls/heavy_turn.h"

#include <QObject>
#include <QPixmap>
#include <functional>

class QPainter;
class QWidget;

namespace hexoderm {

/// The drawn graph without the picked cell or link, kept as a picture, so that picking and pointing cost nothing. It is
/// drawn again when it is needed after a change. A drawing that takes long has a turn of the event loop to itself,
/// apart from the one in which the whole window may be painted; until then the earlier picture is shown.
class GraphSheet : public QObject {
  Q_OBJECT

 public:
  /// `draw` draws the graph, in the coordinates of `view`, which must outlive the sheet.
  GraphSheet(QWidget* view, std::function<void(QPainter&)> draw);

  /// Says that the graph has changed.
  void invalidate(bool takes_long);
  /// Up to date, except while a drawing that takes long is still due.
  const QPixmap& picture();
  /// Up to date.
  const QPixmap& currentPicture();

 private:
  QWidget* view_;
  std::function<void(QPainter&)> draw_;
  QPixmap picture_;
  bool is_current_ = false;
  HeavyTurn draw_soon_;
};

}  // namespace hexoderm
