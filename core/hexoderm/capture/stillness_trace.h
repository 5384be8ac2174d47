#pragma once

#include "hexoderm/capture/pose_recorder.h"

#include <deque>
#include <optional>
#include <vector>

namespace hexoderm {

/// The state of the part at one moment of a trace.
enum class TraceState {
  Moving,      ///< turns, shakes, or is not judged yet
  Still,       ///< is still; a capture does not run
  Collecting,  ///< samples are being taken
};

/// A place on the trace.
struct TracePoint {
  double time_s = 0;
  /// Difference of the shown cell's reading from its mean over the last second, accelerometer's axes; absent where the
  /// cell sent nothing.
  std::optional<Eigen::Vector3d> deviation_g;
  TraceState state = TraceState::Moving;
};

/// What is marked on the trace.
enum class TraceEventKind {
  Captured,
  ArmedAgain,  ///< moved enough since the last capture
  StartsOver,  ///< a motion discarded what was being collected
};
/// A mark on the trace.
struct TraceEvent {
  double time_s = 0;
  TraceEventKind kind{};
  PoseId pose;  ///< set if state is Captured
};

/// The last ten seconds of one cell's readings, with the stillness detector's judgements, for a strip chart.
///
/// The cell is the deciding one, or one that was picked. The deciding cell can change with every judgement; a new one
/// is shown only after it has been decisive for a second. Readings of all cells of skins of up to kMaxKeptCells cells
/// are kept, so that a newly shown cell comes with its past; for larger skins only the shown cell's. Belongs to one
/// thread.
class StillnessTrace {
 public:
  static constexpr double kSpan_s = 10;               ///< the length of the trace
  static constexpr std::size_t kMaxKeptCells = 1000;  ///< the cells of the largest skin of which all are kept

  /// Adds a PoseRecorder's state and preview, at most 20 times per second. Where device time goes back, the trace
  /// starts over. Times that are not finite are ignored.
  void add(const HoldStatus& hold, const SkinPreview& preview);
  /// `time_s`: device time, for example CapturedPose::end_s.
  void addCaptured(PoseId pose, double time_s);
  /// Picks a cell; none: the cell that decides.
  void pick(std::optional<CellId> cell);
  void clear();  ///< forgets all points and events

  [[nodiscard]] const std::deque<TracePoint>& points() const { return points_; }  ///< the oldest first
  [[nodiscard]] const std::deque<TraceEvent>& events() const { return events_; }  ///< the oldest first
  /// ID 0 as long as no cell has decided anything.
  [[nodiscard]] CellId cell() const { return picked_.value_or(decisive_); }
  [[nodiscard]] bool isPicked() const { return picked_.has_value(); }  ///< a cell was picked, whose trace it is
  [[nodiscard]] double limit_g() const { return limit_g_; }            ///< motion above it is no stillness
  /// Device time of the last point; 0 without any.
  [[nodiscard]] double now_s() const { return points_.empty() ? 0 : points_.back().time_s; }

 private:
  void noteDecisive(CellId cell, double time_s);
  void noteEvents(const HoldStatus& hold, double time_s);
  void addPoint(double time_s, TraceState state, const std::vector<CellSample>& means);
  [[nodiscard]] std::optional<Eigen::Vector3d> deviation(std::size_t point) const;
  void showOther();

  std::deque<TracePoint> points_;
  std::deque<TraceEvent> events_;
  std::deque<std::vector<CellSample>> kept_;             ///< beside points_
  std::deque<std::optional<Eigen::Vector3d>> readings_;  ///< readings of the shown cell, parallel to points_
  CellId decisive_;
  CellId candidate_;
  double candidate_since_s_ = 0;
  std::optional<CellId> picked_;
  double limit_g_ = 0.030;
  std::optional<bool> was_armed_;
  std::uint64_t restarts_ = 0;
};

}  // namespace hexoderm
