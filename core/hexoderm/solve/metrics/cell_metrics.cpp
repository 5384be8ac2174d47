#include "hexoderm/solve/metrics/cell_metrics.h"

#include "hexoderm/solve/metrics/cell_links.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

namespace hexoderm {
namespace {

void raiseSize(std::optional<double>& largest, double value) {
  if (!largest || std::abs(value) > std::abs(*largest)) largest = value;
}

void addLinks(LinksOfCell links, std::size_t cell, CellMetrics& figures) {
  const WorstLinkMetrics worst = worstOf(links);
  figures.quality[cell] = worst.quality;
  figures.residual_rad[cell] = worst.residual_rad;
  figures.sigma_rad[cell] = worst.sigma_rad;
  for (const LinkEstimate* link : links) {
    if (!link->used) continue;
    raiseSize(figures.bend_rad[cell], link->bend_rad);
    raiseSize(figures.twist_rad[cell], link->twist_rad);
    raiseSize(figures.yaw_rad[cell], std::abs(link->yaw_rad));
  }
}

/// The way to a cell is the way to the cell before it and one step more: back to a cell whose way is known, and from
/// there outwards.
void addPathLengths(const PatchReconstruction& patch, std::size_t first,
                    const std::unordered_map<CellId, std::size_t>& index, CellMetrics& figures) {
  const auto has_predecessor = [](const CellPlacement& cell) { return cell.predecessor.has_value(); };
  const auto origin = index.find(patch.origin);
  if (origin == index.end() || (patch.cells.size() > 1 && std::ranges::none_of(patch.cells, has_predecessor))) return;
  figures.path_length_m[origin->second] = 0;
  std::vector<std::size_t> ahead;
  for (std::size_t k = 0; k < patch.cells.size(); ++k) {
    ahead.clear();
    std::size_t at = first + k;
    while (!figures.path_length_m[at] && ahead.size() < patch.cells.size()) {
      const auto& predecessor = patch.cells[at - first].predecessor;
      const auto before = predecessor ? index.find(*predecessor) : index.end();
      if (before == index.end()) break;
      ahead.push_back(at);
      at = before->second;
    }
    if (!figures.path_length_m[at]) continue;
    for (; !ahead.empty(); ahead.pop_back()) {
      const Eigen::Vector3d step = patch.cells[ahead.back() - first].T_o_u.t - patch.cells[at - first].T_o_u.t;
      figures.path_length_m[ahead.back()] = *figures.path_length_m[at] + step.norm();
      at = ahead.back();
    }
  }
}

}  // namespace

CellMetrics makeCellMetrics(const Reconstruction& reconstruction) {
  const std::size_t count = reconstruction.cellCount();
  CellMetrics figures;
  figures.cells.reserve(count);
  figures.patch.reserve(count);
  figures.quality.resize(count);
  figures.body_part.resize(count);
  for (auto* each : {&figures.residual_rad, &figures.sigma_rad, &figures.bend_rad, &figures.twist_rad, &figures.yaw_rad,
                     &figures.position_95_m, &figures.orientation_95_rad, &figures.shape_position_95_m,
                     &figures.shape_orientation_95_rad, &figures.path_length_m}) {
    each->resize(count);
  }
  const CellLinks links(reconstruction);
  std::set<std::string> parts;
  for (std::size_t p = 0; p < reconstruction.patches.size(); ++p) {
    const PatchReconstruction& patch = reconstruction.patches[p];
    const std::size_t first = figures.cells.size();
    std::unordered_map<CellId, std::size_t> index;
    index.reserve(patch.cells.size());
    for (const CellPlacement& cell : patch.cells) {
      const std::size_t k = figures.cells.size();
      index.emplace(cell.cell, k);
      figures.cells.push_back(cell.cell);
      figures.patch.push_back(p);
      if (const std::optional<Uncertainty95> known = uncertaintyOf(cell)) {
        figures.position_95_m[k] = known->position_m;
        figures.orientation_95_rad[k] = known->orientation_rad;
      }
      if (const std::optional<Uncertainty95> known = shapeUncertaintyOf(cell)) {
        figures.shape_position_95_m[k] = known->position_m;
        figures.shape_orientation_95_rad[k] = known->orientation_rad;
      }
      if (!cell.body_part.empty()) parts.insert(cell.body_part);
      addLinks(links.of(k), k, figures);
    }
    addPathLengths(patch, first, index, figures);
  }
  figures.body_parts.assign(parts.begin(), parts.end());
  std::size_t k = 0;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      if (!cell.body_part.empty()) {
        const auto found = std::ranges::lower_bound(figures.body_parts, cell.body_part);
        figures.body_part[k] = static_cast<std::size_t>(found - figures.body_parts.begin());
      }
      ++k;
    }
  }
  return figures;
}

}  // namespace hexoderm
