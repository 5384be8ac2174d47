#pragma once

#include "hexoderm/reconstruction/reconstruction.h"

namespace hexoderm {

/// The verdict on a finished reconstruction: how good in mm and degrees (95 %, worst cell), and what to do next. Needs
/// everything else of the reconstruction to be in place.
Verdict judge(const Reconstruction& reconstruction);

}  // namespace hexoderm
