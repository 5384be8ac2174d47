#pragma once

// Private to core.

#include "hexoderm/capture/pose_capture.h"

#include <memory>

namespace hexoderm {

/// averageFrames() of frames that come one by one and need not be kept.
class PoseAverage {
 public:
  PoseAverage();
  ~PoseAverage();
  PoseAverage(PoseAverage&&) noexcept;
  PoseAverage& operator=(PoseAverage&&) noexcept;

  void add(const SampleFrame& frame);
  /// Of the frames so far.
  [[nodiscard]] PoseCapture pose(PoseId id, Message label) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hexoderm
