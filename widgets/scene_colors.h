#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace hexoderm {

/// Red, green and blue in [0, 1].
using Rgb = std::array<double, 3>;

/// What the colour of a cell in the 3D scene means.
enum class CellColoring { LinkQuality, Deviation, Patch };

/// Predicted deviation at which the scale ends: an absolute scale, so that two pictures can be compared. Two poses of
/// an uncalibrated sensor lie near its upper end.
inline constexpr double kDeviationScaleEnd_deg = 6.0;

/// The colours of the 3D scene as plain numbers, so that the scene needs no Qt.
struct SceneColors {
  Rgb background_top{};
  Rgb background_bottom{};
  std::array<Rgb, 4> quality{};  ///< of a front face, by EdgeQuality
  Rgb neutral{};                 ///< of a front face that no link judges
  std::vector<Rgb> scale;        ///< from small to large, not empty
  Rgb edge{};                    ///< of the prisms
  Rgb selection{};               ///< outline of what is picked
  Rgb light_mark{};              ///< IDs, ports and the origin on dark faces
  Rgb dark_mark{};
  Rgb text{};
  Rgb arrow_shaft{};
  Rgb arrow_head{};
};

/// `t` in [0, 1] on the scale; beyond it the ends.
Rgb onScale(const std::vector<Rgb>& scale, double t);
/// Patches are spread evenly over the scale, its ends left out.
Rgb patchColor(const SceneColors& colors, std::size_t patch, std::size_t patch_count);
Rgb mixed(const Rgb& a, const Rgb& b, double share_of_b);
/// Which of the two marks is read better on this face.
const Rgb& markOn(const Rgb& face, const SceneColors& colors);

}  // namespace hexoderm
