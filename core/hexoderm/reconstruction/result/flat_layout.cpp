#include "hexoderm/reconstruction/result/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <deque>
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

FlatPort flatPort(const CellModel& model, PortNumber number) {
  const Port* port = model.findPort(number);
  if (port == nullptr) return {};  // in an imported file; its links then start at the cell's centre
  const Vector2d vector = port->vector_m.head<2>();
  return {vector, std::atan2(vector.y(), vector.x())};
}

Vector2d portPoint(const FlatCell& cell, const FlatPort& port) {
  return cell.center + Eigen::Rotation2Dd(cell.angle_rad) * port.vector_m;
}

/// The neighbour where the link's two port points meet and its two port vectors are opposite: the nominal alignment.
FlatCell placeNeighbor(const FlatCell& cell, const FlatPort& port, CellId neighbor, const FlatPort& neighbor_port) {
  FlatCell placed{neighbor, Vector2d::Zero(),
                  std::remainder(cell.angle_rad + port.heading_rad + std::numbers::pi - neighbor_port.heading_rad,
                                 2 * std::numbers::pi)};
  placed.center = portPoint(cell, port) - portPoint(placed, neighbor_port);
  return placed;
}

/// Occupied places of a sheet: a grid of squares of the least distance between two hexagons' centres.
class TakenPlaces {
 public:
  explicit TakenPlaces(double least_distance_m) : least_distance_m_(least_distance_m) {}

  [[nodiscard]] bool isFree(const Vector2d& center) const {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto square = squares_.find(key(center, dx, dy));
        if (square == squares_.end()) continue;
        for (const Vector2d& other : square->second) {
          if ((other - center).norm() < least_distance_m_) return false;
        }
      }
    }
    return true;
  }

  void take(const Vector2d& center) { squares_[key(center, 0, 0)].push_back(center); }

 private:
  [[nodiscard]] std::uint64_t key(const Vector2d& center, int dx, int dy) const {
    const std::uint32_t x = squareAt(center.x(), dx);
    const std::uint32_t y = squareAt(center.y(), dy);
    return static_cast<std::uint64_t>(x) << 32 | y;
  }
  [[nodiscard]] std::uint32_t squareAt(double coordinate_m, int step) const {
    // Ports that are a world longer than the cells are wide lead anywhere: what is that far out shares a square.
    constexpr double kFarthest = 1e9;
    const double square = std::floor(coordinate_m / least_distance_m_) + step;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::clamp(square, -kFarthest, kFarthest)));
  }

  double least_distance_m_;
  std::unordered_map<std::uint64_t, std::vector<Vector2d>> squares_;
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

/// Unrolls one patch breadth-first from its origin. A cell whose place is taken, as happens where a surface is not
/// developable, starts an island of its own; the links between islands become cuts.
class PatchUnroller {
 public:
  PatchUnroller(const CellModel& model, const PatchReconstruction& patch, FlatCell* cells)
      : patch_(patch), cells_(cells), links_at_(patch.cells.size()), state_(patch.cells.size(), State::Waiting) {
    double shortest_m = std::numeric_limits<double>::infinity();
    for (const Port& port : model.ports) shortest_m = std::min(shortest_m, port.vector_m.head<2>().norm());
    // Nominal alignments need not be multiples of 60 degrees, so honeycombs close with a little play.
    constexpr double kPlay = 0.85;
    least_distance_m_ = kPlay * 2 * std::min(shortest_m, model.side_m * std::numbers::sqrt3 / 2);
    for (const Port& port : model.ports) ports_.emplace(port.number, flatPort(model, port.number));
    for (const LinkEstimate& link : patch.links) {
      if (!link.used || !ports_.contains(link.source.port) || !ports_.contains(link.target.port)) continue;
      const auto source = indexOf(link.source.cell);
      const auto target = indexOf(link.target.cell);
      if (!source || !target || *source == *target) continue;
      links_at_[*source].push_back({*target, ports_.at(link.source.port), ports_.at(link.target.port)});
      links_at_[*target].push_back({*source, ports_.at(link.target.port), ports_.at(link.source.port)});
    }
  }

  /// Fills in the cells; the origin lies at zero, upright.
  Block unroll(double island_spacing_m) {
    std::vector<Block> islands;
    if (const auto origin = indexOf(patch_.origin)) islands.push_back(unrollFrom(*origin));
    for (std::size_t k = 0; k < displaced_.size(); ++k) {  // grows on the way
      if (state_[displaced_[k]] == State::Waiting) islands.push_back(unrollFrom(displaced_[k]));
    }
    for (std::size_t k = 0; k < state_.size(); ++k) {
      if (state_[k] != State::Waiting) continue;
      islands.push_back(unrollFrom(k));
    }
    layInRows(islands, island_spacing_m);
    Block all;
    for (const Block& island : islands) all.add(island);
    return all;
  }

 private:
  enum class State { Waiting, Placed };
  struct Neighbor {
    std::size_t cell;
    FlatPort here;
    FlatPort there;
  };

  [[nodiscard]] std::optional<std::size_t> indexOf(CellId id) const {
    const CellPlacement* cell = patch_.findCell(id);
    return cell == nullptr ? std::nullopt : std::optional(static_cast<std::size_t>(cell - patch_.cells.data()));
  }

  Block unrollFrom(std::size_t start) {
    Block island;
    TakenPlaces taken(least_distance_m_);
    const auto place = [&](std::size_t cell) {
      state_[cell] = State::Placed;
      taken.take(cells_[cell].center);
      island.add(&cells_[cell]);
    };
    place(start);
    std::deque<std::size_t> reached = {start};
    while (!reached.empty()) {
      const std::size_t cell = reached.front();
      reached.pop_front();
      for (const Neighbor& neighbor : links_at_[cell]) {
        if (state_[neighbor.cell] == State::Placed) continue;
        const FlatCell wanted = placeNeighbor(cells_[cell], neighbor.here, cells_[neighbor.cell].cell, neighbor.there);
        cells_[neighbor.cell] = wanted;
        if (taken.isFree(wanted.center)) {
          place(neighbor.cell);
          reached.push_back(neighbor.cell);
        } else {
          displaced_.push_back(neighbor.cell);
        }
      }
    }
    return island;
  }

  const PatchReconstruction& patch_;
  FlatCell* cells_;
  double least_distance_m_ = 0;
  std::unordered_map<PortNumber, FlatPort> ports_;
  std::vector<std::vector<Neighbor>> links_at_;
  std::vector<State> state_;
  std::vector<std::size_t> displaced_;
};

}  // namespace

FlatLayout computeFlatLayout(const CellModel& model, const std::vector<PatchReconstruction>& patches) {
  FlatLayout layout;
  std::unordered_map<CellId, std::size_t> index_of;
  for (const PatchReconstruction& patch : patches) {
    for (const CellPlacement& cell : patch.cells) {
      index_of.emplace(cell.cell, layout.cells.size());
      layout.cells.push_back({cell.cell, Vector2d::Zero(), 0});
    }
  }

  const double reach_m = std::max(model.reach_m(), model.side_m);
  std::vector<Block> blocks;
  std::size_t first = 0;
  for (const PatchReconstruction& patch : patches) {
    if (!patch.cells.empty()) {
      blocks.push_back(PatchUnroller(model, patch, layout.cells.data() + first).unroll(3 * reach_m));
    }
    first += patch.cells.size();
  }
  layInRows(blocks, 4 * reach_m);

  for (const PatchReconstruction& patch : patches) {
    for (std::size_t k = 0; k < patch.links.size(); ++k) {
      const LinkEstimate& link = patch.links[k];
      const auto source = index_of.find(link.source.cell);
      const auto target = index_of.find(link.target.cell);
      if (source == index_of.end() || target == index_of.end()) continue;
      FlatLink flat{patch.id, k, portPoint(layout.cells[source->second], flatPort(model, link.source.port)),
                    portPoint(layout.cells[target->second], flatPort(model, link.target.port)), false};
      flat.cut = link.used && (flat.to - flat.from).norm() > reach_m / 2;
      layout.links.push_back(flat);
    }
  }
  return layout;
}

}  // namespace hexoderm
