// Compiled with -mavx2 and -mfma where there is such a thing: nothing but the kernel may be in here (lanes.h says why).

#include "hexoderm/reconstruction/links/edge_kernel.h"

namespace hexoderm {

void estimateEdgesByFour(const EdgeKernelOptions& options, const EdgeKernelInput& in, EdgeKernelOutput& out) {
#ifdef __AVX2__
  edge_kernel::estimate<Lane4>(options, in, 0, out);
#else
  estimateEdgesByOne(options, in, out);
#endif
}

}  // namespace hexoderm
