#include "widgets/controls/action_button.h"

#include <QAction>
#include <QStyleOptionButton>
#include <QStylePainter>

namespace hexoderm {

ActionButton::ActionButton(QWidget* parent) : QPushButton(parent) {
  hide();
  connect(this, &QPushButton::clicked, this, [this] {
    if (action_) action_->trigger();
  });
}

void ActionButton::setAction(QAction* action) {
  if (action_ == action) return;
  if (action_) disconnect(action_, nullptr, this, nullptr);
  action_ = action;
  if (action_) {
    connect(action_, &QAction::changed, this, &ActionButton::refresh);
    connect(action_, &QObject::destroyed, this, &QWidget::hide);
    refresh();
  }
  setVisible(action_ != nullptr);
}

void ActionButton::setRoom(int width) {
  if (room_ == width) return;
  room_ = width;
  updateGeometry();
  update();
}

/// As few lines as will do, which are broken between words.
QString ActionButton::brokenText() const {
  const int beside = QPushButton::sizeHint().width() - fontMetrics().size(Qt::TextShowMnemonic, text()).width();
  const int room = room_ - beside;
  if (room_ <= 0 || fontMetrics().horizontalAdvance(text()) <= room) return text();
  QString broken;
  QString line;
  for (const QString& word : text().split(QLatin1Char(' '))) {
    const QString longer = line.isEmpty() ? word : line + QLatin1Char(' ') + word;
    if (!line.isEmpty() && fontMetrics().horizontalAdvance(longer) > room) {
      broken += line + QLatin1Char('\n');
      line = word;
    } else {
      line = longer;
    }
  }
  return broken + line;
}

QSize ActionButton::sizeHint() const {
  const QSize whole = fontMetrics().size(Qt::TextShowMnemonic, text());
  const QSize broken = fontMetrics().size(Qt::TextShowMnemonic, brokenText());
  return QPushButton::sizeHint() + broken - whole;
}

void ActionButton::paintEvent(QPaintEvent* /*event*/) {
  QStylePainter painter(this);
  QStyleOptionButton option;
  initStyleOption(&option);
  option.text = brokenText();
  painter.drawControl(QStyle::CE_PushButton, option);
}

void ActionButton::refresh() {
  setText(action_->iconText());
  setAccessibleName(action_->iconText());
  setEnabled(action_->isEnabled());
  setToolTip(action_->toolTip());
  setAccessibleDescription(action_->toolTip());
}

}  // namespace hexoderm
