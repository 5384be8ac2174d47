#pragma once

#include "widgets/patch/patch_legend.h"

namespace hexoderm {

class PatchScene;

/// What is to be explained of a scene that shows cells, in this colouring.
LegendContent legendOf(const PatchScene& scene, Coloring coloring);

}  // namespace hexoderm
