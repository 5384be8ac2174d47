#include "hexoderm/solve/tree/gap_share.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {

GapShare gapShareOf(GapModel model) {
  if (model == GapModel::Fit) return {0.5, 0.5};
  return {model == GapModel::Arc ? 1.0 : 0.0, std::nullopt};
}

Eigen::Vector3d arcOpening_m(const Eigen::Vector3d& U_c, const Eigen::Vector3d& U_n, double e_m) {
  // A link folded back onto itself has no arc; short of that the formula holds.
  constexpr double kFolded = 1e-3;
  const Eigen::Vector3d w = U_c - U_n;
  const double length = std::max(w.norm(), kFolded);
  const double a = std::atan2((U_c + U_n).norm(), length);
  return 2.0 / 3.0 * e_m * a * a * (w / length);
}

}  // namespace hexoderm
