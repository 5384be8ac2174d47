#pragma once

// Private to core: numbers side by side, for kernels that do the same for several things at a time. A kernel is a
// template over one of these types; its source is compiled once for every computer, with Lane1, and once with -mavx2
// and -mfma, with Lane4. What the second source compiles must not be found by the linker under a name that others use
// too: a kernel's header includes nothing but this one, and calls nothing of the standard library, nor of Eigen.

#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace hexoderm {

/// Kernels lay their numbers out for four things side by side, however many they do at a time.
inline constexpr int kLanes = 4;

/// Whether the computer has the instructions that the sources for Lane4 are compiled for.
bool hasFourLanes();

#define HEXODERM_LANES_INLINE [[gnu::always_inline]] inline

/// One number.
struct Lane1 {
  using Mask = bool;
  static constexpr int kWidth = 1;
  double value;

  Lane1() = default;
  HEXODERM_LANES_INLINE Lane1(double v) : value(v) {}  // NOLINT(*-explicit-*): kernels mix lanes and constants
  HEXODERM_LANES_INLINE static Lane1 load(const double* from) { return {*from}; }
  HEXODERM_LANES_INLINE void store(double* to) const { *to = value; }
  HEXODERM_LANES_INLINE friend Lane1 operator+(Lane1 a, Lane1 b) { return a.value + b.value; }
  HEXODERM_LANES_INLINE friend Lane1 operator-(Lane1 a, Lane1 b) { return a.value - b.value; }
  HEXODERM_LANES_INLINE friend Lane1 operator*(Lane1 a, Lane1 b) { return a.value * b.value; }
  HEXODERM_LANES_INLINE friend Lane1 operator/(Lane1 a, Lane1 b) { return a.value / b.value; }
  HEXODERM_LANES_INLINE friend bool operator>(Lane1 a, Lane1 b) { return a.value > b.value; }
  HEXODERM_LANES_INLINE friend Lane1 root(Lane1 a) { return __builtin_sqrt(a.value); }
  HEXODERM_LANES_INLINE friend Lane1 absolute(Lane1 a) { return __builtin_fabs(a.value); }
  /// `size` with the sign of `a`.
  HEXODERM_LANES_INLINE friend Lane1 withSignOf(Lane1 size, Lane1 a) { return __builtin_copysign(size.value, a.value); }
  HEXODERM_LANES_INLINE static Lane1 select(bool mask, Lane1 yes, Lane1 no) { return mask ? yes : no; }
  HEXODERM_LANES_INLINE static bool any(bool mask) { return mask; }
  HEXODERM_LANES_INLINE static bool both(bool a, bool b) { return a && b; }
};

#ifdef __AVX2__
/// Four numbers.
struct Lane4 {
  using Mask = __m256d;
  static constexpr int kWidth = 4;
  __m256d value;

  Lane4() = default;
  HEXODERM_LANES_INLINE Lane4(__m256d v) : value(v) {}                 // NOLINT(*-explicit-*)
  HEXODERM_LANES_INLINE Lane4(double v) : value(_mm256_set1_pd(v)) {}  // NOLINT(*-explicit-*)
  HEXODERM_LANES_INLINE static Lane4 load(const double* from) { return {_mm256_loadu_pd(from)}; }
  HEXODERM_LANES_INLINE void store(double* to) const { _mm256_storeu_pd(to, value); }
  HEXODERM_LANES_INLINE friend Lane4 operator+(Lane4 a, Lane4 b) { return _mm256_add_pd(a.value, b.value); }
  HEXODERM_LANES_INLINE friend Lane4 operator-(Lane4 a, Lane4 b) { return _mm256_sub_pd(a.value, b.value); }
  HEXODERM_LANES_INLINE friend Lane4 operator*(Lane4 a, Lane4 b) { return _mm256_mul_pd(a.value, b.value); }
  HEXODERM_LANES_INLINE friend Lane4 operator/(Lane4 a, Lane4 b) { return _mm256_div_pd(a.value, b.value); }
  HEXODERM_LANES_INLINE friend __m256d operator>(Lane4 a, Lane4 b) {
    return _mm256_cmp_pd(a.value, b.value, _CMP_GT_OQ);
  }
  HEXODERM_LANES_INLINE friend Lane4 root(Lane4 a) { return _mm256_sqrt_pd(a.value); }
  HEXODERM_LANES_INLINE friend Lane4 absolute(Lane4 a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.value); }
  HEXODERM_LANES_INLINE friend Lane4 withSignOf(Lane4 size, Lane4 a) {
    return _mm256_or_pd(size.value, _mm256_and_pd(_mm256_set1_pd(-0.0), a.value));
  }
  HEXODERM_LANES_INLINE static Lane4 select(__m256d mask, Lane4 yes, Lane4 no) {
    return _mm256_blendv_pd(no.value, yes.value, mask);
  }
  HEXODERM_LANES_INLINE static bool any(__m256d mask) { return _mm256_movemask_pd(mask) != 0; }
  HEXODERM_LANES_INLINE static __m256d both(__m256d a, __m256d b) { return _mm256_and_pd(a, b); }
};
#endif

}  // namespace hexoderm
