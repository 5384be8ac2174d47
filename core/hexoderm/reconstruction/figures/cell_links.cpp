#include "hexoderm/reconstruction/figures/cell_links.h"

#include <algorithm>
#include <unordered_map>

namespace hexoderm {
namespace {

void sortByPort(std::span<const LinkEstimate*> links, CellId cell) {
  std::ranges::stable_sort(links, {}, [cell](const LinkEstimate* link) { return portOf(*link, cell); });
}

void raiseFigure(std::optional<double>& worst, const std::optional<double>& value) {
  if (value) worst = std::max(worst.value_or(*value), *value);
}

}  // namespace

CellLinks::CellLinks(const Reconstruction& reconstruction) {
  std::vector<CellId> cells;
  std::unordered_map<CellId, std::size_t> index;
  cells.reserve(reconstruction.cellCount());
  index.reserve(reconstruction.cellCount());
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      index.emplace(cell.cell, cells.size());
      cells.push_back(cell.cell);
    }
  }
  // A cell that is named but not there has no entry; a link from a cell to itself counts once.
  const auto forEachEnd = [&](const auto& visit) {
    for (const PatchReconstruction& patch : reconstruction.patches) {
      for (const LinkEstimate& link : patch.links) {
        if (const auto source = index.find(link.source.cell); source != index.end()) visit(source->second, link);
        if (link.target.cell == link.source.cell) continue;
        if (const auto target = index.find(link.target.cell); target != index.end()) visit(target->second, link);
      }
    }
  };
  first_.assign(cells.size() + 1, 0);
  forEachEnd([&](std::size_t cell, const LinkEstimate&) { ++first_[cell + 1]; });
  for (std::size_t k = 0; k < cells.size(); ++k) first_[k + 1] += first_[k];
  links_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  forEachEnd([&](std::size_t cell, const LinkEstimate& link) { links_[next[cell]++] = &link; });
  for (std::size_t k = 0; k < cells.size(); ++k) {
    sortByPort(std::span(links_).subspan(first_[k], first_[k + 1] - first_[k]), cells[k]);
  }
}

LinksOfCell CellLinks::of(std::size_t index) const {
  if (index + 1 >= first_.size()) return {};
  return LinksOfCell(links_).subspan(first_[index], first_[index + 1] - first_[index]);
}

std::vector<const LinkEstimate*> linksOf(const Reconstruction& reconstruction, CellId cell) {
  std::vector<const LinkEstimate*> links;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      if (link.source.cell == cell || link.target.cell == cell) links.push_back(&link);
    }
  }
  sortByPort(links, cell);
  return links;
}

CellId neighborAcross(const LinkEstimate& link, CellId cell) {
  return link.source.cell == cell ? link.target.cell : link.source.cell;
}

PortNumber portOf(const LinkEstimate& link, CellId cell) {
  return link.source.cell == cell ? link.source.port : link.target.port;
}

WorstLinkFigures worstOf(LinksOfCell links) {
  WorstLinkFigures worst;
  for (const LinkEstimate* link : links) {
    if (!link->used) continue;
    worst.quality = std::min(worst.quality.value_or(link->quality), link->quality);
    raiseFigure(worst.residual_rad, link->knownResidual());
    raiseFigure(worst.sigma_rad, link->knownSigma());
  }
  return worst;
}

}  // namespace hexoderm
