#include "hexoderm/base/error.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/device/skinwire/codec.h"
#include "hexoderm/device/sources/recording.h"
#include "hexoderm/device/sources/skin_stream.h"
#include "hexoderm/device/sources/threaded_source.h"

#include <cmath>

namespace hexoderm {
namespace {

/// Between the stream and the listener: counts frames, so that a step ends after one, although a message may have more.
class Gate final : public SkinListener {
 public:
  Gate(SkinListener& next, std::function<bool()> opens) : next_(next), opens_(std::move(opens)) {}
  void onSkin(const SkinDescription& skin) override { next_.onSkin(skin); }
  void onFrame(const SampleFrame& frame) override {
    if (opens_()) next_.onFrame(frame);
  }
  void onStatus(const SourceStatus& status) override { next_.onStatus(status); }
  void onCommandOutcome(const CommandOutcome& outcome) override { next_.onCommandOutcome(outcome); }
  void onDeviceStatus(const DeviceStatus& status) override { next_.onDeviceStatus(status); }
  void onJoints(const JointReport& joints) override { next_.onJoints(joints); }

 private:
  SkinListener& next_;
  std::function<bool()> opens_;
};

class Replay final : public ThreadedSource<ReplaySource> {
  using Clock = SkinStream::Clock;

 public:
  Replay(std::filesystem::path path, ReplayOptions options)
      : ThreadedSource("replay:" + path.string()), path_(std::move(path)), kept_(path_), options_(options) {
    if (!(options.speed > 0)) throw InvalidArgument(message("replay: speed: expected a number above 0"));
  }
  ~Replay() override { stop(); }

  void step(std::uint64_t frames) override {
    {
      const std::lock_guard lock(mutex_);
      steps_ += frames;
    }
    wake();
  }

 private:
  void open() override { reader_.emplace(path_); }

  /// Waits until `ready`, refusing commands meanwhile. False once the source is to stop.
  template <class Ready>
  bool wait(const Ready& ready, std::optional<Clock::time_point> until = std::nullopt) {
    while (!stop_.stop_requested()) {
      refuseCommands(message("a recording takes no commands"));
      std::unique_lock lock(mutex_);
      if (ready()) return true;
      const auto wakes = [&] { return !queue_.empty() || ready(); };
      if (!until) {
        changed_.wait(lock, stop_, wakes);
      } else if (!changed_.wait_until(lock, stop_, *until, wakes) && !stop_.stop_requested()) {
        return true;
      }
    }
    return false;
  }

  bool mayStep() {
    if (!options_.stepwise) return !stop_.stop_requested();
    if (!wait([this] { return steps_ > 0; })) return false;
    const std::lock_guard lock(mutex_);
    --steps_;
    return true;
  }

  void run() override {
    Gate gate(*listener_, [this] { return mayStep(); });
    SkinStream stream(gate);
    stream.setPace(ClockCheck::Pace::Free);
    const Clock::time_point began = Clock::now();
    const auto say = [&](SourceState state, const Message& what) {
      stream.report(state, located(address(), what), Clock::now());
    };
    say(SourceState::Waiting, message("playing"));
    const auto never = [] { return false; };
    while (const std::optional<RecordedBody> record = reader_->next()) {
      Clock::time_point due = Clock::now();
      if (!options_.stepwise && std::isfinite(options_.speed)) {
        const std::chrono::duration<double, std::micro> after(static_cast<double>(record->arrived.count()) /
                                                              options_.speed);
        // A speed of nearly nothing must not leave the clock's range.
        const auto longest = std::chrono::duration<double, std::micro>(std::chrono::hours(24 * 365));
        due = began + std::chrono::duration_cast<Clock::duration>(std::min(after, longest));
      }
      if (!wait(never, due)) break;
      // By the recording's own time, so that it is the same skin however fast it is played.
      if (stream.take(skinwire::decodeBody(record->body), began + record->arrived) ==
          SkinStream::Effect::Incompatible) {
        say(SourceState::Incompatible, stream.lastRejection());
        break;
      }
      if (stream.isDescribed()) {
        const Message device = stream.deviceText();
        say(SourceState::Streaming,
            device.empty() ? message("playing") : message("playing; the device said: {}", device));
      }
      stream.reportCounters(Clock::now());
    }
    if (stream.state() != SourceState::Incompatible && !stop_.stop_requested()) {
      stream.tend(Clock::time_point::max());
      if (reader_->damage().empty()) {
        say(SourceState::Ended, message("the recording is over"));
      } else {
        stream.report(SourceState::Ended, reader_->damage(), Clock::now());
      }
    }
    wait(never);
    say(SourceState::Stopped, message("stopped"));
  }

  std::filesystem::path path_;
  KeptFile kept_;  ///< a recording of what is played can't go into the same file
  ReplayOptions options_;
  std::optional<RecordingReader> reader_;
  std::uint64_t steps_ = 0;  ///< guarded: frames that may still be delivered
};

}  // namespace

std::unique_ptr<ReplaySource> replaySource(std::filesystem::path path, ReplayOptions options) {
  return std::make_unique<Replay>(std::move(path), options);
}

}  // namespace hexoderm
