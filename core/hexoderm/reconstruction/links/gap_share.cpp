#include "hexoderm/reconstruction/links/gap_share.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {

GapShare gapShareOf(GapModel model) {
  switch (model) {
    case GapModel::Pivot:
      return {0, std::nullopt};
    case GapModel::Arc:
      return {1, std::nullopt};
    case GapModel::Fit:
      break;
  }
  return {0.5, 0.5};
}

ArcShift arcShift(const Eigen::Vector3d& U_c, const Eigen::Vector3d& U_n, double e_m, bool derivatives) {
  // A link folded back onto itself has no arc; short of that the formula holds.
  constexpr double kFolded = 1e-3;
  const Eigen::Vector3d w = U_c - U_n;
  const double length = std::max(w.norm(), kFolded);
  const Eigen::Vector3d m = w / length;
  const double a = std::atan2((U_c + U_n).norm(), length);
  const double factor = 2.0 / 3.0 * e_m;
  ArcShift shift;
  shift.k = factor * a * a * m;
  if (derivatives) {
    // a^2 as a function of q = U_c . U_n = -cos 2a.
    const double sine = std::sin(2 * a);
    const double slope = sine > 1e-9 ? a / sine : 0.5;
    const Eigen::Matrix3d turn = a * a / length * (Eigen::Matrix3d::Identity() - m * m.transpose());
    shift.dk_dUc = factor * (slope * m * U_n.transpose() + turn);
    shift.dk_dUn = factor * (slope * m * U_c.transpose() - turn);
  }
  return shift;
}

Eigen::Vector3d arcOpening_m(const Eigen::Vector3d& U_c, const Eigen::Vector3d& U_n, double e_m) {
  return arcShift(U_c, U_n, e_m, false).k;
}

}  // namespace hexoderm
