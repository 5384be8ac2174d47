// What the texts of kernels share: HEXODERM_LANES numbers side by side, in a vector of the compiler's. A kernel is a
// text that two sources include: one is compiled for any machine, with two lanes, and one with -mavx2 and -mfma, with
// four. Nothing in a text may have a name that others see, nor use a function of a library that a linker could take for
// the other machines, too.
//
//     // root_kernel.inl
//     #include "hexoderm/base/lanes.inl"
//     HEXODERM_INLINE void roots(double* numbers) { store(numbers, rootOf(load(numbers))); }  // of kWidth numbers
//
//     // root_kernel_avx2.cpp; root_kernel.cpp does the same with 2 lanes
//     #define HEXODERM_LANES 4
//     #include "root_kernel.inl"
//     void rootsByFour(double* numbers) { roots(numbers); }

#ifndef HEXODERM_LANES
#error "Define HEXODERM_LANES as 2 or 4 before the text of a kernel is included."
#endif

#include <cstddef>

// Short loops over what stays in registers.
#if defined(__clang__)
#define HEXODERM_UNROLL _Pragma("unroll")
#else
#define HEXODERM_UNROLL _Pragma("GCC unroll 6")
#endif
#define HEXODERM_INLINE [[gnu::always_inline]] inline

namespace hexoderm {
namespace {

constexpr int kWidth = HEXODERM_LANES;
using Lanes = double __attribute__((vector_size(8 * HEXODERM_LANES)));
/// A comparison's result, of which a conditional takes the one or the other lane by lane.
using Mask = decltype(Lanes{} > Lanes{});

HEXODERM_INLINE Lanes load(const double* at) {
  Lanes values;
  __builtin_memcpy(&values, at, sizeof values);
  return values;
}
HEXODERM_INLINE void store(double* at, Lanes values) { __builtin_memcpy(at, &values, sizeof values); }
HEXODERM_INLINE Lanes all(double value) { return value - Lanes{}; }
HEXODERM_INLINE Lanes rootOf(Lanes values) {
  for (int k = 0; k < kWidth; ++k) values[k] = __builtin_sqrt(values[k]);
  return values;
}
HEXODERM_INLINE Lanes absolute(Lanes values) {
  for (int k = 0; k < kWidth; ++k) values[k] = __builtin_fabs(values[k]);
  return values;
}
/// `size` with the signs of `values`.
HEXODERM_INLINE Lanes withSignOf(Lanes size, Lanes values) {
  for (int k = 0; k < kWidth; ++k) size[k] = __builtin_copysign(size[k], values[k]);
  return size;
}
/// How long the part of a unit vector in the plane of x and y is; exactly 1 where z is 0.
HEXODERM_INLINE Lanes levelPart(Lanes x, Lanes y, Lanes z) { return z == Lanes{} ? all(1) : rootOf(x * x + y * y); }
HEXODERM_INLINE bool any(Mask mask) {
  bool found = false;
  for (int k = 0; k < kWidth; ++k) found = found || mask[k] != 0;
  return found;
}

}  // namespace
}  // namespace hexoderm
