#pragma once

#include "widgets/controls/banner.h"
#include "widgets/controls/panel_parts.h"

#include <QAccessible>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVariant>
#include <functional>
#include <utility>

namespace hexoderm {

/// Says what has just happened, without stopping anybody: "Exported to ...", or what went wrong and where. Stays until
/// it is closed or the next message comes. A notice: it lies over the content (NoticeStack).
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr) : QFrame(parent) {
    setObjectName(QStringLiteral("messageBar"));
    setProperty("card", true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    connect(button_, &QPushButton::clicked, this, [this] {
      // A copy: what it does may bring the next message.
      if (const std::function<void()> pressed = pressed_) pressed();
    });
    auto* close = styledAs(named(new QToolButton(this), "messageClose", tr("Close this message")), "flat");
    close->setText(QStringLiteral("\u2715"));
    close->setToolTip(tr("Close this message"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);

    auto* layout = spaced(new QHBoxLayout(this), {16, 6, 8, 6});
    layout->addWidget(text_, 1);
    addWidgets(layout, {button_, close});
    hide();
  }

  void showMessage(Tone tone, const QString& text, const QString& button = {}, std::function<void()> pressed = {}) {
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

  [[nodiscard]] QString text() const { return text_->text(); }
  /// Something went wrong and nobody has closed the message yet: good news should not take its place.
  [[nodiscard]] bool isUrgent() const { return isVisible() && tone_ == Tone::Bad; }

 signals:
  /// Emitted for a record of the messages shown to the operator.
  void shown(hexoderm::Tone tone, const QString& text);

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    if (event->key() == Qt::Key_Escape) {
      hide();
      return;
    }
    QFrame::keyPressEvent(event);
  }

  void paintEvent(QPaintEvent* event) override {
    QFrame::paintEvent(event);
    // A bar along the left edge carries the tone; the words carry it too.
    QPainter(this).fillRect(0, 6, 4, height() - 12, toneColor(tone_, themeOf(palette())));
  }

 private:
  QLabel* text_ = paragraph("messageText", this);
  QPushButton* button_ = named(new QPushButton(this), "messageButton");
  std::function<void()> pressed_;
  Tone tone_ = Tone::Neutral;
};

}  // namespace hexoderm
