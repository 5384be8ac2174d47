#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

// The links of a cell, to its neighbours: used ones, muted ones, and those into other patches.

using LinksOfCell = std::span<const LinkEstimate* const>;  ///< all links that a cell has

/// The links of every cell of a reconstruction, which must outlive this. Made in O(n) for cells and links, so that a
/// view that is asked about one cell after the other need not look through all links each time.
class CellLinks {
 public:
  CellLinks() = default;
  explicit CellLinks(const Reconstruction& reconstruction);  ///< the reconstruction must outlive it

  /// In ascending order of the cell's own ports. `index`: of the cell in order of patch and ID, as in CellMetrics.
  [[nodiscard]] LinksOfCell of(std::size_t index) const;

 private:
  std::vector<const LinkEstimate*> links_;
  std::vector<std::size_t> first_;  ///< one for each cell, and the end
};

/// The links of one cell, likewise, in O(links). Pointers into the reconstruction.
std::vector<const LinkEstimate*> linksOf(const Reconstruction& reconstruction, CellId cell);

/// The cell at the other end.
CellId neighborAcross(const LinkEstimate& link, CellId cell);
/// The cell's own port.
PortNumber portOf(const LinkEstimate& link, CellId cell);

/// The worst of the used links of a cell: smallest class, largest residual, largest predicted deviation, as CellMetrics
/// has them. Absent where no used link has the figure.
struct WorstLinkMetrics {
  std::optional<EdgeQuality> quality;
  std::optional<double> residual_rad;
  std::optional<double> sigma_rad;
};
WorstLinkMetrics worstOf(LinksOfCell links);  ///< the figures of the worst link of a cell

}  // namespace hexoderm
