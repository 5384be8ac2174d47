#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

namespace hexoderm {

/// The first of the most severe findings: what to look at before anything else. Null if none is a warning or an error.
const Finding* worstFinding(const Reconstruction& reconstruction);

/// The verdict on a finished reconstruction: how good in mm and degrees (95 %, worst cell), and what to do next. Needs
/// everything else of the reconstruction to be in place.
Verdict judge(const Reconstruction& reconstruction);

}  // namespace hexoderm
