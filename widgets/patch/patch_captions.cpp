#include "widgets/patch/patch_captions.h"

#include "widgets/scene/scene_corners.h"
#include "widgets/style/palette.h"

#include <QImage>
#include <QPainter>
#include <algorithm>

namespace hexoderm {
namespace {

constexpr int kPadding = 6;
constexpr int kSideMargin = 12;  // at the sides

/// A ground that keeps what stands on it readable over any cell.
void paintPlate(QPainter& painter, const QRect& place, QColor ground) {
  ground.setAlphaF(0.8);
  painter.save();
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(place, 4, 4);
  painter.restore();
}

void writeOnGround(QPainter& painter, const QRect& place, const QString& text, const QColor& color,
                   const QColor& ground) {
  paintPlate(painter, place.adjusted(-kPadding, -3, kPadding, 3), ground);
  painter.save();
  painter.setPen(color);
  painter.drawText(place.adjusted(0, 0, 1, 0), Qt::TextWordWrap, text);
  painter.restore();
}

}  // namespace

PatchCaptions::PatchCaptions(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void PatchCaptions::setContent(const Content& content) {
  content_ = content;
  QStringList words = content.notes;
  if (!content.message.isEmpty()) words.prepend(content.message);
  if (content.hint.isEmpty()) words << content.legend;
  setAccessibleName(content.hint);
  setAccessibleDescription(content.hint.isEmpty() ? words.join(QStringLiteral(". ")) : QString());
  update();
}

void PatchCaptions::setTopMargin(int pixels) {
  top_margin_ = pixels;
  update();
}

int PatchCaptions::notesBottom() const {
  if (content_.notes.isEmpty() || !content_.hint.isEmpty()) return 0;
  const int room = width() - 2 * (kSideMargin + kPadding);
  int bottom = top_margin_;
  for (const QString& note : content_.notes) {
    bottom += kPadding + fontMetrics().boundingRect(QRect(0, 0, room, height()), Qt::TextWordWrap, note).height();
  }
  return bottom + kPadding;
}

void PatchCaptions::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint(painter, size());
}

void PatchCaptions::paint(QPainter& painter, const QSize& area) const {
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
}

/// Below the buttons on the left.
void PatchCaptions::paintNotes(QPainter& painter, const QSize& area) const {
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

}  // namespace hexoderm
