#pragma once

// What SimulatedSkinOptions::faults and link_faults do to a skin.

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/error.h"
#include "hexoderm/device/sample_frame.h"
#include "hexoderm/sim/patch_plan.h"
#include "hexoderm/sim/random_streams.h"
#include "hexoderm/sim/simulated_skin.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace hexoderm {

/// The ID of the cell with this index.
inline CellId cellNumbered(std::size_t index) { return CellId(static_cast<std::uint32_t>(index + 1)); }

/// Throws InvalidArgument if there is no such cell.
inline void requireCellToBreak(CellId cell, std::size_t cell_count) {
  if (cell.value() != 0 && cell.value() <= cell_count) return;
  throw InvalidArgument(message("simulated skin: there is no cell {} to break; cells are 1 to {}", cell, cell_count));
}

/// The defects of one cell's sensor.
struct CellHealth {
  static constexpr double kNoisyFactor = 20;
  static constexpr double kSaturatedGain = 20;
  static constexpr double kWrongGain = 1.25;
  static constexpr double kYawed_rad = 20 * kDegree;
  static constexpr double kReglued_rad = 10 * kDegree;

  std::bitset<enumeratorCount<SkinFault>()> faults;  ///< by SkinFault
  int stuck_axis = -1;
  int dead_axis = -1;
  /// From the cell as it lies now to the cell as it is said to lie; of a reglued one, see reglued_before.
  std::optional<Eigen::Matrix3d> turn;
  std::optional<Eigen::Vector3d> first_reading_g;  ///< set for a stuck cell

  [[nodiscard]] bool has(SkinFault fault) const { return faults[static_cast<std::size_t>(fault)]; }
  /// See WrongDelivery.
  [[nodiscard]] bool sendsAnothers() const { return has(SkinFault::Echo) || has(SkinFault::Swapped); }
  /// Applies the defects to a reading before its noise is added.
  [[nodiscard]] Eigen::Vector3d sensed(const Eigen::Vector3d& reading_g) const {
    if (has(SkinFault::Dead)) return Eigen::Vector3d::Zero();
    Eigen::Vector3d reading =
        (has(SkinFault::Saturated) ? kSaturatedGain : 1) * (has(SkinFault::WrongGain) ? kWrongGain : 1) * reading_g;
    if (dead_axis >= 0) reading(dead_axis) = 0;
    return reading;
  }
  [[nodiscard]] double noiseFactor() const { return has(SkinFault::Noisy) ? kNoisyFactor : 1; }
  /// Applies the defects to a reading with noise, quantised.
  Eigen::Vector3d sent(Eigen::Vector3d reading_g) {
    const bool is_stuck = has(SkinFault::Stuck);
    if (!is_stuck && stuck_axis < 0) return reading_g;
    if (!first_reading_g) first_reading_g = reading_g;
    if (is_stuck) return *first_reading_g;
    reading_g(stuck_axis) = (*first_reading_g)(stuck_axis);
    return reading_g;
  }
};

/// `random` draws the axis, where a fault is of one axis.
inline void addFault(CellHealth& cell, SkinFault kind, std::mt19937_64& random) {
  std::uniform_int_distribution<int> any_axis(0, 2);
  cell.faults.set(static_cast<std::size_t>(kind));
  if (kind == SkinFault::StuckAxis) cell.stuck_axis = any_axis(random);
  if (kind == SkinFault::DeadAxis) cell.dead_axis = any_axis(random);
  if (kind == SkinFault::Yawed) cell.turn = expSO3(CellHealth::kYawed_rad * Eigen::Vector3d::UnitZ());
  if (kind == SkinFault::Reglued)
    cell.turn = expSO3(CellHealth::kReglued_rad * NormalSource(random).nextVector().normalized());
}

/// Throws InvalidArgument for a fault of a cell that is not there.
inline std::vector<CellHealth> breakCells(const SimulatedSkinOptions& options, std::size_t cell_count) {
  std::vector<CellHealth> health(cell_count);
  std::mt19937_64 random = randomStream(options.seed, Stream::Faults);
  for (const CellFault& fault : options.faults) {
    requireCellToBreak(fault.cell, cell_count);
    std::mt19937_64 of_cell = randomStream(options.seed, Stream::DeadAxis, {fault.cell.value()});
    const bool is_drawn_by_cell = fault.kind == SkinFault::DeadAxis || fault.kind == SkinFault::Reglued;
    addFault(health[fault.cell.value() - 1], fault.kind, is_drawn_by_cell ? of_cell : random);
  }
  return health;
}

/// Cells that send what others should, and skins of which all sensors are wrong alike: SkinFault::Echo and Swapped, and
/// the WholeSkinFaults of readings.
class WrongDelivery {
 public:
  WrongDelivery(const SimulatedSkinOptions& options, const NeighborList& neighbors)
      : whole_(options.whole_skin_faults), seed_(options.seed) {
    for (const CellReport& cell : neighbors) {
      const auto first =
          std::ranges::find_if(cell.neighbors, [](const NeighborReport& n) { return n.cell.value() != 0; });
      first_neighbor_.push_back(first == cell.neighbors.end() ? std::nullopt : std::optional(first->cell));
    }
  }
  /// `frame`: a tick of the given recording, with the cells' readings as they should be delivered.
  void apply(const std::vector<CellHealth>& cells, std::size_t recording, SampleFrame& frame) const {
    std::vector<CellSample>& samples = frame.samples;
    exchange(cells, samples);
    for (const WholeSkinFault fault : whole_) {
      std::mt19937_64 random = randomStream(seed_, Stream::WholeSkin, recording);
      switch (fault) {
        case WholeSkinFault::Identical:
          for (CellSample& sample : samples) sample.acceleration_g = samples.front().acceleration_g;
          break;
        case WholeSkinFault::AxesSwapped:
          for (CellSample& sample : samples) std::swap(sample.acceleration_g.x(), sample.acceleration_g.y());
          break;
        case WholeSkinFault::AxesPermuted:
          for (CellSample& sample : samples) {
            const Eigen::Vector3d& y = sample.acceleration_g;
            sample.acceleration_g = Eigen::Vector3d(y.y(), y.z(), y.x());
          }
          break;
        case WholeSkinFault::Shuffled: {
          std::vector<Eigen::Vector3d> readings;
          for (const CellSample& sample : samples) readings.push_back(sample.acceleration_g);
          std::ranges::shuffle(readings, random);
          for (std::size_t k = 0; k < samples.size(); ++k) samples[k].acceleration_g = readings[k];
          break;
        }
        case WholeSkinFault::Random: {
          // What the cell reads is turned as a whole, so that its noise stays what it is.
          NormalSource normal(random);
          for (CellSample& sample : samples) {
            const Eigen::Vector3d to = normal.nextVector();
            sample.acceleration_g = sample.acceleration_g.norm() * to.normalized();
          }
          break;
        }
        case WholeSkinFault::PortsRotated:
        case WholeSkinFault::PortOffset:
          break;  // LinkFaults
      }
    }
  }

 private:
  void exchange(const std::vector<CellHealth>& cells, std::vector<CellSample>& samples) const {
    const bool any = std::ranges::any_of(cells, &CellHealth::sendsAnothers);
    if (!any) return;
    const std::vector<CellSample> sent = samples;
    const auto at = [](std::vector<CellSample>& in, CellId cell) {
      return std::ranges::find(in, cell, &CellSample::cell);
    };
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (!cells[k].sendsAnothers() || !first_neighbor_[k]) continue;
      const auto own = at(samples, cellNumbered(k));
      const auto other = at(samples, *first_neighbor_[k]);
      if (own == samples.end() || other == samples.end()) continue;
      const Eigen::Vector3d own_g = sent[static_cast<std::size_t>(own - samples.begin())].acceleration_g;
      own->acceleration_g = sent[static_cast<std::size_t>(other - samples.begin())].acceleration_g;
      if (cells[k].has(SkinFault::Swapped)) other->acceleration_g = own_g;
    }
  }

  std::vector<WholeSkinFault> whole_;
  std::vector<std::optional<CellId>> first_neighbor_;  ///< per cell
  std::uint64_t seed_;
};

/// The faults of a patch's links.
class LinkFaults {
 public:
  /// Throws InvalidArgument with the reason for a link that is not there, that is broken twice alike, or that can't be
  /// broken in this way.
  LinkFaults(const PatchPlan& plan, const CellModel& model, const SimulatedSkinOptions& options)
      : reported_(plan.allLinks()), joint_angle_rad_(options.joint_angle_rad), seed_(options.seed) {
    // The links of the real mould, needed only where one of them is broken.
    const std::vector<PlannedLink> links = options.link_faults.empty() ? std::vector<PlannedLink>() : reported_;
    std::set<LinkEnd> renamed;
    std::set<std::size_t> cut;
    for (const LinkFault& fault : options.link_faults) {
      const std::size_t link = findLink(fault.at, links, plan.cell_count);
      const bool is_new =
          fault.kind == LinkFaultKind::WrongPort ? renamed.insert(fault.at).second : cut.insert(link).second;
      if (!is_new)
        throw InvalidArgument(message("simulated skin: the link at {} is broken already", inWords(fault.at)));
      if (fault.kind == LinkFaultKind::WrongPort) {
        reportWrongPort(fault.at, link, model, options.seed);
      } else {
        (fault.kind == LinkFaultKind::Joint ? joints_ : cables_).push_back(cutAt(plan, links, link));
      }
    }
    for (const WholeSkinFault fault : options.whole_skin_faults) {
      if (fault == WholeSkinFault::PortsRotated) renumberPorts(model, true);
      if (fault == WholeSkinFault::PortOffset) renumberPorts(model, false);
    }
  }

  /// The patch's links with the ports that the cells report. They are as large as a skin, and asked for once.
  [[nodiscard]] std::vector<PlannedLink> takeReportedLinks() { return std::move(reported_); }

  /// Takes the cells behind every cable to where the cable lets them lie.
  void pullCables(std::vector<TrueCell>& cells) const {
    if (cables_.empty()) return;
    std::vector<SE3> motions;
    for (const Cut& cable : cables_) {
      // The cable is the same, whichever end names it.
      std::mt19937_64 random = randomStream(
          seed_, Stream::LinkFaults, {cellNumbered(cable.link.source).value(), cable.link.source_port.number.value()});
      std::uniform_real_distribution<double> any_angle(kMinCableTurn, kMaxCableTurn);
      const double angle = any_angle(random);
      NormalSource normal(random);
      const Eigen::Vector3d turn = angle * normal.nextVector().normalized();
      const Eigen::Vector3d shift = kCableReach_m * normal.nextVector().normalized();
      const LinkFrame at = frameOf(cable.link, cells[cable.link.source].T_b_u, cells[cable.link.target].T_b_u);
      SE3 motion = turnAbout(at.middle, expSO3(turn));
      motion.t += shift;
      motions.push_back(motion);
    }
    const std::vector<SE3> moved = composed(cables_, motions, cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k) cells[k].T_b_u = moved[k] * cells[k].T_b_u;
  }

  /// The motion of every cell (body frame) that bends all joints; empty without joints.
  [[nodiscard]] std::vector<SE3> bendingOf(const std::vector<TrueCell>& cells) const {
    if (joints_.empty()) return {};
    std::vector<SE3> motions;
    for (const Cut& joint : joints_) {
      const LinkFrame at = frameOf(joint.link, cells[joint.link.source].T_b_u, cells[joint.link.target].T_b_u);
      const Eigen::Vector3d turn = joint_angle_rad_ * at.normal.cross(at.along);
      motions.push_back(turnAbout(at.middle, expSO3(turn)));
    }
    return composed(joints_, motions, cells.size());
  }

 private:
  static constexpr double kCableReach_m = 0.1;
  static constexpr double kMinCableTurn = 40 * kDegree;
  static constexpr double kMaxCableTurn = 120 * kDegree;

  /// Index of the link at this end.
  static std::size_t findLink(const LinkEnd& at, const std::vector<PlannedLink>& links, std::size_t cell_count) {
    requireCellToBreak(at.cell, cell_count);
    std::set<PortNumber> joined;
    for (std::size_t k = 0; k < links.size(); ++k) {
      const PlannedLink& link = links[k];
      for (const LinkEnd& end : {LinkEnd{cellNumbered(link.source), link.source_port.number},
                                 LinkEnd{cellNumbered(link.target), link.target_port.number}}) {
        if (end == at) return k;
        if (end.cell == at.cell) joined.insert(end.port);
      }
    }
    throw InvalidArgument(
        joined.empty() ? message("simulated skin: {} has no link to break; the cell has links at no port", inWords(at))
                       : message("simulated skin: {} has no link to break; the cell has links at the ports {}",
                                 inWords(at), std::vector(joined.begin(), joined.end())));
  }

  using LinksAt = std::vector<std::vector<PlannedLink>>;  // leading away from each cell

  static LinksAt linksByCell(const std::vector<PlannedLink>& links, std::size_t without, std::size_t cell_count) {
    LinksAt at(cell_count);
    for (std::size_t k = 0; k < links.size(); ++k) {
      if (k == without) continue;
      at[links[k].source].push_back(links[k]);
      at[links[k].target].push_back(reversed(links[k]));
    }
    return at;
  }

  /// Placements, in the first cell's frame, of the cells that `links` lead to from `start`, if the patch were flat.
  static std::vector<std::optional<SE3>> layFlat(std::size_t start, const LinksAt& links) {
    std::vector<std::optional<SE3>> cells(links.size());
    cells[start] = SE3();
    std::vector<std::size_t> order = {start};
    for (std::size_t next = 0; next < order.size(); ++next) {
      for (const PlannedLink& link : links[order[next]]) {
        if (cells[link.target]) continue;
        const Eigen::Matrix3d R = nominalAlignment(link.source_port, link.target_port);
        cells[link.target] = *cells[link.source] * linkTransform(R, link.source_port, link.target_port);
        order.push_back(link.target);
      }
    }
    return cells;
  }

  /// Middle of a link, its direction along the surface, and the surface's normal there.
  struct LinkFrame {
    Eigen::Vector3d middle, along, normal;
  };

  static LinkFrame frameOf(const PlannedLink& link, const SE3& source, const SE3& target) {
    LinkFrame frame;
    frame.middle = (source * link.source_port.vector_m + target * link.target_port.vector_m) / 2;
    frame.normal = (source.R.col(2) + target.R.col(2)).normalized();
    const Eigen::Vector3d way = target.t - source.t;
    frame.along = (way - frame.normal * frame.normal.dot(way)).normalized();
    return frame;
  }

  /// The motion that turns about a point.
  static SE3 turnAbout(const Eigen::Vector3d& point, const Eigen::Matrix3d& R) { return {R, point - R * point}; }

  /// A link whose far side moves as one piece.
  struct Cut {
    PlannedLink link;                   ///< from the near side to the far one
    std::vector<std::size_t> far_side;  ///< cells
  };

  /// Every port is reported as the next one: around the cell, or by number.
  void renumberPorts(const CellModel& model, bool around) {
    std::vector<Port> ports = model.ports;
    const auto heading = [](const Port& port) { return std::atan2(port.vector_m.y(), port.vector_m.x()); };
    if (around) {
      std::ranges::sort(ports, {}, heading);
    } else {
      std::ranges::sort(ports, {}, &Port::number);
    }
    const auto next = [&ports](const Port& port) {
      const auto at = std::ranges::find(ports, port.number, &Port::number);
      return at + 1 == ports.end() ? ports.front() : *(at + 1);
    };
    for (PlannedLink& link : reported_) {
      link.source_port = next(link.source_port);
      link.target_port = next(link.target_port);
    }
  }
  void reportWrongPort(const LinkEnd& at, std::size_t link, const CellModel& model, std::uint64_t seed) {
    PlannedLink& wrong = reported_[link];
    const bool at_source = cellNumbered(wrong.source) == at.cell;
    const PortNumber far_port = (at_source ? wrong.target_port : wrong.source_port).number;
    std::set<PortNumber> taken = {at.port};
    for (const PlannedLink& other : reported_) {
      if (cellNumbered(other.source) == at.cell) taken.insert(other.source_port.number);
      if (cellNumbered(other.target) == at.cell) taken.insert(other.target_port.number);
    }
    std::vector<Port> free;
    for (const Port& port : model.ports) {
      if (!taken.contains(port.number) && !model.isForbidden(port.number, far_port)) free.push_back(port);
    }
    if (free.empty()) {
      throw InvalidArgument(message(
          "simulated skin: the link at {} can't be reported at a wrong port: no other port of the cell is free for it",
          inWords(at)));
    }
    std::mt19937_64 random = randomStream(seed, Stream::LinkFaults, {at.cell.value(), at.port.value()});
    std::uniform_int_distribution<std::size_t> any(0, free.size() - 1);
    (at_source ? wrong.source_port : wrong.target_port) = free[any(random)];
  }
  static Cut cutAt(const PatchPlan& plan, const std::vector<PlannedLink>& links, std::size_t link) {
    const auto turnedTo = [&](bool target_is_far) { return target_is_far ? links[link] : reversed(links[link]); };
    const std::vector<std::optional<SE3>> held = layFlat(plan.start, linksByCell(links, link, plan.cell_count));
    const bool reaches_source = held[links[link].source].has_value();
    Cut cut;
    if (reaches_source != held[links[link].target].has_value()) {
      cut.link = turnedTo(reaches_source);
      for (std::size_t cell = 0; cell < held.size(); ++cell) {
        if (!held[cell]) cut.far_side.push_back(cell);
      }
      return cut;
    }
    if (plan.closure) {
      const LinkEnd at{cellNumbered(links[link].source), links[link].source_port.number};
      throw InvalidArgument(
          message("simulated skin: the link at {} can't be a joint or a cable: the rest of the closed ring holds both "
                  "its sides together",
                  inWords(at)));
    }
    // The link is not all that holds the sides together: both are cut apart along a line through it.
    const PlannedLink& through = links[link];
    const LinkFrame line = frameOf(through, *held[through.source], *held[through.target]);
    const auto isBehind = [&](std::size_t cell) { return line.along.dot(held[cell]->t - line.middle) > 0; };
    const bool start_is_behind = isBehind(plan.start);
    cut.link = turnedTo(!start_is_behind);
    for (std::size_t cell = 0; cell < held.size(); ++cell) {
      if (isBehind(cell) != start_is_behind) cut.far_side.push_back(cell);
    }
    return cut;
  }
  /// Every motion is given for the part as it is before any other: what moves more cells moves the smaller motions
  /// along.
  static std::vector<SE3> composed(const std::vector<Cut>& cuts, const std::vector<SE3>& motions, std::size_t cells) {
    std::vector<std::size_t> order(cuts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t k) { return cuts[k].far_side.size(); });
    std::vector<SE3> all(cells);
    for (const std::size_t k : order) {
      for (const std::size_t cell : cuts[k].far_side) all[cell] = all[cell] * motions[k];
    }
    return all;
  }

  std::vector<PlannedLink> reported_;
  std::vector<Cut> joints_;
  std::vector<Cut> cables_;
  double joint_angle_rad_;
  std::uint64_t seed_;
};

}  // namespace hexoderm
