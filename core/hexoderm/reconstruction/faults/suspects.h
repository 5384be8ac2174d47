#pragma once

#include "hexoderm/reconstruction/accelerometer/rigidity.h"
#include "hexoderm/reconstruction/links/edge_rotation.h"
#include "hexoderm/reconstruction/links/skin_readings.h"

#include <vector>

namespace hexoderm {

/// Compares neighbouring cells and finds the links that no skin link can be (by their angles, or because their cells
/// moved against each other between poses) and the cells whose readings fit none of their neighbours'. One bad cell
/// makes good links look bad, so a cell that agrees with nearly none of its neighbours is named instead of its links.
class SuspectSearch {
 public:
  SuspectSearch(const CellModel& model, const SkinGraph& graph, const GravityTable& table, const SkinReadings& readings,
                const std::vector<EdgeRotation>& edges, const SolverOptions& options);

  /// The pose without which nearly all links are rigid, where with it most are not: the part moved while it was
  /// sampled.
  [[nodiscard]] std::optional<std::size_t> worstPose() const;

  /// The cell that contradicts its neighbours most, if there is one: its readings should not be used. Ask again after
  /// that, with new readings and edges.
  [[nodiscard]] std::optional<std::size_t> worstCell() const;

  struct BadLink {
    std::size_t link = 0;
    std::vector<Finding> findings;  ///< at least one
  };
  [[nodiscard]] std::vector<BadLink> badLinks() const;

 private:
  struct Verdict {
    bool tested = false;
    std::vector<Finding> implausible;
    double misfit = 0;  ///< standard deviations
    bool rigid = true;
    [[nodiscard]] bool bad() const { return !implausible.empty() || !rigid; }
  };
  [[nodiscard]] Verdict judge(std::size_t link) const;
  /// What the source reads beside what it would if it turned with the target, in all poses of both.
  struct PairReadings {
    std::vector<CellReading> source;
    std::vector<Eigen::Vector3d> target_g;
    RigidityTest test;
  };
  [[nodiscard]] PairReadings readingsOf(std::size_t link) const;

  const CellModel& model_;
  const SkinGraph& graph_;
  const GravityTable& table_;
  const SkinReadings& readings_;
  const std::vector<EdgeRotation>& edges_;
  const SolverOptions& options_;
  AccelerometerPrior pair_prior_;  ///< errors of two cells, seen from one of them
  std::vector<Verdict> verdicts_;  ///< per link
};

/// Why a cell's readings are not used, in words: a gain that is wrong in all poses, or else readings that fit nothing.
Finding describeBadSensor(const SkinGraph& graph, const GravityTable& table, const SessionSnapshot& snapshot,
                          std::size_t cell, bool is_leaf);

}  // namespace hexoderm
