#pragma once

#include "hexoderm/reconstruction/links/skin_links.h"

#include <vector>

namespace hexoderm {

/// Adds to findings about what is not used what its patch loses with it: a link without which it falls apart, and a
/// cell without readings that alone joins parts of it.
void addConsequences(const SkinLinks& skin, std::vector<Finding>& findings);

}  // namespace hexoderm
