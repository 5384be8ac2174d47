#pragma once

#include "hexoderm/capture/hold_ledger.h"
#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/skin_source.h"
#include "hexoderm/session/session_recorder.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <variant>

namespace hexoderm::cli {

/// A pose that is on disk, or is not.
struct Stored {
  PoseId pose;
  StoreOutcome outcome;
};
/// The same obstacle has kept a capture from starting for so long, in device time.
struct LongWait {
  double duration_s = 0;
  Message why;
};

/// How long something is waited for, in seconds of whichever clock: that is said after a while and then ever more
/// rarely.
class LastingWait {
 public:
  explicit LastingWait(double first_s) : first_s_(first_s), say_after_s_(first_s) {}

  /// What was waited for came.
  void begin(double now_s);
  /// Seconds, where it is time to say so.
  std::optional<double> toBeSaid(double now_s);

 private:
  double first_s_;
  double since_s_ = 0;
  double say_after_s_;
};

using CaptureEvent =
    std::variant<SkinDescription, CapturedPose, SourceStatus, CommandOutcome, HoldStatus, LongWait, Stored>;

/// Events of source, pose recorder and store, from their threads, in order, for the one thread that decides. Only the
/// newest of the hold states and of the source states is kept; an obstacle that lasts is an event of its own, after 5 s
/// and then ever more rarely. Feeds the pose recorder on the source's thread.
class CaptureEvents final : public SkinListener, public PoseRecorderListener {
 public:
  explicit CaptureEvents(const PoseRecorderOptions& options) : recorder_(*this, options) {}

  /// The next event, nullopt if none comes for so long.
  std::optional<CaptureEvent> next(std::chrono::milliseconds patience);
  /// From any thread.
  void push(CaptureEvent event);
  /// Where the time went so far, whatever was dropped on the way. From any thread.
  [[nodiscard]] HoldLedger ledger() const;

  void onSkin(const SkinDescription& skin) override;
  void onFrame(const SampleFrame& frame) override { recorder_.addFrame(frame); }
  void onJoints(const JointReport& joints) override { recorder_.addJoints(joints); }
  void onStatus(const SourceStatus& status) override { push(status); }
  void onCommandOutcome(const CommandOutcome& outcome) override { push(outcome); }
  void onPoseCaptured(CapturedPose captured) override { push(std::move(captured)); }
  void onHold(const HoldStatus& status) override;
  void onPreview(SkinPreview /*preview*/) override {}

 private:
  [[nodiscard]] std::optional<LongWait> longWait(const HoldStatus& status);

  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<CaptureEvent> events_;
  HoldLedger ledger_;
  Blocker blocker_ = Blocker::None;
  double last_s_ = 0;       ///< device time
  LastingWait blocked_{5};  ///< device time
  PoseRecorder recorder_;
};

}  // namespace hexoderm::cli
