#pragma once

#include <QAction>
#include <QPointer>
#include <QPushButton>
#include <QStyleOptionButton>
#include <QStylePainter>

namespace hexoderm {

/// A button that is a view of an action: its text, whether it can be used and, if not, why. Hidden without an action. A
/// text that is wider than its place stands in several lines.
class ActionButton : public QPushButton {
  Q_OBJECT

 public:
  explicit ActionButton(QWidget* parent = nullptr) : QPushButton(parent) {
    hide();
    connect(this, &QPushButton::clicked, this, [this] {
      if (action_) action_->trigger();
    });
  }

  /// Null hides the button. The action need not outlive it.
  void setAction(QAction* action) {
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

  [[nodiscard]] QAction* action() const { return action_; }
  /// The room for the whole button, beyond which its text is broken into lines; 0: as much as it likes.
  void setRoom(int width) {
    if (room_ == width) return;
    room_ = width;
    updateGeometry();
    update();
  }

  [[nodiscard]] QSize sizeHint() const override {
    const QSize whole = fontMetrics().size(Qt::TextShowMnemonic, text());
    const QSize broken = fontMetrics().size(Qt::TextShowMnemonic, brokenText());
    return QPushButton::sizeHint() + broken - whole;
  }

  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QStylePainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    option.text = brokenText();
    painter.drawControl(QStyle::CE_PushButton, option);
  }

 private:
  void refresh() {
    setText(action_->iconText());
    setAccessibleName(action_->iconText());
    setEnabled(action_->isEnabled());
    setToolTip(action_->toolTip());
    setAccessibleDescription(action_->toolTip());
  }

  /// As few lines as will do, which are broken between words.
  [[nodiscard]] QString brokenText() const {
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

  QPointer<QAction> action_;
  int room_ = 0;
};

}  // namespace hexoderm
