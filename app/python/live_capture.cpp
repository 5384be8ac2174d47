#include "app/python/live_capture.h"

#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/reconstruction/advice/pose_advisor.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include <chrono>
#include <filesystem>
#include <utility>
#include <variant>

namespace hexoderm::python {
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

std::vector<std::string> remarksOn(const PoseKept& kept) {
  const CapturedPose& captured = kept.captured;
  std::vector<std::string> remarks;
  if (!captured.silent_cells.empty()) remarks.push_back("silent " + listInWords(captured.silent_cells));
  if (captured.repeats) {
    remarks.push_back("it repeats pose " + toString(*captured.repeats) + " (" +
                      formatFixed(toDegrees(captured.repeat_angle_rad), 1) + "°)");
  }
  for (const OddCell& odd : captured.odd_cells) remarks.push_back(describe(odd).english());
  if (!kept.without_raw.empty()) remarks.push_back("kept without its raw samples: " + kept.without_raw.english());
  return remarks;
}

/// Before anything is connected. The file itself is made once a skin described itself.
void requireNewSession(const std::string& output) {
  if (output.empty()) return;
  if (!output.ends_with(".hexo")) {
    throw InvalidArgument("output: expected a name that ends in .hexo, found \"" + output + "\"");
  }
  if (std::filesystem::exists(std::filesystem::symlink_status(output))) {
    throw StorageError(output + ": exists already; a capture never replaces a session");
  }
}

}  // namespace

LiveCapture::LiveCapture(LiveCaptureOptions options)
    : options_(std::move(options)),
      recorder_(*this, recorderOptions(options_)),
      course_(*this, courseOptions(options_)) {
  if (!(options_.timeout_s > 0)) throw InvalidArgument("timeout: expected seconds above 0");
  requireNewSession(options_.output);
  source_ = openSkinSource(options_.source);
  if (!options_.recording.empty()) recording_.emplace(options_.recording, static_cast<SkinListener&>(*this));
  source_->start(recording_ ? static_cast<SkinListener&>(*recording_) : *this);
}

LiveCapture::~LiveCapture() {
  source_->stop();
  store_.reset();  // writes what waits
}

void LiveCapture::push(std::function<void()> event) {
  {
    const std::lock_guard lock(mutex_);
    events_.push_back(std::move(event));
  }
  arrived_.notify_one();
}

void LiveCapture::onSkin(const SkinDescription& skin) {
  recorder_.setSkin(skin);
  push([this, skin] { session_ ? course_.describe(skin) : begin(skin); });
}

void LiveCapture::onPoseCaptured(CapturedPose captured) {
  push([this, captured = std::move(captured)] { course_.take(captured); });
}

void LiveCapture::onCommandOutcome(const CommandOutcome& outcome) {
  push([this, outcome] { course_.setOutcome(outcome); });
}

void LiveCapture::onStatus(const SourceStatus& status) {
  const std::lock_guard lock(mutex_);
  status_ = status;
}

void LiveCapture::onHold(const HoldStatus& status) {
  const std::lock_guard lock(mutex_);
  hold_ = status;
}

void LiveCapture::begin(const SkinDescription& skin) {
  if (options_.automatic && !skin.can_turn) {
    throw DeviceError(source_->address() + ": auto needs a device that turns by itself, and this one can't");
  }
  session_ = CaptureCourse::sessionOf(skin, source_->address());
  if (!options_.output.empty()) {
    store_ = std::make_unique<SessionRecorder>(SessionStore::create(options_.output, *session_));
  }
  course_.begin(*session_, skin);
  if (!store_) course_.setKeptIn(KeptIn::Memory);
  course_.setRobot(options_.automatic);
  nameTheSkin();
}

/// Labels come from the result without poses, so that they are the same for a recording however fast it is played.
void LiveCapture::nameTheSkin() {
  const Session without_poses(session_->model(), session_->neighbors());
  course_.setResult(reconstruct(*without_poses.snapshot()), false);
}

void LiveCapture::perform(const std::vector<SessionEdit>& edits) {
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

void LiveCapture::retryWriting() {
  if (store_) store_->retry();
}

void LiveCapture::onCourseEvent(const CourseEvent& event) {
  if (const auto* kept = std::get_if<PoseKept>(&event)) {
    kept_.push_back({kept->captured, remarksOn(*kept)});
    has_news_ = true;
  } else if (const auto* pose = std::get_if<PoseLost>(&event)) {
    lost_ = pose->why;
  } else if (std::holds_alternative<SkinChanged>(event)) {
    nameTheSkin();
  } else if (const auto* wanted = std::get_if<AdviceWanted>(&event)) {
    if (wanted->question.seen == result_ && !course_.isFinished()) course_.setAdvice(adviseOn(wanted->question));
  } else if (const auto* turn = std::get_if<TurnRefused>(&event)) {
    if (turn->gave_up) {
      refused_ = source_->address() + ": refused to turn " + std::to_string(turn->times) +
                 " times, the last time: " + turn->why.english();
    }
  }
}

bool LiveCapture::handleOne(std::chrono::milliseconds patience) {
  std::function<void()> event;
  {
    std::unique_lock lock(mutex_);
    if (arrived_.wait_for(lock, patience, [this] { return !events_.empty(); })) {
      event = std::move(events_.front());
      events_.pop_front();
    }
  }
  course_.setSending(status().state == SourceState::Streaming);
  if (!event) return false;
  event();
  made_progress_ = true;
  return true;
}

void LiveCapture::solve(const std::stop_token& stop) {
  const auto result = reconstruct(*session_->snapshot(), {}, result_.get(), stop);
  if (!result) return;  // stopped: the next call solves them
  has_news_ = false;
  result_ = result;
  course_.setResult(result_, true);
}

void LiveCapture::show() {
  const std::lock_guard lock(mutex_);
  shown_.session = session_;
  shown_.result = result_;
  shown_.can_turn = course_.canTurn();
  shown_.up_o.reset();
  shown_.advice = {};
  if (!course_.nextPose() || !result_) return;
  shown_.up_o = course_.nextPose()->up;
  shown_.advice = adviceInWords(*course_.nextPose(), *result_);
}

SourceStatus LiveCapture::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

Message LiveCapture::whyNothingComes() const {
  const std::lock_guard lock(mutex_);
  if (!session_ && !status_.offences.empty()) return inWords(status_.offences.front());
  return session_ ? hold_.message : status_.message;
}

std::optional<LiveCapture::Kept> LiveCapture::next(const std::stop_token& stop) {
  const std::lock_guard turn(turn_);
  constexpr std::chrono::milliseconds kLookEvery(50);
  const auto patience = std::chrono::duration<double>(options_.timeout_s);
  Clock::time_point last_progress = Clock::now();
  try {
    while (!is_ended_ && !is_closing_ && !stop.stop_requested()) {
      // A result of all poses goes with each of them.
      if (has_news_ && course_.waiting() == 0) solve(stop);
      show();
      if (!kept_.empty() && !has_news_) {
        Kept kept = std::move(kept_.front());
        kept_.pop_front();
        const std::lock_guard lock(mutex_);
        shown_.remarks = kept.remarks;
        return kept;
      }
      if (stop.stop_requested()) break;
      if (isOver()) return end(), std::nullopt;
      const bool is_event = handleOne(kLookEvery);
      if (std::exchange(made_progress_, false) || course_.isFileRefused()) last_progress = Clock::now();
      course_.tick();
      const SourceStatus source = status();
      if (!is_event && !has_news_ && source.state == SourceState::Ended && course_.waiting() == 0) {
        return end(), std::nullopt;
      }
      if (source.state == SourceState::Incompatible) throw DeviceError(located(source_->address(), source.message));
      if (Clock::now() - last_progress > patience && (!session_ || options_.automatic)) {
        throw DeviceError(source_->address() + ": nothing for " + formatFixed(options_.timeout_s, 0) + " s. " +
                          whyNothingComes().english());
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

void LiveCapture::end() {
  if (std::exchange(is_ended_, true)) return;
  source_->stop();
  while (store_ && course_.waiting() > 0 && !course_.isFileRefused()) handleOne(std::chrono::milliseconds(100));
  store_.reset();  // tries for the last time
  while (handleOne(std::chrono::milliseconds(0))) continue;
  if (has_news_) solve({});
  show();
  if (recording_) recording_->finish();
  if (!lost_.empty()) throw StorageError(lost_);
  if (!refused_.empty()) throw DeviceError(refused_);
  if (!session_ && !is_closing_) {
    throw DeviceError(options_.source + ": ended before a skin described itself" +
                      (status().offences.empty() ? "" : ". " + whyNothingComes().english()));
  }
}

void LiveCapture::close() {
  is_closing_ = true;
  const std::lock_guard turn(turn_);
  end();
}

void LiveCapture::turnToNextPose() {
  if (!shown().can_turn) throw InvalidArgument(options_.source + ": this device does not turn by itself");
  push([this] { course_.turnToNextPose(); });
}

LiveCapture::Shown LiveCapture::shown() const {
  const std::lock_guard lock(mutex_);
  Shown shown = shown_;
  shown.status = shown.session ? hold_.message : status_.message;
  return shown;
}

}  // namespace hexoderm::python
