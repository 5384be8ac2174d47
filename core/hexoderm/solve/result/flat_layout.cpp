#include "hexoderm/skin/breadth_first.h"
#include "hexoderm/solve/result/result_graph.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <unordered_map>

namespace hexoderm {
namespace {

/// A port vector seen in the sheet.
struct FlatPort {
  Vector2d vector_m = Vector2d::Zero();
  double heading_rad = 0;
};

FlatPort flatPort(const Port& port) {
  const Vector2d vector = port.vector_m.head<2>();
  return {vector, std::atan2(vector.y(), vector.x())};
}

Vector2d portPoint(const FlatCell& cell, const Vector2d& port_m) {
  return cell.center + Eigen::Rotation2Dd(cell.angle_rad) * port_m;
}

/// The neighbour where the link's two port points meet and its two port vectors are opposite: the nominal alignment.
FlatCell placeNeighbor(const FlatCell& cell, const FlatPort& port, CellId neighbor, const FlatPort& neighbor_port) {
  FlatCell placed{neighbor, Vector2d::Zero(),
                  std::remainder(cell.angle_rad + port.heading_rad + std::numbers::pi - neighbor_port.heading_rad,
                                 2 * std::numbers::pi)};
  placed.center = portPoint(cell, port.vector_m) - portPoint(placed, neighbor_port.vector_m);
  return placed;
}

/// Occupied places of a sheet, by squares of the least distance between two hexagons' centres.
class TakenPlaces {
 public:
  explicit TakenPlaces(double least_distance_m) : least_distance_m_(least_distance_m) {}

  [[nodiscard]] bool isFree(const Vector2d& center) const {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto [first, last] = places_.equal_range(squareOf(center, dx, dy));
        const auto isNear = [&](const auto& place) { return (place.second - center).norm() < least_distance_m_; };
        if (std::any_of(first, last, isNear)) return false;
      }
    }
    return true;
  }

  void take(const Vector2d& center) { places_.emplace(squareOf(center, 0, 0), center); }

 private:
  [[nodiscard]] std::uint64_t squareOf(const Vector2d& center, int dx, int dy) const {
    return static_cast<std::uint64_t>(squareAt(center.x(), dx)) << 32 | squareAt(center.y(), dy);
  }
  [[nodiscard]] std::uint32_t squareAt(double coordinate_m, int step) const {
    // Ports that are a world longer than the cells are wide lead anywhere: what is that far out shares a square.
    constexpr double kFarthest = 1e9;
    const double square = std::floor(coordinate_m / least_distance_m_) + step;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::clamp(square, -kFarthest, kFarthest)));
  }

  double least_distance_m_;
  std::unordered_multimap<std::uint64_t, Vector2d> places_;
};

/// Things that keep their shape while they are laid side by side: an island of cells, or a patch of islands.
struct Block {
  std::vector<FlatCell*> cells;
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
  Vector2d high = Vector2d::Constant(-std::numeric_limits<double>::infinity());

  void add(FlatCell* cell) {
    cells.push_back(cell);
    low = low.cwiseMin(cell->center);
    high = high.cwiseMax(cell->center);
  }
  void add(const Block& block) {
    for (FlatCell* cell : block.cells) add(cell);
  }
};

/// Lays blocks side by side in rows, the first one where it is. `spacing_m` is kept between centres of cells.
void layInRows(const std::vector<Block>& blocks, double spacing_m) {
  if (blocks.size() < 2) return;
  double area = 0;
  double row_width = 0;
  for (const Block& block : blocks) {
    const Vector2d size = (block.high - block.low).array() + spacing_m;
    area += size.x() * size.y();
    row_width = std::max(row_width, size.x());
  }
  // About four blocks of one size stay in a row; many make a picture that is wider than it is high.
  row_width = std::max(row_width, std::sqrt(4.5 * area));
  const Vector2d start(blocks.front().low.x(), blocks.front().high.y());
  Vector2d corner = start;
  double row_height = 0;
  for (const Block& block : blocks) {
    const Vector2d size = (block.high - block.low).array() + spacing_m;
    if (corner.x() > start.x() && corner.x() + size.x() - start.x() > row_width) {
      corner = {start.x(), corner.y() - row_height};
      row_height = 0;
    }
    const Vector2d shift = corner - Vector2d(block.low.x(), block.high.y());
    for (FlatCell* cell : block.cells) cell->center += shift;
    corner.x() += size.x();
    row_height = std::max(row_height, size.y());
  }
}

/// Unrolls patches breadth-first from their origins. A cell whose place is taken, as happens where a surface is not
/// developable, starts an island of its own; the links between islands become cuts.
class Unroller {
 public:
  using Vertex = ResultGraph::Vertex;

  Unroller(const CellModel& model, const ResultGraph& graph, std::vector<FlatCell>& cells)
      : model_(model), graph_(graph), cells_(cells), search_(graph.graph()) {
    double shortest_m = std::numeric_limits<double>::infinity();
    for (const Port& port : model.ports) shortest_m = std::min(shortest_m, port.vector_m.head<2>().norm());
    // Nominal alignments need not be multiples of 60 degrees, so honeycombs close with a little play.
    constexpr double kPlay = 0.85;
    least_distance_m_ = kPlay * 2 * std::min(shortest_m, model.side_m * std::numbers::sqrt3 / 2);
    for (const Port& port : model.ports) ports_.push_back(flatPort(port));
  }

  /// Fills in the cells of a patch, which begin with the vertex `first`; the origin lies at zero, upright.
  Block unroll(const PatchReconstruction& patch, Vertex first, double island_spacing_m) {
    std::vector<Block> islands;
    displaced_.clear();
    const auto origin = graph_.find(patch.origin);
    if (origin && graph_.graph()[*origin].patch == &patch) islands.push_back(unrollFrom(*origin));
    for (std::size_t k = 0; k < displaced_.size(); ++k) {  // grows on the way
      if (!search_.isReached(displaced_[k])) islands.push_back(unrollFrom(displaced_[k]));
    }
    for (Vertex cell = first; cell < first + patch.cells.size(); ++cell) {
      if (!search_.isReached(cell)) islands.push_back(unrollFrom(cell));
    }
    layInRows(islands, island_spacing_m);
    Block all;
    for (const Block& island : islands) all.add(island);
    return all;
  }

 private:
  /// Null in an imported file.
  [[nodiscard]] const FlatPort* find(PortNumber number) const {
    const auto found = std::ranges::find(model_.ports, number, &Port::number);
    return found == model_.ports.end() ? nullptr : &ports_[static_cast<std::size_t>(found - model_.ports.begin())];
  }

  Block unrollFrom(Vertex start) {
    TakenPlaces taken(least_distance_m_);
    taken.take(cells_[start].center);
    const ResultGraph::Graph& graph = graph_.graph();
    const auto& reached = search_.searchFrom(start, [&](const ResultGraph::Edge& edge) {
      const ResultEdge& link = graph[edge];
      const FlatPort* here = find(link.tail().port);
      const FlatPort* there = find(link.head().port);
      if (!link.joins || here == nullptr || there == nullptr) return false;
      const Vertex cell = target(edge, graph);
      cells_[cell] = placeNeighbor(cells_[source(edge, graph)], *here, cells_[cell].cell, *there);
      if (!taken.isFree(cells_[cell].center)) {
        displaced_.push_back(cell);
        return false;
      }
      taken.take(cells_[cell].center);
      return true;
    });
    Block island;
    for (const Vertex cell : reached) island.add(&cells_[cell]);
    return island;
  }

  const CellModel& model_;
  const ResultGraph& graph_;
  std::vector<FlatCell>& cells_;
  double least_distance_m_ = 0;
  std::vector<FlatPort> ports_;  ///< as the model has them
  BreadthFirst<ResultGraph::Graph> search_;
  std::vector<Vertex> displaced_;
};

}  // namespace

FlatLayout computeFlatLayout(const CellModel& model, const std::vector<PatchReconstruction>& patches) {
  const ResultGraph graph(patches);
  FlatLayout layout;
  std::size_t link_count = 0;
  for (const PatchReconstruction& patch : patches) {
    for (const CellPlacement& cell : patch.cells) layout.cells.push_back({cell.cell, Vector2d::Zero(), 0});
    link_count += patch.links.size();
  }

  const double reach_m = std::max(model.reach_m(), model.side_m);
  Unroller unroller(model, graph, layout.cells);
  std::vector<Block> blocks;
  Unroller::Vertex first = 0;
  for (const PatchReconstruction& patch : patches) {
    if (!patch.cells.empty()) blocks.push_back(unroller.unroll(patch, first, 3 * reach_m));
    first += static_cast<Unroller::Vertex>(patch.cells.size());
  }
  layInRows(blocks, 4 * reach_m);

  std::vector<Eigen::Matrix<double, 2, 2, Eigen::DontAlign>> turns;
  turns.reserve(layout.cells.size());
  for (const FlatCell& cell : layout.cells) turns.emplace_back(Eigen::Rotation2Dd(cell.angle_rad).toRotationMatrix());
  const auto pointOf = [&](std::size_t cell, PortNumber number) -> Vector2d {
    const Port* port = model.findPort(number);
    if (port == nullptr) return layout.cells[cell].center;  // in an imported file
    return layout.cells[cell].center + turns[cell] * port->vector_m.head<2>();
  };
  layout.links.reserve(link_count);
  for (const PatchReconstruction& patch : patches) {
    for (std::size_t k = 0; k < patch.links.size(); ++k) {
      const LinkEstimate& link = patch.links[k];
      const auto source = graph.find(link.source.cell);
      const auto target = graph.find(link.target.cell);
      if (!source || !target) continue;
      FlatLink flat{patch.id, k, pointOf(*source, link.source.port), pointOf(*target, link.target.port), false};
      flat.cut = link.used && (flat.to - flat.from).norm() > reach_m / 2;
      layout.links.push_back(flat);
    }
  }
  return layout;
}

}  // namespace hexoderm
