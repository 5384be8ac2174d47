#pragma once

#include "hexoderm/capture/pose_capture.h"

namespace hexoderm {

/// Throws InvalidArgument naming the cell for what no file can hold, and no reader takes: numbers that are not finite
/// or beyond all limits, and a covariance that is none.
void requireStorable(const GravitySample& sample);

}  // namespace hexoderm
