#define HEXODERM_LANES 2
#include "hexoderm/solve/tree/edge_kernel.inl"

namespace hexoderm {

void estimateEdgesByTwo(const EdgeKernelOptions& options, const EdgeKernelInput& in, EdgeKernelOutput& out) {
  for (int lane = 0; lane < kLanes; lane += kWidth) estimate(options, in, lane, out);
}

}  // namespace hexoderm
