#pragma once

#include "hexoderm/capture/stillness_detector.h"
#include "hexoderm/device/skin_source.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

/// How a PoseRecorder takes poses.
struct PoseRecorderOptions {
  StillnessOptions stillness{};
  /// Samples per cell and pose. 0: 100, or what a cell delivers in collect_s if that is less, at least 10; its rate is
  /// the cell model's, or what is seen on the wire if that is less. So 100 from 134 Hz on, 75 at 100 Hz, 38 at 50 Hz.
  std::uint32_t samples_per_cell = 0;
  double collect_s = 0.75;
  bool automatic = true;     ///< captures by itself when the part is still and was moved since the last capture
  bool keep_frames = false;  ///< hands the raw frames over with each capture, without repeated readings
  double repeat_angle_rad = 10 * kDegree;  ///< see CapturedPose::repeats
  /// Milliseconds since 1970, UTC; empty: the system's clock.
  std::function<std::int64_t()> wall_clock_ms{};

  /// Throws InvalidArgument naming the option.
  void validate() const;
};

/// A pose, and the circumstances of its capture.
struct CapturedPose {
  std::shared_ptr<const PoseCapture> pose;  ///< never null; has at least one sample
  bool forced = false;                      ///< taken by captureNow(), whether the part moved or not
  /// The nearest earlier pose, if gravity has turned by less than repeat_angle_rad from it (the median over the cells
  /// that both poses have). A turn by 10 degrees adds sin(10 deg) = 17 % of a new direction; a hand that means to
  /// repeat a pose misses it by about 4 degrees.
  std::optional<PoseId> repeats;
  double repeat_angle_rad = 0;  ///< to that pose
  double start_s = 0;           ///< device time: samples are from after this ...
  double end_s = 0;             ///< ... up to this
  /// Known cells without a single sample (absent from the pose), and cells with fewer than the others.
  std::vector<CellId> silent_cells;
  std::vector<CellId> short_cells;
  std::vector<OddCell> odd_cells;   ///< found while the part was still
  std::vector<SampleFrame> frames;  ///< empty unless keep_frames is set
  /// Where the joints of the robot stood, if the device says so: the mean of what it said between start_s and end_s, or
  /// what it said last, at most a second before.
  JointAngles joint_angles{};
};

/// What a PoseRecorder is doing.
enum class HoldPhase {
  Watching,    ///< waits until the part is still
  Collecting,  ///< takes samples; a motion starts it over
  Confirming,  ///< has all samples, and checks that they were not the beginning of a motion
};

/// The state of a hold, for the operator.
struct HoldStatus {
  Stillness stillness;
  HoldPhase phase = HoldPhase::Watching;
  bool automatic = true;
  bool forced = false;            ///< the capture under way was requested by captureNow()
  double progress = 0;            ///< fill of the hold ring, 0 to 1; a motion resets it to 0
  Message message;                ///< the obstacle or the current activity, one line
  std::uint64_t late_frames = 0;  ///< ignored: older than the last one, or a repetition, or without a time
  std::uint64_t restarts = 0;     ///< collections that a motion discarded
};

/// Mean of about the last 100 ms of every cell that sent something then, and the temperature that each cell sent last,
/// of those that measure it.
struct SkinPreview {
  double time_s = 0;
  std::vector<CellSample> means;
  std::vector<CellTemperature> temperatures{};
};

/// Receives what a PoseRecorder makes, on the thread that feeds it. Must not throw where that is a source's:
/// std::terminate. May call the recorder's commands.
class PoseRecorderListener {
 public:
  virtual ~PoseRecorderListener() = default;
  virtual void onPoseCaptured(CapturedPose captured) = 0;  ///< a pose is complete
  /// Each is called at most 20 times per second of device time.
  virtual void onHold(const HoldStatus& status) = 0;
  virtual void onPreview(SkinPreview preview) = 0;  ///< the newest readings, for the operator
};

/// Turns a stream of frames into poses (line 8 of the paper's Algorithm 1): when the part is still and
/// has been moved since the last capture, it takes samples of every cell; if the part moves meanwhile, they are
/// discarded.
///
/// A pose is handed over once every cell heard recently has its samples and the part has stayed still for another 0.1
/// s, so that the beginning of a motion is not sampled. Cells that fall silent meanwhile are not waited for, and when
/// more than half of the cells are complete, the others have as long again.
///
/// A reading that the device sends several times over counts once (StillnessDetector): repeating it makes no mean
/// better.
///
/// Frames with the same time are one tick, as long as no cell reads twice in it. Other frames whose time does not
/// increase are ignored and counted. If nothing else comes for 0.5 s of their own time, the device's clock was set back
/// (the device was reset), and recording starts over.
///
/// Threads: setSkin(), addFrame() and addJoints() belong to one thread, the source's; the listener is called there. The
/// other functions may be called from any thread; they take effect with the next frame.
class PoseRecorder {
 public:
  /// `listener` must outlive the recorder. Throws InvalidArgument (PoseRecorderOptions::validate).
  explicit PoseRecorder(PoseRecorderListener& listener, PoseRecorderOptions options = {});
  ~PoseRecorder();

  /// Handles SkinListener::onSkin, which tells the accelerometer and the expected cells. Without it, the noise and rate
  /// of hex-bma150 are assumed, and only cells that have sent something are known. A capture under way starts over.
  void setSkin(const SkinDescription& skin);
  /// Handles SkinListener::onFrame.
  void addFrame(const SampleFrame& frame);
  /// Handles SkinListener::onJoints.
  void addJoints(const JointReport& joints);

  void setAutomatic(bool automatic);  ///< PoseRecorderOptions::automatic, from now on
  /// "Capture anyway": takes the next samples whatever moves.
  void captureNow();
  /// Gives up the capture under way, if any.
  void cancelCapture();
  /// The ID of the next capture; later ones count up from it. The first is 1 by default.
  void setNextPoseId(PoseId id);
  /// Sets the poses that a capture may repeat, in place of those known so far. The recorder adds its own captures
  /// itself.
  void setEarlierPoses(std::vector<std::shared_ptr<const PoseCapture>> poses);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Device time for which one obstacle kept a capture from starting.
struct BlockedTime {
  Blocker blocker{};
  double duration_s = 0;
  CellId cell;        ///< the cell that decided for longest; ID 0 where none decides alone
  double cell_s = 0;  ///< ... for so long
  Message message{};  ///< the obstacle in words, as it was last
};

/// Adds up what a PoseRecorder says: why nothing was captured, once it is over.
class StillnessStatistics {
 public:
  /// The time since the state before counts for this one. Where device time goes back, none counts.
  void add(const HoldStatus& hold);

  /// The obstacles that there were, the longest first.
  [[nodiscard]] std::vector<BlockedTime> blocked() const;
  [[nodiscard]] double still_s() const { return still_s_; }      ///< while still, or being sampled
  [[nodiscard]] double watched_s() const { return watched_s_; }  ///< in all
  /// The last state; nullopt before the first.
  [[nodiscard]] const std::optional<HoldStatus>& last() const { return last_; }

 private:
  struct Entry {
    double duration_s = 0;
    std::map<CellId, double> cells_s;
    Message message;
  };
  std::map<Blocker, Entry> entries_;
  double still_s_ = 0;
  double watched_s_ = 0;
  std::optional<HoldStatus> last_;
};

}  // namespace hexoderm
