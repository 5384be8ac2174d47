#include "hexoderm/geometry/lanes.h"

namespace hexoderm {

bool hasFourLanes() {
#ifdef __x86_64__
  static const bool kHas = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  return kHas;
#else
  return false;
#endif
}

}  // namespace hexoderm
