#pragma once

// What is said of the links of patches.

#include "hexoderm/mounting/attachment/links.h"

#include <vector>

namespace hexoderm {

/// Whether the operator chose a link that doesn't fit.
bool contradictsChoice(const PatchLinks& patch);

/// PatchLinks::why and ::what_would_tell, from all the rest of it.
void putIntoWords(PatchLinks& patch, const RobotModel& robot);

/// Of how many patches the link is known; needs one at least.
Message summaryOf(const std::vector<PatchLinks>& patches);

}  // namespace hexoderm
