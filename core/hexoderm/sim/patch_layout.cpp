#include "hexoderm/sim/patch_layout.h"

#include "hexoderm/base/error.h"
#include "hexoderm/sim/sheet_relaxation.h"
#include "hexoderm/skin/breadth_first.h"

#include <Eigen/Eigenvalues>
#include <boost/functional/hash.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/range/iterator_range.hpp>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <unordered_map>

namespace hexoderm {
namespace {

/// The cells of a plan. An edge holds the number of its link; those of a cell come in the plan's order.
using PlanGraph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, std::size_t>;

PlanGraph graphOf(const PatchPlan& plan) {
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < plan.links.size(); ++k) {
    ends.emplace_back(plan.links[k].source, plan.links[k].target);
    ends.emplace_back(plan.links[k].target, plan.links[k].source);
    numbers.insert(numbers.end(), 2, k);
  }
  return {boost::edges_are_unsorted_multi_pass, ends.begin(), ends.end(), numbers.begin(), plan.cell_count};
}

/// Distance along the geodesic from one centre to the next.
double linkLength(const PlannedLink& link, LinkLaw law, const Surface& surface, const Eigen::Vector3d& from,
                  const Eigen::Vector3d& direction) {
  const double a = reachOf(link.source_port);
  const double b = reachOf(link.target_port);
  double length = a + b;
  if (law == LinkLaw::Surface) return length;
  const auto curvatureAt = [&](const GeodesicPoint& point) {
    return point.direction.dot(surface.weingarten(point.position) * point.direction);
  };
  // If the curvature changes on the way (cone, torus), the mean of both ends counts.
  for (int k = 0; k < 4; ++k) {
    const GeodesicPoint end = surface.walk(from, direction, length);
    const double curvature = (curvatureAt({from, direction}) + curvatureAt(end)) / 2;
    if (std::abs(curvature) * length < 1e-7) return a + b;
    length = (std::atan(curvature * a) + std::atan(curvature * b)) / curvature;
  }
  return length;
}

void requireRoom(const Surface& surface, const Eigen::Vector3d& position, double reach_m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(surface.weingarten(position), Eigen::EigenvaluesOnly);
  const double sharpest = solver.eigenvalues().cwiseAbs().maxCoeff();
  if (!position.allFinite() || !(sharpest * reach_m < 1)) {
    throw InvalidArgument(message(
        "the surface is too small for these cells: where one is laid it is curved more sharply than the cell is wide"));
  }
}

/// Frame of the cell behind a link: entered through the target's port, which points back along the way.
SE3 cellAtEnd(const GeodesicPoint& end, const Eigen::Vector3d& normal, const Port& entered_by) {
  const Eigen::Vector3d back = -end.direction;
  const Eigen::Vector2d port = entered_by.vector_m.head<2>().normalized();
  const Eigen::Vector3d left = normal.cross(back);
  SE3 T;
  T.R.col(0) = port.x() * back - port.y() * left;
  T.R.col(1) = port.y() * back + port.x() * left;
  T.R.col(2) = normal;
  T.t = end.position;
  return T;
}

/// Two cells nearer than half a link lie on top of each other: the patch goes round the body and meets itself.
void requireNoOverlap(const std::vector<SE3>& cells, double closest_m) {
  using Box = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  std::unordered_multimap<Box, std::size_t, boost::hash<Box>> boxes;
  boxes.reserve(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Eigen::Vector3d box = (cells[k].t / closest_m).array().round();
    const auto at = [&](int axis, int by) { return static_cast<std::int64_t>(box[axis]) + by; };
    for (int near = 0; near < 27; ++near) {
      const Box beside(at(0, near / 9 - 1), at(1, near / 3 % 3 - 1), at(2, near % 3 - 1));
      const auto [first, last] = boxes.equal_range(beside);
      for (auto other = first; other != last; ++other) {
        if ((cells[k].t - cells[other->second].t).norm() >= closest_m) continue;
        throw InvalidArgument(
            message("the surface is too small for this patch: cells {} and {} would lie on top of each other",
                    other->second + 1, k + 1));
      }
    }
    boxes.emplace(Box(at(0, 0), at(1, 0), at(2, 0)), k);
  }
}

/// A closed ring's last link may be about as far apart as its others: 1 / 10 of the reach is half a gap in hex-bma150.
void requireClosed(const PatchPlan& plan, const std::vector<SE3>& cells) {
  const auto gapOf = [&](const PlannedLink& link) {
    return (cells[link.source] * link.source_port.vector_m - cells[link.target] * link.target_port.vector_m).norm();
  };
  const double gap = gapOf(*plan.closure);
  if (std::abs(gap - gapOf(plan.links.front())) > 0.1 * reachOf(plan.closure->source_port)) {
    throw InvalidArgument(
        message("the surface does not close this ring: its two ends would be {} mm apart; leave the surface out for a "
                "cylinder that closes it",
                Number{gap * 1000, 1}));
  }
}

}  // namespace

std::vector<SE3> layPatch(const PatchPlan& plan, const Surface& surface, LinkLaw law) {
  const PlanGraph graph = graphOf(plan);
  const auto leadingAway = [&](const PlanGraph::edge_descriptor& edge) {
    const PlannedLink& link = plan.links[graph[edge]];
    return link.source == source(edge, graph) ? link : reversed(link);
  };
  double reach = 0;
  for (const PlannedLink& link : plan.links) {
    reach = std::max({reach, reachOf(link.source_port), reachOf(link.target_port)});
  }
  std::vector<SE3> cells(plan.cell_count);
  std::vector<bool> laid(plan.cell_count, false);
  const SE3 middle = surface.middle();
  const Eigen::Vector3d turn(0, 0, plan.start_yaw_rad);
  cells[plan.start] = {middle.R * expSO3(turn), middle.t};
  laid[plan.start] = true;
  requireRoom(surface, middle.t, reach);

  const SheetRelaxation relaxation(plan, surface, law);
  std::vector<PlannedLink> known;
  BreadthFirst(graph).searchFrom(plan.start, [&](const PlanGraph::edge_descriptor& edge) {
    const PlannedLink link = leadingAway(edge);
    const SE3& from = cells[link.source];
    const Eigen::Vector3d direction = from.R.leftCols<2>() * link.source_port.vector_m.head<2>().normalized();
    const GeodesicPoint end = surface.walk(from.t, direction, linkLength(link, law, surface, from.t, direction));
    requireRoom(surface, end.position, reach);
    cells[link.target] = cellAtEnd(end, surface.normal(end.position), link.target_port);
    laid[link.target] = true;
    if (plan.has_loops) {
      known.clear();
      for (const auto& other : boost::make_iterator_range(out_edges(link.target, graph))) {
        if (laid[target(other, graph)]) known.push_back(leadingAway(other));
      }
      relaxation.fitCell(link.target, known, cells);
    }
    return true;
  });
  if (plan.has_loops) relaxation.relax(cells);
  if (cells.size() > 1) requireNoOverlap(cells, reach);  // a single cell has no links and thus no reach
  if (plan.closure) requireClosed(plan, cells);
  return cells;
}

}  // namespace hexoderm
