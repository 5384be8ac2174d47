#pragma once

#include "widgets/style/palette.h"

#include <QCheckBox>
#include <QPainter>

namespace hexoderm {

/// A check box drawn as a switch: a mode that stays on, rather than a choice in a form.
class ToggleSwitch : public QCheckBox {
  Q_OBJECT

 public:
  using QCheckBox::QCheckBox;
  QSize sizeHint() const override {
    const int line = fontMetrics().height();
    return {static_cast<int>((1.8 + kSpace) * line) + fontMetrics().horizontalAdvance(text()) + 6,
            static_cast<int>(1.5 * line)};
  }

  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    const Colors& colors = Colors::of(palette());
    const double line = fontMetrics().height();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF track(2, 0.5 * (height() - 0.95 * line), 1.75 * line, 0.95 * line);
    const bool on = isChecked();
    painter.setPen(QPen(on && isEnabled() ? colors.accent : colors.excluded_link, 1.2));
    painter.setBrush(on ? (isEnabled() ? colors.accent : colors.excluded_link) : colors.panel);
    painter.drawRoundedRect(track, track.height() / 2, track.height() / 2);
    const double radius = 0.36 * line;
    const QPointF knob(on ? track.right() - track.height() / 2 : track.left() + track.height() / 2, track.center().y());
    painter.setPen(Qt::NoPen);
    painter.setBrush(on ? colors.panel : colors.excluded_link);
    painter.drawEllipse(knob, radius, radius);
    const QRectF label(track.right() + kSpace * line, 0, width() - track.right() - kSpace * line, height());
    painter.setPen(isEnabled() ? colors.text : colors.text_muted);
    painter.drawText(label, Qt::AlignLeft | Qt::AlignVCenter, text());
    if (hasFocus()) {
      painter.setPen(QPen(colors.text, 1.5));
      painter.setBrush(Qt::NoBrush);
      painter.drawRoundedRect(track.adjusted(-1.5, -1.5, 1.5, 1.5), track.height() / 2, track.height() / 2);
    }
  }

  bool hitButton(const QPoint& position) const override { return rect().contains(position); }

 private:
  static constexpr double kSpace = 0.6;  // between switch and text, in line heights
};

}  // namespace hexoderm
