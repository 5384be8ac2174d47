#include "widgets/style/dressed_theme.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

TEST(DressedTheme, IsChangedOnceByAPaletteOfAnotherTheme) {
  QWidget widget;
  widget.setPalette(qtPalette(Theme::Light));
  DressedTheme dressed(widget);
  const QEvent palette_changed(QEvent::PaletteChange);
  EXPECT_FALSE(dressed.isChangedBy(palette_changed)) << "dressed in it from the beginning";
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    widget.setPalette(qtPalette(theme));
    EXPECT_FALSE(dressed.isChangedBy(QEvent(QEvent::FontChange)));
    EXPECT_TRUE(dressed.isChangedBy(palette_changed));
    EXPECT_FALSE(dressed.isChangedBy(palette_changed));
  }
}

}  // namespace
}  // namespace hexoderm
