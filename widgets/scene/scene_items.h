#pragma once

#include "hexoderm/base/ids.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace hexoderm {

/// Directions to look from: Front from +z (out of the origin cell's skin), Side from +x, Top from +y; Back, OtherSide
/// and Bottom from the other ends of these axes; Isometric from between all three; Oblique as at first.
enum class StandardView { Oblique, Front, Side, Top, Back, OtherSide, Bottom, Isometric };

/// Things that can be shown over the cells or left out, in the order of the menu.
enum class SceneItem { Ports, Ids, Axes, Gravity, Links, Tree, Ellipsoids, Truth, Surface, Loop, Comparison };

inline constexpr std::array kSceneItems = {SceneItem::Ports,      SceneItem::Ids,       SceneItem::Axes,
                                           SceneItem::Gravity,    SceneItem::Links,     SceneItem::Tree,
                                           SceneItem::Ellipsoids, SceneItem::Truth,     SceneItem::Surface,
                                           SceneItem::Loop,       SceneItem::Comparison};

/// Tells whether an item can be drawn now, and why not.
enum class Availability { Available, NoSkin, NoData, TooManyCells };

using ShownItems = std::array<bool, kSceneItems.size()>;

/// Links, the tree, ellipsoids and the truth are asked for; the rest is there from the start, or comes with its data.
inline constexpr ShownItems kShownAtFirst = {true, true, true, true, false, false, false, false, true, true, true};

constexpr std::size_t indexOf(SceneItem item) { return static_cast<std::size_t>(item); }

/// The overlays that were drawn, with their enlargements, for the words beside them. Absent: not drawn.
struct SceneNotes {
  std::vector<CellId> not_placed;  ///< origins of the patches that stand beside the largest
  bool frames = false;             ///< drawn about these
  std::optional<double> ellipsoid_factor;
  std::optional<double> shift_factor;
  std::optional<double> loop_factor;
  std::optional<double> distance_factor;  ///< enlargement of the lines from the fitted surface to the cells
  bool truth = false;
  bool tree = false;
};

}  // namespace hexoderm
