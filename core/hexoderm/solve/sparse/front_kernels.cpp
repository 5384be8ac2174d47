#define HEXODERM_LANES 2
#include "hexoderm/solve/sparse/front_kernels.inl"

#include "hexoderm/base/vector_instructions.h"

namespace hexoderm {

const FrontKernels& portableFrontKernels() { return kKernels; }

const FrontKernels& frontKernels() { return hasVectorInstructions() ? avx2FrontKernels() : kKernels; }

}  // namespace hexoderm
