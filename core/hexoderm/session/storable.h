#pragma once

#include "hexoderm/device/pose_capture.h"

namespace hexoderm {

/// What is wrong with a reading that no file can hold, and no reader takes: numbers that are not finite or beyond all
/// limits, and a covariance that is none. Empty: nothing.
Message problemOf(const GravitySample& sample);
/// Throws InvalidArgument naming the cell if there is a problem.
void requireStorable(const GravitySample& sample);

}  // namespace hexoderm
