#pragma once

#include "hexoderm/mounting/parts/rigid_fit.h"

namespace hexoderm {

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

}  // namespace hexoderm
