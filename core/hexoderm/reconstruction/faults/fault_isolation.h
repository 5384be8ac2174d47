#pragma once

#include "hexoderm/reconstruction/links/skin_links.h"
#include "hexoderm/reconstruction/result/completion.h"

#include <stop_token>
#include <vector>

namespace hexoderm {

// The steps that keep what is broken, or unwanted, out of a reconstruction before anything is placed. Each adds one
// finding for everything that it takes out of the skin.

/// Mutes the links that the operator set aside. It comes first: what is known to be a cable needs no measurement to be
/// found.
void setLinksAside(SkinLinks& skin, std::vector<Finding>& findings);

/// Drops the readings of the cells in SolverOptions::left_out. Throws InvalidArgument for a cell that is not there.
void leaveOutCells(SkinLinks& skin, std::vector<Finding>& findings);

/// Drops the worst pose or cell and looks at the skin again, until only links are left to blame, which it mutes. A cell
/// that two poses don't clearly show to be wrong is called suspicious and stays, and so do its links. Needs
/// estimated edges, and leaves them estimated without what it dropped.
[[nodiscard]] Completion isolateSuspects(SkinLinks& skin, const std::stop_token& stop, std::vector<Finding>& findings);

}  // namespace hexoderm
