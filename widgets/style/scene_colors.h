#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace hexoderm {

/// Red, green and blue in [0, 1].
using Rgb = std::array<double, 3>;

/// Colours of the values on a scale.
struct ColorMap {
  std::vector<Rgb> steps;  ///< from its lower end to its upper one, not empty
  Rgb below{};             ///< of values beyond its ends
  Rgb above{};
};

/// The colours of the 3D scene as plain numbers, so that the scene needs no Qt.
struct SceneColors {
  Rgb background_top{};
  Rgb background_bottom{};
  std::array<Rgb, 4> quality{};    ///< colour of a front face, by EdgeQuality
  std::array<Rgb, 4> link_line{};  ///< colour of a link's line, by EdgeQuality
  Rgb neutral{};                   ///< colour of excluded links and of frames
  Rgb no_data{};                   ///< colour of a front face without data
  ColorMap scale;                  ///< from small to large
  ColorMap signed_scale;           ///< from below zero to above it
  std::vector<Rgb> classes;        ///< without an order; not empty
  Rgb edge{};                      ///< colour of the prisms' edges
  Rgb selection{};                 ///< outline of what is picked
  Rgb light_mark{};                ///< IDs, ports and the origin on dark faces
  Rgb dark_mark{};
  Rgb text{};
  Rgb arrow_shaft{};
  Rgb arrow_head{};
  Rgb overlay{};     ///< truth, fitted surface
  Rgb difference{};  ///< arrows of gaps and differences
  Rgb ellipsoid{};
  std::array<Rgb, 3> axis{};  ///< x, y, z
};

/// `t` in [0, 1] on the scale; beyond it the ends.
Rgb onScale(const std::vector<Rgb>& scale, double t);
/// The colour at `t`, or that of what lies beyond the ends.
Rgb onMap(const ColorMap& map, double t);
/// One of the colours of classes; categories that are more than these are spread evenly over the scale, its ends left
/// out.
Rgb categoryColor(const SceneColors& colors, std::size_t category, std::size_t count);
Rgb mixed(const Rgb& a, const Rgb& b, double share_of_b);
/// Contrast ratio as the WCAG defines it: 1 to 21.
double contrast(const Rgb& a, const Rgb& b);
/// The mark, light or dark, that is read better on this face.
const Rgb& markOn(const Rgb& face, const SceneColors& colors);

}  // namespace hexoderm
