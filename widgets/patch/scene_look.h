#pragma once

#include "widgets/style/palette.h"
#include "widgets/style/scene_colors.h"

namespace hexoderm {

/// The colours of a 3D scene, derived from those of the theme.
SceneColors sceneColors(Theme theme);

}  // namespace hexoderm
