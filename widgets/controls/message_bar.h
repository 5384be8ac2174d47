#pragma once

#include "widgets/controls/banner.h"

#include <QFrame>
#include <functional>

class QLabel;
class QPushButton;

namespace hexoderm {

/// Says what has just happened, without stopping anybody: "Exported to ...", or what went wrong and where. Stays until
/// it is closed or the next message comes. A notice: it lies over the content (NoticeStack).
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showMessage(Tone tone, const QString& text, const QString& button = {}, std::function<void()> pressed = {});
  [[nodiscard]] QString text() const;
  /// Something went wrong and nobody has closed the message yet: good news should not take its place.
  [[nodiscard]] bool isUrgent() const { return isVisible() && tone_ == Tone::Bad; }

 signals:
  /// Emitted for a record of the messages shown to the operator.
  void shown(hexoderm::Tone tone, const QString& text);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QLabel* text_;
  QPushButton* button_;
  std::function<void()> pressed_;
  Tone tone_ = Tone::Neutral;
};

}  // namespace hexoderm
