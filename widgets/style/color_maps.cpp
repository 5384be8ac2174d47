#include "widgets/style/color_maps.h"

#include <array>
#include <cstdint>
#include <span>

namespace hexoderm {
namespace {

// Lines through CIELAB in steps of equal difference (CIE94), from a blue over violet to gold or to a deep brown: their
// lightness and their blueness both run one way, the second as all eyes see it. Lit from the front every colour has a
// contrast of 3 and more to the ground.
constexpr std::array<std::uint32_t, 17> kSequentialOnDark = {0x2E75B9, 0x5A77BF, 0x7979C5, 0x967AC8, 0xB17BC5, 0xC77BBF,
                                                             0xDB7BB7, 0xED7CAD, 0xFA80A3, 0xFF8797, 0xFF8F8B, 0xFF987F,
                                                             0xFFA173, 0xFFAD69, 0xFFBA63, 0xFFC95E, 0xFFD75A};

constexpr std::array<std::uint32_t, 17> kSequentialOnLight = {
    0x3D87BE, 0x4C7FBB, 0x5876B7, 0x646DB2, 0x6F63A9, 0x7A5A9E, 0x845192, 0x8C4786, 0x913E78,
    0x933569, 0x932F5A, 0x902A4B, 0x8D273C, 0x8B2431, 0x862126, 0x7E1C1D, 0x751715};

// From grey to blue and to orange, which are opposites for all eyes.
constexpr std::array<std::uint32_t, 17> kDivergingOnDark = {0x3FCBEE, 0x3FBCE3, 0x40AED7, 0x45A0C8, 0x5292B4, 0x5F879F,
                                                            0x677D8C, 0x6C767D, 0x6F6F6F, 0x7E726C, 0x8E7667, 0xA17A61,
                                                            0xB57F5B, 0xCB8756, 0xDE9354, 0xF1A054, 0xFFAE54};

constexpr std::array<std::uint32_t, 17> kDivergingOnLight = {0x0A3F7F, 0x0E4A86, 0x13568D, 0x206292, 0x3A6C93, 0x54738F,
                                                             0x67798A, 0x767D85, 0x818181, 0x877C77, 0x8E756A, 0x956D5C,
                                                             0x9A634A, 0x9B5536, 0x924727, 0x85391C, 0x782C14};

constexpr std::array<std::uint32_t, 8> kClassesOnDark = {0x8277FB, 0xC6A634, 0x7FDFF5, 0xB14C1C,
                                                         0x82AB7D, 0xDBED51, 0xB97FA3, 0xA7FEBE};
constexpr std::array<std::uint32_t, 6> kClassesOnLight = {0x06299E, 0xDA5819, 0x3F9788, 0x614B7A, 0x2E3E0F, 0x480F2E};

/// Every 17th of the 256 colours of viridis (van der Walt, Smith, Firing; CC0); between them it is nearly linear.
constexpr std::array<std::uint32_t, 16> kViridis = {0x440154, 0x481A6C, 0x472F7D, 0x414487, 0x39568C, 0x31688E,
                                                    0x2A788E, 0x23888E, 0x1F988B, 0x22A884, 0x35B779, 0x54C568,
                                                    0x7AD151, 0xA5DB36, 0xD2E21B, 0xFDE725};

Rgb fromHex(std::uint32_t rgb) {
  constexpr double kFull = 255;
  return {(rgb >> 16U & 0xFFU) / kFull, (rgb >> 8U & 0xFFU) / kFull, (rgb & 0xFFU) / kFull};
}

std::vector<Rgb> fromHex(std::span<const std::uint32_t> steps) {
  std::vector<Rgb> colors;
  for (const std::uint32_t step : steps) colors.push_back(fromHex(step));
  return colors;
}

ColorMap mapOf(std::span<const std::uint32_t> steps, std::uint32_t below, std::uint32_t above) {
  return {fromHex(steps), fromHex(below), fromHex(above)};
}

}  // namespace

const ColorMap& sequentialMap(Theme theme) {
  // What lies beyond an end goes on where the scale ends.
  static const ColorMap on_dark = mapOf(kSequentialOnDark, 0x2F5F73, 0xFFFFF4);
  static const ColorMap on_light = mapOf(kSequentialOnLight, 0x5B9AA0, 0x0A0306);
  return theme == Theme::Dark ? on_dark : on_light;
}

const ColorMap& divergingMap(Theme theme) {
  static const ColorMap on_dark = mapOf(kDivergingOnDark, 0xDDFBFF, 0xFFF6DC);
  static const ColorMap on_light = mapOf(kDivergingOnLight, 0x020A24, 0x250702);
  return theme == Theme::Dark ? on_dark : on_light;
}

const std::vector<Rgb>& classColors(Theme theme) {
  static const std::vector<Rgb> on_dark = fromHex(kClassesOnDark);
  static const std::vector<Rgb> on_light = fromHex(kClassesOnLight);
  return theme == Theme::Dark ? on_dark : on_light;
}

QColor viridis(double t) {
  static const std::vector<Rgb> steps = fromHex(kViridis);
  return toQColor(onScale(steps, t));
}

QColor toQColor(const Rgb& color) { return QColor::fromRgbF(color[0], color[1], color[2]); }

Rgb toRgb(const QColor& color) { return {color.redF(), color.greenF(), color.blueF()}; }

SceneColors sceneColors(Theme theme) {
  const Colors& colors = Colors::of(theme);
  const bool dark = theme == Theme::Dark;
  // Large faces in a link's full colour would shout: they are calmed towards black, as far as that brings none near the
  // ground.
  const Rgb black{};
  const double calm = dark ? 0.08 : 0.16;
  SceneColors scene;
  scene.background_top = toRgb(colors.scene_top);
  scene.background_bottom = toRgb(colors.scene_bottom);
  for (std::size_t k = 0; k < scene.quality.size(); ++k) {
    scene.link_line.at(k) = toRgb(linkStroke(static_cast<EdgeQuality>(k), theme).color);
    scene.quality.at(k) = mixed(scene.link_line.at(k), black, calm);
  }
  scene.neutral = toRgb(colors.excluded_link);
  // What is not known stands back.
  scene.no_data = mixed(scene.neutral, scene.background_bottom, 0.45);
  scene.scale = sequentialMap(theme);
  scene.signed_scale = divergingMap(theme);
  scene.classes = classColors(theme);
  scene.edge = toRgb(dark ? colors.scene_top : colors.text);
  scene.selection = toRgb(colors.selection);
  scene.light_mark = toRgb(dark ? colors.selection : colors.panel);
  scene.dark_mark = toRgb(dark ? colors.scene_top : colors.text);
  scene.arrow_shaft = toRgb(colors.text_muted);
  scene.arrow_head = toRgb(colors.accent);
  scene.text = toRgb(colors.text);
  scene.overlay = toRgb(colors.accent);
  scene.difference = toRgb(colors.caution);
  scene.ellipsoid = toRgb(dark ? colors.selection : colors.panel);
  for (std::size_t k = 0; k < scene.axis.size(); ++k) scene.axis.at(k) = toRgb(colors.axis.at(k));
  return scene;
}

}  // namespace hexoderm
