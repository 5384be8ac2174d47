#include "hexoderm/capture/pose_capture.h"

#include <map>

namespace hexoderm {

PoseCapture averageFrames(std::span<const SampleFrame> frames, PoseId id, std::string label) {
  // Welford's update: one pass, no cancellation.
  struct Accumulator {
    std::uint32_t count = 0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  };
  std::map<CellId, Accumulator> cells;
  for (const SampleFrame& frame : frames) {
    for (const CellSample& sample : frame.samples) {
      if (!sample.acceleration_g.allFinite()) continue;
      Accumulator& cell = cells[sample.cell];
      ++cell.count;
      const Eigen::Vector3d before = sample.acceleration_g - cell.mean;
      cell.mean += before / cell.count;
      cell.scatter += before * (sample.acceleration_g - cell.mean).transpose();
    }
  }
  PoseCapture pose{id, std::move(label), {}};
  pose.samples.reserve(cells.size());
  for (const auto& [cell_id, cell] : cells) {
    GravitySample sample{cell_id, cell.mean, Eigen::Matrix3d::Zero(), cell.count};
    if (cell.count > 1) {
      const double n = cell.count;
      sample.cov_g2 = (cell.scatter + cell.scatter.transpose()) / (2 * n * (n - 1));
    }
    pose.samples.push_back(sample);
  }
  return pose;
}

}  // namespace hexoderm
