#pragma once

#include <cstddef>

/// From these radii of a hexagon on (pixels), details of the graph are drawn.
namespace hexoderm::graph_levels {

/// Below, dots would hide the links between them.
inline constexpr double kDotRadius = 1.5;
inline constexpr double kOutlineRadius = 2.5;
inline constexpr double kStyleRadius = 4.0;
inline constexpr double kIdRadius = 8.0;
inline constexpr double kPortRadius = 26.0;
/// More cells than this in view are drawn by simpler means.
inline constexpr std::size_t kCrowd = 1500;

}  // namespace hexoderm::graph_levels
