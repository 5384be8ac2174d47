#define HEXODERM_LANES 2
#include "hexoderm/reconstruction/accelerometer/attitude_kernel_text.h"

namespace hexoderm {

void findAttitudesByTwo(const AttitudeKernelOptions& options, const OwnAttitudeKernelInput& in,
                        OwnAttitudeKernelOutput& out) {
  for (int lane = 0; lane < kLanes; lane += kWidth) find(options, in, lane, out);
}

}  // namespace hexoderm
