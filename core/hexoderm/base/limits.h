#pragma once

#include <Eigen/Core>

/// Finite numbers that no skin has. They are refused where they come in, or left out where a device sends them, so that
/// squares, sums and quotients stay finite wherever they are used.
namespace hexoderm {

inline constexpr double kMaxAcceleration_g = 1e6;  ///< of a reading, and of its mean
inline constexpr double kMaxVariance_g2 = 1e13;    ///< of readings within kMaxAcceleration_g, with room for rounding
inline constexpr double kMaxLength_m = 1e6;        ///< of a place, and of a distance

inline constexpr double kMaxAngle_rad = 1e6;  ///< of a rotation that is given, which may go round many times

/// Every element is a number, and at most `most` in magnitude.
template <class Derived>
bool isWithin(const Eigen::MatrixBase<Derived>& values, double most) {
  return (values.array().abs() <= most).all();  // NaN is not
}

}  // namespace hexoderm
