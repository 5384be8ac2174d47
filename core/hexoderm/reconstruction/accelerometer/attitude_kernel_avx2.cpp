// Compiled with -mavx2 and -mfma where there is such a thing: nothing but the kernel may be in here (lanes.h says why).

#include "hexoderm/reconstruction/accelerometer/attitude_kernel.h"

namespace hexoderm {

void findAttitudesByFour(const AttitudeKernelOptions& options, const OwnAttitudeKernelInput& in,
                         OwnAttitudeKernelOutput& out) {
#ifdef __AVX2__
  attitude_kernel::find<Lane4>(options, in, 0, out);
#else
  findAttitudesByOne(options, in, out);
#endif
}

}  // namespace hexoderm
