#include "widgets/patch/scene_look.h"

#include "widgets/style/color_maps.h"

namespace hexoderm {
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
