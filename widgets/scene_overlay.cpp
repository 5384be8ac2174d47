#include "widgets/scene_overlay.h"

#include "widgets/scene_corners.h"

#include <QPainter>

namespace hexoderm {

SceneOverlay::SceneOverlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void SceneOverlay::setContent(const Content& content) {
  content_ = content;
  QStringList words = content.notes;
  if (!content.message.isEmpty()) words.prepend(content.message);
  if (content.hint.isEmpty()) words << legendInWords(content.legend);
  setAccessibleName(content.hint);
  setAccessibleDescription(content.hint.isEmpty() ? words.join(QStringLiteral(". ")) : QString());
  update();
}

void SceneOverlay::setTheme(Theme theme, const SceneColors& colors) {
  theme_ = theme;
  colors_ = colors;
  update();
}

void SceneOverlay::setTopMargin(int pixels) {
  top_margin_ = pixels;
  update();
}

void SceneOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint(painter, size());
}

void SceneOverlay::paint(QPainter& painter, const QSize& area) const {
  const Colors& colors = Colors::of(theme_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font());
  if (!content_.hint.isEmpty()) {
    painter.setPen(colors.text_muted);
    painter.drawText(QRect(QPoint(0, 0), area).adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                     content_.hint);
    return;
  }
  if (content_.gravity) {
    painter.setPen(colors.text_muted);
    const int right = area.width() - 12;
    const int middle = area.height() - SceneCorners::kBottom - SceneCorners::kSize / 2;
    painter.drawText(QRect(right - 120, middle - 12, 120, 24), Qt::AlignRight | Qt::AlignVCenter, tr("gravity"));
  }
  paintNotes(painter, area);
  paintLegend(painter, area, content_.legend, theme_, colors_);
}

/// Below the buttons on the left, on a ground that keeps them readable over any cell.
void SceneOverlay::paintNotes(QPainter& painter, const QSize& area) const {
  const Colors& colors = Colors::of(theme_);
  constexpr int kMargin = 12;
  constexpr int kPadding = 6;
  const QRect room(kMargin + kPadding, top_margin_ + kPadding, area.width() - 2 * (kMargin + kPadding),
                   area.height() - top_margin_);
  int top = room.top();
  const auto write = [&](const QString& text, const QColor& color, bool emphasised) {
    QFont font = painter.font();
    font.setBold(emphasised);
    painter.setFont(font);
    const QRect needed =
        painter.boundingRect(QRect(room.left(), top, room.width(), area.height()), Qt::TextWordWrap, text);
    QColor ground = colors.scene_top;
    ground.setAlphaF(0.78);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(needed.adjusted(-kPadding, -3, kPadding, 3), 3, 3);
    painter.setPen(color);
    painter.drawText(needed.adjusted(0, 0, 1, 0), Qt::TextWordWrap, text);
    top = needed.bottom() + kPadding;
  };
  painter.save();
  if (!content_.message.isEmpty()) write(content_.message, colors.text, true);
  for (const QString& note : content_.notes) write(note, colors.text_muted, false);
  painter.restore();
}

}  // namespace hexoderm
