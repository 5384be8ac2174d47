#pragma once

#include "hexoderm/solve/tree/skin_links.h"

#include <vector>

namespace hexoderm {

/// Makes findings about what is not used say what the patch loses with it: that it is split where a link is muted, once
/// for any two parts, and that a cell without readings alone connects parts of it.
void addConsequences(const SkinLinks& skin, std::vector<Finding>& findings);

}  // namespace hexoderm
