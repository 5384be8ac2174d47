#include "widgets/coloring/scale_strip.h"

#include "widgets/style/color_maps.h"

#include <gtest/gtest.h>
#include <QtWidgets>
#include <algorithm>

namespace hexoderm {
namespace {

using Values = std::vector<std::optional<double>>;
constexpr int kWidth = 360;

class ScaleStripTest : public testing::Test {
 protected:
  static ScaleStrip stripOf(const Values& values, const std::optional<ColorRange>& fixed = {}) {
    ScaleStrip strip(makeScaleLegend(Coloring::PositionUncertainty, values, values, fixed, {}),
                     sequentialMap(Theme::Light), Theme::Light, QGuiApplication::font(), ScaleStrip::Histogram::Shown);
    strip.setPlace(QPointF(10, 10), kWidth);
    return strip;
  }
  static QImage picture(const ScaleStrip& strip, std::optional<double> marked = {}, std::optional<int> probed = {}) {
    QImage image(kWidth + 20, static_cast<int>(strip.height()) + 20, QImage::Format_RGB32);
    image.fill(Colors::of(Theme::Light).panel);
    QPainter painter(&image);
    strip.paint(painter, marked, probed);
    return image;
  }
  /// The lowest row above the bar that differs from the ground, in the column of a value.
  static int heightOver(const ScaleStrip& strip, const QImage& image, double value) {
    const int x = static_cast<int>(strip.xOf(value));
    int height = 0;
    for (int y = static_cast<int>(strip.bar().top()) - 3; y > 10; --y, ++height) {
      if (image.pixelColor(x, y) == Colors::of(Theme::Light).panel) break;
    }
    return height;
  }
};

TEST_F(ScaleStripTest, TheBarHasTheColoursOfTheScaleFromEndToEnd) {
  const ScaleStrip strip = stripOf({0.0, 1.0});
  const QImage image = picture(strip);
  const auto colorAt = [&](double value) {
    return toRgb(image.pixelColor(static_cast<int>(strip.xOf(value)), static_cast<int>(strip.bar().center().y())));
  };
  for (const double t : {0.05, 0.5, 0.95}) {
    const Rgb wanted = onScale(sequentialMap(Theme::Light).steps, t);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(colorAt(t)[k], wanted[k], 0.03) << t;
  }
}

TEST_F(ScaleStripTest, MoreCellsMakeAHigherColumn) {
  Values values(30, 0.1);
  values.insert(values.end(), 10, 0.55);
  values.emplace_back(0.0);
  values.emplace_back(1.0);
  const ScaleStrip strip = stripOf(values);
  const QImage image = picture(strip);
  EXPECT_GT(heightOver(strip, image, 0.1), heightOver(strip, image, 0.55) + 2);
  EXPECT_GT(heightOver(strip, image, 0.55), heightOver(strip, image, 0.3) + 2) << "no cell is there";
}

TEST_F(ScaleStripTest, ArrowsStandOnlyWhereValuesLieBeyond) {
  const auto arrowAt = [](const ScaleStrip& strip, bool above) {
    const double x = above ? strip.bar().right() + 3 : strip.bar().left() - 3;
    return picture(strip).pixelColor(static_cast<int>(x), static_cast<int>(strip.bar().center().y())) !=
           Colors::of(Theme::Light).panel;
  };
  EXPECT_FALSE(arrowAt(stripOf({0.0, 1.0}), true));
  EXPECT_FALSE(arrowAt(stripOf({0.0, 1.0}), false));
  EXPECT_TRUE(arrowAt(stripOf({0.0, 8.0}, ColorRange{0, 6}), true));
  EXPECT_FALSE(arrowAt(stripOf({0.0, 8.0}, ColorRange{0, 6}), false));
  EXPECT_TRUE(arrowAt(stripOf({0.0, 3.0}, ColorRange{1, 6}), false));
}

TEST_F(ScaleStripTest, FixedEndsLimitsMarksAndProbesAreSeen) {
  const Values values = {0.0, 6.0};
  const QImage plain = picture(stripOf(values));
  EXPECT_NE(picture(stripOf(values, ColorRange{0, 6})), plain) << "the same range, fixed";
  EXPECT_NE(picture(stripOf(values), 2.0), plain);
  EXPECT_NE(picture(stripOf(values), 2.0), picture(stripOf(values), 4.0));
  EXPECT_NE(picture(stripOf(values), {}, 3), plain);
  ScaleLegend without = stripOf(values).legend();
  ASSERT_FALSE(without.limits.empty());
  without.limits.clear();
  ScaleStrip bare(without, sequentialMap(Theme::Light), Theme::Light, QGuiApplication::font(),
                  ScaleStrip::Histogram::Shown);
  bare.setPlace(QPointF(10, 10), kWidth);
  EXPECT_NE(picture(bare), plain);
}

TEST_F(ScaleStripTest, PlacesAndValuesBelongTogether) {
  const ScaleStrip strip = stripOf({0.0, 1.0, 0.5}, ColorRange{0, 1});
  const double y = strip.bar().center().y();
  EXPECT_EQ(strip.binAt(QPointF(strip.xOf(0.01), y)), 0);
  EXPECT_EQ(strip.binAt(QPointF(strip.xOf(0.99), y)), 23);
  EXPECT_EQ(strip.binAt(QPointF(strip.bar().left() - 4, y)), -1);
  EXPECT_EQ(strip.binAt(QPointF(strip.bar().right() + 4, y)), 24);
  EXPECT_EQ(strip.binAt(QPointF(0, 0)), std::nullopt);
  EXPECT_GT(strip.xOf(5), strip.bar().right()) << "on the arrow";
  EXPECT_LT(strip.xOf(-5), strip.bar().left());
  EXPECT_DOUBLE_EQ(strip.place().width(), kWidth);
  EXPECT_DOUBLE_EQ(strip.place().top(), 10);
}

}  // namespace
}  // namespace hexoderm
