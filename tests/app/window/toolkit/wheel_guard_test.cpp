#include "app/window/toolkit/wheel_guard.h"

#include "tests/support/qt_wait.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

/// A panel that scrolls, with one control of each kind at its top and much below.
class WheelGuardTest : public testing::Test {
 protected:
  WheelGuardTest() {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    for (QWidget* control : std::initializer_list<QWidget*>{number_, choice_, typed_, slider_}) {
      column->addWidget(control);
    }
    for (QComboBox* combo : {choice_, typed_}) combo->addItems({"one", "two", "three"});
    typed_->setEditable(true);
    number_->setValue(50);
    choice_->setCurrentIndex(1);
    typed_->setCurrentIndex(1);
    slider_->setValue(50);
    column->addSpacing(3000);
    area_.setWidget(content);
    area_.setWidgetResizable(true);
    area_.resize(300, 300);
    area_.show();
    area_.activateWindow();
    EXPECT_TRUE(test::waitUntil([this] { return area_.isActiveWindow(); }));
    area_.setFocus();
  }

  [[nodiscard]] bool isUnchanged() const {
    return number_->value() == 50 && choice_->currentIndex() == 1 && typed_->currentIndex() == 1 &&
           slider_->value() == 50;
  }
  /// One notch down over the middle of `widget`; whether it was taken. What is not taken, Qt gives to what is around
  /// the widget, if it comes from a real wheel.
  static bool turnWheel(QWidget* widget) { return test::turnWheel(widget, widget->rect().center(), -120); }

  QScrollArea area_;
  QDoubleSpinBox* number_ = new QDoubleSpinBox;
  QComboBox* choice_ = new QComboBox;
  QComboBox* typed_ = new QComboBox;
  QSlider* slider_ = new QSlider(Qt::Horizontal);
};

TEST_F(WheelGuardTest, WhatLiesBelowTheWheelLeavesItToThePanelAroundIt) {
  const WheelGuard guard(*qApp);
  for (QWidget* below : std::initializer_list<QWidget*>{number_, number_->findChild<QLineEdit*>(), choice_, typed_,
                                                        typed_->lineEdit(), slider_}) {
    EXPECT_FALSE(turnWheel(below)) << below->metaObject()->className();
    EXPECT_TRUE(isUnchanged()) << below->metaObject()->className();
  }
}

TEST_F(WheelGuardTest, WhatHasTheKeyboardIsTurned) {
  const WheelGuard guard(*qApp);
  number_->setFocus();
  turnWheel(number_);
  EXPECT_EQ(number_->value(), 49);
  choice_->setFocus();
  turnWheel(choice_);
  EXPECT_EQ(choice_->currentIndex(), 2);
  EXPECT_EQ(area_.verticalScrollBar()->value(), 0);
}

TEST_F(WheelGuardTest, TheWheelBringsTheKeyboardNowhere) {
  const WheelGuard guard(*qApp);
  QDoubleSpinBox later;
  ASSERT_EQ(later.focusPolicy(), Qt::WheelFocus);
  later.show();
  EXPECT_EQ(later.focusPolicy(), Qt::StrongFocus);
}

TEST_F(WheelGuardTest, WithoutItANumberIsChanged) {
  EXPECT_TRUE(turnWheel(number_));
  EXPECT_EQ(number_->value(), 49) << "else there would be nothing to guard against";
}

}  // namespace
}  // namespace hexoderm
