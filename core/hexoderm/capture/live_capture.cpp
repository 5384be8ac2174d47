#include "hexoderm/capture/live_capture.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/system_reason.h"
#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/device/sources/recording.h"
#include "hexoderm/session/session_recorder.h"
#include "hexoderm/solve/reconstructor.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

/// Before anything is connected. The file itself is made once a skin described itself.
void requireNewSession(const std::filesystem::path& file) {
  if (file.empty()) return;
  if (!file.string().ends_with(".hexo")) {
    throw InvalidArgument(message("expected a name that ends in .hexo, found \"{}\"", file.string()));
  }
  std::error_code error;
  const auto there = std::filesystem::symlink_status(file, error).type();
  if (there == std::filesystem::file_type::none) {
    throw StorageError(file.string(), message("cannot be written: {}", systemReason(error)));
  }
  if (there != std::filesystem::file_type::not_found) {
    throw StorageError(file.string(), message("exists already; a capture never replaces a session"));
  }
}

/// How long something is waited for, in seconds of whichever clock: that is said after a while and then ever more
/// rarely.
struct LastingWait {
  double first_s;
  double since_s = 0;
  double say_after_s = first_s;

  /// What was waited for came.
  void begin(double now_s) { *this = {first_s, now_s}; }
  /// Seconds, where it is time to say so.
  std::optional<double> toBeSaid(double now_s) {
    const double waited_s = now_s - since_s;
    if (waited_s < say_after_s) return std::nullopt;
    say_after_s = 2 * waited_s;
    return waited_s;
  }
};

}  // namespace

/// What belongs to the threads of source, recorder and file is guarded by mutex_; the rest belongs to the thread that
/// holds turn_.
class LiveCapture::Run final : public CaptureOwner, public SkinListener, public PoseRecorderListener {
  using Clock = CaptureWorkflow::Clock;

 public:
  Run(LiveCaptureOptions options, std::unique_ptr<SkinSource> source, Listener listener)
      : options_(std::move(options)),
        tell_(std::move(listener)),
        recorder_(*this, {.keep_frames = options_.keep_raw}),
        source_(std::move(source)),
        // The disk may have room again in a moment.
        course_(*this, {.poses = options_.poses,
                        .keep_raw = options_.keep_raw,
                        .retry_every = std::chrono::seconds(1),
                        .give_up_after = std::chrono::seconds(10)}) {
    if (!(options_.timeout_s > 0)) throw InvalidArgument("LiveCaptureOptions::timeout_s: expected seconds above 0");
    requireNewSession(options_.file);
    if (!options_.record_to.empty()) recording_.emplace(options_.record_to, static_cast<SkinListener&>(*this));
  }
  void start() { source_->start(recording_ ? static_cast<SkinListener&>(*recording_) : *this); }
  ~Run() override {
    source_->stop();
    store_.reset();  // writes what waits
  }

  std::optional<CapturedPose> next(const std::stop_token& stop, const std::stop_token& stop_solving) {
    const std::lock_guard turn(turn_);
    stop_solving_ = stop_solving;
    last_progress_ = Clock::now();
    try {
      while (!is_ended_ && !is_closing_ && !stop.stop_requested()) {
        if (session_ && !is_named_) nameTheSkin();
        // A result of all poses goes with each of them.
        if (has_news_ && course_.waiting() == 0) solve();
        if (!kept_.empty() && !has_news_) {
          const std::lock_guard lock(mutex_);
          state_.last = std::move(kept_.front());
          kept_.pop_front();
          return state_.last->captured;
        }
        if (course_.isFinished() || !lost_.empty()) {
          end();
        } else if (!stop.stop_requested()) {
          waitForEvent();
        }
      }
    } catch (const std::exception& failure) {
      const Message not_stored = endAfterFailure();
      if (not_stored.empty()) throw;
      throw StorageError(inRow({messageOf(failure), not_stored}, "; "));  // a lost pose is the worse of the two
    } catch (...) {
      endAfterFailure();
      throw;
    }
    return std::nullopt;
  }

  void close(const std::stop_token& stop_solving) {
    is_closing_ = true;
    const std::lock_guard turn(turn_);
    stop_solving_ = stop_solving;
    end();
  }

  void turnToNextPose() {
    if (!state().session) {
      throw InvalidArgument(
          options_.source,
          message("no skin has described itself yet; that is noticed while the next pose is waited for"));
    }
    if (!state().can_turn) throw InvalidArgument(options_.source, message("this device does not turn by itself"));
    push(Kind::Other, [this] { course_.turnToNextPose(); });
  }

  [[nodiscard]] LiveCaptureState state() const {
    const std::lock_guard lock(mutex_);
    LiveCaptureState state = state_;
    if (!state.status.empty()) return state;
    if (!state.session) state.status = connection_;
    if (state.session && state.holds.last()) state.status = state.holds.last()->message;
    return state;
  }

 private:
  /// Progress is what the device is given time for.
  enum class Kind { Hold, Status, Stored, Progress, Other };
  /// What happened, and how the thread of next() deals with it.
  struct Arrival {
    Kind kind = Kind::Other;
    std::function<void()> handle{};
    [[nodiscard]] bool isState() const { return kind == Kind::Hold || kind == Kind::Status; }
  };

  // On the threads of source, recorder and file:
  /// Only the newest of the hold states and of the source states is kept, until something else arrives.
  void push(Kind kind, std::function<void()> handle) {
    {
      const std::lock_guard lock(mutex_);
      Arrival arrival{kind, std::move(handle)};
      const auto last = std::find_if(arrivals_.rbegin(), arrivals_.rend(), [&](const Arrival& earlier) {
        return earlier.kind == kind || !earlier.isState();
      });
      if (arrival.isState() && last != arrivals_.rend() && last->isState()) {
        *last = std::move(arrival);
      } else {
        arrivals_.push_back(std::move(arrival));
      }
    }
    arrived_.notify_one();
  }
  void onSkin(const SkinDescription& skin) override {
    recorder_.setSkin(skin);
    push(Kind::Progress, [this, skin] {
      tell_(skin);
      session_ ? course_.describe(skin) : begin(skin);
    });
  }
  void onFrame(const SampleFrame& frame) override { recorder_.addFrame(frame); }
  void onJoints(const JointReport& joints) override { recorder_.addJoints(joints); }
  void onStatus(const SourceStatus& status) override {
    {
      const std::lock_guard lock(mutex_);
      connection_ = status.message;
    }
    push(Kind::Status, [this, status] { handle(status); });
  }
  void onCommandOutcome(const CommandOutcome& outcome) override {
    // A device that answers nothing is no progress, however often it is asked.
    push(outcome.done ? Kind::Progress : Kind::Other, [this, outcome] { course_.setOutcome(outcome); });
  }
  void onPoseCaptured(CapturedPose captured) override {
    push(Kind::Progress, [this, captured = std::move(captured)] { course_.take(captured); });
  }
  void onHold(const HoldStatus& status) override {
    {
      const std::lock_guard lock(mutex_);
      state_.holds.add(status);
    }
    push(Kind::Hold, [this, status] { tell_(status); });
    if (const std::optional<double> blocked_s = longBlocked(status)) {
      push(Kind::Other, [this, wait = NoPose{*blocked_s, status.stillness.message}] { tell_(wait); });
    }
  }
  void onPreview(SkinPreview /*preview*/) override {}

  /// For how long the same obstacle has kept a capture from starting, where it is time to say so.
  std::optional<double> longBlocked(const HoldStatus& status) {
    const Stillness& stillness = status.stillness;
    // That the part is to be moved after a capture is no obstacle.
    const bool is_blocked = status.phase == HoldPhase::Watching && stillness.blocker != Blocker::NotMoved;
    const Blocker blocker = is_blocked ? stillness.blocker : Blocker::None;
    const bool is_set_back = stillness.time_s < std::exchange(last_s_, stillness.time_s);
    if (std::exchange(blocker_, blocker) != blocker || blocker == Blocker::None || is_set_back) {
      blocked_.begin(stillness.time_s);
      return std::nullopt;
    }
    return blocked_.toBeSaid(stillness.time_s);
  }

  // On the thread of next():
  void begin(const SkinDescription& skin) {
    if (options_.automatic && !skin.can_turn) {
      throw DeviceError(source_->address(), message("auto needs a device that turns by itself, and this one can't"));
    }
    session_ = CaptureWorkflow::sessionOf(skin, source_->address());
    if (!options_.file.empty()) {
      store_ = std::make_unique<SessionRecorder>(SessionStore::create(options_.file, *session_));
      made_ = identityOf(options_.file);
    }
    device_ = skin.device;
    tell_(CaptureBegun{skin});
    course_.begin(*session_, skin);
    if (!store_) course_.setKeptIn(KeptIn::Memory);
    course_.setRobot(options_.automatic);
  }

  void handle(const SourceStatus& status) {
    if (status.frames != state_.source.frames) readings_.begin(hostTime_s());
    {
      const std::lock_guard lock(mutex_);
      state_.source = status;
    }
    tell_(status);
    course_.setSending(status.state == SourceState::Streaming);
  }

  /// Labels come from the result without poses, so that they are the same for a recording however fast it is played.
  void nameTheSkin() {
    const Session without_poses(session_->model(), session_->neighbors());
    const auto result = reconstruct(*without_poses.snapshot(), {}, nullptr, stop_solving_);
    is_named_ = result != nullptr;
    if (is_named_) course_.setResult(result, false);
    last_progress_ = Clock::now();
  }

  void perform(const std::vector<SessionEdit>& edits) override {
    for (const SessionEdit& edit : edits) {
      apply(edit, *session_);
      if (!store_) continue;
      SessionRecorder::Acknowledge done;
      if (const auto* add = std::get_if<AddPose>(&edit)) {
        done = [this, id = add->pose.capture->id](const StoreOutcome& outcome) {
          push(Kind::Stored, [this, id, outcome] { course_.setStored(id, outcome); });
        };
      }
      store_->append({edit}, std::move(done));
    }
    course_.noteChange();
  }
  std::uint32_t send(const SkinCommand& command) override { return source_->send(command); }
  void retryWriting() override {
    if (store_) store_->retry();
  }
  void onWorkflowEvent(const WorkflowEvent& event) override {
    if (const auto* refused = std::get_if<FileRefused>(&event)) {
      refusal_ = refused->why;
      if (is_ended_) return;  // nobody tries again
    }
    tell_(event);
    if (const auto* kept = std::get_if<PoseKept>(&event)) {
      kept_.push_back(*kept);
      has_news_ = true;
      last_refusal_ = {};
      refusal_ = {};
    } else if (const auto* pose = std::get_if<PoseLost>(&event)) {
      lost_.push_back(pose->pose);
      if (refusal_.empty()) refusal_ = pose->why;
    } else if (std::holds_alternative<SkinChanged>(event)) {
      is_named_ = false;
    } else if (const auto* wanted = std::get_if<AdviceWanted>(&event)) {
      if (wanted->question.seen == result_ && !course_.isFinished()) course_.setAdvice(adviseOn(wanted->question));
    } else if (std::holds_alternative<AdviceChanged>(event)) {
      if (course_.nextPose()) tell_(PoseAdvised{adviceText(*course_.nextPose(), *result_)});
    } else if (const auto* turn = std::get_if<TurnRefused>(&event)) {
      last_refusal_ = message("The device does not turn there: {}", turn->why);
      if (!turn->gave_up) return;
      throw DeviceError(source_->address(),
                        message("refused to turn {} times, the last time: {}", turn->times, turn->why));
    }
  }

  std::optional<Kind> handleOne(std::chrono::milliseconds patience) {
    Arrival arrival;
    {
      std::unique_lock lock(mutex_);
      if (!arrived_.wait_for(lock, patience, [this] { return !arrivals_.empty(); })) return std::nullopt;
      arrival = std::move(arrivals_.front());
      arrivals_.pop_front();
    }
    // At the end it only matters what became of the poses that were taken.
    if (!is_ended_ || arrival.kind == Kind::Stored) arrival.handle();
    if (!arrival.isState()) show();
    return arrival.kind;
  }

  void waitForEvent() {
    constexpr std::chrono::milliseconds kLookEvery(50);
    const std::optional<Kind> event = handleOne(kLookEvery);
    if (event == Kind::Progress || event == Kind::Stored || course_.isFileRefused()) last_progress_ = Clock::now();
    course_.tick();
    tellOfRecording();
    const SourceStatus& status = state_.source;
    if (!event) lookForReadings();  // after a long solution news wait that come first
    if (!event && !has_news_ && status.state == SourceState::Ended && course_.waiting() == 0) return end();
    if (status.state == SourceState::Incompatible) throw DeviceError(source_->address(), status.message);
    if (Clock::now() - last_progress_ > std::chrono::duration<double>(options_.timeout_s) &&
        (!session_ || options_.automatic)) {
      const Seconds waited{options_.timeout_s, options_.timeout_s < 1 ? 1 : 0};
      throw DeviceError(source_->address(),
                        session_ ? message("no pose for {}: {}", waited, whyNothingComes())
                                 : message("the device did not describe itself for {}: {}", waited, whyNothingComes()));
    }
  }

  static double hostTime_s() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

  /// What the device says of it is in the state's text. Where it is not connected, that has been said.
  void lookForReadings() {
    if (!session_ || state_.source.state != SourceState::Streaming) return readings_.begin(hostTime_s());
    const std::optional<double> waited_s = readings_.toBeSaid(hostTime_s());
    if (waited_s) tell_(NoReadings{*waited_s, state_.source.message});
  }

  void solve() {
    has_news_ = false;  // also where it throws
    const std::shared_ptr<const Reconstruction> result =
        reconstruct(*session_->snapshot(), {}, result_.get(), stop_solving_);
    has_news_ = result == nullptr;  // it was stopped, and the next call solves them
    if (has_news_) return;
    result_ = result;
    course_.setResult(result_, true);
    show();
  }

  void show() {
    const std::lock_guard lock(mutex_);
    state_.device = device_;
    state_.session = session_;
    state_.result = result_;
    state_.can_turn = course_.canTurn();
    state_.up.reset();
    state_.advice = {};
    state_.status = {};
    // What was advised before the last pose, and what the recorder waits for then, helps nobody any more.
    if (is_ended_ || course_.isFinished()) {
      const bool is_enough = course_.isFinished() && !course_.isFileRefused();
      state_.status = !session_   ? inRow({message("ended before a skin described itself"), firstViolation()}, ". ")
                      : is_enough ? message("There are enough poses.")
                                  : message("The capture is over.");
      return;
    }
    if (!course_.nextPose() || !result_ || !course_.wantsMorePoses()) return;
    state_.up = course_.nextPose()->up;
    state_.advice = adviceText(*course_.nextPose(), *result_);
  }

  [[nodiscard]] Message firstViolation() const {
    return state_.source.offences.empty() ? Message() : inWords(state_.source.offences.front());
  }
  /// What the device does wrong goes before what is waited for.
  [[nodiscard]] Message whyNothingComes() const {
    const SourceStatus& status = state_.source;
    if (session_) return inRow({state().status, last_refusal_, status.message}, "; ");
    return status.offences.empty() ? status.message : firstViolation();
  }

  /// Waits until all that was captured is on disk.
  void finish() {
    if (std::exchange(is_ended_, true)) return;
    source_->stop();
    if (store_) {
      store_->flush(
          [this](const StoreOutcome& outcome) { push(Kind::Stored, [this, outcome] { setFlushed(outcome); }); });
    }
    while (store_ && !is_flushed_ && !course_.isFileRefused()) handleOne(std::chrono::milliseconds(100));
    store_.reset();  // tries for the last time
    while (handleOne(std::chrono::milliseconds(0))) continue;
    try {
      if (has_news_) solve();
    } catch (...) {
      if (!lost_.empty()) failForLostPoses();  // which is worse
      throw;
    }
    if (has_news_) result_.reset();  // it was stopped
    show();
    if (!lost_.empty()) failForLostPoses();
    if (!not_flushed_.empty()) throw StorageError(not_flushed_);
  }

  /// What became of the file after the last pose, or of one that has no poses.
  void setFlushed(const StoreOutcome& outcome) {
    is_flushed_ = true;
    if (!outcome.renewed.empty()) tell_(WorkflowEvent(FileRenewed{outcome.renewed}));
    if (outcome.error.empty()) {
      not_flushed_ = {};
    } else if (not_flushed_.empty()) {
      not_flushed_ = outcome.error;  // the last one only says that nobody tries again
    }
  }

  [[noreturn]] void failForLostPoses() {
    const std::size_t stored = session_->poses().size() - lost_.size();
    // A file without poses helps nobody, and would be in the way of the next capture.
    if (stored == 0 && made_ && identityOf(options_.file) == made_) removeSessionStore(options_.file);
    throw StorageError(
        inRow({refusal_,
               lost_.size() == 1 ? message("pose {} is not stored", lost_.front())
                                 : message("poses {} are not stored", lost_),
               stored == 1 ? message("1 pose was stored before") : message("{} poses were stored before", stored)},
              "; "));
  }

  /// Once.
  void tellOfRecording() {
    if (!recording_ || is_recording_over_) return;
    const Message why = recording_->error();
    if (why.empty()) return;
    is_recording_over_ = true;
    tell_(RecordingEnded{why});
  }

  void setRecordingError(const Message& why) {
    const std::lock_guard lock(mutex_);
    state_.recording_error = why;
  }

  /// Returns why not all was recorded, which is told; empty if it was.
  Message finishRecording(bool after_failure) {
    if (!recording_) return {};
    try {
      recording_->finish();
    } catch (const StorageError&) {
      if (!after_failure) setRecordingError(recording_->error());
      tellOfRecording();
    }
    return recording_->error();
  }

  /// Captured poses stay where something else failed, which is what is thrown. Returns which are not stored, and why.
  Message endAfterFailure() {
    Message not_stored;
    try {
      finish();
    } catch (const StorageError& error) {
      not_stored = error.message();
    } catch (...) {  // by the listener, which was told of the failure before
    }
    try {
      finishRecording(true);
    } catch (...) {  // likewise
    }
    return not_stored;
  }

  void end() {
    if (is_ended_) return;
    finish();
    if (const Message why = finishRecording(false); !why.empty()) throw StorageError(why);
    if (!session_ && !is_closing_) throw DeviceError(options_.source, state_.status);
  }

  LiveCaptureOptions options_;
  Listener tell_;
  std::mutex turn_;
  std::atomic<bool> is_closing_{false};

  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<Arrival> arrivals_;
  Message connection_;      ///< the newest state of the source
  LiveCaptureState state_;  ///< but for `holds` only the thread that holds turn_ changes it

  // Of the source's thread:
  Blocker blocker_ = Blocker::None;
  double last_s_ = 0;       ///< device time
  LastingWait blocked_{5};  ///< device time

  PoseRecorder recorder_;
  std::unique_ptr<SkinSource> source_;
  std::optional<StreamRecorder> recording_;
  Message device_;
  std::optional<Session> session_;
  std::unique_ptr<SessionRecorder> store_;
  CaptureWorkflow course_;
  std::shared_ptr<const Reconstruction> result_;
  std::deque<PoseKept> kept_;  ///< not given out yet
  std::stop_token stop_solving_;
  bool is_named_ = false;  ///< the course knows what poses of the skin are labelled by
  bool has_news_ = false;  ///< poses that are not in the result
  bool is_ended_ = false;
  Clock::time_point last_progress_{};
  LastingWait readings_{3, hostTime_s()};
  std::optional<FileIdentity> made_;  ///< the file
  std::vector<PoseId> lost_;          ///< those that are not on disk and never will be
  Message refusal_;                   ///< why the file can't be written; empty since a pose was
  bool is_flushed_ = false;           ///< or could not be
  Message not_flushed_;               ///< why not all is in the file at the end
  bool is_recording_over_ = false;    ///< before its time, and that was told
  Message last_refusal_;              ///< of a turn, since the last pose
};

LiveCapture::LiveCapture(LiveCaptureOptions options)
    : LiveCapture(options, openSkinSource(options.source), [](const LiveCaptureEvent& /*event*/) {}) {
  start();
}
LiveCapture::LiveCapture(LiveCaptureOptions options, std::unique_ptr<SkinSource> source, Listener listener)
    : run_(std::make_unique<Run>(std::move(options), std::move(source), std::move(listener))) {}
LiveCapture::~LiveCapture() = default;
void LiveCapture::start() { run_->start(); }
std::optional<CapturedPose> LiveCapture::next(const std::stop_token& stop, const std::stop_token& stop_solving) {
  return run_->next(stop, stop_solving);
}
void LiveCapture::turnToNextPose() { run_->turnToNextPose(); }
void LiveCapture::close(const std::stop_token& stop_solving) { run_->close(stop_solving); }
LiveCaptureState LiveCapture::state() const { return run_->state(); }

}  // namespace hexoderm
