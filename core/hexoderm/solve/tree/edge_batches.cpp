#include "hexoderm/solve/tree/edge_batches.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/lane_numbers.h"

#include <algorithm>
#include <array>

namespace hexoderm {
namespace {

constexpr std::size_t kMaxPorts = 16;  // of a model whose pairs are worth a table

/// Up to kLanes links, whose cells measured in equally many poses together, with their readings side by side as the
/// kernel wants them: value k of the link in lane l is at [kLanes * k + l]. Lanes that are over repeat the first.
struct Batch {
  int poses = 0;
  int size = 0;
  std::array<std::size_t, kLanes> links{};
  std::vector<double> c_g;          // poses x 3, source cell, in its frame
  std::vector<double> n_g;          // poses x 3, target cell
  std::vector<double> variance_g2;  // poses: sum of both means' variances, per axis
  std::array<double, 9 * kLanes> R_nom{};
  std::array<double, 3 * kLanes> outward{};

  void makeRoom(int for_poses) {
    poses = for_poses;
    variance_g2.resize(static_cast<std::size_t>(kLanes * poses));
    c_g.resize(3 * variance_g2.size());
    n_g.resize(3 * variance_g2.size());
  }
};

class EdgeBatches {
 public:
  EdgeBatches(const SkinLinks& skin, std::vector<EdgeRotation>& edges,
              std::vector<std::optional<double>>& pose_residuals, EdgeKernel kernel)
      : skin_(skin),
        edges_(edges),
        pose_residuals_(pose_residuals),
        kernel_(kernel),
        waiting_(skin.table().enabledPoses().size() + 1),
        residual_rad_(kLanes * skin.table().enabledPoses().size()) {
    for (const Port& source : skin.model().ports) {
      for (const Port& target : skin.model().ports) {
        pairs_.push_back({nominalAlignment(source, target), source.vector_m.normalized()});
      }
    }
  }

  std::vector<std::size_t> estimate(std::span<const std::size_t> links) {
    for (const std::size_t link : links) add(link);
    for (Batch& batch : waiting_) {
      for (int lane = batch.size; batch.size > 0 && lane < kLanes; ++lane) fill(batch, lane, batch.links.front());
      if (batch.size > 0) run(batch);
    }
    std::ranges::sort(unusual_);
    return std::move(unusual_);
  }

 private:
  struct PortPair {
    Eigen::Matrix3d R_nom;
    Eigen::Vector3d outward;
  };

  void add(std::size_t index) {
    constexpr int kFewestPoses = 2;
    const GraphLink& link = skin_.graph().links()[index];
    int poses = 0;
    if (skin_.readings().measured(link)) {
      for (const std::size_t pose : skin_.table().enabledPoses()) poses += skin_.readings().inBoth(link, pose) ? 1 : 0;
    }
    if (poses < kFewestPoses) {
      unusual_.push_back(index);
      return;
    }
    Batch& batch = waiting_[static_cast<std::size_t>(poses)];
    if (batch.poses == 0) batch.makeRoom(poses);
    batch.links.at(static_cast<std::size_t>(batch.size)) = index;
    fill(batch, batch.size, index);
    if (++batch.size == kLanes) run(batch);
  }

  [[nodiscard]] std::size_t portIndex(PortNumber number) const {
    return static_cast<std::size_t>(skin_.model().findPort(number) - skin_.model().ports.data());
  }

  void fill(Batch& batch, int in_lane, std::size_t index) const {
    const GraphLink& link = skin_.graph().links()[index];
    const auto lane = static_cast<std::size_t>(in_lane);
    const PortPair& pair =
        pairs_[portIndex(link.source_port) * skin_.model().ports.size() + portIndex(link.target_port)];
    matrixOfLane(batch.R_nom.data(), lane) = pair.R_nom;
    vectorOfLane(batch.outward.data(), lane) = pair.outward;
    std::size_t k = 0;
    for (const std::size_t pose : skin_.table().enabledPoses()) {
      if (!skin_.readings().inBoth(link, pose)) continue;
      vectorOfLane(&batch.c_g[3 * kLanes * k], lane) = skin_.readings().gravityOf(link.source, pose);
      vectorOfLane(&batch.n_g[3 * kLanes * k], lane) = skin_.readings().gravityOf(link.target, pose);
      batch.variance_g2[kLanes * k + lane] =
          skin_.table().at(link.source, pose).variance_g2 + skin_.table().at(link.target, pose).variance_g2;
      ++k;
    }
  }

  void run(Batch& batch) {
    EdgeKernelOptions options = edgeKernelOptions(skin_.model(), skin_.options());
    // Two vectors less their mean are one difference and its opposite: a single direction.
    options.centre = options.centre && batch.poses >= 3;
    out_.pose_residual_rad = residual_rad_.data();
    kernel_(options,
            {batch.poses, batch.c_g.data(), batch.n_g.data(), batch.variance_g2.data(), batch.R_nom.data(),
             batch.outward.data()},
            out_);
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(batch.size); ++lane) take(lane, batch.links.at(lane));
    batch.size = 0;
  }

  void take(std::size_t lane, std::size_t index) {
    const GraphLink& link = skin_.graph().links()[index];
    EdgeRotation edge;
    if (out_.usual[lane] != 0) edge = edgeIn(lane, link);
    if (out_.usual[lane] == 0 || needsSupport(edge, skin_.options().support_axes, skin_.model())) {
      unusual_.push_back(index);
      return;
    }
    edges_[index] = std::move(edge);
    std::size_t at = lane;
    const auto residuals = std::span(pose_residuals_).subspan(index * skin_.table().poseCount());
    std::fill_n(residuals.begin(), skin_.table().poseCount(), std::nullopt);
    for (const std::size_t pose : skin_.table().enabledPoses()) {
      if (!skin_.readings().inBoth(link, pose)) continue;
      residuals[pose] = residual_rad_[at];
      at += kLanes;
    }
  }

  [[nodiscard]] EdgeRotation edgeIn(std::size_t lane, const GraphLink& link) const {
    EdgeRotation edge;
    edge.R_c_n = matrixOfLane(out_.R_c_n, lane);
    edge.singular_values = vectorOfLane(out_.singular_values, lane);
    edge.quality = classifyEdge(edge.singular_values, skin_.options().class_threshold);
    edge.centred = out_.centred[lane] != 0;
    edge.covariance = symmetricOfLane(out_.covariance, lane);
    edge.prior_part = symmetricOfLane(out_.prior_part, lane);
    edge.residual_rad = out_.residual_rad[lane];
    edge.expected_residual_rad = out_.expected_residual_rad[lane];
    edge.deviation_rad = largestDeviation(edge.covariance);
    const Eigen::Vector3d angles = vectorOfLane(out_.angles_rad, lane);
    edge.angles = out_.has_angles[lane] != 0 ? LinkAngles{angles.x(), angles.y(), angles.z()}
                                             : linkAngles(edge.R_c_n, skin_.sourcePort(link), skin_.targetPort(link));
    return edge;
  }

  const SkinLinks& skin_;
  std::vector<EdgeRotation>& edges_;
  std::vector<std::optional<double>>& pose_residuals_;
  EdgeKernel kernel_;
  std::vector<PortPair> pairs_;  // per port of the source and port of the target
  std::vector<Batch> waiting_;   // by their number of poses
  std::vector<double> residual_rad_;
  EdgeKernelOutput out_{};
  std::vector<std::size_t> unusual_;
};

}  // namespace

std::vector<std::size_t> estimateUsualEdges(const SkinLinks& skin, std::span<const std::size_t> links,
                                            std::vector<EdgeRotation>& edges,
                                            std::vector<std::optional<double>>& pose_residuals, EdgeKernel kernel) {
  if (skin.model().ports.size() > kMaxPorts || skin.options().support_axes == SupportAxes::On) {
    return {links.begin(), links.end()};
  }
  return EdgeBatches(skin, edges, pose_residuals, kernel).estimate(links);
}

}  // namespace hexoderm
