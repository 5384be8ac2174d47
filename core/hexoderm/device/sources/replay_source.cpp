#include "hexoderm/device/skinwire/codec.h"
#include "hexoderm/device/sources/recording.h"
#include "hexoderm/device/sources/skin_stream.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/kept_files.h"

#include <cmath>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace hexoderm {

void ReplayOptions::validate() const {
  if (!(speed > 0)) throw InvalidArgument(message("replay: speed: expected a number above 0"));
}

struct ReplaySource::Impl {
  /// Between the stream and the listener: counts frames, so that a step ends after one, although a message may have
  /// more.
  struct Gate final : SkinListener {
    Impl& impl;
    SkinListener& next;
    Gate(Impl& owner, SkinListener& listener) : impl(owner), next(listener) {}
    void onSkin(const SkinDescription& skin) override { next.onSkin(skin); }
    void onFrame(const SampleFrame& frame) override {
      if (impl.mayStep()) next.onFrame(frame);
    }
    void onStatus(const SourceStatus& status) override { next.onStatus(status); }
    void onCommandOutcome(const CommandOutcome& outcome) override { next.onCommandOutcome(outcome); }
    void onDeviceStatus(const DeviceStatus& status) override { next.onDeviceStatus(status); }
    void onJoints(const JointReport& joints) override { next.onJoints(joints); }
  };

  std::filesystem::path path;
  std::optional<KeptFile> kept;  ///< a recording of what is played can't go into the same file
  ReplayOptions options;
  std::optional<RecordingReader> reader;
  SkinListener* listener = nullptr;
  std::optional<Gate> gate;
  std::optional<SkinStream> stream;
  std::stop_token stop;
  std::mutex mutex;
  std::condition_variable_any changed;
  std::uint64_t steps = 0;              ///< guarded: frames that may still be delivered
  std::vector<std::uint32_t> commands;  ///< guarded: to be refused
  std::uint32_t next_command = 1;       ///< guarded
  std::jthread thread;                  ///< last: everything it uses exists before and after it

  /// Waits until `ready`, answering commands meanwhile. False once the source is to stop.
  template <class Ready>
  bool wait(const Ready& ready, std::optional<SkinStream::Clock::time_point> until = std::nullopt) {
    std::unique_lock lock(mutex);
    while (true) {
      if (stop.stop_requested()) return false;
      if (!commands.empty()) {
        std::vector<std::uint32_t> numbers;
        numbers.swap(commands);
        lock.unlock();
        for (const std::uint32_t number : numbers) {
          listener->onCommandOutcome({number, false, message("a recording takes no commands")});
        }
        lock.lock();
        continue;
      }
      if (ready()) return true;
      const auto wakes = [&] { return !commands.empty() || ready(); };
      if (!until) {
        changed.wait(lock, stop, wakes);
      } else if (!changed.wait_until(lock, stop, *until, wakes) && !stop.stop_requested()) {
        return true;
      }
    }
  }

  bool mayStep() {
    if (!options.stepwise) return !stop.stop_requested();
    if (!wait([this] { return steps > 0; })) return false;
    const std::lock_guard lock(mutex);
    --steps;
    return true;
  }

  void run() {
    using Clock = SkinStream::Clock;
    const Clock::time_point began = Clock::now();
    const std::string name = "replay:" + path.string();
    stream->report(SourceState::Waiting, located(name, message("playing")), began);
    const auto never = [] { return false; };
    while (const std::optional<RecordedBody> record = reader->next()) {
      Clock::time_point due = Clock::now();
      if (!options.stepwise && std::isfinite(options.speed)) {
        const std::chrono::duration<double, std::micro> after(static_cast<double>(record->arrived.count()) /
                                                              options.speed);
        // A speed of nearly nothing must not leave the clock's range.
        const auto longest = std::chrono::duration<double, std::micro>(std::chrono::hours(24 * 365));
        due = began + std::chrono::duration_cast<Clock::duration>(std::min(after, longest));
      }
      if (!wait(never, due)) break;
      // By the recording's own time, so that it is the same skin however fast it is played.
      if (stream->take(skinwire::decodeBody(record->body), began + record->arrived) ==
          SkinStream::Effect::Incompatible) {
        stream->report(SourceState::Incompatible, located(name, stream->lastRejection()), Clock::now());
        break;
      }
      if (stream->isDescribed()) {
        const Message device = stream->deviceText();
        stream->report(
            SourceState::Streaming,
            located(name, device.empty() ? message("playing") : message("playing; the device said: {}", device)),
            Clock::now());
      }
      stream->reportCounters(Clock::now());
    }
    if (stream->state() != SourceState::Incompatible && !stop.stop_requested()) {
      stream->tend(Clock::time_point::max());
      stream->report(SourceState::Ended,
                     reader->damage().empty() ? located(name, message("the recording is over")) : reader->damage(),
                     Clock::now());
    }
    wait(never);
    stream->report(SourceState::Stopped, located(name, message("stopped")), Clock::now());
  }
};

ReplaySource::ReplaySource(std::filesystem::path path, ReplayOptions options) : impl_(std::make_unique<Impl>()) {
  options.validate();
  impl_->path = std::move(path);
  impl_->kept.emplace(impl_->path);
  impl_->options = options;
}

ReplaySource::~ReplaySource() { stop(); }

void ReplaySource::start(SkinListener& listener) {
  if (impl_->listener != nullptr) throw InvalidArgument(address(), message("a source can be started only once"));
  impl_->reader.emplace(impl_->path);
  impl_->listener = &listener;
  impl_->gate.emplace(*impl_, listener);
  impl_->stream.emplace(*impl_->gate);
  impl_->stream->setPace(ClockCheck::Pace::Free);
  impl_->thread = std::jthread([impl = impl_.get()](std::stop_token stop) {
    impl->stop = std::move(stop);
    impl->run();
  });
}

void ReplaySource::stop() noexcept {
  if (!impl_->thread.joinable()) return;
  impl_->thread.request_stop();
  impl_->thread.join();
}

std::uint32_t ReplaySource::send(const SkinCommand& /*command*/) {
  std::uint32_t number = 0;
  {
    const std::lock_guard lock(impl_->mutex);
    number = impl_->next_command++;
    impl_->commands.push_back(number);
  }
  impl_->changed.notify_all();
  return number;
}

std::string ReplaySource::address() const { return "replay:" + impl_->path.string(); }

void ReplaySource::step(std::uint64_t frames) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->steps += frames;
  }
  impl_->changed.notify_all();
}

}  // namespace hexoderm
