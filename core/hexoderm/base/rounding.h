#pragma once

// Rounding for what is done millions of times a second.

namespace hexoderm {

/// The nearest whole number, of two the even one, never -0; for magnitudes below 2^51. std::round is a call into libm
/// where the processor's baseline has no instruction for it.
inline double nearestWhole(double value) {
  constexpr double kOnesAreLast = 0x1.8p52;
  return (value + kOnesAreLast) - kOnesAreLast;
}

}  // namespace hexoderm
