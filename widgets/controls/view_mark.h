#pragma once

#include "widgets/controls/banner.h"
#include "widgets/controls/panel_parts.h"

#include <QEvent>
#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <optional>

namespace hexoderm {

/// Marks a view whose picture is not what it usually is: of this moment, without readings, preliminary, or from
/// before. A frame around the view, words at its upper edge, and a veil over a picture that is no result of now. Lies
/// over the view, lets the mouse through, and is hidden where there is nothing to mark.
class ViewMark : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    Tone tone = Tone::Neutral;
    QString words;
    bool has_frame = true;
    bool is_muted = false;  ///< a veil lies over the picture

    friend bool operator==(const Content&, const Content&) = default;
  };

  /// Lies over `view`, which owns it, as large as that is.
  explicit ViewMark(QWidget* view) : QWidget(view) {
    letThrough(this);
    view->installEventFilter(this);
    hide();
  }

  /// None: nothing is marked.
  void setContent(const std::optional<Content>& content) {
    if (content_ == content) return;
    content_ = content;
    setAccessibleName(content_ ? content_->words : QString());
    setGeometry(parentWidget()->rect());
    raise();
    setVisible(content_.has_value());
    update();
  }

  [[nodiscard]] const std::optional<Content>& content() const { return content_; }
  /// What of the top is kept free for buttons, and whether the words stand on the right instead of in the middle.
  void setPlace(int top_margin, bool at_right) {
    top_margin_ = top_margin;
    at_right_ = at_right;
    update();
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
    // Views change places.
    if (event->type() == QEvent::LayoutRequest) raise();
    return QWidget::eventFilter(watched, event);
  }

  void paintEvent(QPaintEvent* /*event*/) override {
    if (!content_) return;
    constexpr int kFrame = 4;
    constexpr int kPaddingX = 12;
    constexpr int kPaddingY = 5;
    const Colors& colors = Colors::of(palette());
    const QColor color =
        content_->tone == Tone::Neutral ? colors.accent : toneColor(content_->tone, themeOf(palette()));
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (content_->is_muted) {
      QColor veil = colors.panel;
      veil.setAlphaF(0.45);
      painter.fillRect(rect(), veil);
    }
    if (content_->has_frame) {
      painter.setPen(QPen(color, kFrame, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
      painter.setBrush(Qt::NoBrush);
      const double half = kFrame / 2.0;
      painter.drawRect(QRectF(rect()).adjusted(half, half, -half, -half));
    }
    if (content_->words.isEmpty()) return;
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    const int beside = 2 * (kFrame + kPaddingX + 4);
    const QRect needed = painter.boundingRect(QRect(0, 0, std::max(1, width() - beside), height()),
                                              Qt::AlignHCenter | Qt::TextWordWrap, content_->words);
    const QSize plate(needed.width() + 2 * kPaddingX, needed.height() + 2 * kPaddingY);
    constexpr int kApart = 6;
    const int left = at_right_ ? width() - plate.width() - kFrame - kApart : (width() - plate.width()) / 2;
    const QRect place(QPoint(left, top_margin_ + kFrame + kApart), plate);
    painter.setPen(QPen(color, 2));
    painter.setBrush(colors.panel);
    painter.drawRoundedRect(place, 6, 6);
    painter.setPen(colors.text);
    painter.drawText(place, Qt::AlignCenter | Qt::TextWordWrap, content_->words);
  }

 private:
  std::optional<Content> content_;
  int top_margin_ = 0;
  bool at_right_ = false;
};

}  // namespace hexoderm
