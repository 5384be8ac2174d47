#pragma once

#include "widgets/style/palette.h"
#include "widgets/style/scene_colors.h"

#include <vector>

namespace hexoderm {

// The colours that figures, signed figures and classes have in the graph and in the 3D view. Those of the quality of
// links are in core (hexoderm/solve/result/quality_colors.h).
//
// The further a value is up its scale, the further its colour is from the ground: on the dark theme brighter, on the
// light one darker. No colour comes near the ground of the theme, nor does one that lies in the shade. Steps look
// equally large, in lightness too, so that the order of the colours does not hang on hue.

/// From small to large.
const ColorMap& sequentialMap(Theme theme);
/// From far below the middle to far above it; grey in the middle.
const ColorMap& divergingMap(Theme theme);
/// For classes without an order, told apart by eyes that can't tell red from green, too.
const std::vector<Rgb>& classColors(Theme theme);

/// Viridis (perceptually uniform, safe for colour-blind eyes) at `t` in [0, 1].
QColor viridis(double t);

QColor toQColor(const Rgb& color);
Rgb toRgb(const QColor& color);

/// The colours of a 3D scene, derived from those of the theme.
SceneColors sceneColors(Theme theme);

}  // namespace hexoderm
