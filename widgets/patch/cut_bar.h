#pragma once

#include <QFrame>

class QSlider;

namespace hexoderm {

/// How deep the skin is cut open: a slider, which the arrow keys move too, and a button that turns the cut to the
/// viewer.
class CutBar : public QFrame {
  Q_OBJECT

 public:
  explicit CutBar(QWidget* parent = nullptr);

  /// Of the skin's depth, 0 to 1.
  [[nodiscard]] double share() const;

 signals:
  void shareChanged(double share);
  void alignRequested();

 private:
  static constexpr int kSteps = 100;
  QSlider* slider_;
};

}  // namespace hexoderm
