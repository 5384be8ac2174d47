#include "widgets/scene/scene_pointing.h"

#include "hexoderm/solve/metrics/patch_mesh.h"
#include "widgets/scene/patch_scene.h"

#include <algorithm>

namespace hexoderm {
namespace {

constexpr double kMinSide_px = 12;   // of a cell whose links can be aimed at
constexpr double kFromPort = 0.7;    // where a link begins to be hit, as a share of the way from centre to port
constexpr double kMinFacing = 0.15;  // cosine between a face and the line of sight

double turnAtCorner(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// The convex hull, counter-clockwise (A. M. Andrew, 1979).
std::vector<Eigen::Vector2d> hullOf(std::vector<Eigen::Vector2d> points) {
  std::ranges::sort(points,
                    [](const auto& a, const auto& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
  std::vector<Eigen::Vector2d> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const Eigen::Vector2d& point : points) {
      while (hull.size() >= first + 2 && turnAtCorner(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();  // the other side begins with it
    std::ranges::reverse(points);
  }
  return hull;
}

double pixelsToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (point - a - t * along).norm();
}

/// The points that a link passes: centre, port, port, centre. Empty if one is missing.
std::vector<Eigen::Vector3d> waypointsOfLink(const SceneContent& content, LinkEnd a, LinkEnd b) {
  const auto port_a = content.portPoint(a);
  const auto port_b = content.portPoint(b);
  if (!port_a || !port_b) return {};
  return {content.layout.find(a.cell)->T_s_u.t, *port_a, *port_b, content.layout.find(b.cell)->T_s_u.t};
}

}  // namespace

SceneHit hitAt(PatchScene& scene, const Eigen::Vector2d& pixel, double slack_px) {
  const std::optional<CellId> cell = scene.pick(pixel.x(), pixel.y());
  const SceneContent* content = scene.content();
  if (content == nullptr) return {};
  // In the gap between two cells the ray passes both.
  std::vector<CellId> around;
  if (cell) {
    around = {*cell};
  } else {
    for (const Eigen::Vector2d& aside :
         {Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(0, -1)}) {
      const Eigen::Vector2d near = pixel + slack_px * aside;
      if (const auto found = scene.pick(near.x(), near.y())) around.push_back(*found);
    }
  }
  const SceneSight sight = scene.sight();
  SceneHit hit{cell, std::nullopt};
  double nearest = slack_px;
  for (const CellId id : around) {
    const auto index = content->layout.index.find(id);
    if (index == content->layout.index.end()) continue;
    const Eigen::Vector3d& center = content->layout.cells[index->second].T_s_u.t;
    if (content->reconstruction->model->side_m * sight.scaleAt(sight.depthOf(center)) < kMinSide_px) continue;
    for (const LinkEstimate* link : content->links.of(index->second)) {
      const auto way = waypointsOfLink(*content, link->source, link->target);
      if (way.empty() || !std::ranges::all_of(way, [&](const auto& point) { return sight.isAhead(point); })) continue;
      const Eigen::Vector2d from = sight.at(way[0] + kFromPort * (way[1] - way[0]));
      const Eigen::Vector2d to = sight.at(way[3] + kFromPort * (way[2] - way[3]));
      const double away = pixelsToSegment(pixel, from, to);
      if (away > nearest) continue;
      nearest = away;
      hit = {std::nullopt, std::pair(link->source, link->target)};
    }
  }
  return hit;
}

std::optional<SeenCell> seenCell(PatchScene& scene, CellId id) {
  const SceneContent* content = scene.content();
  const SceneCell* cell = content == nullptr ? nullptr : content->layout.find(id);
  if (cell == nullptr) return std::nullopt;
  const SceneSight sight = scene.sight();
  SeenCell seen;
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector3d& corner : prismCorners(*content->reconstruction->model, cell->T_s_u)) {
    if (!sight.isAhead(corner)) return std::nullopt;
    corners.push_back(sight.at(corner));
  }
  seen.outline = hullOf(std::move(corners));
  seen.center = sight.at(cell->T_s_u.t);
  const bool faces = cell->T_s_u.R.col(2).dot(sight.towards(cell->T_s_u.t)) > kMinFacing;
  seen.is_seen = faces && scene.pick(seen.center.x(), seen.center.y()) == id;
  return seen;
}

std::vector<Eigen::Vector2d> seenLink(const PatchScene& scene, LinkEnd a, LinkEnd b) {
  const SceneContent* content = scene.content();
  if (content == nullptr) return {};
  const SceneSight sight = scene.sight();
  std::vector<Eigen::Vector2d> line;
  for (const Eigen::Vector3d& point : waypointsOfLink(*content, a, b)) {
    if (!sight.isAhead(point)) return {};
    line.push_back(sight.at(point));
  }
  return line;
}

}  // namespace hexoderm
