#include "widgets/patch/patch_marks.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace hexoderm {
namespace {

constexpr double kPickedWidth = 3;
constexpr double kHoverWidth = 1.4;
constexpr double kToldWidth = 4;
constexpr double kHalo = 2;  // on either side

QPainterPath pathOf(const SceneMark& mark) {
  QPainterPath path;
  path.addPolygon(mark.line);
  if (mark.closed) path.closeSubpath();
  return path;
}

}  // namespace

PatchMarks::PatchMarks(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void PatchMarks::setContent(const Content& content) {
  content_ = content;
  update();
}

void PatchMarks::setTheme(Theme theme) {
  theme_ = theme;
  update();
}

void PatchMarks::setFocusShown(bool shown) {
  shows_focus_ = shown;
  update();
}

void PatchMarks::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  paintLasting(painter);
  const Colors& colors = Colors::of(theme_);
  if (content_.hovered.isThere()) {
    paintOutline(painter, content_.hovered, colors.selection, textOn(colors.selection), kHoverWidth);
  }
  if (!shows_focus_) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.accent, 2));
  painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
}

void PatchMarks::paintLasting(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  const Colors& colors = Colors::of(theme_);
  if (content_.told.isThere()) {
    QColor light = colors.accent;
    light.setAlphaF(0.45);
    painter.fillPath(pathOf(content_.told), light);
    paintOutline(painter, content_.told, colors.accent, colors.panel, kToldWidth);
    paintTag(painter, content_.told, colors.accent, colors.accent_text);
  }
  if (content_.picked.isThere()) {
    paintOutline(painter, content_.picked, colors.selection, textOn(colors.selection), kPickedWidth);
    paintTag(painter, content_.picked, colors.selection, textOn(colors.selection));
  }
}

void PatchMarks::paintOutline(QPainter& painter, const SceneMark& mark, const QColor& core, const QColor& halo,
                              double width) const {
  painter.save();
  painter.setBrush(Qt::NoBrush);
  QPen pen(halo, width + 2 * kHalo, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  painter.setPen(pen);
  painter.drawPath(pathOf(mark));
  pen.setColor(core);
  pen.setWidthF(width);
  if (mark.hidden) {
    pen.setCapStyle(Qt::FlatCap);
    pen.setDashPattern({2.5, 1.8});
  }
  painter.setPen(pen);
  painter.drawPath(pathOf(mark));
  painter.restore();
}

/// On the side of the mark where there is room for it.
void PatchMarks::paintTag(QPainter& painter, const SceneMark& mark, const QColor& ground, const QColor& ink) const {
  if (mark.tag.isEmpty()) return;
  constexpr int kAside = 6;
  painter.save();
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  const QRectF around = mark.line.boundingRect();
  QRectF plate(QPointF(), QSizeF(painter.fontMetrics().size(0, mark.tag)) + QSizeF(10, 4));
  plate.moveBottomLeft(QPointF(around.right() - 2, around.top() - kAside));
  if (plate.right() > width() - kAside) plate.moveRight(around.left() + 2);
  if (plate.top() < kAside) plate.moveTop(around.bottom() + kAside);
  plate.moveLeft(std::clamp<double>(plate.left(), kAside, std::max<double>(kAside, width() - kAside - plate.width())));
  painter.setPen(QPen(textOn(ground), 1));
  painter.setBrush(ground);
  painter.drawRoundedRect(plate, 4, 4);
  painter.setPen(ink);
  painter.drawText(plate, Qt::AlignCenter, mark.tag);
  painter.restore();
}

}  // namespace hexoderm
