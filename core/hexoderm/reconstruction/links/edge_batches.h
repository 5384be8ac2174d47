#pragma once

#include "hexoderm/reconstruction/links/edge_kernel.h"
#include "hexoderm/reconstruction/links/edge_rotation.h"
#include "hexoderm/reconstruction/links/link_batches.h"
#include "hexoderm/util/vector_instructions.h"

#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

/// What the kernel needs to know of a cell model and of how edges are to be solved; as estimateEdgeRotation() does it.
EdgeKernelOptions edgeKernelOptions(const CellModel& model, const SolverOptions& options);

/// The rotations of usual links, several at a time: those of which at least two poses with clearly different directions
/// are known, and that need no support axes. Equal to estimateEdgeRotation() but for rounding.
class EdgeBatches {
 public:
  using Kernel = void (*)(const EdgeKernelOptions&, const EdgeKernelInput&, EdgeKernelOutput&);

  /// The fastest kernel that the computer can run.
  static Kernel fastest() { return hasVectorInstructions() ? estimateEdgesByFour : estimateEdgesByTwo; }

  /// All must outlive it.
  EdgeBatches(const CellModel& model, const SkinGraph& graph, const GravityTable& table, const SkinReadings& readings,
              const SolverOptions& options, Kernel kernel = fastest());

  /// Estimates these links into `edges`, with their figures, and `pose_residuals`: per link of the graph and pose of
  /// the table. Returns the links that are not usual, whose edges are left as they are.
  std::vector<std::size_t> estimate(std::span<const std::size_t> links, std::vector<EdgeRotation>& edges,
                                    std::vector<std::optional<double>>& pose_residuals);

 private:
  struct PortPair {
    Eigen::Matrix3d R_nom;
    Eigen::Vector3d outward;
  };
  [[nodiscard]] std::size_t portIndex(PortNumber number) const;
  void run(const LinkBatch& batch, std::vector<EdgeRotation>& edges, std::vector<std::optional<double>>& pose_residuals,
           std::vector<std::size_t>& unusual);
  [[nodiscard]] EdgeRotation edgeIn(int lane, const GraphLink& link) const;

  const CellModel& model_;
  const SkinGraph& graph_;
  const GravityTable& table_;
  const SkinReadings& readings_;
  const SolverOptions& options_;
  Kernel kernel_;
  std::vector<PortPair> pairs_;  ///< per port of the source and port of the target
  std::vector<double> R_nom_;
  std::vector<double> outward_;
  std::vector<double> residual_rad_;
  EdgeKernelOutput out_{};
};

}  // namespace hexoderm
