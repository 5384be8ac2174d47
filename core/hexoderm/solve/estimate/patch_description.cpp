#include "hexoderm/solve/estimate/patch_description.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

/// Where a cell is, and nothing of how sure that is.
CellPlacement placeCell(const SkinLinks& skin, const PatchSolver& patch, std::size_t cell) {
  const GraphCell& graph_cell = skin.graph().cells()[cell];
  CellPlacement placement;
  placement.cell = graph_cell.id;
  placement.body_part = graph_cell.body_part;
  placement.placed_by = skin.readings().measured(cell) ? PlacedBy::Samples : PlacedBy::Links;
  placement.T_o_u = patch.placementOf(cell);
  if (const std::size_t before = patch.paths().predecessor[graph_cell.place]; before != kNoIndex) {
    placement.predecessor = skin.graph().cells()[before].id;
  }
  placement.sensors.reserve(skin.model().sensors.size());
  for (const CellSensor& sensor : skin.model().sensors) {
    placement.sensors.push_back({sensor.name, sensor.type, placement.T_o_u * sensor.T_u_s});
  }
  return placement;
}

CellPlacement describeCell(const SkinLinks& skin, const PatchSolver& patch, std::size_t cell) {
  CellPlacement placement = placeCell(skin, patch, cell);
  if (const GlobalRefinement* joint = patch.joint()) {
    placement.cov_t_r = joint->covarianceOf(cell);
    if (skin.readings().measured(cell)) {
      placement.accel_offset_g = joint->lot().offset_g + joint->sensorOf(cell).offset_g;
      placement.accel_scale = joint->lot().gain(joint->sensorOf(cell).gain).diagonal();
    }
  } else {
    placement.cov_t_r = patch.treePlacements()[skin.graph().cells()[cell].place].covariance;
  }
  return placement;
}

/// Gravity in each pose as the joint estimate has it.
std::vector<GravityDirection> jointGravity(const SkinLinks& skin, const GlobalRefinement& joint) {
  const GlobalSolution& solution = joint.solution();
  std::vector<GravityDirection> directions;
  for (std::size_t k = 0; k < joint.poses().size(); ++k) {
    const Eigen::Vector3d& force = solution.state.force_o[k];
    const Eigen::Vector3d up = force.normalized();
    // Across the direction: [up]x takes what lies along it away.
    const Eigen::Matrix3d across = skew(up) * solution.covariance->forces(k, k) * skew(up).transpose();
    const Eigen::Vector3d swing = solution.state.acceleration_o[k] / kStandardGravity;
    directions.push_back({skin.poseId(joint.poses()[k]), up, rotationSigma(across) / force.norm(),
                          GravityDirection::Force{force - swing.cross(solution.state.middle_o), swing}});
  }
  return directions;
}

/// Gravity in each pose as the mean of what the cells, as they are placed, read.
std::vector<GravityDirection> meanGravity(const SkinLinks& skin, const PatchSolver& patch) {
  std::vector<GravityDirection> directions;
  for (const std::size_t pose : skin.table().enabledPoses()) {
    std::vector<Eigen::Vector3d> seen;
    seen.reserve(patch.cells().size());
    for (const std::size_t cell : patch.cells()) {
      const GravityTable::Entry& entry = skin.table().at(cell, pose);
      if (entry.usable) seen.push_back(patch.placementOf(cell).R * entry.mean_g.normalized());
    }
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& g : seen) sum += g;
    if (sum.norm() < 1e-6) continue;
    GravityDirection direction{skin.poseId(pose), sum.normalized(), 0};
    double scatter = 0;
    for (const Eigen::Vector3d& g : seen) scatter += std::pow(angleBetween(g, direction.g_o), 2);
    direction.sigma_rad = std::sqrt(scatter) / static_cast<double>(seen.size());
    directions.push_back(direction);
  }
  return directions;
}

/// A link's rotation and predicted deviation follow from the placements; its residuals are of readings freed from the
/// estimated errors of their sensors.
void estimateJointly(const SkinLinks& skin, const GlobalRefinement& joint, std::size_t index, LinkEstimate& estimate) {
  const GraphLink& link = skin.graph().links()[index];
  estimate.R_c_n = joint.placementOf(link.source).R.transpose() * joint.placementOf(link.target).R;
  estimate.sigma_rad = rotationSigma(joint.linkCovariance(index));
  estimate.centred = false;
  estimate.supported = false;
  if (!skin.readings().measured(link)) return;
  double sum = 0;
  double weights = 0;
  for (const std::size_t pose : skin.readings().posesOf(link)) {
    const GravityTable::Entry& at_source = skin.table().at(link.source, pose);
    const GravityTable::Entry& at_target = skin.table().at(link.target, pose);
    const Eigen::Vector3d c = joint.correctedReading(link.source, at_source.mean_g);
    const Eigen::Vector3d n = joint.correctedReading(link.target, at_target.mean_g);
    const double angle = angleBetween(c, estimate.R_c_n * n);
    estimate.pose_residual_rad[pose] = angle;
    // A short window says less than a long one.
    const double weight = 1 / (at_source.variance_g2 + at_target.variance_g2);
    sum += weight * angle * angle;
    weights += weight;
  }
  if (weights > 0) estimate.residual_rad = std::sqrt(sum / weights);
}

void setAngles(const LinkAngles& angles, LinkEstimate& estimate) {
  estimate.bend_rad = angles.bend_rad;
  estimate.twist_rad = angles.twist_rad;
  estimate.yaw_rad = angles.yaw_rad;
}

bool isInTree(const SkinGraph& graph, const ShortestPaths& paths, std::size_t index) {
  const GraphLink& link = graph.links()[index];
  return paths.link[graph.cells()[link.source].place] == index || paths.link[graph.cells()[link.target].place] == index;
}

/// A link as the readings of its two cells show it.
LinkEstimate describeEdge(const SkinLinks& skin, const PatchSolver& patch, std::size_t index, double weight) {
  const GraphLink& link = skin.graph().links()[index];
  const EdgeRotation& edge = skin.edges()[index];
  LinkEstimate estimate;
  estimate.source = skin.graph().sourceEnd(link);
  estimate.target = skin.graph().targetEnd(link);
  estimate.R_c_n = edge.R_c_n;
  estimate.quality = edge.quality;
  estimate.singular_values = edge.singular_values;
  estimate.weight = weight;
  estimate.residual_rad = edge.residual_rad;
  estimate.sigma_rad = std::min(kPi, edge.deviation_rad);
  estimate.centred = edge.centred;
  estimate.supported = edge.supported;
  estimate.used = !link.muted();
  estimate.in_tree = !link.muted() && isInTree(skin.graph(), patch.paths(), index);
  estimate.muted_by = link.muted_by;
  estimate.pose_residual_rad = skin.poseResiduals(index);
  setAngles(edge.angles, estimate);
  return estimate;
}

LinkEstimate describeLink(const SkinLinks& skin, const PatchSolver& patch, std::size_t index, double weight) {
  LinkEstimate estimate = describeEdge(skin, patch, index, weight);
  const GraphLink& link = skin.graph().links()[index];
  if (patch.joint() != nullptr && !link.muted()) {
    estimateJointly(skin, *patch.joint(), index, estimate);
    setAngles(linkAngles(estimate.R_c_n, skin.sourcePort(link), skin.targetPort(link)), estimate);
  }
  return estimate;
}

PatchReconstruction beginPatch(const SkinLinks& skin, const PatchSolver& patch) {
  PatchReconstruction result;
  result.id = PatchId(static_cast<std::uint32_t>(patch.patch()));
  result.origin = skin.graph().cells()[patch.origin()].id;
  result.cells.reserve(patch.cells().size());
  return result;
}

/// All but the links.
PatchReconstruction placePatch(const SkinLinks& skin, const PatchSolver& patch) {
  PatchReconstruction result = beginPatch(skin, patch);
  for (const std::size_t cell : patch.cells()) result.cells.push_back(placeCell(skin, patch, cell));
  result.gravity = meanGravity(skin, patch);
  return result;
}

/// All but the links.
PatchReconstruction describePatch(const SkinLinks& skin, const PatchSolver& patch) {
  PatchReconstruction result = beginPatch(skin, patch);
  for (const std::size_t cell : patch.cells()) result.cells.push_back(describeCell(skin, patch, cell));
  if (const GlobalRefinement* joint = patch.joint()) {
    const GlobalSolution& solution = joint->solution();
    const std::vector<Matrix6d>& shape = joint->shapeCovariances();
    for (std::size_t k = 0; k < shape.size(); ++k) result.cells[k].shape_cov_t_r = shape[k];
    result.gravity = jointGravity(skin, *joint);
    result.gap_share = GapShareEstimate{solution.state.gap_share, solution.covariance->gapShareSigma()};
    if (joint->problem().estimatesLot()) {
      const SensorLot& lot = joint->lot();
      const Eigen::Vector4d sigmas = solution.covariance->lotSigmas();
      result.lot = LotEstimate{lot.offset_g, sigmas.head<3>(), lot.scale, sigmas[3] / lot.scale};
    }
    result.covariance = joint->placementCovariance(skin.graph());
    result.gravity_covariance = joint->gravityCovariance();
  } else {
    result.gravity = meanGravity(skin, patch);
  }
  return result;
}

using DescribePatch = PatchReconstruction (*)(const SkinLinks&, const PatchSolver&);
using DescribeLink = LinkEstimate (*)(const SkinLinks&, const PatchSolver&, std::size_t index, double weight);

std::vector<PatchReconstruction> describe(const SkinLinks& skin, std::span<const PatchSolver> patches,
                                          std::span<const double> weights, DescribePatch patch_of,
                                          DescribeLink link_of) {
  std::vector<PatchReconstruction> result;
  result.reserve(patches.size());
  for (const PatchSolver& patch : patches) result.push_back(patch_of(skin, patch));
  std::vector<std::size_t> links(patches.size(), 0);
  for (const GraphLink& link : skin.graph().links()) ++links[skin.graph().cells()[link.source].patch.value()];
  for (std::size_t patch = 0; patch < links.size(); ++patch) result[patch].links.reserve(links[patch]);
  for (std::size_t k = 0; k < skin.edges().size(); ++k) {
    const std::uint32_t patch = skin.graph().cells()[skin.graph().links()[k].source].patch.value();
    result[patch].links.push_back(link_of(skin, patches[patch], k, weights[k]));
  }
  return result;
}

}  // namespace

std::vector<PatchReconstruction> describePatches(const SkinLinks& skin, std::span<const PatchSolver> patches,
                                                 std::span<const double> weights) {
  return describe(skin, patches, weights, describePatch, describeLink);
}

std::vector<PatchReconstruction> describePlacements(const SkinLinks& skin, std::span<const PatchSolver> patches,
                                                    std::span<const double> weights) {
  return describe(skin, patches, weights, placePatch, describeEdge);
}

}  // namespace hexoderm
