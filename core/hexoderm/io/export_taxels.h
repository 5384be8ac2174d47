#pragma once

#include "hexoderm/io/export_selection.h"

#include <string>
#include <vector>

namespace hexoderm {

/// A cell as a taxel: the centre of its front face and its outward normal in the link's frame, metres.
struct Taxel {
  CellId cell;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  std::size_t link = 0;  ///< index into the links of the file
};
struct TaxelMap {
  std::vector<std::string> links;  ///< in order of their first patch
  std::vector<Taxel> taxels;
  double radius_m = 0;  ///< of the circle in a cell
};
TaxelMap taxelMap(const CellModel& model, const std::vector<ExportMount>& mounted, const ExportOptions& options);

/// iCub taxel positions: a row "x y z nx ny nz" for each cell in order of ID, then rows of zeros, which stand for no
/// taxel, up to whole triangles of 12, at least one, and an empty line: a reader that drops the last row, or the last
/// line, loses no cell. Each cell is its own representative in taxel2Repr, -1 a row without. The file's `name` is that
/// of the link.
std::string icubText(const TaxelMap& map);

/// Skinware map: the number of cells, then a line of ten integers each: type (0), uid (the cell), position (nm), normal
/// (a unit vector times 10^9), radius (nm), link (0 for the first of `map`).
std::string skinwareText(const TaxelMap& map);

}  // namespace hexoderm
