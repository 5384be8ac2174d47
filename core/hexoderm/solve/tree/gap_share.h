#pragma once

// How a bent mould keeps the ends of its links together: the gap share in README.md one folder up.

#include "hexoderm/solve/result/solver_options.h"

#include <Eigen/Core>
#include <optional>

namespace hexoderm {

/// Position between `pivot` (0) and `arc` (1) of the mould's behaviour when it is bent (gap share, in
/// core/hexoderm/solve/README.md): fixed, or to be estimated from a prior.
struct GapShare {
  double mean = 0.5;
  std::optional<double> sigma;  ///< absent: fixed
};

GapShare gapShareOf(GapModel model);

/// The arc's share in a link's opening, k = (2/3) e a^2 m, for outward directions U_c and U_n of its ends in one frame
/// (unit); e: mean length of the extended port vectors, metres; a: half the angle between U_c and -U_n; m = unit(U_c -
/// U_n).
Eigen::Vector3d arcOpening_m(const Eigen::Vector3d& U_c, const Eigen::Vector3d& U_n, double e_m);

}  // namespace hexoderm
