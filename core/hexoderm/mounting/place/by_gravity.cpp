#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/mounting/place/place.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

namespace hexoderm {

std::optional<KnownRotation> rotationByGravity(const PatchLinks& patch, std::string_view link) {
  if (patch.placed && patch.placed->link == link) return KnownRotation{patch.placed->R_l_o, patch.placed->covariance};
  std::vector<const LinkCandidate*> candidates;
  for (const LinkCandidate& candidate : patch.candidates) candidates.push_back(&candidate);
  if (patch.nearest) candidates.push_back(&*patch.nearest);
  for (const LinkCandidate* candidate : candidates) {
    const auto turn = std::ranges::find(candidate->links, link, &PatchTurn::link);
    if (turn != candidate->links.end()) return KnownRotation{turn->R_l_o, turn->covariance};
  }
  return std::nullopt;
}

std::optional<AgainstGravity> againstGravity(const KnownRotation& known, const Eigen::Matrix3d& R_l_o,
                                             double slack_rad) {
  constexpr double kKnown_rad = 15 * kDegree;
  // 99.9 % of chi-squared, by its degrees of freedom.
  constexpr double kQuantile[] = {0, 10.828, 13.816, 16.266};
  const Eigen::Vector3d error = logSO3(known.R_l_o.transpose() * R_l_o);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(known.covariance);
  AgainstGravity against;
  double chi_squared = 0;
  double sum = 0;
  int axis_count = 0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double variance = std::max(0.0, axes.eigenvalues()[k]);
    if (variance > kKnown_rad * kKnown_rad) continue;
    const double off = axes.eigenvectors().col(k).dot(error);
    chi_squared += off * off / (variance + slack_rad * slack_rad);
    sum += off * off;
    against.sigma_rad = std::max(against.sigma_rad, std::sqrt(variance));
    ++axis_count;
  }
  if (chi_squared <= kQuantile[axis_count]) return std::nullopt;
  against.angle_rad = std::sqrt(sum);
  return against;
}

}  // namespace hexoderm
