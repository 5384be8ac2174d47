#pragma once

#include "hexoderm/base/ids.h"

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

class PatchScene;

// What is under a pixel of the scene, and where a cell or a link is in the picture. Pixels are those of the window that
// the scene is attached to, origin lower left.

/// A cell, or a link between two cells; or neither.
struct SceneHit {
  std::optional<CellId> cell;
  std::optional<std::pair<LinkEnd, LinkEnd>> link;
  friend bool operator==(const SceneHit&, const SceneHit&) = default;
  [[nodiscard]] bool isNothing() const { return !cell && !link; }
};

/// What is drawn at a pixel: a link beside the ports that it joins, else the cell. A link is hit within `slack_px` of
/// it, and not at all where cells are so small that nobody could aim at it. Looks along one ray and at the links of the
/// cell there: microseconds, however large the skin is.
SceneHit hitAt(PatchScene& scene, const Eigen::Vector2d& pixel, double slack_px);

/// A cell in the picture.
struct SeenCell {
  std::vector<Eigen::Vector2d> outline;  ///< of the whole prism, convex, counter-clockwise
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  bool is_seen = false;  ///< its front looks at the camera, and nothing hides its middle
};
/// None if the scene does not have it, or it lies behind the camera.
std::optional<SeenCell> seenCell(PatchScene& scene, CellId cell);
/// From centre to centre through both ports. Empty if the scene does not have it, or a part lies behind the camera.
std::vector<Eigen::Vector2d> seenLink(const PatchScene& scene, LinkEnd a, LinkEnd b);

}  // namespace hexoderm
