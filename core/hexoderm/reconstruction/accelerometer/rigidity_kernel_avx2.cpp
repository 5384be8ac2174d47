// Compiled with -mavx2 and -mfma where there is such a thing: nothing but the kernel may be in here.

#define HEXODERM_LANES 4
#include "hexoderm/reconstruction/accelerometer/rigidity_kernel_text.h"

namespace hexoderm {

void testRigidityByFour(const RigidityKernelOptions& options, const RigidityKernelInput& in,
                        RigidityKernelOutput& out) {
  for (int lane = 0; lane < kLanes; lane += kWidth) test(options, in, lane, out);
}

}  // namespace hexoderm
