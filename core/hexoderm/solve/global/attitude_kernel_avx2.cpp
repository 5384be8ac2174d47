// Compiled with -mavx2 and -mfma where there is such a thing: nothing but the kernel may be in here.

#define HEXODERM_LANES 4
#include "hexoderm/solve/global/attitude_kernel.inl"

namespace hexoderm {

void findAttitudesByFour(const AttitudeKernelOptions& options, const OwnAttitudeKernelInput& in,
                         OwnAttitudeKernelOutput& out) {
  for (int lane = 0; lane < kLanes; lane += kWidth) find(options, in, lane, out);
}

}  // namespace hexoderm
