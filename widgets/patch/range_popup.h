#pragma once

#include "widgets/coloring/scale_legend.h"

#include <QFrame>

class QDoubleSpinBox;
class QLabel;
class QRadioButton;

namespace hexoderm {

/// Asks for the range of a scale: fitted to what is shown, the usual one, or one that is typed. What is chosen holds at
/// once; Esc, or a click beside it, closes the popup.
class RangePopup : public QFrame {
  Q_OBJECT

 public:
  explicit RangePopup(QWidget* parent);

  void setScale(const ScaleLegend& scale);
  /// Opens with its lower right corner at a place on the screen.
  void openAt(const QPoint& lower_right);

 signals:
  /// low < high
  void rangeWanted(hexoderm::ColorRange range);
  void fitWanted();

 private:
  void choose();
  void takeTyped();

  ScaleLegend scale_;
  QRadioButton* fitted_;
  QRadioButton* usual_;
  QRadioButton* typed_;
  QDoubleSpinBox* low_;
  QDoubleSpinBox* high_;
  QLabel* unit_;
  QLabel* complaint_;
};

}  // namespace hexoderm
