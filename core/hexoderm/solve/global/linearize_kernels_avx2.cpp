// Compiled for AVX2 and FMA: nothing but the kernels may be in here.

#define HEXODERM_LANES 4
#include "hexoderm/solve/global/linearize_kernels.inl"

namespace hexoderm {

const LinearizeKernels& avx2LinearizeKernels() { return kKernels; }

}  // namespace hexoderm
