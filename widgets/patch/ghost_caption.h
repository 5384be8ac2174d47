#pragma once

#include "widgets/scene/scene_ghost.h"
#include "widgets/style/palette.h"

#include <QPainter>
#include <QPainterPath>
#include <QWidget>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hexoderm {

/// "next pose" beside its ghost in the 3D view, how far it is, and a curved arrow that leads there. Lets the mouse
/// through.
class GhostCaption : public QWidget {
  Q_OBJECT

 public:
  explicit GhostCaption(QWidget* parent = nullptr) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
  }

  void setShown(bool shown) {
    // It lies over the whole view, which would be painted with it.
    if (std::exchange(shown_, shown) != shown) update();
  }

  /// "70°"; empty: not said.
  void setAngle(const QString& angle) {
    if (angle_ == angle) return;
    angle_ = angle;
    update();
  }

  void paint(QPainter& painter, const QSize& area) const {
    if (!shown_) return;
    const Colors& colors = Colors::of(palette());
    const auto [left, bottom, right, top] = SceneGhost::placeIn(area.width(), area.height());
    const QRectF ghost(left, area.height() - top, right - left, top - bottom);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    const double line = QFontMetricsF(bold).height();
    const QString words = angle_.isEmpty() ? tr("next pose") : tr("next pose, %1").arg(angle_);
    QRectF room(ghost.left() - line, ghost.top() - 1.4 * line, ghost.width() + 2 * line, line);
    QRectF plate(0, 0, QFontMetricsF(bold).horizontalAdvance(words) + line, 1.2 * line);
    plate.moveCenter(room.center());
    constexpr double kInset_px = 8;
    plate.moveRight(std::min(plate.right(), area.width() - kInset_px));
    room.moveCenter(plate.center());
    QColor ground = colors.scene_top;
    ground.setAlphaF(0.8);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(plate, 4, 4);
    painter.setPen(colors.accent);
    painter.drawText(room, Qt::AlignCenter, words);
    // From the part, over its upper right, to the ghost.
    const QPointF from(ghost.left() - 0.34 * ghost.width(), ghost.top() + 0.26 * ghost.height());
    const QPointF to(ghost.left() + 0.06 * ghost.width(), ghost.top() + 0.16 * ghost.height());
    const QPointF over(0.5 * (from.x() + to.x()), ghost.top() - 0.14 * ghost.height());
    QPainterPath path(from);
    path.quadTo(over, to);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors.accent, 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(path);
    QPointF along = to - over;
    along /= std::hypot(along.x(), along.y());
    const QPointF across(-along.y(), along.x());
    const double size = 0.75 * line;
    const std::array<QPointF, 3> head = {to + 0.4 * size * along, to - 0.6 * size * along + 0.45 * size * across,
                                         to - 0.6 * size * along - 0.45 * size * across};
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors.accent);
    painter.drawPolygon(head.data(), 3);
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    paint(painter, size());
  }

 private:
  bool shown_ = false;
  QString angle_;
};

}  // namespace hexoderm
