#pragma once

#include "hexoderm/solve/tree/edge_rotation.h"
#include "hexoderm/solve/tree/gravity_table.h"
#include "hexoderm/solve/tree/skin_readings.h"

#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

/// The skin of one snapshot as every step of a reconstruction sees it: the graph, the readings that may still be used,
/// and the rotation that these give each link. Steps that find something broken take it out here; the rotations follow
/// when estimateEdges() is called, so that several readings can be taken out for one estimate.
///
/// Cells, links and poses are indices of the graph and of the snapshot. Snapshot, options and cell model must outlive
/// it.
class SkinLinks {
 public:
  /// Findings: those of the graph and of the gravity table. There are no rotations before the first estimateEdges().
  SkinLinks(const SessionSnapshot& snapshot, const SolverOptions& options, std::vector<Finding>& findings);
  // The readings refer to the table.
  SkinLinks(const SkinLinks&) = delete;
  SkinLinks& operator=(const SkinLinks&) = delete;

  [[nodiscard]] const SessionSnapshot& snapshot() const { return snapshot_; }
  [[nodiscard]] const SolverOptions& options() const { return options_; }
  [[nodiscard]] const CellModel& model() const { return model_; }
  [[nodiscard]] const SkinGraph& graph() const { return graph_; }
  [[nodiscard]] const GravityTable& table() const { return table_; }
  [[nodiscard]] GravityTable& table() { return table_; }
  [[nodiscard]] const SkinReadings& readings() const { return readings_; }
  [[nodiscard]] const std::vector<EdgeRotation>& edges() const { return edges_; }  ///< per link
  /// Residual angle of a link, rad, per pose of the snapshot; absent where an end has no reading of its own.
  [[nodiscard]] std::vector<std::optional<double>> poseResiduals(std::size_t link) const {
    const auto first = pose_residuals_.begin() + static_cast<std::ptrdiff_t>(link * table_.poseCount());
    return {first, first + static_cast<std::ptrdiff_t>(table_.poseCount())};
  }
  [[nodiscard]] PoseId poseId(std::size_t pose) const;
  [[nodiscard]] const Port& sourcePort(const GraphLink& link) const { return model_.port(link.source_port); }
  [[nodiscard]] const Port& targetPort(const GraphLink& link) const { return model_.port(link.target_port); }

  /// Takes links out of the solution; patches may fall apart.
  void mute(std::span<const std::size_t> links, FindingCode why) { graph_.mute(links, why); }
  /// No reading of the cell is used any more; it is placed by its links.
  void dropCell(std::size_t cell);
  /// No reading of the pose is used any more.
  void dropPose(std::size_t pose);
  /// A reading (cell of the graph, pose of the snapshot) less what a motion added to it (cell frame), with the variance
  /// of that.
  void correct(std::size_t cell, std::size_t pose, const Eigen::Vector3d& added_g, double variance_g2);
  /// The rotation of every link from the readings that are left.
  void estimateEdges();
  /// The same where dropCell() of this cell is all that happened since, at the cost of the links concerned: those.
  std::vector<std::size_t> estimateEdgesAround(std::size_t cell);

  /// Covariance of a cell's own attitude error, R_true = R exp(e), rad^2 in the cell frame: of its readings, or of its
  /// neighbours' where it has none. `link`: the one that the cell is placed by; of the origin one of its own; kNoIndex
  /// if it has none.
  [[nodiscard]] Eigen::Matrix3d attitudeCovariance(std::size_t cell, std::size_t link) const;

 private:
  void estimate(std::span<const std::size_t> links);
  void estimateCarefully(std::size_t link);
  void markAsGuessed(EdgeRotation& edge, const GraphLink& link) const;
  [[nodiscard]] Eigen::Matrix3d elastomerPrior(const Port& port) const;

  const SessionSnapshot& snapshot_;
  const SolverOptions& options_;
  const CellModel& model_;
  SkinGraph graph_;
  GravityTable table_;
  SkinReadings readings_;
  std::vector<EdgeRotation> edges_;
  std::vector<std::optional<double>> pose_residuals_;  ///< per link and pose
};

/// Cost of each link on a shortest path, by SolverOptions::weights.
std::vector<double> linkWeights(const SkinLinks& skin);

}  // namespace hexoderm
