#pragma once

#include "widgets/style/palette.h"

#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <array>
#include <cmath>

namespace hexoderm {

/// A ring that fills while the part is held, with what to do in its middle: "Hold still", "starts over".
class HoldRing : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString word;
    QString detail;
    double progress = 0;    ///< 0 to 1
    bool captured = false;  ///< a pose was just taken: a full ring with a tick

    friend bool operator==(const Content&, const Content&) = default;
  };

  explicit HoldRing(QWidget* parent = nullptr) : QWidget(parent) {
    setObjectName(QStringLiteral("holdRing"));
    setAccessibleName(tr("How long the part has been held"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  }

  /// Cheap: may be called 20 times a second.
  void setContent(const Content& content) {
    // The words alone: progress would be read out twenty times a second.
    if (content.word != content_.word) setAccessibleDescription(content.word);
    const bool is_same = content == content_;
    content_ = content;
    if (!is_same) update();
  }

  [[nodiscard]] const Content& content() const { return content_; }

  QSize sizeHint() const override {
    const int side = 9 * fontMetrics().height();
    return {side, side};
  }

  QSize minimumSizeHint() const override {
    const int side = 6 * fontMetrics().height();
    return {side, side};
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    const Colors& colors = Colors::of(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = std::min(width(), height()) - 2.0;
    const double thick = 0.085 * side;
    const QRectF circle(0.5 * (width() - side + thick), 0.5 * (height() - side + thick), side - thick, side - thick);
    painter.setPen(QPen(colors.border, thick));
    painter.drawEllipse(circle);
    const double progress = content_.captured ? 1 : std::clamp(content_.progress, 0.0, 1.0);
    if (progress > 0) {
      constexpr double kTurn = 360 * 16;  // sixteenths of a degree, as Qt counts
      constexpr int kTop = 90 * 16;
      painter.setPen(QPen(content_.captured ? colors.good : colors.accent, thick, Qt::SolidLine, Qt::RoundCap));
      painter.drawArc(circle, kTop, -static_cast<int>(std::lround(kTurn * progress)));
    }
    const double inner = 0.78 * (side - 2 * thick);
    QFont large = font();
    large.setWeight(QFont::DemiBold);
    large = fitted(large, content_.word, inner, 1.55 * font().pointSizeF());
    const QFont small = fitted(font(), content_.detail, 0.92 * inner, font().pointSizeF());
    const double large_height = QFontMetricsF(large).height();
    const double small_height = QFontMetricsF(small).height();
    double top = circle.center().y() - 0.5 * (large_height + small_height);
    if (content_.captured) {
      const QPointF c(circle.center().x(), top - 0.05 * side);
      const double unit = 0.05 * side;
      const std::array<QPointF, 3> tick = {c + QPointF(-unit, 0), c + QPointF(-0.25 * unit, 0.75 * unit),
                                           c + QPointF(1.1 * unit, -0.8 * unit)};
      painter.setPen(QPen(colors.good, 0.4 * unit + 1, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPolyline(tick.data(), 3);
    }
    painter.setFont(large);
    painter.setPen(colors.text);
    painter.drawText(QRectF(0, top, width(), large_height), Qt::AlignCenter, content_.word);
    top += large_height;
    painter.setFont(small);
    painter.setPen(colors.text_muted);
    painter.drawText(QRectF(0, top, width(), small_height), Qt::AlignCenter, content_.detail);
  }

 private:
  /// The largest size up to `most_pt` at which the text is no wider than this.
  static QFont fitted(QFont font, const QString& text, double width, double most_pt) {
    font.setPointSizeF(most_pt);
    const double needed = QFontMetricsF(font).horizontalAdvance(text);
    constexpr double kSmallest_pt = 1;  // Qt has no font of no size, which a ring without room would ask for
    if (needed > width && needed > 0) font.setPointSizeF(std::max(kSmallest_pt, most_pt * width / needed));
    return font;
  }

  Content content_;
};

}  // namespace hexoderm
