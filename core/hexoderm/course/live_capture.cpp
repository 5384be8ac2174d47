#include "hexoderm/course/live_capture.h"

#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/device/sources/recording.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/session/session_recorder.h"
#include "hexoderm/util/error.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <utility>
#include <variant>

namespace hexoderm {
namespace {

PoseRecorderOptions recorderOptions(const LiveCaptureOptions& options) {
  PoseRecorderOptions recorder;
  recorder.keep_frames = options.keep_raw;
  return recorder;
}

CaptureCourseOptions courseOptions(const LiveCaptureOptions& options) {
  CaptureCourseOptions course;
  course.poses = options.poses;
  course.keep_raw = options.keep_raw;
  // The disk may have room again in a moment.
  course.retry_every = std::chrono::seconds(1);
  course.give_up_after = std::chrono::seconds(10);
  return course;
}

/// Before anything is connected. The file itself is made once a skin described itself.
void requireNewSession(const std::filesystem::path& file) {
  if (file.empty()) return;
  if (!file.string().ends_with(".hexo")) {
    throw InvalidArgument(message("expected a name that ends in .hexo, found \"{}\"", file.string()));
  }
  if (std::filesystem::exists(std::filesystem::symlink_status(file))) {
    throw StorageError(located(file.string(), message("exists already; a capture never replaces a session")));
  }
}

}  // namespace

/// What belongs to the threads of source, recorder and file is guarded by mutex_; the rest belongs to the thread that
/// holds turn_.
class LiveCapture::Run final : public CaptureOwner, public SkinListener, public PoseRecorderListener {
  using Clock = CaptureCourse::Clock;

 public:
  explicit Run(LiveCaptureOptions options)
      : options_(std::move(options)),
        recorder_(*this, recorderOptions(options_)),
        course_(*this, courseOptions(options_)) {
    if (!(options_.timeout_s > 0)) throw InvalidArgument("LiveCaptureOptions::timeout_s: expected seconds above 0");
    requireNewSession(options_.file);
    source_ = openSkinSource(options_.source);
    if (!options_.record_to.empty()) recording_.emplace(options_.record_to, static_cast<SkinListener&>(*this));
    source_->start(recording_ ? static_cast<SkinListener&>(*recording_) : *this);
  }
  ~Run() override {
    source_->stop();
    store_.reset();  // writes what waits
  }

  std::optional<CapturedPose> next(const std::stop_token& stop) {
    const std::lock_guard turn(turn_);
    last_progress_ = Clock::now();
    try {
      while (!is_ended_ && !is_closing_ && !stop.stop_requested()) {
        // A result of all poses goes with each of them.
        if (has_news_ && course_.waiting() == 0) solve(stop);
        show();
        if (!kept_.empty() && !has_news_) {
          const std::lock_guard lock(mutex_);
          state_.last = std::move(kept_.front());
          kept_.pop_front();
          return state_.last->captured;
        }
        if (course_.isFinished() || !lost_.empty() || !refused_.empty()) {
          end();
        } else if (!stop.stop_requested()) {
          waitForEvent();
        }
      }
    } catch (...) {
      is_ended_ = true;
      source_->stop();
      store_.reset();  // captured poses stay
      show();
      throw;
    }
    return std::nullopt;
  }

  void close() {
    is_closing_ = true;
    const std::lock_guard turn(turn_);
    end();
  }

  void turnToNextPose() {
    if (!state().session) {
      throw InvalidArgument(
          located(options_.source,
                  message("no skin has described itself yet; that is noticed while the next pose is waited for")));
    }
    if (!state().can_turn) {
      throw InvalidArgument(located(options_.source, message("this device does not turn by itself")));
    }
    push([this] { course_.turnToNextPose(); });
  }

  [[nodiscard]] LiveCaptureState state() const {
    const std::lock_guard lock(mutex_);
    LiveCaptureState state = state_;
    if (state.status.empty()) state.status = state.session ? hold_.message : status_.message;
    return state;
  }

 private:
  // On the threads of source, recorder and file:
  void push(std::function<void()> event) {
    {
      const std::lock_guard lock(mutex_);
      events_.push_back(std::move(event));
    }
    arrived_.notify_one();
  }
  void onSkin(const SkinDescription& skin) override {
    recorder_.setSkin(skin);
    push([this, skin] { session_ ? course_.describe(skin) : begin(skin); });
  }
  void onFrame(const SampleFrame& frame) override { recorder_.addFrame(frame); }
  void onJoints(const JointReport& joints) override { recorder_.addJoints(joints); }
  void onStatus(const SourceStatus& status) override {
    const std::lock_guard lock(mutex_);
    status_ = status;
  }
  void onCommandOutcome(const CommandOutcome& outcome) override {
    push([this, outcome] { course_.setOutcome(outcome); });
  }
  void onPoseCaptured(CapturedPose captured) override {
    push([this, captured = std::move(captured)] { course_.take(captured); });
  }
  void onHold(const HoldStatus& status) override {
    const std::lock_guard lock(mutex_);
    hold_ = status;
  }
  void onPreview(SkinPreview /*preview*/) override {}

  // On the thread of next():
  void begin(const SkinDescription& skin) {
    if (options_.automatic && !skin.can_turn) {
      throw DeviceError(
          located(source_->address(), message("auto needs a device that turns by itself, and this one can't")));
    }
    session_ = CaptureCourse::sessionOf(skin, source_->address());
    if (!options_.file.empty()) {
      store_ = std::make_unique<SessionRecorder>(SessionStore::create(options_.file, *session_));
    }
    course_.begin(*session_, skin);
    if (!store_) course_.setKeptIn(KeptIn::Memory);
    course_.setRobot(options_.automatic);
    nameTheSkin();
  }

  /// Labels come from the result without poses, so that they are the same for a recording however fast it is played.
  void nameTheSkin() {
    const Session without_poses(session_->model(), session_->neighbors());
    course_.setResult(reconstruct(*without_poses.snapshot()), false);
  }

  void perform(const std::vector<SessionEdit>& edits) override {
    for (const SessionEdit& edit : edits) {
      apply(edit, *session_);
      if (!store_) continue;
      SessionRecorder::Acknowledge done;
      if (const auto* add = std::get_if<AddPose>(&edit)) {
        done = [this, id = add->pose.capture->id](const StoreOutcome& outcome) {
          push([this, id, outcome] { course_.setStored(id, outcome); });
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
  void onCourseEvent(const CourseEvent& event) override {
    if (const auto* kept = std::get_if<PoseKept>(&event)) {
      kept_.push_back(*kept);
      has_news_ = true;
    } else if (const auto* pose = std::get_if<PoseLost>(&event)) {
      lost_ = pose->why;
    } else if (std::holds_alternative<SkinChanged>(event)) {
      nameTheSkin();
    } else if (const auto* wanted = std::get_if<AdviceWanted>(&event)) {
      if (wanted->question.seen == result_ && !course_.isFinished()) course_.setAdvice(adviseOn(wanted->question));
    } else if (const auto* turn = std::get_if<TurnRefused>(&event)) {
      if (turn->gave_up) refused_ = message("refused to turn {} times, the last time: {}", turn->times, turn->why);
    }
  }

  bool handleOne(std::chrono::milliseconds patience) {
    std::function<void()> event;
    SourceState state{};
    {
      std::unique_lock lock(mutex_);
      if (arrived_.wait_for(lock, patience, [this] { return !events_.empty(); })) {
        event = std::move(events_.front());
        events_.pop_front();
      }
      state = status_.state;
    }
    course_.setSending(state == SourceState::Streaming);
    if (!event) return false;
    event();
    return true;
  }

  void waitForEvent() {
    constexpr std::chrono::milliseconds kLookEvery(50);
    const bool is_event = handleOne(kLookEvery);
    if (is_event || course_.isFileRefused()) last_progress_ = Clock::now();
    course_.tick();
    const SourceStatus status = sourceStatus();
    if (!is_event && !has_news_ && status.state == SourceState::Ended && course_.waiting() == 0) return end();
    if (status.state == SourceState::Incompatible) throw DeviceError(located(source_->address(), status.message));
    if (Clock::now() - last_progress_ > std::chrono::duration<double>(options_.timeout_s) &&
        (!session_ || options_.automatic)) {
      const Seconds waited{options_.timeout_s, options_.timeout_s < 1 ? 1 : 0};
      throw DeviceError(located(source_->address(), session_ ? message("no pose for {}: {}", waited, whyNothingComes())
                                                             : message("the device did not describe itself for {}: {}",
                                                                       waited, whyNothingComes())));
    }
  }

  void solve(const std::stop_token& stop) {
    const std::shared_ptr<const Reconstruction> result = reconstruct(*session_->snapshot(), {}, result_.get(), stop);
    if (!result) return;  // it was stopped, and the next call solves them
    has_news_ = false;
    result_ = result;
    course_.setResult(result_, true);
  }

  void show() {
    const std::lock_guard lock(mutex_);
    state_.session = session_;
    state_.result = result_;
    state_.can_turn = course_.canTurn();
    state_.up.reset();
    state_.advice = {};
    state_.status = {};
    // What was advised before the last pose, and what the recorder waits for then, helps nobody any more.
    if (is_ended_ || course_.isFinished()) {
      const bool is_enough = course_.isFinished() && !course_.isFileRefused();
      if (session_) state_.status = is_enough ? message("There are enough poses.") : message("The capture is over.");
      return;
    }
    if (!course_.nextPose() || !result_ || !course_.wantsMorePoses()) return;
    state_.up = course_.nextPose()->up;
    state_.advice = adviceInWords(*course_.nextPose(), *result_);
  }

  [[nodiscard]] SourceStatus sourceStatus() const {
    const std::lock_guard lock(mutex_);
    return status_;
  }
  /// What the device does wrong goes before what is waited for.
  [[nodiscard]] Message whyNothingComes() const {
    const std::lock_guard lock(mutex_);
    if (!session_ && !status_.offences.empty()) return inWords(status_.offences.front());
    return session_ ? inRow({hold_.message, status_.message}, "; ") : status_.message;
  }

  void end() {
    if (std::exchange(is_ended_, true)) return;
    source_->stop();
    while (store_ && course_.waiting() > 0 && !course_.isFileRefused()) handleOne(std::chrono::milliseconds(100));
    store_.reset();  // tries for the last time
    while (handleOne(std::chrono::milliseconds(0))) continue;
    if (has_news_) solve({});
    show();
    if (recording_) recording_->finish();
    if (!lost_.empty()) throw StorageError(lost_);
    if (!refused_.empty()) throw DeviceError(located(source_->address(), refused_));
    if (!session_ && !is_closing_) {
      const bool is_wrong = !sourceStatus().offences.empty();
      throw DeviceError(located(
          options_.source,
          inRow({message("ended before a skin described itself"), is_wrong ? whyNothingComes() : Message()}, ". ")));
    }
  }

  LiveCaptureOptions options_;
  std::mutex turn_;
  std::atomic<bool> is_closing_{false};

  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<std::function<void()>> events_;
  SourceStatus status_;
  HoldStatus hold_;
  LiveCaptureState state_;

  PoseRecorder recorder_;
  std::unique_ptr<SkinSource> source_;
  std::optional<StreamRecorder> recording_;
  std::optional<Session> session_;
  std::unique_ptr<SessionRecorder> store_;
  CaptureCourse course_;
  std::shared_ptr<const Reconstruction> result_;
  std::deque<PoseKept> kept_;  ///< not given out yet
  bool has_news_ = false;      ///< poses that are not in the result
  bool is_ended_ = false;
  Clock::time_point last_progress_{};
  Message lost_;     ///< why a pose is not on disk and never will be
  Message refused_;  ///< why the device does not turn any more
};

LiveCapture::LiveCapture(LiveCaptureOptions options) : run_(std::make_unique<Run>(std::move(options))) {}
LiveCapture::~LiveCapture() = default;
std::optional<CapturedPose> LiveCapture::next(const std::stop_token& stop) { return run_->next(stop); }
void LiveCapture::turnToNextPose() { run_->turnToNextPose(); }
void LiveCapture::close() { run_->close(); }
LiveCaptureState LiveCapture::state() const { return run_->state(); }

}  // namespace hexoderm
