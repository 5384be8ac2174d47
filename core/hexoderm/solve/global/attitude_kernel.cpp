#define HEXODERM_LANES 2
#include "hexoderm/solve/global/attitude_kernel.inl"

namespace hexoderm {

void findAttitudesByTwo(const AttitudeKernelOptions& options, const OwnAttitudeKernelInput& in,
                        OwnAttitudeKernelOutput& out) {
  for (int lane = 0; lane < kLanes; lane += kWidth) find(options, in, lane, out);
}

}  // namespace hexoderm
