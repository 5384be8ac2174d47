#include "hexoderm/reconstruction/links/edge_batches.h"

#include "hexoderm/geometry/covariance.h"
#include "hexoderm/geometry/lane_numbers.h"

#include <algorithm>

namespace hexoderm {
namespace {

constexpr std::size_t kMostPorts = 16;  // of a model whose pairs are worth a table

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
    for (const Port& target : model.ports) {
      pairs_.push_back({nominalAlignment(source, target), source.vector_m.normalized()});
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
    matrixOfLane(R_nom_.data(), static_cast<std::size_t>(lane)) = pair.R_nom;
    vectorOfLane(outward_.data(), static_cast<std::size_t>(lane)) = pair.outward;
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
  const auto at = static_cast<std::size_t>(lane);
  EdgeRotation edge;
  edge.R_c_n = matrixOfLane(out_.R_c_n, at);
  edge.singular_values = vectorOfLane(out_.singular_values, at);
  edge.quality = classifyEdge(edge.singular_values, options_.class_threshold);
  edge.centred = out_.centred[lane] != 0;
  edge.covariance = symmetricOfLane(out_.covariance, at);
  edge.prior_part = symmetricOfLane(out_.prior_part, at);
  edge.residual_rad = out_.residual_rad[lane];
  edge.expected_residual_rad = out_.expected_residual_rad[lane];
  edge.deviation_rad = largestDeviation(edge.covariance);
  const Eigen::Vector3d angles = vectorOfLane(out_.angles_rad, at);
  edge.angles = out_.has_angles[lane] != 0
                    ? LinkAngles{angles.x(), angles.y(), angles.z()}
                    : linkAngles(edge.R_c_n, model_.port(link.source_port), model_.port(link.target_port));
  return edge;
}

}  // namespace hexoderm
