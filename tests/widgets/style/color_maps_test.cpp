// The colours of figures, measured: against the grounds of both themes, against each other, and as eyes see them that
// can't tell all colours apart.

#include "widgets/style/color_maps.h"
#include "tests/support/color_vision.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

constexpr std::array kThemes = {Theme::Light, Theme::Dark};
/// Least share of its colour that a front face keeps where no light falls on it (scene_skin.cpp).
constexpr double kDarkestShade = 0.58;

/// CIE94, which weighs differences between strong colours less.
double difference(const Rgb& a, const Rgb& b) {
  const Lab p = toLab(a);
  const Lab q = toLab(b);
  const double c1 = std::hypot(p[1], p[2]);
  const double c2 = std::hypot(q[1], q[2]);
  const double dh2 = std::max(0.0, std::pow(p[1] - q[1], 2) + std::pow(p[2] - q[2], 2) - std::pow(c1 - c2, 2));
  return std::sqrt(std::pow(p[0] - q[0], 2) + std::pow((c1 - c2) / (1 + 0.045 * c1), 2) +
                   dh2 / std::pow(1 + 0.015 * c1, 2));
}

double leastContrast(const Rgb& color, Theme theme) {
  const Colors& colors = Colors::of(theme);
  return std::min(contrast(color, toRgb(colors.scene_top)), contrast(color, toRgb(colors.scene_bottom)));
}

Rgb shaded(const Rgb& color, double share) { return {share * color[0], share * color[1], share * color[2]}; }

TEST(ColorMaps, NoColourComesNearTheGroundLitOrInTheShade) {
  for (const Theme theme : kThemes) {
    for (const ColorMap* map : {&sequentialMap(theme), &divergingMap(theme)}) {
      for (std::size_t k = 0; k < map->steps.size(); ++k) {
        EXPECT_GE(leastContrast(map->steps[k], theme), 2.99) << static_cast<int>(theme) << " " << k;
        EXPECT_GE(leastContrast(shaded(map->steps[k], kDarkestShade), theme), 1.5) << static_cast<int>(theme) << k;
      }
      EXPECT_GE(leastContrast(map->below, theme), 2) << static_cast<int>(theme);
      EXPECT_GE(leastContrast(map->above, theme), 3) << static_cast<int>(theme);
    }
    for (const Rgb& color : classColors(theme)) EXPECT_GE(leastContrast(color, theme), 2.5);
  }
  // The negative control: a map as it is often used would vanish.
  EXPECT_LT(leastContrast(toRgb(viridis(0)), Theme::Dark), 1.5);
  EXPECT_LT(leastContrast(toRgb(viridis(1)), Theme::Light), 1.5);
}

TEST(ColorMaps, LargerValuesStandOutFurtherFromTheGround) {
  for (const Theme theme : kThemes) {
    const std::vector<Rgb>& steps = sequentialMap(theme).steps;
    for (std::size_t k = 1; k < steps.size(); ++k) {
      EXPECT_GT(leastContrast(steps[k], theme), leastContrast(steps[k - 1], theme)) << k;
    }
    EXPECT_GT(leastContrast(sequentialMap(theme).above, theme), leastContrast(steps.back(), theme));
    const std::vector<Rgb>& both = divergingMap(theme).steps;
    const std::size_t middle = both.size() / 2;
    for (std::size_t k = 1; k <= middle; ++k) {
      EXPECT_GT(leastContrast(both[middle + k], theme), leastContrast(both[middle + k - 1], theme)) << k;
      EXPECT_GT(leastContrast(both[middle - k], theme), leastContrast(both[middle - k + 1], theme)) << k;
    }
  }
}

TEST(ColorMaps, StepsLookEquallyLarge) {
  for (const Theme theme : kThemes) {
    for (const ColorMap* map : {&sequentialMap(theme), &divergingMap(theme)}) {
      std::vector<double> sizes;
      for (std::size_t k = 1; k < map->steps.size(); ++k) {
        sizes.push_back(difference(map->steps[k - 1], map->steps[k]));
      }
      const auto [least, largest] = std::ranges::minmax(sizes);
      EXPECT_LT(largest, 2.0 * least) << static_cast<int>(theme);
    }
  }
}

TEST(ColorMaps, TheOrderIsSeenByEyesThatCantTellAllColoursApart) {
  for (const Theme theme : kThemes) {
    for (const ColorMatrix& eyes : {kAllColours, kProtanopia, kDeuteranopia, kTritanopia}) {
      const std::vector<Rgb>& steps = sequentialMap(theme).steps;
      const Rgb first = seenBy(eyes, steps.front());
      for (std::size_t k = 2; k < steps.size(); k += 2) {
        EXPECT_GT(difference(seenBy(eyes, steps[k]), seenBy(eyes, steps[k - 2])), 2) << static_cast<int>(theme) << k;
      }
      EXPECT_GT(difference(first, seenBy(eyes, steps.back())), 40) << static_cast<int>(theme);
      EXPECT_GT(difference(seenBy(eyes, steps.back()), seenBy(eyes, sequentialMap(theme).above)), 15);
      const std::vector<Rgb>& both = divergingMap(theme).steps;
      EXPECT_GT(difference(seenBy(eyes, both.front()), seenBy(eyes, both.back())), 25) << static_cast<int>(theme);
      for (const Rgb& end : {both.front(), both.back()}) {
        EXPECT_GT(difference(seenBy(eyes, end), seenBy(eyes, both[both.size() / 2])), 20) << static_cast<int>(theme);
      }
    }
  }
}

TEST(ColorMaps, ClassesAreToldApart) {
  for (const Theme theme : kThemes) {
    const std::vector<Rgb>& colors = classColors(theme);
    for (const ColorMatrix& eyes : {kAllColours, kProtanopia, kDeuteranopia}) {
      for (std::size_t a = 0; a < colors.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          EXPECT_GT(difference(seenBy(eyes, colors[a]), seenBy(eyes, colors[b])), 17) << a << " " << b;
        }
      }
    }
  }
}

TEST(ColorMaps, WhatLiesBeyondTheEndsHasAColourOfItsOwn) {
  const ColorMap map = {{{0.2, 0, 0}, {0.8, 0, 0}}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(onMap(map, 0), map.steps.front());
  EXPECT_EQ(onMap(map, 1), map.steps.back());
  EXPECT_EQ(onMap(map, -0.01), map.below);
  EXPECT_EQ(onMap(map, 1.01), map.above);
  EXPECT_EQ(onMap(map, 1 + 1e-12), map.steps.back()) << "rounding is not beyond";
  EXPECT_EQ(onMap(map, std::nan("")), map.steps.front());
}

TEST(ColorMaps, MoreCategoriesThanColoursAreSpreadOverTheScale) {
  SceneColors colors;
  colors.scale = sequentialMap(Theme::Dark);
  colors.classes = classColors(Theme::Dark);
  EXPECT_EQ(categoryColor(colors, 2, 5), colors.classes[2]);
  for (std::size_t k = 1; k < 30; ++k) EXPECT_NE(categoryColor(colors, k, 30), categoryColor(colors, k - 1, 30));
}

}  // namespace
}  // namespace hexoderm
