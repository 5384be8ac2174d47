#include "widgets/graph/graph_sheet.h"

#include <QPainter>
#include <QWidget>
#include <utility>

namespace hexoderm {
namespace {

constexpr int kDrawAfter_ms = 1;  // 0 may be in the turn in which the window is painted

}  // namespace

GraphSheet::GraphSheet(QWidget* view, std::function<void(QPainter&)> draw)
    : view_(view), draw_(std::move(draw)), draw_soon_(kDrawAfter_ms, [this] {
        currentPicture();
        view_->update();
      }) {}

void GraphSheet::invalidate(bool takes_long) {
  is_current_ = false;
  if (takes_long && !picture_.isNull()) {
    draw_soon_.start();
  } else {
    view_->update();
  }
}

const QPixmap& GraphSheet::picture() { return draw_soon_.isActive() ? picture_ : currentPicture(); }

const QPixmap& GraphSheet::currentPicture() {
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

}  // namespace hexoderm
