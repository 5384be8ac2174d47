#pragma once

#include "hexoderm/mounting/parts/gravity_seen.h"
#include "hexoderm/mounting/parts/parts.h"

namespace hexoderm {

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
