#pragma once

#include <QAction>
#include <QPointer>
#include <QPushButton>

namespace hexoderm {

/// A button that is a view of an action: its text, whether it can be used and, if not, why. Hidden without an action. A
/// text that is wider than its place stands in several lines.
class ActionButton : public QPushButton {
  Q_OBJECT

 public:
  explicit ActionButton(QWidget* parent = nullptr);

  /// Null hides the button. The action need not outlive it.
  void setAction(QAction* action);
  [[nodiscard]] QAction* action() const { return action_; }
  /// The room for the whole button, beyond which its text is broken into lines; 0: as much as it likes.
  void setRoom(int width);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void refresh();
  [[nodiscard]] QString brokenText() const;

  QPointer<QAction> action_;
  int room_ = 0;
};

}  // namespace hexoderm
