#include "hexoderm/base/se3.h"

#include <Eigen/SVD>
#include <cmath>

namespace hexoderm {

Eigen::Matrix3d skew(const Eigen::Vector3d& w) {
  Eigen::Matrix3d m;
  m << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return m;
}

Eigen::Matrix3d expSO3(const Eigen::Vector3d& w) {
  const double angle_sq = w.squaredNorm();
  const double angle = std::sqrt(angle_sq);
  // Series below 1e-4: the next term is 1e-18.
  const double a = angle < 1e-4 ? 1 - angle_sq / 6 : std::sin(angle) / angle;
  const double half = std::sin(angle / 2);
  const double b = angle < 1e-4 ? 0.5 - angle_sq / 24 : 2 * half * half / angle_sq;
  const Eigen::Matrix3d W = skew(w);
  return Eigen::Matrix3d::Identity() + a * W + b * W * W;
}

Eigen::Vector3d logSO3(const Eigen::Matrix3d& R) {
  // By way of the quaternion: accurate at 0 and at pi alike.
  Eigen::Quaterniond q(R);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2 * q.vec();
  return 2 * std::atan2(sine, q.w()) / sine * q.vec();
}

double rotationAngle(const Eigen::Matrix3d& R) { return logSO3(R).norm(); }

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Eigen::Matrix3d projectToSO3(const Eigen::Matrix3d& M) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d d(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant());
  return svd.matrixU() * d.asDiagonal() * svd.matrixV().transpose();
}

Eigen::Matrix3d shortestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to).normalized().toRotationMatrix();
}

Eigen::Vector3d rpyFromRotation(const Eigen::Matrix3d& R) {
  const double cos_pitch = std::hypot(R(2, 1), R(2, 2));
  const double pitch = std::atan2(-R(2, 0), cos_pitch);
  if (cos_pitch < 1e-12) {
    // Gimbal lock: only yaw -+ roll is defined; put all of it into roll.
    return {std::atan2(R(2, 0) < 0 ? R(0, 1) : -R(0, 1), R(1, 1)), pitch, 0};
  }
  const double roll = std::atan2(R(2, 1), R(2, 2));
  // Yaw from what is left when the roll is taken off, not from the first column: near the lock both are mostly
  // rounding, and only so do their errors cancel.
  const double s = std::sin(roll);
  const double c = std::cos(roll);
  return {roll, pitch, std::atan2(s * R(0, 2) - c * R(0, 1), c * R(1, 1) - s * R(1, 2))};
}

Eigen::Matrix3d rotationFromRpy(const Eigen::Vector3d& rpy_rad) {
  return (Eigen::AngleAxisd(rpy_rad.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(rpy_rad.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy_rad.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

}  // namespace hexoderm
