#include "hexoderm/reconstruction/accelerometer/rigidity_kernel.h"

namespace hexoderm {

void testRigidityByOne(const RigidityKernelOptions& options, const RigidityKernelInput& in, RigidityKernelOutput& out) {
  for (int lane = 0; lane < kLanes; ++lane) rigidity_kernel::test<Lane1>(options, in, lane, out);
}

}  // namespace hexoderm
