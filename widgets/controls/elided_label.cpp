#include "widgets/controls/elided_label.h"

#include <QHelpEvent>
#include <QPainter>
#include <QStyle>
#include <QTextLayout>
#include <QToolTip>
#include <algorithm>

namespace hexoderm {

ElidedLabel::ElidedLabel(int lines, QWidget* parent) : QLabel(parent), lines_(lines) {
  setProperty(kElides, true);
  // Names of cells, files and devices come from outside: never read as markup.
  setTextFormat(Qt::PlainText);
  setSizePolicy(lines > 1 ? QSizePolicy::Expanding : QSizePolicy::Preferred, QSizePolicy::Fixed);
  setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

int ElidedLabel::linesHeight() const { return lines_ * fontMetrics().lineSpacing(); }

QSize ElidedLabel::sizeHint() const {
  const QMargins margins = contentsMargins();
  return {fontMetrics().horizontalAdvance(text()) + 1 + margins.left() + margins.right(), heightForWidth(0)};
}

QSize ElidedLabel::minimumSizeHint() const {
  constexpr int kFewest = 3;  // characters, so that the dots are seen
  return {kFewest * fontMetrics().averageCharWidth(), heightForWidth(0)};
}

int ElidedLabel::heightForWidth(int /*width*/) const {
  const QMargins margins = contentsMargins();
  return linesHeight() + margins.top() + margins.bottom();
}

QStringList ElidedLabel::shownLines() const {
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

bool ElidedLabel::isElided() const {
  const QStringList lines = shownLines();
  return !lines.isEmpty() && lines.last().endsWith(QChar(0x2026)) && !text().endsWith(QChar(0x2026));
}

bool ElidedLabel::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && isElided()) {
    const QString whole = toolTip().isEmpty() ? text() : text() + QStringLiteral("\n\n") + toolTip();
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), whole, this);
    return true;
  }
  return QLabel::event(event);
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
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

}  // namespace hexoderm
