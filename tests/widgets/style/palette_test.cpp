// The colours of both themes, and what is dressed in them.

#include "widgets/style/palette.h"
#include "hexoderm/solve/result/quality_colors.h"
#include "tests/support/color_vision.h"
#include "widgets/style/color_maps.h"
#include "widgets/style/dressed_theme.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QtWidgets>
#include <set>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

double contrast(const QColor& a, const QColor& b) { return hexoderm::contrast(toRgb(a), toRgb(b)); }

class PaletteOfTheme : public testing::TestWithParam<Theme> {
 protected:
  const Colors& colors_ = Colors::of(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Both, PaletteOfTheme, testing::Values(Theme::Light, Theme::Dark),
                         [](const auto& theme) { return theme.param == Theme::Dark ? "Dark" : "Light"; });

TEST(Contrast, IsThatOfWcag) {
  EXPECT_NEAR(contrast(Qt::black, Qt::white), 21, 1e-9);
  EXPECT_NEAR(contrast(QColor(0x77, 0x77, 0x77), Qt::white), 4.48, 0.01);
}

TEST_P(PaletteOfTheme, TextIsReadableOnEveryGround) {
  const std::vector<std::pair<QColor, const char*>> texts = {{colors_.text, "text"},
                                                             {colors_.text_muted, "text_muted"},
                                                             {colors_.good, "good"},
                                                             {colors_.bad, "bad"},
                                                             {colors_.accent, "accent"}};
  const std::vector<std::pair<QColor, const char*>> grounds = {{colors_.window, "window"},
                                                               {colors_.panel, "panel"},
                                                               {colors_.panel_active, "panel_active"},
                                                               {colors_.scene_top, "scene_top"},
                                                               {colors_.scene_bottom, "scene_bottom"},
                                                               {colors_.cell_fill, "cell_fill"}};
  for (const auto& [text, text_name] : texts) {
    for (const auto& [ground, ground_name] : grounds) {
      // Green, red and blue words stand on panels, not on the 3D scene.
      const bool on_scene = ground == colors_.scene_bottom && text != colors_.text && text != colors_.text_muted;
      if (on_scene) continue;
      EXPECT_GE(contrast(text, ground), 4.5) << text_name << " on " << ground_name;
    }
  }
  EXPECT_GE(contrast(colors_.accent_text, colors_.accent), 4.5);
}

TEST_P(PaletteOfTheme, MarksAndStrokesStandOutFromTheirGround) {
  EXPECT_GE(contrast(colors_.caution, colors_.panel), 3);
  EXPECT_GE(contrast(colors_.excluded_link, colors_.panel), 3);
  EXPECT_GE(contrast(colors_.tree_band, colors_.panel), GetParam() == Theme::Dark ? 1.7 : 1.3);
  EXPECT_GE(contrast(colors_.selection, colors_.panel), 15);
  for (const EdgeQuality quality :
       {EdgeQuality::Undefined, EdgeQuality::Partially, EdgeQuality::Fully, EdgeQuality::Over}) {
    EXPECT_GE(contrast(linkStroke(quality, GetParam()).color, colors_.panel), 3) << qualityName(quality);
  }
}

TEST_P(PaletteOfTheme, QualityHasTheColoursThatExportedFilesHave) {
  const Background background = GetParam() == Theme::Dark ? Background::Dark : Background::Light;
  for (const EdgeQuality quality :
       {EdgeQuality::Undefined, EdgeQuality::Partially, EdgeQuality::Fully, EdgeQuality::Over}) {
    EXPECT_EQ(linkStroke(quality, GetParam()).color, QColor::fromRgb(qualityColor(quality, background)));
  }
  EXPECT_EQ(colors_.excluded_link, QColor::fromRgb(unusedColor(background)));
}

TEST_P(PaletteOfTheme, AxesAreToldApartByEveryEye) {
  for (const ColorMatrix& eyes : {kAllColours, kProtanopia, kDeuteranopia, kTritanopia}) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Lab a = toLab(seenBy(eyes, toRgb(colors_.axis.at(k))));
      const Lab b = toLab(seenBy(eyes, toRgb(colors_.axis.at((k + 1) % 3))));
      EXPECT_GE(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 20) << "a difference of 2 is just seen; axis " << k;
    }
  }
  for (const QColor& axis : colors_.axis) {
    for (const QColor& ground : {colors_.panel, colors_.scene_top, colors_.scene_bottom}) {
      EXPECT_GE(contrast(axis, ground), 3);
    }
  }
}

TEST_P(PaletteOfTheme, TextOnAnyColourHasTheLargerContrast) {
  for (int k = 0; k <= 100; ++k) {
    const QColor ground = viridis(k / 100.0);
    EXPECT_GE(contrast(textOn(ground), ground), 4.5) << k;
  }
}

TEST_P(PaletteOfTheme, StrokesDifferInStyleAndWordNotOnlyInHue) {
  std::set<std::pair<int, bool>> styles;
  std::set<QByteArray> pictures;  // all in one colour
  std::set<QString> words;
  for (const EdgeQuality quality :
       {EdgeQuality::Undefined, EdgeQuality::Partially, EdgeQuality::Fully, EdgeQuality::Over}) {
    LinkStroke stroke = linkStroke(quality, GetParam());
    styles.insert({static_cast<int>(stroke.style), stroke.doubled});
    stroke.color = colors_.text;
    QImage image(52, 12, QImage::Format_RGB32);
    image.fill(colors_.panel);
    QPainter painter(&image);
    drawStroke(painter, stroke, QLineF(0, 6, 52, 6), 4);
    painter.end();
    pictures.emplace(reinterpret_cast<const char*>(image.constBits()), static_cast<int>(image.sizeInBytes()));
    words.insert(qualityWord(quality));
  }
  EXPECT_EQ(styles.size(), 4u);
  EXPECT_EQ(pictures.size(), 4u);
  EXPECT_EQ(words.size(), 4u);
}

TEST_P(PaletteOfTheme, StyleSheetAndQtPaletteAreFilledInAndUseTheirThemeOnly) {
  const QString sheet = styleSheet(GetParam());
  EXPECT_FALSE(sheet.contains('@')) << sheet.mid(sheet.indexOf('@'), 40).toStdString();
  EXPECT_EQ(sheet.count('{'), sheet.count('}'));
  EXPECT_TRUE(sheet.contains(colors_.accent.name()));
  const Colors& other = Colors::of(GetParam() == Theme::Dark ? Theme::Light : Theme::Dark);
  EXPECT_FALSE(sheet.contains(other.panel_active.name()));
  const QPalette palette = qtPalette(GetParam());
  EXPECT_EQ(palette.color(QPalette::Text), colors_.text);
  EXPECT_EQ(palette.color(QPalette::PlaceholderText), colors_.text_muted);
  EXPECT_NE(palette.color(QPalette::Disabled, QPalette::Text), colors_.text);
}

TEST_P(PaletteOfTheme, SystemThemeFollowsTheApplicationsPaletteWhereNoPortalAnswers) {
  qunsetenv("DBUS_SESSION_BUS_ADDRESS");
  const QPalette before = QApplication::palette();
  QApplication::setPalette(qtPalette(GetParam()));
  EXPECT_EQ(systemTheme(), GetParam());
  QApplication::setPalette(before);
}

TEST(StyleSheet, IsAcceptedByQt) {
  testing::internal::CaptureStderr();
  QWidget widget;
  widget.setStyleSheet(styleSheet(Theme::Light));
  widget.ensurePolished();
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::Not(testing::HasSubstr("parse")));
}

TEST(Viridis, RunsFromDarkVioletToYellowAndGetsBrighterAllTheWay) {
  EXPECT_EQ(viridis(0).name(), "#440154");
  EXPECT_EQ(viridis(1).name(), "#fde725");
  EXPECT_EQ(viridis(0.2).name(), "#414487");  // colour 51 of 255
  // Colour 128 of matplotlib's table is (0.127568, 0.566949, 0.550556); between two stops, so to about 1 of 255.
  const QColor middle = viridis(128.0 / 255);
  EXPECT_NEAR(middle.red(), 32.5, 1.6);
  EXPECT_NEAR(middle.green(), 144.6, 1.6);
  EXPECT_NEAR(middle.blue(), 140.4, 1.6);
  for (int k = 1; k <= 100; ++k) {
    EXPECT_GT(contrast(viridis(k / 100.0), Qt::black), contrast(viridis((k - 1) / 100.0), Qt::black)) << k;
  }
}

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
