#include "hexoderm/solve/tree/skin_readings.h"

#include "hexoderm/skin/breadth_first.h"
#include "hexoderm/skin/skin_graph_boost.h"

#include <algorithm>

namespace hexoderm {

SkinReadings::SkinReadings(const CellModel& model, const SkinGraph& graph, const GravityTable& table)
    : table_(&table),
      measured_(graph.cells().size(), false),
      gravity_(graph.cells().size() * table.poseCount(), Eigen::Vector3d::Zero()) {
  std::vector<std::size_t> blind;
  for (std::size_t cell = 0; cell < measured_.size(); ++cell) {
    readCell(cell);
    if (!measured_[cell]) blind.push_back(cell);
  }
  if (!blind.empty() && !table.enabledPoses().empty()) fillMissing(model, graph, blind);
}

void SkinReadings::readCell(std::size_t cell) {
  measured_[cell] = false;
  for (std::size_t pose = 0; pose < table_->poseCount(); ++pose) gravityAt(cell, pose).setZero();
  for (const std::size_t pose : table_->enabledPoses()) {
    const GravityTable::Entry& entry = table_->at(cell, pose);
    if (!entry.usable) continue;
    measured_[cell] = true;
    gravityAt(cell, pose) = entry.mean_g;
  }
}

std::vector<std::size_t> SkinReadings::update(const CellModel& model, const SkinGraph& graph, std::size_t cell) {
  readCell(cell);
  if (measured_[cell] || table_->enabledPoses().empty()) return {cell};
  // What a cell without readings gets from its neighbours depends on no other such cell than those it is joined to by
  // such cells alone, and on the order among these.
  const std::vector<std::size_t> blind = blindAround(graph, cell);
  for (const std::size_t other : blind) readCell(other);
  fillMissing(model, graph, blind);
  return blind;
}

/// The cells without readings that are joined to `cell` by cells without readings, with it, ascending.
std::vector<std::size_t> SkinReadings::blindAround(const SkinGraph& graph, std::size_t cell) const {
  const PatchGraph view{&graph, graph.cells()[cell].patch.value()};
  BreadthFirst search(view);
  std::vector<std::size_t> blind =
      search.searchFrom(cell, [&](const SkinEdge& edge) { return !measured_[target(edge, view)]; });
  std::ranges::sort(blind);
  return blind;
}

void SkinReadings::fillMissing(const CellModel& model, const SkinGraph& graph, const std::vector<std::size_t>& blind) {
  // First outwards from the cells that read, then a few rounds for chains of several blind ones.
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    for (const std::size_t cell : blind) {
      for (const std::size_t pose : table_->enabledPoses()) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const std::size_t link_index : graph.linksAt(cell)) {
          const GraphLink& link = graph.links()[link_index];
          if (link.muted()) continue;
          const Eigen::Vector3d& g = gravityOf(link.other(cell), pose);
          if (g.isZero()) continue;
          Eigen::Matrix3d R_nom = nominalAlignment(model.port(link.source_port), model.port(link.target_port));
          if (link.source != cell) R_nom.transposeInPlace();
          sum += R_nom * g.normalized();
        }
        if (sum.norm() > 1e-6) gravityAt(cell, pose) = sum.normalized();
      }
    }
  }
}

bool SkinReadings::interpolated(std::size_t cell) const {
  if (measured_[cell]) return false;
  const auto first = gravity_.begin() + static_cast<std::ptrdiff_t>(cell * table_->poseCount());
  return std::any_of(first, first + static_cast<std::ptrdiff_t>(table_->poseCount()),
                     [](const Eigen::Vector3d& g) { return !g.isZero(); });
}

std::vector<std::size_t> SkinReadings::posesOf(const GraphLink& link) const {
  std::vector<std::size_t> poses;
  poses.reserve(table_->enabledPoses().size());
  for (const std::size_t pose : table_->enabledPoses()) {
    if (inBoth(link, pose)) poses.push_back(pose);
  }
  return poses;
}

EdgeReadings SkinReadings::readingsOf(const GraphLink& link) const {
  const std::vector<std::size_t> poses = posesOf(link);
  EdgeReadings readings;
  const auto count = static_cast<Eigen::Index>(poses.size());
  readings.c_g.resize(3, count);
  readings.n_g.resize(3, count);
  readings.variance_g2.reserve(poses.size());
  for (Eigen::Index k = 0; k < count; ++k) {
    const std::size_t pose = poses[static_cast<std::size_t>(k)];
    readings.c_g.col(k) = gravityOf(link.source, pose);
    readings.n_g.col(k) = gravityOf(link.target, pose);
    readings.variance_g2.push_back(table_->at(link.source, pose).variance_g2 +
                                   table_->at(link.target, pose).variance_g2);
  }
  return readings;
}

}  // namespace hexoderm
