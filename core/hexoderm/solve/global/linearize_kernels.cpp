#define HEXODERM_LANES 2
#include "hexoderm/solve/global/linearize_kernels.inl"

#include "hexoderm/base/vector_instructions.h"

namespace hexoderm {

const LinearizeKernels& portableLinearizeKernels() { return kKernels; }

const LinearizeKernels& linearizeKernels() { return hasVectorInstructions() ? avx2LinearizeKernels() : kKernels; }

}  // namespace hexoderm
