#pragma once

#include <QCheckBox>

namespace hexoderm {

/// A check box drawn as a switch: a mode that stays on, rather than a choice in a form.
class ToggleSwitch : public QCheckBox {
  Q_OBJECT

 public:
  using QCheckBox::QCheckBox;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool hitButton(const QPoint& position) const override { return rect().contains(position); }
};

}  // namespace hexoderm
