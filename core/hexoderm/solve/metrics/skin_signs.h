#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <utility>
#include <vector>

namespace hexoderm {

/// About the readings of single cells, which are all that Finding::cells names.
bool isAboutCells(FindingCode code);

/// What the findings hold against a cell, and how it was placed; for signs in pictures.
struct CellSign {
  bool by_links = false;  ///< placed through its links alone: its own readings say nothing
  bool faulty = false;    ///< an error was found in its readings
  bool doubtful = false;  ///< a warning about its readings, and no error

  [[nodiscard]] bool any() const { return by_links || faulty || doubtful; }  ///< the cell has a sign at all
  friend bool operator==(const CellSign&, const CellSign&) = default;
};

/// The signs of all cells.
struct SkinSigns {
  std::vector<CellSign> cells;                     ///< in order of patch and ID, as in CellMetrics
  std::vector<std::pair<LinkEnd, LinkEnd>> links;  ///< that a warning or an error is about, each once
};

/// Where no cell was measured at all, none is signed as placed through its links: it would tell none apart. O(n log n)
/// in cells and findings.
SkinSigns signsOf(const Reconstruction& reconstruction);

/// All links that are used are of one class, and not of none: their classes tell cells apart no longer.
bool isOfOneQuality(const Reconstruction& reconstruction);

}  // namespace hexoderm
