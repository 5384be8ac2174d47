// Compiled with -mavx2 and -mfma where there is such a thing: nothing but the kernel may be in here.

#define HEXODERM_LANES 4
#include "hexoderm/solve/tree/edge_kernel.inl"

namespace hexoderm {

void estimateEdgesByFour(const EdgeKernelOptions& options, const EdgeKernelInput& in, EdgeKernelOutput& out) {
  for (int lane = 0; lane < kLanes; lane += kWidth) estimate(options, in, lane, out);
}

}  // namespace hexoderm
