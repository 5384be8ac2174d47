#pragma once

#include <QHelpEvent>
#include <QLabel>
#include <QPainter>
#include <QStyle>
#include <QTextLayout>
#include <QToolTip>
#include <algorithm>

namespace hexoderm {

/// A label that never asks for more room, whatever its text: as many lines high as it is told to be, and as narrow as
/// its place. What does not fit ends in dots, and the tool tip has the whole of it. text() is always the whole.
class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  /// Property of labels whose whole text stands in the tool tip if it is elided.
  static constexpr const char* kElides = "elides";

  explicit ElidedLabel(int lines = 1, QWidget* parent = nullptr) : QLabel(parent), lines_(lines) {
    setProperty(kElides, true);
    // Names of cells, files and devices come from outside: never read as markup.
    setTextFormat(Qt::PlainText);
    setSizePolicy(lines > 1 ? QSizePolicy::Expanding : QSizePolicy::Preferred, QSizePolicy::Fixed);
    setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  }

  [[nodiscard]] bool isElided() const {
    const QStringList lines = shownLines();
    return !lines.isEmpty() && lines.last().endsWith(QChar(0x2026)) && !text().endsWith(QChar(0x2026));
  }

  [[nodiscard]] QSize sizeHint() const override {
    const QMargins margins = contentsMargins();
    return {fontMetrics().horizontalAdvance(text()) + 1 + margins.left() + margins.right(), heightForWidth(0)};
  }

  [[nodiscard]] QSize minimumSizeHint() const override {
    constexpr int kFewest = 3;  // characters, so that the dots are seen
    return {kFewest * fontMetrics().averageCharWidth(), heightForWidth(0)};
  }

  [[nodiscard]] bool hasHeightForWidth() const override { return false; }
  [[nodiscard]] int heightForWidth(int /*width*/) const override {
    const QMargins margins = contentsMargins();
    return linesHeight() + margins.top() + margins.bottom();
  }

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ToolTip && isElided()) {
      const QString whole = toolTip().isEmpty() ? text() : text() + QStringLiteral("\n\n") + toolTip();
      QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), whole, this);
      return true;
    }
    return QLabel::event(event);
  }

  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    const QStringList lines = shownLines();
    const int spacing = fontMetrics().lineSpacing();
    const QRect room = contentsRect();
    int top = room.top() + (room.height() - spacing * static_cast<int>(lines.size())) / 2;
    for (const QString& line : lines) {
      style()->drawItemText(&painter, QRect(room.left(), top, room.width(), spacing),
                            static_cast<int>(alignment() & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter, palette(),
                            isEnabled(), line, foregroundRole());
      top += spacing;
    }
  }

 private:
  /// The lines that are shown; the last one elided if there would be more.
  [[nodiscard]] QStringList shownLines() const {
    const int width = std::max(1, contentsRect().width());
    QTextLayout layout(text(), font());
    layout.beginLayout();
    QStringList lines;
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
      line.setLineWidth(width);
      const int begin = line.textStart();
      if (lines.size() + 1 == lines_) {
        lines << fontMetrics().elidedText(text().mid(begin), Qt::ElideRight, width);
        break;
      }
      lines << text().mid(begin, line.textLength()).trimmed();
    }
    layout.endLayout();
    return lines;
  }

  [[nodiscard]] int linesHeight() const { return lines_ * fontMetrics().lineSpacing(); }

  int lines_;
};

}  // namespace hexoderm
