#pragma once

#include "widgets/controls/panel_parts.h"
#include "widgets/scene/scene_corners.h"
#include "widgets/scene/scene_ghost.h"
#include "widgets/style/palette.h"

#include <QPainter>
#include <QPainterPath>
#include <QStringList>
#include <QWidget>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hexoderm {

/// The texts over the 3D scene: a line for each thing drawn over the cells, the word beside the gravity arrow, that of
/// the next pose beside its ghost with a curved arrow that leads there, and a hint if there is nothing to see. Lets the
/// mouse through.
class PatchCaptions : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString hint;                      ///< instead of everything else, where not empty
    bool gravity = false;              ///< the arrow is there
    std::optional<QString> next_pose;  ///< its ghost is there; how far it is ("70°"), or empty
    QStringList notes;
    QString message;  ///< the message of a tool; emphasised above the notes
    QString legend;   ///< in words, for screen readers
  };

  explicit PatchCaptions(QWidget* parent = nullptr) : QWidget(parent) { letThrough(this); }

  void setContent(const Content& content) {
    content_ = content;
    QStringList words = content.notes;
    if (!content.message.isEmpty()) words.prepend(content.message);
    if (content.hint.isEmpty()) words << content.legend;
    setAccessibleName(content.hint);
    setAccessibleDescription(content.hint.isEmpty() ? words.join(QStringLiteral(". ")) : QString());
    update();
  }

  /// Kept free for the buttons.
  void setTopMargin(int pixels) {
    top_margin_ = pixels;
    update();
  }

  /// Down to here the notes reach, which stay while the picture does; 0 if there are none. In pixels.
  [[nodiscard]] int notesBottom() const {
    if (content_.notes.isEmpty() || !content_.hint.isEmpty()) return 0;
    const int room = width() - 2 * (kSideMargin + kPadding);
    int bottom = top_margin_;
    for (const QString& note : content_.notes) {
      bottom += kPadding + fontMetrics().boundingRect(QRect(0, 0, room, height()), Qt::TextWordWrap, note).height();
    }
    return bottom + kPadding;
  }

  /// Paints the same texts into a screenshot of the given size.
  void paint(QPainter& painter, const QSize& area) const {
    const Colors& colors = Colors::of(palette());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    if (!content_.hint.isEmpty()) {
      painter.setPen(colors.text_muted);
      painter.drawText(QRect(QPoint(0, 0), area).adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                       content_.hint);
      return;
    }
    if (content_.gravity) {
      // Above the arrow, wherever that points.
      const QRect arrow(area.width() - SceneCorners::kRight - SceneCorners::kSize,
                        area.height() - SceneCorners::kBottom - SceneCorners::kSize, SceneCorners::kSize,
                        SceneCorners::kSize);
      QRect word = painter.fontMetrics().boundingRect(tr("gravity"));
      word.moveCenter(QPoint(arrow.center().x(), arrow.top() - word.height()));
      word.moveRight(std::min(word.right(), area.width() - kPadding - SceneCorners::kRight / 2));
      writeOnGround(painter, word, tr("gravity"), colors.text_muted, colors.scene_bottom);
    }
    paintNotes(painter, area);
    if (content_.next_pose) paintNextPose(painter, area);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    paint(painter, size());
  }

 private:
  static constexpr int kPadding = 6;
  static constexpr int kSideMargin = 12;  // at the sides
  /// A ground that keeps what stands on it readable over any cell.
  static void paintPlate(QPainter& painter, const QRect& place, QColor ground) {
    ground.setAlphaF(0.8);
    painter.save();
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(place, 4, 4);
    painter.restore();
  }

  static void writeOnGround(QPainter& painter, const QRect& place, const QString& text, const QColor& color,
                            const QColor& ground) {
    paintPlate(painter, place.adjusted(-kPadding, -3, kPadding, 3), ground);
    painter.save();
    painter.setPen(color);
    painter.drawText(place.adjusted(0, 0, 1, 0), Qt::TextWordWrap, text);
    painter.restore();
  }

  /// Below the buttons on the left.
  void paintNotes(QPainter& painter, const QSize& area) const {
    const Colors& colors = Colors::of(palette());
    const QRect room(kSideMargin + kPadding, top_margin_ + kPadding, area.width() - 2 * (kSideMargin + kPadding),
                     area.height() - top_margin_);
    int top = room.top();
    const auto write = [&](const QString& text, const QColor& color, bool emphasised) {
      QFont font = painter.font();
      font.setBold(emphasised);
      painter.setFont(font);
      const QRect needed =
          painter.boundingRect(QRect(room.left(), top, room.width(), area.height()), Qt::TextWordWrap, text);
      writeOnGround(painter, needed, text, color, colors.scene_top);
      top = needed.bottom() + kPadding;
    };
    painter.save();
    if (!content_.message.isEmpty()) write(content_.message, colors.text, true);
    for (const QString& note : content_.notes) write(note, colors.text_muted, false);
    painter.restore();
  }

  void paintNextPose(QPainter& painter, const QSize& area) const {
    const Colors& colors = Colors::of(palette());
    const auto [left, bottom, right, top] = SceneGhost::placeIn(area.width(), area.height());
    const QRectF ghost(left, area.height() - top, right - left, top - bottom);
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    const double line = QFontMetricsF(bold).height();
    const QString& angle = *content_.next_pose;
    const QString words = angle.isEmpty() ? tr("next pose") : tr("next pose, %1").arg(angle);
    QRectF plate(0, 0, QFontMetricsF(bold).horizontalAdvance(words) + line, 1.2 * line);
    plate.moveCenter({ghost.center().x(), ghost.top() - 0.9 * line});
    constexpr double kInset_px = 8;
    plate.moveRight(std::min(plate.right(), area.width() - kInset_px));
    paintPlate(painter, plate.toAlignedRect(), colors.scene_top);
    painter.setPen(colors.accent);
    painter.drawText(plate, Qt::AlignCenter, words);
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

  Content content_;
  int top_margin_ = 0;
};

}  // namespace hexoderm
