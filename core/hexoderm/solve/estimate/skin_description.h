#pragma once

#include "hexoderm/solve/result/reconstruction.h"
#include "hexoderm/solve/tree/skin_links.h"

#include <memory>
#include <vector>

namespace hexoderm {

/// A result with these patches (describePatches(), describePlacements()) and all that follows from them, but for
/// findings and assessment.
std::shared_ptr<Reconstruction> describeSkin(const SkinLinks& skin, std::vector<PatchReconstruction> patches);

}  // namespace hexoderm
