#define HEXODERM_LANES 2
#include "hexoderm/reconstruction/accelerometer/rigidity_kernel_text.h"

namespace hexoderm {

void testRigidityByTwo(const RigidityKernelOptions& options, const RigidityKernelInput& in, RigidityKernelOutput& out) {
  for (int lane = 0; lane < kLanes; lane += kWidth) test(options, in, lane, out);
}

}  // namespace hexoderm
