#pragma once

// The poses in which patches are compared, and how much of a usual hand there was.

#include "hexoderm/mounting/parts/gravity_seen.h"

#include <functional>
#include <vector>

namespace hexoderm {

/// The poses in which any of the patches saw gravity, ascending.
std::vector<PoseId> posesOf(const std::vector<const PatchReconstruction*>& patches);

/// As many of `all` as are allowed, each the one that differs most from those taken before, by what the patch sees that
/// tells them apart best; ascending.
std::vector<PoseId> differentPoses(const std::vector<const PatchReconstruction*>& patches,
                                   const std::vector<PoseId>& all, std::size_t most);

/// gravityOf() in those of these poses (ascending) that the patch saw.
GravitySeen gravityIn(const PatchReconstruction& patch, const std::vector<PoseId>& poses, double lever_m,
                      double tremor_share = 1);

/// A usual hand that holds a part swings it and trembles. How much of that there really was shows where several patches
/// saw the same gravity. Of shares of the usual variance, from 1 to 1/64 and each as probable beforehand, the mean by
/// what was seen. `log_evidence`: logarithm of how probable that is with a share, but for a constant.
double meanHandShare(const std::function<double(double hand_share)>& log_evidence);

}  // namespace hexoderm
