#include "hexoderm/mounting/place/by_hand.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/mesh_feet.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/mounting/attachment/links.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace hexoderm {

struct PatchByHand::State {
  State(const TriangleMesh& surface, const PatchToPlace& of, double back)
      : box(boundingBox(surface)), feet(surface), patch(of), back_m(back) {
    patch.covariance.clear();  // large, and of no use here
  }

  BoundingBox box;
  MeshFeet feet;
  PatchToPlace patch;
  double back_m;
  std::size_t middle = 0;  ///< the cell nearest to the middle

  [[nodiscard]] Eigen::Vector3d back(std::size_t cell) const {
    return patch.T_o_u[cell] * Eigen::Vector3d(0, 0, -back_m);
  }
  [[nodiscard]] Eigen::Vector3d normalAt(const SE3& T_l_o) const { return feet.footOf(T_l_o * back(middle)).normal; }
  [[nodiscard]] SE3 laidByMiddle(const SE3& T_l_o) const;
  [[nodiscard]] bool settle(SE3& T_l_o) const;
};

/// The middle cell flat on the surface.
SE3 PatchByHand::State::laidByMiddle(const SE3& T_l_o) const {
  const MeshFoot foot = feet.footOf(T_l_o * back(middle));
  SE3 laid;
  laid.R = projectToSO3(shortestRotation((T_l_o.R * patch.T_o_u[middle].R.col(2)).normalized(), foot.normal) * T_l_o.R);
  laid.t = foot.position - laid.R * back(middle);
  return laid;
}

/// One step to where all cells together lie best: the mean of their tilts and of their heights. The middle goes nowhere
/// along the surface, and nothing turns about its normal. False: no cell is near the surface.
bool PatchByHand::State::settle(SE3& T_l_o) const {
  constexpr double kOtherSide_rad = 60 * kDegree;
  Eigen::Vector3d tilt = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double above_m = 0;
  double count = 0;
  for (std::size_t k = 0; k < patch.T_o_u.size(); ++k) {
    const Eigen::Vector3d x = T_l_o * back(k);
    const Eigen::Vector3d z = T_l_o.R * patch.T_o_u[k].R.col(2);
    const MeshFoot foot = feet.footOf(x);
    // Beyond an edge, or where the link ends.
    if (angleBetween(z, foot.normal) > kOtherSide_rad) continue;
    tilt += z.cross(foot.normal);
    normal += foot.normal;
    above_m += (x - foot.position).dot(foot.normal);
    count += 1;
  }
  if (count == 0 || !(normal.norm() > 1e-9)) return false;
  normal.normalize();
  tilt = tilt / count - tilt.dot(normal) / count * normal;
  const Eigen::Vector3d pivot = T_l_o * back(middle);
  T_l_o.R = projectToSO3(expSO3(tilt) * T_l_o.R);
  T_l_o.t = pivot - above_m / count * normal - T_l_o.R * back(middle);
  return true;
}

PatchByHand::PatchByHand(TriangleMesh surface, const PatchToPlace& patch, double back_m) {
  if (patch.T_o_u.empty()) throw InvalidArgument(message("there is no patch to place"));
  if (isInsideOut(surface)) turnInsideOut(surface);
  auto state = std::make_shared<State>(surface, patch, back_m);
  if (state->feet.empty()) throw InvalidArgument(message("the body has no surface on which a patch could lie"));
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const SE3& T_o_u : patch.T_o_u) mean += T_o_u.t / static_cast<double>(patch.T_o_u.size());
  for (std::size_t k = 1; k < patch.T_o_u.size(); ++k) {
    if ((patch.T_o_u[k].t - mean).norm() < (patch.T_o_u[state->middle].t - mean).norm()) state->middle = k;
  }
  state_ = std::move(state);
}

SE3 PatchByHand::laid(const SE3& T_l_o) const {
  constexpr int kSteps = 6;
  SE3 laid = state_->laidByMiddle(T_l_o);
  for (int k = 0; k < kSteps && state_->settle(laid); ++k) continue;
  return laid;
}

SE3 PatchByHand::somewhere() const {
  const Eigen::Vector3d z_o = state_->patch.T_o_u[state_->middle].R.col(2);
  const Eigen::Vector3d size = state_->box.size();
  SE3 beside;
  if (state_->patch.rotation) {
    beside.R = state_->patch.rotation->R_l_o;
  } else {
    // On a side, not on an end.
    Eigen::Index thinnest = 0;
    size.minCoeff(&thinnest);
    beside.R = shortestRotation(z_o, Eigen::Vector3d::Unit(thinnest));
  }
  const Eigen::Vector3d center = (state_->box.low + state_->box.high) / 2;
  beside.t = center + size.norm() * (beside.R * z_o) - beside.R * state_->back(state_->middle);
  return laid(beside);
}

SE3 PatchByHand::pulled(const SE3& T_l_o, const Eigen::Vector3d& grip_o, const Eigen::Vector3d& x_l) const {
  constexpr int kSteps = 8;
  constexpr double kNear_m = 0.0002;
  const auto& cells = state_->patch.T_o_u;
  const auto gripped = std::ranges::min_element(cells, {}, [&](const SE3& T_o_u) { return (T_o_u.t - grip_o).norm(); });
  const Eigen::Vector3d normal = state_->feet.footOf(x_l).normal;
  // The gripped cell goes there and lies flat.
  SE3 pulled;
  pulled.R = projectToSO3(shortestRotation((T_l_o.R * gripped->R.col(2)).normalized(), normal) * T_l_o.R);
  pulled.t = x_l - pulled.R * grip_o;
  pulled = laid(pulled);
  // Then its middle goes over the surface by what the grip still misses, which is seen from there as it is turned.
  for (int k = 0; k < kSteps; ++k) {
    Eigen::Vector3d miss = x_l - pulled * grip_o;
    miss -= miss.dot(normal) * normal;
    if (miss.norm() < kNear_m) break;
    pulled.t += shortestRotation(normal, state_->normalAt(pulled)) * miss;
    pulled = laid(pulled);
  }
  return pulled;
}

SE3 PatchByHand::slid(const SE3& T_l_o, const Eigen::Vector3d& way_l) const {
  constexpr double kSteep = 0.1;  // of the way that is left along the surface
  const Eigen::Vector3d normal = state_->normalAt(T_l_o);
  const Eigen::Vector3d along = way_l - way_l.dot(normal) * normal;
  if (!(along.norm() > kSteep * way_l.norm())) return laid(T_l_o);
  return laid({T_l_o.R, T_l_o.t + way_l.norm() * along.normalized()});
}

SE3 PatchByHand::turned(const SE3& T_l_o, double angle_rad) const {
  const Eigen::Vector3d pivot = T_l_o * state_->back(state_->middle);
  SE3 turned;
  turned.R = projectToSO3(expSO3(angle_rad * state_->normalAt(T_l_o)) * T_l_o.R);
  turned.t = pivot - turned.R * state_->back(state_->middle);
  return laid(turned);
}

std::optional<Message> PatchByHand::objection(const SE3& T_l_o) const {
  if (!state_->patch.rotation) return std::nullopt;
  const auto against = againstGravity(*state_->patch.rotation, T_l_o.R, kTurnByHand_rad);
  if (!against) return std::nullopt;
  return message("Here the patch is turned by {} against what gravity says, which is certain to {} (1 sigma).",
                 Degrees{against->angle_rad, 0}, Degrees{against->sigma_rad});
}

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
