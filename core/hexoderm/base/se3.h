#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace hexoderm {

// Fixed-size matrices that Eigen would align for vector instructions are held without alignment: how strict it is
// depends on the compiler's flags, and a program's need not be those of this library.
/// A pair of numbers that is laid out alike whatever a program is compiled for.
using Vector2d = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;
using Matrix6d = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;  ///< a covariance of six numbers, likewise

/// A rigid transform. `T_a_b` maps coordinates in frame b to frame a: x_a = R_a_b x_b + t_a_b, so that chains read
/// T_o_n = T_o_c * T_c_n (eq. (4) of the paper). Translation in metres.
struct SE3 {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();

  /// The transform that takes this one back.
  [[nodiscard]] SE3 inverse() const { return {R.transpose(), -(R.transpose() * t)}; }
  friend SE3 operator*(const SE3& a, const SE3& b) { return {a.R * b.R, a.R * b.t + a.t}; }  ///< first b, then a
  /// The point x, transformed.
  friend Eigen::Vector3d operator*(const SE3& T, const Eigen::Vector3d& x) { return T.R * x + T.t; }
};

/// [w]x, with [w]x v = w cross v.
Eigen::Matrix3d skew(const Eigen::Vector3d& w);

/// Rotation by |w| radians about w (Rodrigues); exact to rounding also for tiny |w|.
Eigen::Matrix3d expSO3(const Eigen::Vector3d& w);

/// The rotation vector w, |w| <= pi, with expSO3(w) = R. At exactly pi the sign of the axis is arbitrary.
Eigen::Vector3d logSO3(const Eigen::Matrix3d& R);

/// Angle of the rotation in [0, pi], by atan2 (acos loses half the digits near 0).
double rotationAngle(const Eigen::Matrix3d& R);

/// Angle between two non-zero vectors in [0, pi], by atan2.
double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// The rotation closest to M in the Frobenius norm. M must not be rank deficient by more than one.
Eigen::Matrix3d projectToSO3(const Eigen::Matrix3d& M);

/// Some rotation that turns the unit vector `from` onto the unit vector `to` along the shortest way; for opposite
/// vectors about an arbitrary perpendicular axis.
Eigen::Matrix3d shortestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Roll, pitch and yaw with R = Rz(yaw) Ry(pitch) Rx(roll), as URDF's rpy. At pitch = +-90 degrees yaw is set to 0.
Eigen::Vector3d rpyFromRotation(const Eigen::Matrix3d& R);
/// The rotation of roll, pitch and yaw as in a URDF: about the fixed x axis, then y, then z.
Eigen::Matrix3d rotationFromRpy(const Eigen::Vector3d& rpy_rad);

}  // namespace hexoderm
