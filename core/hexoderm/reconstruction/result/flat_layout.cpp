#include "hexoderm/reconstruction/result/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

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

Vector2d portPoint(const FlatCell& cell, const Vector2d& port_m) {
  return cell.center + Eigen::Rotation2Dd(cell.angle_rad) * port_m;
}

/// Places of cells in a list, by their IDs; of equal ones the first.
class CellTable {
 public:
  explicit CellTable(const std::vector<CellId>& ids) {
    if (ids.empty()) return;
    const auto [least, most] = std::ranges::minmax(ids);
    first_ = least.value();
    const std::size_t range = std::size_t{most.value()} - first_ + 1;
    constexpr std::size_t kMostPerCell = 8;
    if (range <= kMostPerCell * ids.size()) {
      by_id_.assign(range, kNone);
      for (std::size_t k = ids.size(); k-- > 0;) by_id_[ids[k].value() - first_] = static_cast<std::uint32_t>(k);
    } else {
      sorted_.reserve(ids.size());
      for (std::size_t k = 0; k < ids.size(); ++k) sorted_.emplace_back(ids[k], static_cast<std::uint32_t>(k));
      std::ranges::sort(sorted_);
    }
  }

  [[nodiscard]] std::optional<std::size_t> find(CellId id) const {
    if (!by_id_.empty()) {
      const std::size_t at = std::size_t{id.value()} - first_;  // beyond the end for one that is less than the first
      if (at >= by_id_.size() || by_id_[at] == kNone) return std::nullopt;
      return by_id_[at];
    }
    const auto found = std::ranges::lower_bound(sorted_, id, {}, &std::pair<CellId, std::uint32_t>::first);
    if (found == sorted_.end() || found->first != id) return std::nullopt;
    return found->second;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::size_t first_ = 0;
  std::vector<std::uint32_t> by_id_;  ///< empty where IDs are far apart
  std::vector<std::pair<CellId, std::uint32_t>> sorted_;
};

std::vector<CellId> idsOf(const PatchReconstruction& patch) {
  std::vector<CellId> ids;
  ids.reserve(patch.cells.size());
  for (const CellPlacement& cell : patch.cells) ids.push_back(cell.cell);
  return ids;
}

/// The neighbour where the link's two port points meet and its two port vectors are opposite: the nominal alignment.
FlatCell placeNeighbor(const FlatCell& cell, const FlatPort& port, CellId neighbor, const FlatPort& neighbor_port) {
  FlatCell placed{neighbor, Vector2d::Zero(),
                  std::remainder(cell.angle_rad + port.heading_rad + std::numbers::pi - neighbor_port.heading_rad,
                                 2 * std::numbers::pi)};
  placed.center = portPoint(cell, port.vector_m) - portPoint(placed, neighbor_port.vector_m);
  return placed;
}

/// Occupied places of a sheet: a grid of squares of the least distance between two hexagons' centres, found by hashing.
class TakenPlaces {
 public:
  explicit TakenPlaces(double least_distance_m) : least_distance_m_(least_distance_m) {}

  [[nodiscard]] bool isFree(const Vector2d& center) const {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const Square square = squareOf(center, dx, dy);
        for (std::uint32_t k = first_in_[slotOf(square)]; k != kNone; k = places_[k].next) {
          if (places_[k].square == square && (places_[k].center - center).norm() < least_distance_m_) return false;
        }
      }
    }
    return true;
  }

  void take(const Vector2d& center) {
    places_.push_back({center, squareOf(center, 0, 0), kNone});
    if (2 * places_.size() > first_in_.size()) {
      first_in_.assign(2 * first_in_.size(), kNone);
      for (std::size_t k = 0; k < places_.size(); ++k) enter(k);
    } else {
      enter(places_.size() - 1);
    }
  }

 private:
  using Square = std::uint64_t;
  struct Place {
    Vector2d center;
    Square square;
    std::uint32_t next;  ///< in the same slot
  };
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  void enter(std::size_t k) {
    std::uint32_t& first = first_in_[slotOf(places_[k].square)];
    places_[k].next = first;
    first = static_cast<std::uint32_t>(k);
  }
  [[nodiscard]] Square squareOf(const Vector2d& center, int dx, int dy) const {
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
  [[nodiscard]] std::size_t slotOf(Square square) const {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio spreads neighbours (Knuth)
    return static_cast<std::size_t>((square * kGolden) >> 32) & (first_in_.size() - 1);
  }

  double least_distance_m_;
  std::vector<std::uint32_t> first_in_ = std::vector(16, kNone);  ///< per slot; a power of two
  std::vector<Place> places_;
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
      : patch_(patch), cells_(cells), table_(idsOf(patch)), placed_(patch.cells.size(), false) {
    double shortest_m = std::numeric_limits<double>::infinity();
    for (const Port& port : model.ports) shortest_m = std::min(shortest_m, port.vector_m.head<2>().norm());
    // Nominal alignments need not be multiples of 60 degrees, so honeycombs close with a little play.
    constexpr double kPlay = 0.85;
    least_distance_m_ = kPlay * 2 * std::min(shortest_m, model.side_m * std::numbers::sqrt3 / 2);
    for (const Port& port : model.ports) ports_.push_back(flatPort(model, port.number));
    findNeighbors(model);
  }

  /// Fills in the cells; the origin lies at zero, upright.
  Block unroll(double island_spacing_m) {
    std::vector<Block> islands;
    if (const auto origin = table_.find(patch_.origin)) islands.push_back(unrollFrom(*origin));
    for (std::size_t k = 0; k < displaced_.size(); ++k) {  // grows on the way
      if (!placed_[displaced_[k]]) islands.push_back(unrollFrom(displaced_[k]));
    }
    for (std::size_t k = 0; k < placed_.size(); ++k) {
      if (!placed_[k]) islands.push_back(unrollFrom(k));
    }
    layInRows(islands, island_spacing_m);
    Block all;
    for (const Block& island : islands) all.add(island);
    return all;
  }

 private:
  /// A link as one of its cells sees it; ports are indices of the model's.
  struct Neighbor {
    std::uint32_t cell;
    std::uint32_t here;
    std::uint32_t there;
  };

  /// The links of all cells, one cell's after the other's, in the order of the patch's links.
  void findNeighbors(const CellModel& model) {
    struct Join {
      std::size_t source;
      std::size_t target;
      std::uint32_t source_port;
      std::uint32_t target_port;
    };
    const auto portIndex = [&model](PortNumber number) {
      return static_cast<std::size_t>(std::ranges::find(model.ports, number, &Port::number) - model.ports.begin());
    };
    std::vector<Join> joins;
    joins.reserve(patch_.links.size());
    first_neighbor_.assign(patch_.cells.size() + 1, 0);
    for (const LinkEstimate& link : patch_.links) {
      if (!link.used) continue;
      const std::size_t source_port = portIndex(link.source.port);
      const std::size_t target_port = portIndex(link.target.port);
      if (source_port == ports_.size() || target_port == ports_.size()) continue;
      const auto source = table_.find(link.source.cell);
      const auto target = table_.find(link.target.cell);
      if (!source || !target || *source == *target) continue;
      joins.push_back(
          {*source, *target, static_cast<std::uint32_t>(source_port), static_cast<std::uint32_t>(target_port)});
      ++first_neighbor_[*source + 1];
      ++first_neighbor_[*target + 1];
    }
    std::partial_sum(first_neighbor_.begin(), first_neighbor_.end(), first_neighbor_.begin());
    neighbors_.resize(2 * joins.size());
    std::vector<std::size_t> next(first_neighbor_.begin(), first_neighbor_.end() - 1);
    for (const Join& join : joins) {
      neighbors_[next[join.source]++] = {static_cast<std::uint32_t>(join.target), join.source_port, join.target_port};
      neighbors_[next[join.target]++] = {static_cast<std::uint32_t>(join.source), join.target_port, join.source_port};
    }
  }

  Block unrollFrom(std::size_t start) {
    Block island;
    TakenPlaces taken(least_distance_m_);
    const auto place = [&](std::size_t cell) {
      placed_[cell] = true;
      taken.take(cells_[cell].center);
      island.add(&cells_[cell]);
    };
    place(start);
    std::deque<std::size_t> reached = {start};
    while (!reached.empty()) {
      const std::size_t cell = reached.front();
      reached.pop_front();
      for (std::size_t k = first_neighbor_[cell]; k < first_neighbor_[cell + 1]; ++k) {
        const Neighbor& neighbor = neighbors_[k];
        if (placed_[neighbor.cell]) continue;
        const FlatCell wanted =
            placeNeighbor(cells_[cell], ports_[neighbor.here], cells_[neighbor.cell].cell, ports_[neighbor.there]);
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
  std::vector<FlatPort> ports_;  ///< as the model has them
  CellTable table_;
  std::vector<std::size_t> first_neighbor_;  ///< per cell, and the end
  std::vector<Neighbor> neighbors_;
  std::vector<bool> placed_;
  std::vector<std::size_t> displaced_;
};

}  // namespace

FlatLayout computeFlatLayout(const CellModel& model, const std::vector<PatchReconstruction>& patches) {
  FlatLayout layout;
  std::vector<CellId> ids;
  std::size_t link_count = 0;
  for (const PatchReconstruction& patch : patches) {
    for (const CellPlacement& cell : patch.cells) {
      ids.push_back(cell.cell);
      layout.cells.push_back({cell.cell, Vector2d::Zero(), 0});
    }
    link_count += patch.links.size();
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

  const CellTable table(ids);
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
      const auto source = table.find(link.source.cell);
      const auto target = table.find(link.target.cell);
      if (!source || !target) continue;
      FlatLink flat{patch.id, k, pointOf(*source, link.source.port), pointOf(*target, link.target.port), false};
      flat.cut = link.used && (flat.to - flat.from).norm() > reach_m / 2;
      layout.links.push_back(flat);
    }
  }
  return layout;
}

}  // namespace hexoderm
