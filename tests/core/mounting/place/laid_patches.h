#pragma once

// Simulated patches that lie on a mesh, with errors that are drawn from a stated covariance.

#include "hexoderm/base/mesh_feet.h"
#include "hexoderm/base/units.h"
#include "hexoderm/mounting/place/place.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/sim/simulated_skin.h"
#include "tests/support/paths.h"
#include "tests/support/testing.h"

namespace hexoderm {

struct PlaceErrors {
  double position_m = 0;  ///< of each cell in the patch, an axis
  double attitude_rad = 0;
  double rotation_rad = 0;  ///< of how the patch is known to be turned
};

/// What is stated where errors are zero: a covariance has to be there.
inline constexpr PlaceErrors kStated{0.0005, 0.5 * kDegree, 1 * kDegree};

struct LaidPatch {
  PatchToPlace patch;
  std::vector<SE3> T_l_u;  ///< true
  SE3 T_l_o;               ///< true
};

inline TriangleMesh demoBody(const std::string& link) {
  const RobotModel robot = RobotModel::read(HEXODERM_DEMO_ROBOT);
  return robot.bodyOf(robot.linkNamed(link));
}

inline Eigen::Vector3d drawVector(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random);
  const double y = normal(random);
  return {x, y, normal(random)};
}

/// An x17 laid on a mesh, its middle near T_l_near, cells numbered from `first` on.
inline LaidPatch layPatch(const TriangleMesh& mesh, const SE3& T_l_near, std::uint64_t seed = 1,
                          const PlaceErrors& errors = {}, std::uint32_t first = 1) {
  const CellModel model = builtInCellModel("hex-bma150");
  SimulatedSkinOptions options = SimulatedSkinOptions::ideal();
  options.seed = seed;
  options.laid_on = std::make_shared<MeshSurface>(mesh, T_l_near, model.thickness_m);
  const SimulatedSkin skin(model, options);

  std::mt19937_64 random(seed);
  LaidPatch laid;
  laid.patch.origin = CellId(first);
  const auto count = static_cast<Eigen::Index>(skin.truth().size());
  Eigen::VectorXd variances(6 * count);
  const PlaceErrors stated = errors.position_m > 0 ? errors : kStated;
  std::vector<SE3> estimated;  // in the link's frame as a frame of the patch as a whole
  for (const TrueCell& cell : skin.truth()) {
    laid.T_l_u.push_back(cell.T_b_u);
    const Eigen::Vector3d e = errors.attitude_rad * drawVector(random);
    estimated.push_back({cell.T_b_u.R * expSO3(e).transpose(), cell.T_b_u.t - errors.position_m * drawVector(random)});
    const auto at = static_cast<Eigen::Index>(6 * laid.patch.cells.size());
    variances.segment<3>(at).setConstant(stated.position_m * stated.position_m);
    variances.segment<3>(at + 3).setConstant(stated.attitude_rad * stated.attitude_rad);
    laid.patch.cells.emplace_back(first + static_cast<std::uint32_t>(laid.patch.cells.size()));
  }
  laid.T_l_o = laid.T_l_u.front();
  for (const SE3& T_l_u : estimated) laid.patch.T_o_u.push_back(estimated.front().inverse() * T_l_u);
  const Eigen::MatrixXd C = variances.asDiagonal();
  laid.patch.covariance.assign(C.data(), C.data() + C.size());
  const Eigen::Matrix3d R = laid.T_l_o.R * expSO3(errors.rotation_rad * drawVector(random)).transpose();
  laid.patch.rotation = KnownRotation{R, stated.rotation_rad * stated.rotation_rad * Eigen::Matrix3d::Identity()};
  return laid;
}

/// A long cylinder about the link's z, and an x17 that lies on it.
struct OnCylinder {
  double radius_m = 0.05;
  TriangleMesh mesh = meshOfCylinder(radius_m, 0.4);
  LaidPatch laid = layPatch(mesh, {rotationFromRpy({0, 0, kPi / 2}), {0.06, 0, 0.02}});
};

inline PlaceTask surfaceTask(const TriangleMesh& mesh, const LaidPatch& laid) {
  PlaceTask task;
  task.link = "link";
  task.patches = {laid.patch};
  task.surface = mesh;
  task.thickness_m = builtInCellModel("hex-bma150").thickness_m;
  return task;
}

/// Rms distance of the cells from where they are.
inline double cellError(const SE3& T_l_o, const LaidPatch& laid) {
  double sum = 0;
  for (std::size_t k = 0; k < laid.T_l_u.size(); ++k) {
    sum += (T_l_o * laid.patch.T_o_u[k].t - laid.T_l_u[k].t).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(laid.T_l_u.size()));
}

}  // namespace hexoderm
