#pragma once

#include "hexoderm/solve/tree/edge_rotation.h"
#include "hexoderm/solve/tree/gravity_table.h"

#include <vector>

namespace hexoderm {

/// Every cell's gravity in every pose as the edges see it: the usable readings, and for cells that have none, what
/// their neighbours read.
///
/// A cell without any usable reading would cut its chain: its gravity is taken half way between its neighbours', as
/// their nominal alignment brings it over. Such a cell is placed by its links and says so.
class SkinReadings {
 public:
  SkinReadings(const CellModel& model, const SkinGraph& graph, const GravityTable& table);

  /// Follows the table after the readings of one cell were taken out of it, as if made anew. The cells whose gravity is
  /// another one now: this one, and those without readings that hang together with it.
  std::vector<std::size_t> update(const CellModel& model, const SkinGraph& graph, std::size_t cell);

  /// The cell has usable readings of its own.
  [[nodiscard]] bool measured(std::size_t cell) const { return measured_[cell]; }
  [[nodiscard]] bool measured(const GraphLink& link) const { return measured_[link.source] && measured_[link.target]; }
  /// Its gravity is its neighbours'.
  [[nodiscard]] bool interpolated(std::size_t cell) const;
  /// What a cell reads in a pose, or has from its neighbours; zero: nothing.
  [[nodiscard]] const Eigen::Vector3d& gravityOf(std::size_t cell, std::size_t pose) const {
    return gravity_[cell * table_->poseCount() + pose];
  }
  /// Both ends of the link have a gravity vector in the pose.
  [[nodiscard]] bool inBoth(const GraphLink& link, std::size_t pose) const {
    return !gravityOf(link.source, pose).isZero() && !gravityOf(link.target, pose).isZero();
  }
  /// Enabled poses in which both ends of the link have a gravity vector, ascending.
  [[nodiscard]] std::vector<std::size_t> posesOf(const GraphLink& link) const;
  [[nodiscard]] EdgeReadings readingsOf(const GraphLink& link) const;

 private:
  void readCell(std::size_t cell);
  [[nodiscard]] Eigen::Vector3d& gravityAt(std::size_t cell, std::size_t pose) {
    return gravity_[cell * table_->poseCount() + pose];
  }
  [[nodiscard]] std::vector<std::size_t> blindAround(const SkinGraph& graph, std::size_t cell) const;
  void fillMissing(const CellModel& model, const SkinGraph& graph, const std::vector<std::size_t>& blind);

  const GravityTable* table_;
  std::vector<bool> measured_;
  std::vector<Eigen::Vector3d> gravity_;  ///< per cell and pose; zero: none
};

}  // namespace hexoderm
