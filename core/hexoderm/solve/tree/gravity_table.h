#pragma once

#include "hexoderm/session/session.h"
#include "hexoderm/skin/skin_graph.h"

#include <vector>

namespace hexoderm {

/// A hand's tremor is not white: averaging does not bring a mean below this.
inline constexpr double kTremorFloor_g = 0.003;
/// Angular acceleration that a hand's tremor of 0.05 degrees at 4 to 12 Hz leaves in a mean over 0.1 s, rms per axis.
inline constexpr double kTremorAcceleration_rad_s2 = 0.6;

/// The readings of all cells in all poses of a snapshot, laid out for the solver: cells as in the graph, poses as in
/// the snapshot, turned into the cell frame.
///
/// The scatter of a few samples says little about their noise: that of six is a third of the truth or less once in
/// twenty windows, and such a window would outweigh a long one. What a window lacks to 20 degrees of freedom is taken
/// from the cell's scatter in all its poses.
class GravityTable {
 public:
  struct Entry {
    Eigen::Vector3d mean_g = Eigen::Vector3d::Zero();  ///< cell frame, not normalised
    double count = 0;                                  ///< samples averaged; the paper's K where the file doesn't say
    double variance_g2 = 0;      ///< of the mean, per axis: the worst axis, never below the floor of tremor and steps
    double own_variance_g2 = 0;  ///< of the mean, per axis: from the scatter of the samples, mean of the axes, no floor
    double sample_sigma_g = 0;   ///< scatter of single samples, worst axis; 0 if the file doesn't say
    bool not_finite = false;     ///< there is a reading, which is no finite number
    bool measured = false;       ///< there is a finite reading
    bool usable = false;         ///< and nothing speaks against it
  };

  /// Findings: samples of unknown cells, two samples of one cell in a pose, two poses of one ID.
  GravityTable(const SessionSnapshot& snapshot, const SkinGraph& graph, std::vector<Finding>& findings);

  [[nodiscard]] std::size_t cellCount() const { return cells_; }
  [[nodiscard]] std::size_t poseCount() const { return poses_; }
  /// Poses that are not disabled, ascending.
  [[nodiscard]] const std::vector<std::size_t>& enabledPoses() const { return enabled_; }
  [[nodiscard]] const Entry& at(std::size_t cell, std::size_t pose) const { return entries_[cell * poses_ + pose]; }
  [[nodiscard]] Entry& at(std::size_t cell, std::size_t pose) { return entries_[cell * poses_ + pose]; }
  /// Enabled poses in which the cell has a usable reading.
  [[nodiscard]] std::vector<std::size_t> usablePoses(std::size_t cell) const;
  [[nodiscard]] std::size_t usablePoseCount(std::size_t cell) const;

 private:
  std::size_t cells_;
  std::size_t poses_;
  std::vector<std::size_t> enabled_;
  std::vector<Entry> entries_;

  class Scatter;
};

}  // namespace hexoderm
