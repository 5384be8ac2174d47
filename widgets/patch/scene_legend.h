#pragma once

#include "widgets/patch/patch_legend.h"
#include "widgets/scene/patch_scene.h"

#include <algorithm>

namespace hexoderm {

/// What is to be explained of a scene that shows cells, in this colouring.
inline LegendContent legendOf(const PatchScene& scene, Coloring coloring) {
  LegendContent content;
  const SceneContent& shown = *scene.content();
  content.coloring = coloring;
  content.patches = shown.reconstruction->patches.size();
  content.some_links = !shown.signs.links.empty();
  for (const CellSign& sign : shown.signs.cells) {
    content.some_by_links = content.some_by_links || sign.by_links;
    content.some_faulty = content.some_faulty || sign.faulty;
    content.some_doubtful = content.some_doubtful || sign.doubtful;
  }
  content.scale = scene.scale();
  // Where nothing is known, as of a single moment, there is no range to fit, and one would be made up.
  if (content.scale && !content.scale->extremes && !content.scale->is_fixed) {
    content.scale.reset();
    content.some_unknown = true;
  } else if (content.scale) {
    content.some_unknown = content.scale->counts.unknown > 0;
  } else if (coloring == Coloring::LinkQuality) {
    content.some_unknown = std::ranges::any_of(shown.figures.quality, [](const auto& quality) { return !quality; });
  } else if (coloring == Coloring::BodyPart) {
    for (const std::string& name : shown.figures.body_parts) content.body_parts.push_back(QString::fromStdString(name));
    content.some_unknown = std::ranges::any_of(shown.figures.body_part, [](const auto& part) { return !part; });
  }
  return content;
}

}  // namespace hexoderm
