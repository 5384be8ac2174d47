// Compiled for AVX2 and FMA: nothing but the kernels may be in here.

#define HEXODERM_LANES 4
#include "hexoderm/solve/sparse/front_kernels.inl"

namespace hexoderm {

const FrontKernels& avx2FrontKernels() { return kKernels; }

}  // namespace hexoderm
