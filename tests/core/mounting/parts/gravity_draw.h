#pragma once

// Gravity as rigid bodies see it, drawn with errors that are known exactly: an offset and a turn that are the same in
// all poses, and noise.

#include "hexoderm/mounting/parts/gravity_seen.h"
#include "tests/support/normal_draw.h"
#include "tests/support/testing.h"

namespace hexoderm {

struct GravityErrors {
  double offset_rad = 0.01;
  double turn_rad = 0.03;
  double noise_rad = 0.003;
};

class GravityDraw : public test::NormalDraw {
 public:
  using NormalDraw::NormalDraw;
  std::vector<Eigen::Vector3d> directions(std::size_t poses) {
    std::vector<Eigen::Vector3d> result;
    for (std::size_t k = 0; k < poses; ++k) result.push_back(direction());
    return result;
  }

  /// What a body sees of these true directions in its frame, in the poses 1, 2, ... Errors are drawn times `scale`.
  GravitySeen see(const std::vector<Eigen::Vector3d>& up, const GravityErrors& errors, double scale = 1) {
    const Eigen::Vector3d offset = errors.offset_rad * vector();
    const Eigen::Vector3d turn = errors.turn_rad * vector();
    GravitySeen seen;
    for (std::size_t k = 0; k < up.size(); ++k) {
      seen.poses.emplace_back(static_cast<std::uint32_t>(k + 1));
      const Eigen::Vector3d error = offset + turn.cross(up[k]) + errors.noise_rad * vector();
      seen.up.push_back((up[k] + scale * error).normalized());
    }
    const auto at = [](std::size_t pose) { return static_cast<Eigen::Index>(2 * pose); };
    seen.covariance.resize(at(up.size()), at(up.size()));
    for (std::size_t a = 0; a < up.size(); ++a) {
      for (std::size_t b = 0; b < up.size(); ++b) {
        Eigen::Matrix3d C = std::pow(errors.offset_rad, 2) * Eigen::Matrix3d::Identity() +
                            std::pow(errors.turn_rad, 2) * skew(seen.up[a]) * skew(seen.up[b]).transpose();
        if (a == b) C += std::pow(errors.noise_rad, 2) * Eigen::Matrix3d::Identity();
        seen.covariance.block<2, 2>(at(a), at(b)) = acrossBasis(seen.up[a]).transpose() * C * acrossBasis(seen.up[b]);
      }
    }
    return seen;
  }
};

/// Directions as a body sees them that is turned by R against the frame in which they are given: x = R x_body.
inline std::vector<Eigen::Vector3d> seenFrom(const Eigen::Matrix3d& R, const std::vector<Eigen::Vector3d>& up) {
  return collect(up, [&R](const Eigen::Vector3d& g) { return Eigen::Vector3d(R.transpose() * g); });
}

/// What a body sees, with the same covariances, in a frame that is turned: x_turned = Q x.
inline GravitySeen turnedBy(const Eigen::Matrix3d& Q, const GravitySeen& seen) {
  GravitySeen turned = seen;
  const auto rows = static_cast<Eigen::Index>(2 * seen.size());
  Eigen::MatrixXd across = Eigen::MatrixXd::Zero(rows, rows);  // from the one frame's components to the other's
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(2 * k);
    turned.up[k] = Q * seen.up[k];
    across.block<2, 2>(at, at) = acrossBasis(turned.up[k]).transpose() * Q * acrossBasis(seen.up[k]);
  }
  turned.covariance = across * seen.covariance * across.transpose();
  return turned;
}

/// Two bodies on a hinge: R_p = exp(u angle_p) R_0 maps b into a.
struct DrawnHinge {
  Eigen::Vector3d u_a;
  Eigen::Vector3d u_b;
  std::vector<double> angle;
  std::vector<Eigen::Vector3d> up_a;
  std::vector<Eigen::Vector3d> up_b;
};
inline DrawnHinge drawHinge(GravityDraw& draw, std::size_t poses, double spread_rad) {
  DrawnHinge hinge;
  hinge.u_a = draw.direction();
  const Eigen::Matrix3d R_0 = draw.rotation();
  hinge.u_b = R_0.transpose() * hinge.u_a;
  hinge.up_a = draw.directions(poses);
  for (std::size_t k = 0; k < poses; ++k) {
    hinge.angle.push_back(spread_rad * draw.normal());
    hinge.up_b.emplace_back((expSO3(hinge.angle.back() * hinge.u_a) * R_0).transpose() * hinge.up_a[k]);
  }
  return hinge;
}

/// The square of the error of a unit vector in its covariance, by its two degrees of freedom. Its sign does not count.
inline double neesOfAxis(const Eigen::Vector3d& u, const Eigen::Matrix3d& covariance, const Eigen::Vector3d& truth) {
  const Eigen::Matrix<double, 3, 2> across = acrossBasis(u);
  const Eigen::Vector2d e = across.transpose() * truth;
  const Eigen::Matrix2d C = across.transpose() * covariance * across;
  return e.dot(C.llt().solve(e)) / 2;
}

inline double meanOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

}  // namespace hexoderm
