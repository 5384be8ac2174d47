#pragma once

#include "hexoderm/mounting/parts/gravity_seen.h"
#include "hexoderm/mounting/parts/parts.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace hexoderm {

/// Information about every turn that stands for "within a radian", so that what poses leave open stays finite.
inline constexpr double kOpenTurnInformation = 1;
/// A turn that is known to less is none that a fit has used up.
inline constexpr double kOpenVariance_rad2 = 0.25;

/// How well a model of several bodies explains the gravity that they saw.
struct GravityMisfit {
  double chi_squared = 0;
  int freedom = 0;
  /// Probability of a misfit at least as large by chance; 1 where nothing is left over to test.
  [[nodiscard]] double probability() const;
};

/// Several bodies that are one: g_p = R_k g_k,p for one rotation R_k per body in all poses p. R_k maps body k into the
/// first one's frame.
struct RigidFit {
  std::vector<Eigen::Matrix3d> R;  ///< per body; the first is the identity
  /// 3m x 3m, rad^2, of the errors R_true = R exp(e) (e in the body's own frame); the first body's is zero. A turn that
  /// the poses leave open has a sigma of about 1 rad.
  Eigen::MatrixXd covariance;
  GravityMisfit misfit;
  /// Logarithm of how probable what the bodies saw is, all directions and turns being as probable beforehand; of use
  /// for comparing covariances of the same bodies.
  double log_evidence = 0;
  GravitySeen gravity;  ///< in the first body's frame, in every pose in which any body saw it
};

/// Maximum likelihood (weighted orthogonal Procrustes with the full covariances of all bodies), the true directions
/// being unknowns too: minimises sum_k e_k^T C_k^-1 e_k. Bodies may lack poses. Starts from Procrustes on unit weights.
/// Needs at least one body. Degenerate: a body without a pose in common with the others has a rotation that means
/// nothing, and a covariance that says so; the same about the line where all directions lie on one.
RigidFit fitRigid(std::span<const GravitySeen> bodies);

/// What gravity says about whether two bodies turn against each other (the rule is in the room's README).
struct MovementTest {
  RigidFit fit;  ///< of the poses that both have
  /// Logarithm of how much more probable what was seen is for one rigid body than for two with a joint between them
  /// that turned by kTypicalTurn_rad, rms, from pose to pose, about any axis.
  double log_odds = 0;
  /// Gravity came along one line in all poses, or in fewer than two: a turn about it doesn't show.
  bool on_one_line = true;
  /// Turns from pose to pose, rms, that would have shown at three sigma about any axis; pi at most.
  double noticeable_rad = 0;
};

/// Joints of robots that are posed for a calibration turn by tens of degrees.
inline constexpr double kTypicalTurn_rad = 0.5;

MovementTest testMovement(const GravitySeen& a, const GravitySeen& b);

/// An axis that is known to less than this is not called known.
inline constexpr double kKnownAxis_rad = 0.17;
/// The fewest poses in which an axis can be told and be wrong.
inline constexpr std::size_t kPosesForHinge = 5;

/// The revolute joint between two bodies that turn against each other. First the axis that satisfies u_a . g_a,p = u_b
/// . g_b,p best, from starts all around, each difference weighed by what is uncertain about it; then all at once by
/// maximum likelihood: axis, angles and the true directions. Covariances by the inverse information. `least_probable`:
/// misfits less probable than this contradict the axis.
Hinge fitHinge(const GravitySeen& a, const GravitySeen& b, double least_probable);

}  // namespace hexoderm
