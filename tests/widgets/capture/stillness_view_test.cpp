#include "widgets/capture/stillness_view.h"
#include "tests/support/qt_wait.h"
#include "widgets/style/palette.h"

#include <gtest/gtest.h>
#include <cmath>

namespace hexoderm {
namespace {

HoldStatus holdAt(int step) {
  HoldStatus hold;
  hold.stillness.excess_cell = CellId(7);
  hold.stillness.excess_limit_g = 0.030;
  hold.stillness.still = step > 60;
  hold.stillness.armed = step < 100 || step > 140;
  if (step > 80 && step < 100) hold.phase = HoldPhase::Collecting;
  return hold;
}

SkinPreview previewAt(int step, std::size_t cells = 17) {
  SkinPreview preview;
  preview.time_s = 0.05 * step;
  for (std::size_t k = 0; k < cells; ++k) {
    const double wave = (step < 60 ? 0.05 : 0.004) * std::sin(0.9 * step + static_cast<double>(k));
    preview.means.push_back({CellId(static_cast<std::uint32_t>(k + 1)), {wave, 0.7 * wave, 1 + 0.5 * wave}});
  }
  return preview;
}

class StillnessViewTest : public testing::Test {
 protected:
  void show() {
    view.resize(700, 160);
    view.show();
    ASSERT_TRUE(test::waitUntilExposed(view));
  }
  void feed(int steps) {
    for (int k = 0; k < steps; ++k) view.add(holdAt(k), previewAt(k));
  }
  StillnessView view;
};

TEST_F(StillnessViewTest, SaysThatThereAreNoReadingsAndThenDrawsThemWithTheCaptures) {
  show();
  const QImage nothing = view.grab().toImage();
  feed(200);
  QImage some = view.grab().toImage();
  EXPECT_NE(some, nothing);
  view.addCaptured(PoseId(3), 5.0);
  EXPECT_NE(view.grab().toImage(), some) << "the capture is marked";
  some = view.grab().toImage();
  view.clear();
  EXPECT_TRUE(view.findChild<QLabel*>("stillnessNothing")->isVisible());
  EXPECT_TRUE(view.header().isEmpty());
  EXPECT_NE(view.grab().toImage(), some);
}

TEST_F(StillnessViewTest, TheHeaderNamesCellAndLimit) {
  show();
  feed(10);
  EXPECT_EQ(view.header(), "cell 7, which decides · x y z, deviation from its mean, last 10 s, limit 30 mg");
  EXPECT_EQ(view.findChild<QLabel*>("stillnessHeader")->text(), view.header());
  view.setCell(CellId(3));
  EXPECT_TRUE(view.header().startsWith("cell 3, picked"));
}

TEST_F(StillnessViewTest, WhatCameWhileItWasHiddenIsDrawnWhenItIsShown) {
  feed(100);
  show();
  EXPECT_FALSE(view.header().isEmpty());
  EXPECT_EQ(view.findChild<QLabel*>("stillnessHeader")->text(), view.header());
}

TEST_F(StillnessViewTest, ThemesDiffer) {
  show();
  feed(150);
  const QImage light = view.grab().toImage();
  view.setPalette(qtPalette(Theme::Dark));
  EXPECT_LT(qGray(view.grab().toImage().pixel(350, 40)), qGray(light.pixel(350, 40)));
}

}  // namespace
}  // namespace hexoderm
