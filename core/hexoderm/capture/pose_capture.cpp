#include "hexoderm/capture/pose_capture.h"

#include "hexoderm/capture/gravity_accumulator.h"

#include <map>

namespace hexoderm {

PoseCapture averageFrames(std::span<const SampleFrame> frames, PoseId id, Message label) {
  std::map<CellId, GravityAccumulator> cells;
  for (const SampleFrame& frame : frames) {
    for (const CellSample& sample : frame.samples) {
      if (isUsable(sample)) cells[sample.cell].add(sample.acceleration_g);
    }
    for (const CellMean& mean : frame.means) {
      if (isUsable(mean)) cells[mean.cell].add(mean);
    }
  }
  PoseCapture pose{id, std::move(label), {}};
  pose.samples.reserve(cells.size());
  for (const auto& [cell_id, cell] : cells) pose.samples.push_back(cell.sample(cell_id));
  return pose;
}

}  // namespace hexoderm
