#pragma once

#include "hexoderm/device/cell_index.h"
#include "hexoderm/device/gravity_accumulator.h"
#include "hexoderm/device/pose_capture.h"

#include <limits>
#include <vector>

namespace hexoderm {

/// averageFrames() of frames that come one by one and need not be kept.
class PoseAverage {
 public:
  void add(const SampleFrame& frame);
  /// Of the frames so far.
  [[nodiscard]] PoseCapture pose(PoseId id, Message label) const;

 private:
  GravityAccumulator& of(CellId cell);

  CellIndex index_{std::numeric_limits<std::size_t>::max()};
  std::vector<GravityAccumulator> cells_;  ///< by the index's numbers
};

}  // namespace hexoderm
