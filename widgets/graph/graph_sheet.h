#pragma once

#include "widgets/controls/heavy_turn.h"

#include <QObject>
#include <QPainter>
#include <QPixmap>
#include <QWidget>
#include <functional>
#include <utility>

namespace hexoderm {

/// The drawn graph without the picked cell or link, kept as a picture, so that picking and pointing cost nothing. It is
/// drawn again when it is needed after a change. A drawing that takes long has a turn of the event loop to itself,
/// apart from the one in which the whole window may be painted; until then the earlier picture is shown.
class GraphSheet : public QObject {
  Q_OBJECT

 public:
  /// `draw` draws the graph, in the coordinates of `view`, which must outlive the sheet.
  GraphSheet(QWidget* view, std::function<void(QPainter&)> draw)
      : view_(view), draw_(std::move(draw)), draw_soon_(kDrawAfter_ms, [this] {
          currentPicture();
          view_->update();
        }) {}

  /// Says that the graph has changed.
  void invalidate(bool takes_long) {
    is_current_ = false;
    if (takes_long && !picture_.isNull()) {
      draw_soon_.start();
    } else {
      view_->update();
    }
  }

  /// Up to date, except while a drawing that takes long is still due.
  const QPixmap& picture() { return draw_soon_.isActive() ? picture_ : currentPicture(); }
  /// Up to date.
  const QPixmap& currentPicture() {
    const double ratio = view_->devicePixelRatioF();
    const QSize pixels = (QSizeF(view_->size()) * ratio).toSize();
    if (is_current_ && picture_.size() == pixels) return picture_;
    if (picture_.size() != pixels) picture_ = QPixmap(pixels);
    picture_.setDevicePixelRatio(ratio);
    QPainter painter(&picture_);
    draw_(painter);
    is_current_ = true;
    return picture_;
  }

 private:
  static constexpr int kDrawAfter_ms = 1;  // 0 may be in the turn in which the window is painted

  QWidget* view_;
  std::function<void(QPainter&)> draw_;
  QPixmap picture_;
  bool is_current_ = false;
  HeavyTurn draw_soon_;
};

}  // namespace hexoderm
