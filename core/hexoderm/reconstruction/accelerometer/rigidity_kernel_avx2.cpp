// Compiled with -mavx2 and -mfma where there is such a thing: nothing but the kernel may be in here (lanes.h says why).

#include "hexoderm/reconstruction/accelerometer/rigidity_kernel.h"

namespace hexoderm {

void testRigidityByFour(const RigidityKernelOptions& options, const RigidityKernelInput& in,
                        RigidityKernelOutput& out) {
#ifdef __AVX2__
  rigidity_kernel::test<Lane4>(options, in, 0, out);
#else
  testRigidityByOne(options, in, out);
#endif
}

}  // namespace hexoderm
