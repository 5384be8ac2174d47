#include "hexoderm/reconstruction/links/edge_batches.h"

#include "hexoderm/geometry/covariance.h"

#include <algorithm>

namespace hexoderm {
namespace {

constexpr std::size_t kMostPorts = 16;  // of a model whose pairs are worth a table

Eigen::Matrix3d symmetricIn(const double* values, int lane) {
  const auto at = [&](int k) { return values[kLanes * k + lane]; };
  Eigen::Matrix3d m;
  m << at(0), at(1), at(2), at(1), at(3), at(4), at(2), at(4), at(5);
  return m;
}

}  // namespace

EdgeBatches::EdgeBatches(const CellModel& model, const SkinGraph& graph, const GravityTable& table,
                         const SkinReadings& readings, const SolverOptions& options, Kernel kernel)
    : model_(model),
      graph_(graph),
      table_(table),
      readings_(readings),
      options_(options),
      kernel_(kernel),
      R_nom_(9 * kLanes),
      outward_(3 * kLanes),
      residual_rad_(kLanes * table.enabledPoses().size()) {
  if (model.ports.size() > kMostPorts) return;
  for (const Port& source : model.ports) {
    const Eigen::Vector3d u = source.vector_m.normalized();
    for (const Port& target : model.ports) {
      PortPair pair;
      const Eigen::Matrix3d R_nom = nominalAlignment(source, target);
      for (int k = 0; k < 9; ++k) pair.R_nom.at(static_cast<std::size_t>(k)) = R_nom(k / 3, k % 3);
      for (int k = 0; k < 3; ++k) pair.outward.at(static_cast<std::size_t>(k)) = u[k];
      pairs_.push_back(pair);
    }
  }
}

std::size_t EdgeBatches::portIndex(PortNumber number) const {
  return static_cast<std::size_t>(model_.findPort(number) - model_.ports.data());
}

std::vector<std::size_t> EdgeBatches::estimate(std::span<const std::size_t> links, std::vector<EdgeRotation>& edges,
                                               std::vector<std::optional<double>>& pose_residuals) {
  if (pairs_.empty() || options_.support_axes == SupportAxes::On) return {links.begin(), links.end()};
  std::vector<std::size_t> unusual;
  const std::vector<std::size_t> others = forBatches(
      graph_, table_, readings_, links, [&](const LinkBatch& batch) { run(batch, edges, pose_residuals, unusual); });
  unusual.insert(unusual.end(), others.begin(), others.end());
  std::ranges::sort(unusual);
  return unusual;
}

void EdgeBatches::run(const LinkBatch& batch, std::vector<EdgeRotation>& edges,
                      std::vector<std::optional<double>>& pose_residuals, std::vector<std::size_t>& unusual) {
  for (int lane = 0; lane < kLanes; ++lane) {
    const GraphLink& link = graph_.links()[batch.linkIn(lane)];
    const PortPair& pair = pairs_[portIndex(link.source_port) * model_.ports.size() + portIndex(link.target_port)];
    for (std::size_t k = 0; k < 9; ++k) R_nom_[kLanes * k + static_cast<std::size_t>(lane)] = pair.R_nom[k];
    for (std::size_t k = 0; k < 3; ++k) outward_[kLanes * k + static_cast<std::size_t>(lane)] = pair.outward[k];
  }
  EdgeKernelOptions options = edgeKernelOptions(model_, options_);
  // Two vectors less their mean are one difference and its opposite: a single direction.
  options.centre = options.centre && batch.poses >= 3;
  out_.pose_residual_rad = residual_rad_.data();
  kernel_(options,
          {batch.poses, batch.c_g.data(), batch.n_g.data(), batch.variance_g2.data(), R_nom_.data(), outward_.data()},
          out_);
  for (int lane = 0; lane < batch.size; ++lane) {
    const std::size_t index = batch.linkIn(lane);
    const GraphLink& link = graph_.links()[index];
    EdgeRotation edge;
    if (out_.usual[lane] != 0) edge = edgeIn(lane, link);
    if (out_.usual[lane] == 0 || needsSupport(edge, options_.support_axes, model_)) {
      unusual.push_back(index);
      continue;
    }
    edges[index] = std::move(edge);
    std::size_t at = static_cast<std::size_t>(lane);
    std::optional<double>* residuals = pose_residuals.data() + index * table_.poseCount();
    std::fill(residuals, residuals + table_.poseCount(), std::nullopt);
    for (const std::size_t pose : table_.enabledPoses()) {
      if (!readings_.inBoth(link, pose)) continue;
      residuals[pose] = residual_rad_[at];
      at += kLanes;
    }
  }
}

EdgeRotation EdgeBatches::edgeIn(int lane, const GraphLink& link) const {
  const auto at = [lane](const double* values, int k) { return values[kLanes * k + lane]; };
  EdgeRotation edge;
  for (int k = 0; k < 9; ++k) edge.R_c_n(k / 3, k % 3) = at(out_.R_c_n, k);
  for (int k = 0; k < 3; ++k) edge.singular_values[k] = at(out_.singular_values, k);
  edge.quality = classifyEdge(edge.singular_values, options_.class_threshold);
  edge.centred = out_.centred[lane] != 0;
  edge.covariance = symmetricIn(out_.covariance, lane);
  edge.prior_part = symmetricIn(out_.prior_part, lane);
  edge.residual_rad = out_.residual_rad[lane];
  edge.expected_residual_rad = out_.expected_residual_rad[lane];
  edge.deviation_rad = largestDeviation(edge.covariance);
  edge.angles = out_.has_angles[lane] != 0
                    ? LinkAngles{at(out_.angles_rad, 0), at(out_.angles_rad, 1), at(out_.angles_rad, 2)}
                    : linkAngles(edge.R_c_n, model_.port(link.source_port), model_.port(link.target_port));
  return edge;
}

}  // namespace hexoderm
