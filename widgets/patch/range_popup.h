#pragma once

#include "widgets/coloring/scale_legend.h"
#include "widgets/controls/panel_parts.h"

#include <QDoubleSpinBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QRadioButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace hexoderm {

/// Asks for the range of a scale: fitted to what is shown, the usual one, or one that is typed. What is chosen holds at
/// once; Esc, or a click beside it, closes the popup.
class RangePopup : public QFrame {
  Q_OBJECT

 public:
  explicit RangePopup(QWidget* parent) : QFrame(parent, Qt::Popup) {
    setObjectName(QStringLiteral("rangePopup"));
    setProperty("card", true);
    setAccessibleName(tr("Range of the colours"));
    complaint_->setWordWrap(true);
    auto* ends = new QHBoxLayout;
    addWidgets(ends, {typed_, low_});
    ends->addWidget(new QLabel(tr("to")));
    addWidgets(ends, {high_, unit_});
    auto* layout = new QVBoxLayout(this);
    addWidgets(layout, {fitted_, usual_});
    layout->addLayout(ends);
    layout->addWidget(complaint_);
    for (QRadioButton* choice : {fitted_, usual_, typed_}) {
      connect(choice, &QRadioButton::clicked, this, &RangePopup::choose);
    }
    for (QDoubleSpinBox* end : {low_, high_}) {
      connect(end, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &RangePopup::takeTyped);
    }
  }

  void setScale(const ScaleLegend& scale) {
    scale_ = scale;
    const ColoringRow& row = coloringRow(scale_.coloring);
    const double step = std::pow(10.0, std::floor(std::log10((scale_.range.high - scale_.range.low) / 10)));
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step))) + 1, 1, 6);
    unit_->setText(QString::fromUtf8(row.unit));
    fitted_->setVisible(row.is_fitted);
    if (row.range) {
      usual_->setText(tr("&Usual range, %1 to %2")
                          .arg(QLocale().toString(row.range->low, 'g', 6),
                               valueWithUnit(row.range->high, *row.range, scale_.coloring)));
    }
    usual_->setVisible(row.range.has_value());
    const bool is_usual = row.range && scale_.range == *row.range && (scale_.is_fixed || !row.is_fitted);
    (is_usual ? usual_ : scale_.is_fixed ? typed_ : fitted_)->setChecked(true);
    complaint_->hide();
    // An end that is being typed stays as it is.
    const auto show = [&](QDoubleSpinBox* end, double value) {
      const QSignalBlocker quiet(end);
      end->setDecimals(decimals);
      end->setSingleStep(step);
      end->setValue(value);
    };
    show(low_, scale_.range.low);
    show(high_, scale_.range.high);
  }

  /// Opens with its lower right corner at a place on the screen.
  void openAt(const QPoint& lower_right) {
    adjustSize();
    QRect place(QPoint(0, 0), size());
    place.moveBottomRight(lower_right);
    const QRect room = parentWidget()->screen()->availableGeometry();
    place.moveLeft(std::clamp(place.left(), room.left(), std::max(room.left(), room.right() - place.width())));
    place.moveTop(std::clamp(place.top(), room.top(), std::max(room.top(), room.bottom() - place.height())));
    move(place.topLeft());
    show();
    for (QRadioButton* choice : {fitted_, usual_, typed_}) {
      if (choice->isChecked()) choice->setFocus(Qt::PopupFocusReason);
    }
  }

 signals:
  /// low < high
  void rangeWanted(hexoderm::ColorRange range);
  void fitWanted();

 private:
  static constexpr double kLargestEnd = 1e6;
  static QDoubleSpinBox* makeEnd(const QString& name, const QString& words) {
    auto* end = new QDoubleSpinBox;
    setNames(end, name, words);
    end->setRange(-kLargestEnd, kLargestEnd);
    end->setKeyboardTracking(false);  // a number that is half typed is none
    return end;
  }

  void choose() {
    const ColoringRow& row = coloringRow(scale_.coloring);
    if (fitted_->isChecked() || (usual_->isChecked() && !row.is_fitted)) {
      emit fitWanted();
    } else if (usual_->isChecked()) {
      emit rangeWanted(*row.range);
    } else {
      takeTyped();
    }
  }

  void takeTyped() {
    const ColorRange range{low_->value(), high_->value()};
    const bool is_one = range.low < range.high;
    complaint_->setVisible(!is_one);
    adjustSize();
    if (is_one) emit rangeWanted(range);
  }

  ScaleLegend scale_;
  QRadioButton* fitted_ = named(new QRadioButton(tr("&Fitted to what is shown")), "rangeFitted");
  QRadioButton* usual_ = named(new QRadioButton, "rangeUsual");
  QRadioButton* typed_ = named(new QRadioButton(tr("F&ixed:")), "rangeTyped");
  QDoubleSpinBox* low_ = makeEnd(QStringLiteral("rangeLow"), tr("Lower end of the range"));
  QDoubleSpinBox* high_ = makeEnd(QStringLiteral("rangeHigh"), tr("Upper end of the range"));
  QLabel* unit_ = new QLabel;
  QLabel* complaint_ = styledAs(new QLabel(tr("The lower end must be below the upper one.")), "muted");
};

}  // namespace hexoderm
