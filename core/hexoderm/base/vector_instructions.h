#pragma once

namespace hexoderm {

/// Whether this machine has AVX2 and FMA, for which some kernels are compiled a second time.
inline bool hasVectorInstructions() {
#if defined(__x86_64__)
  static const bool has_them = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  return has_them;
#else
  return false;
#endif
}

}  // namespace hexoderm
