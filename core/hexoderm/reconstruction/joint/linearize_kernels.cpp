#define HEXODERM_LANES 2
#include "hexoderm/reconstruction/joint/linearize_kernels_text.h"

#include "hexoderm/util/vector_instructions.h"

namespace hexoderm {

const LinearizeKernels& portableLinearizeKernels() { return kKernels; }

const LinearizeKernels* vectorLinearizeKernels() {
#ifdef HEXODERM_AVX2
  if (hasVectorInstructions()) return &avx2LinearizeKernels();
#endif
  return nullptr;
}

const LinearizeKernels& linearizeKernels() {
  const LinearizeKernels* const vector = vectorLinearizeKernels();
  return vector != nullptr ? *vector : kKernels;
}

}  // namespace hexoderm
