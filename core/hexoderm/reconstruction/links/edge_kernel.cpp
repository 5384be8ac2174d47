#include "hexoderm/reconstruction/links/edge_kernel.h"

namespace hexoderm {

void estimateEdgesByOne(const EdgeKernelOptions& options, const EdgeKernelInput& in, EdgeKernelOutput& out) {
  for (int lane = 0; lane < kLanes; ++lane) edge_kernel::estimate<Lane1>(options, in, lane, out);
}

}  // namespace hexoderm
