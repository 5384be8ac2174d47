#include "widgets/controls/message_bar.h"

#include "widgets/controls/panel_parts.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVariant>
#include <utility>

namespace hexoderm {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), text_(new QLabel(this)), button_(new QPushButton(this)) {
  setObjectName(QStringLiteral("messageBar"));
  setProperty("card", true);
  text_->setObjectName(QStringLiteral("messageText"));
  setPlainParagraph(text_);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  button_->setObjectName(QStringLiteral("messageButton"));
  connect(button_, &QPushButton::clicked, this, [this] {
    // A copy: what it does may bring the next message.
    if (const std::function<void()> pressed = pressed_) pressed();
  });
  auto* close = new QToolButton(this);
  close->setObjectName(QStringLiteral("messageClose"));
  close->setProperty("flat", true);
  close->setText(QStringLiteral("\u2715"));
  close->setToolTip(tr("Close this message"));
  close->setAccessibleName(tr("Close this message"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);

  auto* layout = spaced(new QHBoxLayout(this), {16, 6, 8, 6});
  layout->addWidget(text_, 1);
  addWidgets(layout, {button_, close});
  hide();
}

void MessageBar::showMessage(Tone tone, const QString& text, const QString& button, std::function<void()> pressed) {
  tone_ = tone;
  text_->setText(text);
  pressed_ = std::move(pressed);
  button_->setText(button);
  button_->setVisible(!button.isEmpty());
  setAccessibleName(text);
  show();
  update();
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
  emit shown(tone, text);
}

QString MessageBar::text() const { return text_->text(); }

void MessageBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    hide();
    return;
  }
  QFrame::keyPressEvent(event);
}

void MessageBar::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  // A bar along the left edge carries the tone; the words carry it too.
  QPainter(this).fillRect(0, 6, 4, height() - 12, toneColor(tone_, themeOf(palette())));
}

}  // namespace hexoderm
