#include "hexoderm/reconstruction/accelerometer/attitude_kernel.h"

namespace hexoderm {

void findAttitudesByOne(const AttitudeKernelOptions& options, const OwnAttitudeKernelInput& in,
                        OwnAttitudeKernelOutput& out) {
  for (int lane = 0; lane < kLanes; ++lane) attitude_kernel::find<Lane1>(options, in, lane, out);
}

}  // namespace hexoderm
