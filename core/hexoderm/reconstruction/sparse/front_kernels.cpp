#define HEXODERM_LANES 2
#include "hexoderm/reconstruction/sparse/front_kernels_text.h"

#include "hexoderm/util/vector_instructions.h"

namespace hexoderm {

const FrontKernels& portableFrontKernels() { return kKernels; }

const FrontKernels* vectorFrontKernels() {
#ifdef HEXODERM_AVX2
  if (hasVectorInstructions()) return &avx2FrontKernels();
#endif
  return nullptr;
}

const FrontKernels& frontKernels() {
  const FrontKernels* const vector = vectorFrontKernels();
  return vector != nullptr ? *vector : kKernels;
}

}  // namespace hexoderm
