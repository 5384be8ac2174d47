#pragma once

#include <numbers>

namespace hexoderm {

inline constexpr double kPi = std::numbers::pi;      ///< half a turn, rad
inline constexpr double kDegree = kPi / 180.0;       ///< radians in a degree
inline constexpr double kMillimetre = 1e-3;          ///< metres in a millimetre
inline constexpr double kStandardGravity = 9.80665;  ///< m/s^2 in 1 g

constexpr double toDegrees(double angle_rad) { return angle_rad / kDegree; }        ///< an angle in degrees
constexpr double toMillimetres(double length_m) { return length_m / kMillimetre; }  ///< a length in millimetres

}  // namespace hexoderm
