#pragma once

#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/course/capture_course.h"
#include "hexoderm/device/skin_source.h"
#include "hexoderm/device/sources/recording.h"
#include "hexoderm/session/session_recorder.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace hexoderm::python {

struct LiveCaptureOptions {
  std::string source;     ///< as openSkinSource() has it
  std::string output;     ///< *.hexo, a new file; empty: the session is kept in memory
  std::string recording;  ///< empty: none
  std::size_t poses = 0;  ///< 0: as many as the course of a capture takes
  bool automatic = false;
  bool keep_raw = false;
  double timeout_s = 30;
};

/// A live capture from which poses are taken one by one. The threads of source and file only queue what happened; it is
/// dealt with by next(). Any thread may call any function, one after the other at next() and close().
class LiveCapture final : CaptureOwner, SkinListener, PoseRecorderListener {
 public:
  /// The state of the capture when it was looked at last. Copies share what is large.
  struct Shown {
    std::optional<Session> session;                ///< once a skin described itself
    std::shared_ptr<const Reconstruction> result;  ///< of all poses; null before the first
    bool can_turn = false;                         ///< the device answers turnToNextPose()
    Message status;                                ///< what is waited for
    Message advice;                                ///< the pose that would help most; empty: none is known
    std::vector<std::string> remarks;              ///< of the pose that was given out last
    std::optional<Eigen::Vector3d> up_o;           ///< the same: what to turn up, frame of the largest patch
  };

  /// Connects. Throws as openSkinSource() and SkinSource::start(), and InvalidArgument or StorageError for an output
  /// that no capture can be kept in.
  explicit LiveCapture(LiveCaptureOptions options);
  ~LiveCapture() override;

  /// A pose that counts as captured, and what was odd about it, in words.
  struct Kept {
    CapturedPose captured;  ///< without its frames
    std::vector<std::string> remarks;
  };
  /// The next one, with the result of all poses; nullopt if there are enough, the stream is
  /// over, or `stop` or close() was called. Throws DeviceError or StorageError; what was captured stays.
  std::optional<Kept> next(const std::stop_token& stop);
  /// Ends the capture and waits until all poses are on disk. Throws StorageError if one is not.
  void close();
  /// Asks the device to turn to the pose that would help most, in next(). Throws InvalidArgument if it can't.
  void turnToNextPose();
  [[nodiscard]] Shown shown() const;

 private:
  using Clock = CaptureCourse::Clock;

  // On the threads of source, recorder and file:
  void push(std::function<void()> event);
  void onSkin(const SkinDescription& skin) override;
  void onFrame(const SampleFrame& frame) override { recorder_.addFrame(frame); }
  void onJoints(const JointReport& joints) override { recorder_.addJoints(joints); }
  void onStatus(const SourceStatus& status) override;
  void onCommandOutcome(const CommandOutcome& outcome) override;
  void onPoseCaptured(CapturedPose captured) override;
  void onHold(const HoldStatus& status) override;
  void onPreview(SkinPreview /*preview*/) override {}

  // On the thread of next():
  void perform(const std::vector<SessionEdit>& edits) override;
  std::uint32_t send(const SkinCommand& command) override { return source_->send(command); }
  void retryWriting() override;
  void onCourseEvent(const CourseEvent& event) override;
  bool handleOne(std::chrono::milliseconds patience);
  void begin(const SkinDescription& skin);
  void nameTheSkin();
  void solve(const std::stop_token& stop);
  void show();
  void end();
  [[nodiscard]] SourceStatus status() const;
  [[nodiscard]] Message whyNothingComes() const;
  [[nodiscard]] bool isOver() const { return course_.isFinished() || !lost_.empty() || !refused_.empty(); }

  LiveCaptureOptions options_;
  std::mutex turn_;  ///< held by next() and close()
  std::atomic<bool> is_closing_{false};

  mutable std::mutex mutex_;  ///< of what follows
  std::condition_variable arrived_;
  std::deque<std::function<void()>> events_;
  SourceStatus status_;
  HoldStatus hold_;
  Shown shown_;

  PoseRecorder recorder_;
  std::unique_ptr<SkinSource> source_;
  std::optional<StreamRecorder> recording_;
  std::optional<Session> session_;
  std::unique_ptr<SessionRecorder> store_;
  CaptureCourse course_;
  std::shared_ptr<const Reconstruction> result_;
  std::deque<Kept> kept_;  ///< not given out yet
  bool has_news_ = false;  ///< poses that are not in the result
  bool made_progress_ = false;
  bool is_ended_ = false;
  Message lost_;         ///< why a pose is not on disk and never will be
  std::string refused_;  ///< why the device does not turn any more
};

}  // namespace hexoderm::python
