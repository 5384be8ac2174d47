#include "hexoderm/capture/pose_recorder.h"

#include "hexoderm/base/error.h"
#include "hexoderm/capture/capture_window.h"
#include "hexoderm/device/cell_index.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <mutex>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::uint32_t kUsualSamples = 100;  // as many as in the paper
constexpr std::uint32_t kMinSamples = 10;
constexpr double kConfirm_s = 0.1;
// Means of 100 ms in one hold differ by less, with default tremor: 3 sigma are 2.5 degrees.
constexpr double kMovedMeanwhile = 3 * kDegree;
constexpr double kClockReset_s = 0.5;  // back in time, not a gap
constexpr double kJointsKept_s = 20;   // no capture takes longer
constexpr double kJointsLast_s = 1;
constexpr std::size_t kMaxJointReports = 100'000;

std::int64_t systemClock_ms() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

/// Angle of gravity between two poses, median over their common cells; nullopt without any.
std::optional<double> angleBetweenPoses(const PoseCapture& a, const PoseCapture& b) {
  std::map<CellId, Eigen::Vector3d> of_a;
  for (const GravitySample& sample : a.samples) of_a.emplace(sample.cell, sample.mean_g);
  std::vector<double> angles;
  for (const GravitySample& sample : b.samples) {
    const auto other = of_a.find(sample.cell);
    if (other != of_a.end()) angles.push_back(angleBetweenReadings(sample.mean_g, other->second));
  }
  if (angles.empty()) return std::nullopt;
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>((angles.size() - 1) / 2);
  std::nth_element(angles.begin(), middle, angles.end());
  return *middle;
}

/// The mean of reports, of the joints that all of them name.
JointAngles meanOf(const std::vector<const JointReport*>& reports) {
  JointAngles mean = reports.front()->angles;
  for (std::size_t k = 1; k < reports.size(); ++k) {
    const auto& positions = reports[k]->angles.positions;
    std::erase_if(mean.positions, [&](const auto& joint) { return !positions.contains(joint.first); });
    for (auto& [name, position] : mean.positions) {
      position += (positions.at(name) - position) / static_cast<double>(k + 1);
    }
  }
  return mean;
}

CellId decidingCell(const Stillness& stillness) {
  switch (stillness.blocker) {
    case Blocker::Shaking:
      return stillness.excess_cell;
    case Blocker::CellTurning:
      return stillness.turning_cell;
    default:
      return {};
  }
}

}  // namespace

void PoseRecorderOptions::validate() const {
  stillness.validate();
  if (!(collect_s > 0 && collect_s <= 60))
    throw InvalidArgument(message("pose recorder: collect_s must be within 0 and 60"));
  if (!(repeat_angle_rad >= 0 && repeat_angle_rad <= kPi)) {
    throw InvalidArgument(message("pose recorder: repeat_angle_rad must be between 0 and pi"));
  }
}

struct PoseRecorder::State {
  using Command = std::function<void(State&)>;

  State(PoseRecorderListener& pose_listener, PoseRecorderOptions recorder_options)
      : listener(pose_listener),
        options((recorder_options.validate(), std::move(recorder_options))),
        accelerometer(),
        detector(accelerometer, options.stillness),
        automatic(options.automatic) {}

  PoseRecorderListener& listener;
  const PoseRecorderOptions options;
  std::mutex mutex;
  // Guarded by the mutex: what was asked for since the last frame, of what describes a state only the newest.
  std::vector<Command> commands;
  std::optional<PoseId> wanted_next_id;
  std::optional<std::vector<std::shared_ptr<const PoseCapture>>> wanted_earlier;
  // All others belong to the feeding thread.

  Accelerometer accelerometer;
  std::vector<CellId> described;
  StillnessDetector detector;
  bool automatic;
  bool asked = false;  ///< captureNow() was called and nothing has been captured since
  PoseId next_id{1};
  std::vector<std::shared_ptr<const PoseCapture>> earlier;
  std::optional<CaptureWindow> window;
  bool forced = false;
  std::map<CellId, double> temperatures_c;
  std::deque<JointReport> joints;  ///< of the last kJointsKept_s
  std::optional<double> last_s;
  std::optional<double> late_from_s, late_to_s;  ///< times of consecutive late frames; their own time increases
  std::uint64_t late_in_row = 0;
  std::uint64_t late_frames = 0;
  std::uint64_t tick = 0;  ///< number of distinct times so far
  CellIndex cells_noted;
  std::vector<std::uint64_t> samples_noted_in, means_noted_in;  ///< the tick in which each cell was last noted
  std::uint64_t restarts = 0;

  /// From any thread.
  void ask(Command command) {
    const std::lock_guard lock(mutex);
    commands.push_back(std::move(command));
  }
  void obey() {
    std::vector<Command> wanted;
    {
      const std::lock_guard lock(mutex);
      wanted.swap(commands);
      if (wanted_next_id) next_id = *std::exchange(wanted_next_id, std::nullopt);
      if (wanted_earlier) earlier = *std::exchange(wanted_earlier, std::nullopt);
    }
    for (const Command& command : wanted) command(*this);
    if (window && !forced && !automatic) window.reset();
  }
  /// Gives up the capture under way; another may be wanted at once.
  void startOver(bool is_asked) {
    window.reset();
    asked = is_asked;
  }

  void setSkin(const SkinDescription& skin) {
    const Accelerometer& now = skin.model->accelerometer;
    const bool is_same = now.rate_hz == accelerometer.rate_hz && now.lsb_g == accelerometer.lsb_g &&
                         now.noise_g_per_sqrt_hz == accelerometer.noise_g_per_sqrt_hz;
    if (is_same) {
      detector.restart();
    } else {
      detector = StillnessDetector(now, options.stillness);
    }
    accelerometer = now;
    described.clear();
    for (const CellReport& cell : skin.neighbors) {
      if (cell.id < skin.model->interface_id) described.push_back(cell.id);
    }
    std::ranges::sort(described);
    joints.clear();
    window.reset();
    last_s.reset();
    late_from_s.reset();
  }

  // ---- the clock

  bool isLate(const SampleFrame& frame) {
    const double time_s = frame.time_s;
    if (std::isfinite(time_s) && (!last_s || time_s > *last_s)) {
      beginTick(frame);
      return false;
    }
    // A tick of a large skin comes in several frames, each of other cells.
    if (last_s && time_s == *last_s && noteReadings(frame)) return false;
    ++late_frames;
    if (!std::isfinite(time_s)) return true;
    if (!late_from_s || time_s < *late_to_s) {
      late_from_s = time_s;
      late_in_row = 0;
    }
    ++late_in_row;
    late_to_s = time_s;
    if (*late_to_s - *late_from_s < kClockReset_s) return true;
    // They were not late: the clock has changed.
    late_frames -= late_in_row;
    window.reset();
    detector.restart();
    beginTick(frame);
    return false;
  }

  /// Returns false if a cell reads twice at one time.
  bool noteReadings(const SampleFrame& frame) {
    bool is_new = true;
    const auto note = [&](CellId cell, std::vector<std::uint64_t>& noted_in) {
      const std::size_t k = cells_noted.of(cell);
      if (k == CellIndex::kNone) return;
      if (k >= noted_in.size()) noted_in.resize(k + 1);
      if (std::exchange(noted_in[k], tick) == tick) is_new = false;
    };
    for (const CellSample& sample : frame.samples) note(sample.cell, samples_noted_in);
    for (const CellMean& mean : frame.means) note(mean.cell, means_noted_in);
    return is_new;
  }
  void beginTick(const SampleFrame& frame) {
    last_s = frame.time_s;
    late_from_s.reset();
    ++tick;
    noteReadings(frame);
  }

  void addJoints(const JointReport& report) {
    if (!joints.empty() && report.time_s < joints.back().time_s) joints.clear();  // the clock began anew
    joints.push_back(report);
    while (joints.size() > kMaxJointReports || joints.front().time_s < report.time_s - kJointsKept_s)
      joints.pop_front();
  }

  [[nodiscard]] JointAngles jointAngles(double start_s, double end_s) const {
    std::vector<const JointReport*> during;
    const JointReport* last = nullptr;
    for (const JointReport& report : joints) {
      if (report.time_s > end_s) break;
      if (report.time_s >= start_s) during.push_back(&report);
      if (report.time_s >= start_s - kJointsLast_s) last = &report;
    }
    if (during.empty() && last != nullptr) during.push_back(last);
    return during.empty() ? JointAngles() : meanOf(during);
  }

  // ---- the course of a capture

  void addFrame(const SampleFrame& frame) {
    obey();
    if (isLate(frame)) return;
    for (const CellTemperature& temperature : frame.temperatures) {
      if (std::isfinite(temperature.temperature_c)) temperatures_c[temperature.cell] = temperature.temperature_c;
    }
    if (asked && !window) begin(frame.time_s, true);
    const bool judged = detector.add(frame);
    // The frame that a forced capture begins with belongs to it.
    if (window) window->add(detector.newIn(frame));
    if (window && forced && window->isComplete()) {
      finish();
    } else if (judged) {
      proceed(frame.time_s);
    }
    if (!judged) return;
    listener.onHold(status());
    SkinPreview preview{detector.stillness().time_s, detector.recentMeans()};
    preview.temperatures.reserve(temperatures_c.size());
    for (const auto& [cell, temperature_c] : temperatures_c) preview.temperatures.push_back({cell, temperature_c});
    listener.onPreview(std::move(preview));
  }

  void begin(double time_s, bool is_forced) {
    forced = is_forced;
    std::vector<CellId> expected = detector.cellsHeard();
    if (expected.empty()) expected = described;
    window.emplace(time_s, samplesPerCell(), expected, options.keep_frames);
  }

  [[nodiscard]] std::uint32_t samplesPerCell() const {
    if (options.samples_per_cell > 0) return options.samples_per_cell;
    double rate_hz = accelerometer.rate_hz;
    const double seen_hz = detector.stillness().rate_hz;
    if (seen_hz > 0) rate_hz = std::min(rate_hz, seen_hz);
    const double most = std::clamp(std::round(rate_hz * options.collect_s), 1.0 * kMinSamples, 1.0 * kUsualSamples);
    return static_cast<std::uint32_t>(most);
  }

  void proceed(double time_s) {
    const Stillness& stillness = detector.stillness();
    if (window && !forced && !stillness.still) {
      window.reset();
      ++restarts;
    }
    if (window) {
      window->giveUpOn(time_s, detector.cellsHeard());
      if (!window->isComplete()) return;
      if (forced) {
        finish();
      } else if (stillness.time_s >= window->end_s() + kConfirm_s) {
        if (detector.angleFrom(PoseCapture{PoseId(0), {}, window->samples()}) < kMovedMeanwhile) {
          finish();
        } else {
          window.reset();
          ++restarts;
        }
      }
    } else if (automatic && stillness.ready()) {
      begin(time_s, false);
    }
  }

  void finish() {
    CapturedPose captured;
    auto pose = std::make_shared<PoseCapture>();
    pose->id = next_id;
    pose->samples = window->samples();
    for (GravitySample& sample : pose->samples) {
      const auto temperature = temperatures_c.find(sample.cell);
      if (temperature != temperatures_c.end()) sample.temperature_c = temperature->second;
    }
    pose->taken_at_ms = options.wall_clock_ms ? options.wall_clock_ms() : systemClock_ms();
    captured.forced = forced;
    captured.start_s = window->start_s();
    captured.end_s = window->end_s();
    captured.joint_angles = jointAngles(captured.start_s, captured.end_s);
    captured.odd_cells = detector.stillness().odd_cells;
    listMissing(*pose, captured);
    captured.frames = window->takeFrames();
    for (const auto& other : earlier) {
      const auto angle = angleBetweenPoses(*other, *pose);
      if (!angle || *angle >= options.repeat_angle_rad) continue;
      if (captured.repeats && *angle >= captured.repeat_angle_rad) continue;
      captured.repeats = other->id;
      captured.repeat_angle_rad = *angle;
    }
    window.reset();
    asked = false;
    next_id = PoseId(next_id.value() + 1);
    detector.disarm(*pose);
    captured.pose = std::move(pose);
    earlier.push_back(captured.pose);
    listener.onPoseCaptured(std::move(captured));
  }

  void listMissing(const PoseCapture& pose, CapturedPose& captured) const {
    const auto isIn = [&](CellId cell) {
      return std::ranges::binary_search(pose.samples, cell, {}, &GravitySample::cell);
    };
    for (const CellId cell : window->shortCells()) {
      (isIn(cell) ? captured.short_cells : captured.silent_cells).push_back(cell);
    }
    for (const OddCell& odd : captured.odd_cells) {
      if (odd.kind == OddCellKind::Silent && !isIn(odd.cell)) captured.silent_cells.push_back(odd.cell);
    }
    for (const CellId cell : described) {
      if (!isIn(cell)) captured.silent_cells.push_back(cell);
    }
    std::ranges::sort(captured.silent_cells);
    const auto twice = std::unique(captured.silent_cells.begin(), captured.silent_cells.end());
    captured.silent_cells.erase(twice, captured.silent_cells.end());
  }

  // ---- for people

  [[nodiscard]] HoldStatus status() const {
    HoldStatus status;
    status.stillness = detector.stillness();
    status.automatic = automatic;
    status.forced = window ? forced : asked;
    status.late_frames = late_frames;
    status.restarts = restarts;
    const Stillness& stillness = status.stillness;
    if (window) status.phase = window->isComplete() ? HoldPhase::Confirming : HoldPhase::Collecting;
    // The ring shows the time of waiting, of collecting and of confirming in one.
    const double rate_hz = stillness.rate_hz > 0 ? stillness.rate_hz : accelerometer.rate_hz;
    const double collect_s = samplesPerCell() / rate_hz;
    const double wait_s = forced && window ? 0 : stillness.window_s;
    const double confirm_s = forced && window ? 0 : kConfirm_s;
    double done_s = 0;
    if (window) {
      done_s = wait_s + collect_s * window->progress();
      if (window->isComplete()) done_s += std::min(confirm_s, std::max(0.0, stillness.time_s - window->end_s()));
    } else if (stillness.armed && automatic) {
      done_s = std::min(wait_s, stillness.steady_for_s);
    }
    status.progress = std::clamp(done_s / (wait_s + collect_s + confirm_s), 0.0, 1.0);
    if (window && forced) {
      status.message = message("Capturing what there is, moved or not");
    } else if (window) {
      status.message = message("Keep still: taking samples");
    } else if (!stillness.message.empty()) {
      status.message = stillness.message;
    } else {
      status.message = automatic ? message("Still") : message("Still: ready to capture");
    }
    return status;
  }
};

PoseRecorder::PoseRecorder(PoseRecorderListener& listener, PoseRecorderOptions options)
    : state_(std::make_unique<State>(listener, std::move(options))) {}
PoseRecorder::~PoseRecorder() = default;

void PoseRecorder::setSkin(const SkinDescription& skin) { state_->setSkin(skin); }
void PoseRecorder::addFrame(const SampleFrame& frame) { state_->addFrame(frame); }
void PoseRecorder::addJoints(const JointReport& joints) { state_->addJoints(joints); }

void PoseRecorder::setAutomatic(bool automatic) {
  state_->ask([automatic](State& state) { state.automatic = automatic; });
}
void PoseRecorder::captureNow() {
  state_->ask([](State& state) { state.startOver(true); });
}
void PoseRecorder::cancelCapture() {
  state_->ask([](State& state) { state.startOver(false); });
}
void PoseRecorder::setNextPoseId(PoseId id) {
  const std::lock_guard lock(state_->mutex);
  state_->wanted_next_id = id;
}
void PoseRecorder::setEarlierPoses(std::vector<std::shared_ptr<const PoseCapture>> poses) {
  const std::lock_guard lock(state_->mutex);
  state_->wanted_earlier = std::move(poses);
}

void StillnessStatistics::add(const HoldStatus& hold) {
  const Stillness& stillness = hold.stillness;
  const double step_s = last_ ? std::max(0.0, stillness.time_s - last_->stillness.time_s) : 0;
  last_ = hold;
  watched_s_ += step_s;
  if (hold.phase != HoldPhase::Watching || stillness.blocker == Blocker::None) {
    still_s_ += step_s;
    return;
  }
  Entry& entry = entries_[stillness.blocker];
  entry.duration_s += step_s;
  entry.message = stillness.message;
  const CellId cell = decidingCell(stillness);
  if (cell != CellId()) entry.cells_s[cell] += step_s;
}

std::vector<BlockedTime> StillnessStatistics::blocked() const {
  std::vector<BlockedTime> times;
  for (const auto& [blocker, entry] : entries_) {
    BlockedTime time{blocker, entry.duration_s, {}, 0, entry.message};
    for (const auto& [cell, duration_s] : entry.cells_s) {
      if (time.cell != CellId() && duration_s <= time.cell_s) continue;
      time.cell = cell;
      time.cell_s = duration_s;
    }
    times.push_back(std::move(time));
  }
  std::ranges::stable_sort(times, std::greater(), &BlockedTime::duration_s);
  return times;
}

}  // namespace hexoderm
