#pragma once

#include "hexoderm/solve/tree/skin_links.h"

#include <vector>

namespace hexoderm {

/// Mutes the links that the operator set aside, with a finding for each: what is known to be a cable needs no
/// measurement to be found.
void setLinksAside(SkinLinks& skin, std::vector<Finding>& findings);

/// Drops the readings of the cells in SolverOptions::left_out, with a finding for each. Throws InvalidArgument for a
/// cell that the skin does not have.
void leaveOutCells(SkinLinks& skin, std::vector<Finding>& findings);

}  // namespace hexoderm
