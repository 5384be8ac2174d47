#pragma once

#include "hexoderm/reconstruction/links/skin_links.h"

#include <vector>

namespace hexoderm {

/// Adds to findings about what is not used what its patch loses with it: a link where it is split, once for any two
/// parts, and a cell without readings that alone connects parts of it.
void addConsequences(const SkinLinks& skin, std::vector<Finding>& findings);

}  // namespace hexoderm
