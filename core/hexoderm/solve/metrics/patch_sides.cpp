#include "hexoderm/solve/metrics/patch_sides.h"

#include <Eigen/Eigenvalues>

namespace hexoderm {
namespace {

/// The weight of where cells are beside where they face: it decides only where the faces leave two directions open.
constexpr double kPlaces = 0.02;
/// Faces that look to all sides have no mean direction.
constexpr double kNoDirection = 0.05;

Eigen::Vector3d turningAxis(const PatchReconstruction& patch, const Eigen::Vector3d& middle) {
  Eigen::Matrix3d facing = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const CellPlacement& cell : patch.cells) {
    const Eigen::Vector3d normal = cell.T_o_u.R.col(2);
    const Eigen::Vector3d place = cell.T_o_u.t - middle;
    facing += normal * normal.transpose();
    spread += place * place.transpose();
  }
  facing /= static_cast<double>(patch.cells.size());
  if (spread.trace() > 0) facing -= kPlaces * spread / spread.trace();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(facing);
  const Eigen::Vector3d axis = solver.eigenvectors().col(0).normalized();
  // Upwards as far as the patch's frame says what that is.
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  constexpr double kAcross = 0.3;
  const double sign = std::abs(axis.y()) > kAcross ? axis.y() : axis(largest);
  return sign < 0 ? Eigen::Vector3d(-axis) : axis;
}

}  // namespace

PatchSides patchSides(const PatchReconstruction& patch) {
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  Eigen::Vector3d front = Eigen::Vector3d::UnitZ();
  if (!patch.cells.empty()) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const CellPlacement& cell : patch.cells) {
      middle += cell.T_o_u.t / static_cast<double>(patch.cells.size());
      normal += cell.T_o_u.R.col(2) / static_cast<double>(patch.cells.size());
    }
    up = turningAxis(patch, middle);
    front = normal - up * up.dot(normal);
    if (front.norm() < kNoDirection) front = Eigen::Vector3d::UnitZ() - up * up.z();
    if (front.norm() < kNoDirection) front = up.unitOrthogonal();
    front.normalize();
  }
  const Eigen::Vector3d right = up.cross(front);
  PatchSides sides;
  const std::array<Eigen::Vector3d, 4> towards = {front, right, -front, -right};
  for (std::size_t k = 0; k < towards.size(); ++k) {
    sides.R_v_o.at(k) << up.cross(towards.at(k)).transpose(), up.transpose(), towards.at(k).transpose();
  }
  return sides;
}

}  // namespace hexoderm
