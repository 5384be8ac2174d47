#pragma once

#include "hexoderm/capture/stillness.h"
#include "hexoderm/device/pose_capture.h"
#include "hexoderm/device/sample_frame.h"
#include "hexoderm/skin/cell_model.h"

#include <memory>
#include <vector>

namespace hexoderm {

/// Decides from a stream of readings whether a body part is held still.
///
/// Readings are summed up in slots of 50 ms (longer where cells send more rarely). At the end of each slot the part is
/// judged again by:
/// - drift: per cell, the slope of the direction over drift_window_s, its squared magnitude less the contribution of
///   the cell's noise; over the cells, the median. All cells of a rigid part see gravity turn by the same angle per
///   second, wherever they are. Noise is what the readings show: their deviations from a straight line in this window,
///   times how much more the means of parts of it scatter (learned while the part does not turn), so that it may be
///   vibration of any colour. Where it would drown the limit the window grows, up to 5 s or kSlots slots, and no
///   further than it must: before that the part may have moved. A part turns if its drift exceeds the limit by more
///   than noise explains; as long as there is no telling, the blocker is Waiting. A turn about gravity can't be seen,
///   and adds nothing to a pose.
/// - excess: per cell, sqrt(max(0, variance - floor^2)) per axis over hold_s; over the cells, the value that
///   quiet_fraction of them (quiet_cells, if that is less) stay below; the limit is higher by two standard errors where
///   a few samples say little. Shaking and turning move all cells alike, and one moves more than another only because
///   it is further from the hand: on a large part, harmless tremor is 100 mg at the far end.
/// - a single cell that turns by more than twice the drift limit while the rest is still, which blocks too, for
///   patience_s.
/// Differences are scaled to 1 g, whatever the norm of a reading: offsets cancel, and the norm never blocks.
///
/// The noise floor of a cell, for the excess, starts from the model's accelerometer (white noise and step) and is
/// learned while the part is still: quickly down, slowly up, and up only where scatter is white (slot means scatter as
/// little as samples within slots, or neighbouring samples, predict), which motion is not. Where only
/// scatter blocks, and it has been white for 10 s, it is taken for noise as well: those accelerometers are worse than
/// their model says.
///
/// A device may send readings several times over (a gateway whose rate is above the cells'): how often shows within the
/// first few, the judgement begins anew, and each counts once from then on, for the rate and the noise as well.
///
/// Cells that misbehave (OddCell) are named; dead and stuck ones do not count as long as others do. A minority of bad
/// cells blocks for patience_s at most.
///
/// Cost: constant per reading, and about 20 times a second some hundred operations per cell. No allocation per sample.
/// Belongs to one thread.
class StillnessDetector {
 public:
  /// Throws InvalidArgument (StillnessOptions::validate).
  explicit StillnessDetector(const Accelerometer& accelerometer, StillnessOptions options = {});
  ~StillnessDetector();
  StillnessDetector(StillnessDetector&&) noexcept;
  StillnessDetector& operator=(StillnessDetector&&) noexcept;

  /// Takes a frame; true if stillness() was judged again. `time_s` must be finite and not before the last frame's: an
  /// assertion; frames of the same time have no cell in common. A gap in time (0.5 s, or five times the usual distance
  /// of frames) begins a new window. Readings that are not finite or beyond 100 g are ignored, and so are cells beyond
  /// the first 200,000.
  bool add(const SampleFrame& frame);

  /// What was new in the frame that was added last: without the readings that the device had sent before.
  [[nodiscard]] const SampleFrame& newIn(const SampleFrame& frame) const;

  [[nodiscard]] const Stillness& stillness() const;  ///< the state after the last frame

  /// The pose was captured: the next one needs a move of more than rearm_angle_rad from these readings.
  void disarm(const PoseCapture& pose);
  /// Returns to the initial state, but keeps learned noise floors and known cells; the clock may start over.
  void restart();

  /// Means of about the last 100 ms of every cell that sent something in that time, in the order in which the cells
  /// were first seen.
  [[nodiscard]] std::vector<CellSample> recentMeans() const;
  /// Cells that were heard within silent_after_s, in the same order.
  [[nodiscard]] std::vector<CellId> cellsHeard() const;
  /// Angle between the readings of the last 100 ms and a pose's, median over the cells that both have; 0 without any.
  [[nodiscard]] double angleFrom(const PoseCapture& pose) const;
  /// A cell's noise floor, rms per axis, g; the model's for a cell that is not known.
  [[nodiscard]] double noiseFloor_g(CellId cell) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Angle between two readings of one cell in two poses from their distance d, 2 asin(d / 2 g): the cell's offset
/// cancels.
double angleBetweenReadings(const Eigen::Vector3d& a_g, const Eigen::Vector3d& b_g);

}  // namespace hexoderm
