#pragma once

#include "hexoderm/base/message.h"
#include "hexoderm/capture/capture_workflow.h"
#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/skin_source.h"
#include "hexoderm/session/session.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>

namespace hexoderm {

/// What is captured, and where it is kept.
struct LiveCaptureOptions {
  std::string source;                 ///< as openSkinSource() has it
  std::filesystem::path file{};       ///< *.hexo, a new file; empty: the session is kept in memory
  std::filesystem::path record_to{};  ///< what the device sends, for replay:FILE; empty: it is not kept
  std::size_t poses = 0;              ///< so many are enough; 0: as the verdict on the result says
  /// The device is asked to turn itself, to where each pose helps most. Without it somebody turns the part; next() then
  /// waits without limit, use `stop`. A part that nobody but the device can turn needs it, or turnToNextPose().
  bool automatic = false;
  bool keep_raw = false;  ///< keeps every sample of the poses in the file too
  double timeout_s = 30;  ///< to wait for a device to describe itself; with `automatic` also for each pose
};

/// The state of a live capture. Copies share what is large. What to do next is result->assessment.next_action; `advice`
/// is the same without the forecast.
struct LiveCaptureState {
  std::optional<Session> session{};  ///< since a skin described itself
  /// Of all poses; null before the first, and at the end where solving them was stopped.
  std::shared_ptr<const Reconstruction> result{};
  std::optional<PoseKept> last{};       ///< the pose that next() gave last, and what was odd about it
  bool can_turn = false;                ///< the device can be asked to, see turnToNextPose()
  Message status{};                     ///< what is waited for, or that nothing is, one line
  Message advice{};                     ///< the pose that would help most; empty: none is known, or wanted
  std::optional<Eigen::Vector3d> up{};  ///< the same: what to turn up, unit, frame of the largest patch
  Message device{};                     ///< what the device calls itself; empty: no skin described itself
  SourceStatus source{};                ///< of the source, up to the end of the capture
  StillnessStatistics holds{};          ///< where the time went, in which the part was watched
  /// At the end of a capture that kept all its poses: why not all that the device sent was recorded; empty if it was.
  Message recording_error{};
};

/// A skin described itself for the first time: the session is begun, and its file made.
struct CaptureBegun {
  SkinDescription skin;
};
/// One obstacle alone has kept a capture from starting for so long, in device time. Told after 5 s, and then ever more
/// rarely.
struct NoPose {
  double duration_s = 0;
  Message why;
};
/// The device is connected and has sent no readings for so long. Told after 3 s, and then ever more rarely.
struct NoReadings {
  double duration_s = 0;
  Message why;
};
/// What the device sends is not recorded any more. The capture goes on.
struct RecordingEnded {
  Message why;
};
/// The pose that would help most is another one now, whether or not more poses are wanted.
struct PoseAdvised {
  Message advice;
};

/// Everything that a live capture tells while it goes on: what the device says of itself (SkinDescription, before
/// anything is made of it, and SourceStatus), what the recorder says of the part (HoldStatus), of either only the
/// newest where they come faster than they are told, and what its course tells.
using LiveCaptureEvent = std::variant<SkinDescription, CaptureBegun, SourceStatus, HoldStatus, NoPose, NoReadings,
                                      RecordingEnded, PoseAdvised, WorkflowEvent>;

/// A live capture with a loop of its own: a CaptureWorkflow with its source, its session, the file that keeps it, and
/// the solver, for programs that have no event loop. Poses are taken from it one by one:
///
///     LiveCapture capture({.source = "tcp://localhost:7700", .file = "arm.hexo"});
///     while (capture.next()) use(*capture.state().result);
///
/// Threads of its own only queue what happened; it is dealt with by next(). Any thread may call any function; next()
/// and close() wait for each other.
class LiveCapture {
 public:
  /// Is told what happens, in the calls of next() and close(). What it throws ends the capture and comes back to their
  /// caller. It must call neither.
  using Listener = std::function<void(const LiveCaptureEvent&)>;

  /// Connects. Throws as openSkinSource() and SkinSource::start(), InvalidArgument for a name that does not end in
  /// .hexo, and StorageError for a file that exists.
  explicit LiveCapture(LiveCaptureOptions options);
  /// The same with a source that was opened and not started, which start() does; `options.source` only names it.
  LiveCapture(LiveCaptureOptions options, std::unique_ptr<SkinSource> source, Listener listener);
  /// Ends the capture as close() does, and throws nothing.
  ~LiveCapture();

  /// Connects, as SkinSource::start(). Call once, and only for a source that was handed over.
  void start();
  /// Waits for the next pose that counts as captured, and solves all poses; nullopt if there are enough, the stream is
  /// over, or `stop` or close() was called. Without `automatic` it waits for a pose without limit. Throws DeviceError
  /// or StorageError; what was captured stays, and a DeviceError says which poses are not stored. A recording that
  /// ended early is said so at the end, after all else.
  std::optional<CapturedPose> next(const std::stop_token& stop = {}) { return next(stop, stop); }
  /// The same where the solver is stopped by `stop_solving`, which comes later than `stop`.
  std::optional<CapturedPose> next(const std::stop_token& stop, const std::stop_token& stop_solving);
  /// Asks the device to turn to the pose that would help most. It is next() that does so, the call that waits in
  /// another thread or else the next one. Throws InvalidArgument if the device can't turn, or did not describe itself
  /// yet.
  void turnToNextPose();
  /// Ends the capture, waits until all poses are on disk, and solves them if that is still to be done. Throws
  /// StorageError if one is not on disk, or not all was recorded. A file that took no pose at all is removed then.
  /// Idempotent.
  void close(const std::stop_token& stop_solving = {});
  /// The state as next() saw it last, also while another thread waits there.
  [[nodiscard]] LiveCaptureState state() const;

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

}  // namespace hexoderm
