#pragma once

#include "hexoderm/solve/metrics/cell_links.h"

#include <QString>

namespace hexoderm {

/// cellToolTip() for a caller that knows the cell's links already, as a view that is asked about one cell of a large
/// skin after the other.
QString cellToolTip(const Reconstruction& reconstruction, CellId cell, LinksOfCell links);

}  // namespace hexoderm
