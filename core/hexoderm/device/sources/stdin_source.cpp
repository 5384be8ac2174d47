#include "hexoderm/device/sources/stdin_source.h"

#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/device/sources/skin_stream.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/system_reason.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

constexpr int kTick_ms = 50;

}  // namespace

// Not by Asio: it would make the descriptor non-blocking for every program that shares the terminal.
struct StdinSource::Impl {
  int descriptor = 0;
  std::chrono::milliseconds silent_after{};
  std::array<int, 2> wake{-1, -1};  ///< a pipe that ends the wait
  std::mutex mutex;
  std::vector<std::uint32_t> commands;
  std::uint32_t next_command = 1;
  bool stopping = false;
  SkinListener* listener = nullptr;
  std::optional<SkinStream> stream;
  skinwire::FrameDecoder decoder{std::nullopt};
  SkinStream::Clock::time_point alive;
  bool ended = false;
  std::thread thread;

  ~Impl() {
    for (const int end : wake) {
      if (end >= 0) ::close(end);
    }
  }

  void wakeUp() const {
    const char byte = 0;
    // A full pipe wakes as well.
    [[maybe_unused]] const ssize_t written = ::write(wake[1], &byte, 1);
  }

  void end(const Message& why) {
    ended = true;
    stream->tend(SkinStream::Clock::time_point::max());
    stream->report(SourceState::Ended, located("stdin", why), SkinStream::Clock::now());
  }

  void decode() {
    while (auto decoded = decoder.next()) {
      const SkinStream::Effect effect = stream->take(std::move(*decoded), SkinStream::Clock::now());
      if (effect == SkinStream::Effect::Alive) alive = SkinStream::Clock::now();
      if (effect == SkinStream::Effect::Incompatible) {
        ended = true;
        return stream->report(SourceState::Incompatible, located("stdin", stream->lastRejection()),
                              SkinStream::Clock::now());
      }
    }
    if (!decoder.stuck().empty()) end(message("what came is broken: {}", decoder.stuck()));
  }

  void read() {
    std::array<std::uint8_t, 65'536> buffer;
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) return;
    if (count < 0) return end(systemReason(errno));
    if (count > 0) {
      decoder.feed(skinwire::ByteView(buffer.data(), static_cast<std::size_t>(count)));
      return decode();
    }
    // The last line may lack its line feed.
    const std::uint8_t line_feed = '\n';
    if (decoder.framing() == skinwire::Framing::Lines) decoder.feed({&line_feed, 1});
    decode();
    if (!ended) end(message("the input is over"));
  }

  void reportState() {
    const auto now = SkinStream::Clock::now();
    stream->tend(now);
    if (now - alive >= silent_after) {
      stream->report(SourceState::Silent, located("stdin", message("nothing comes")), now);
    } else if (!stream->isDescribed()) {
      stream->report(
          SourceState::Waiting,
          located("stdin",
                  inRow({message("waiting for the device, {}", stream->whatIsMissing()), stream->deviceText()}, ": ")),
          now);
    } else {
      stream->report(
          SourceState::Streaming,
          located("stdin", inRow({message("connected to {}", stream->deviceName()), stream->deviceText()}, ": ")), now);
    }
    stream->noteOnce(decoder.complaintOfWaiting());
    stream->reportCounters(now);
  }

  /// False once the source is to stop.
  bool answerCommands() {
    std::vector<std::uint32_t> numbers;
    bool go_on = true;
    {
      const std::lock_guard lock(mutex);
      numbers.swap(commands);
      go_on = !stopping;
    }
    for (const std::uint32_t number : numbers) {
      listener->onCommandOutcome({number, false, message("standard input takes no commands")});
    }
    return go_on;
  }

  void run() {
    alive = SkinStream::Clock::now();
    while (answerCommands()) {
      if (!ended) reportState();
      std::array<pollfd, 2> waited{{{wake[0], POLLIN, 0}, {ended ? -1 : descriptor, POLLIN, 0}}};
      if (::poll(waited.data(), waited.size(), kTick_ms) < 0) continue;
      if (waited[0].revents != 0) {
        std::array<char, 64> bytes;
        [[maybe_unused]] const ssize_t count = ::read(wake[0], bytes.data(), bytes.size());
      }
      if (waited[1].revents != 0) read();
    }
    stream->report(SourceState::Stopped, located("stdin", message("stopped")), SkinStream::Clock::now());
  }
};

StdinSource::StdinSource(int descriptor, std::chrono::milliseconds silent_after) : impl_(std::make_unique<Impl>()) {
  impl_->descriptor = descriptor;
  impl_->silent_after = silent_after;
}

StdinSource::~StdinSource() { stop(); }

void StdinSource::start(SkinListener& listener) {
  if (impl_->stream) throw InvalidArgument("stdin", message("a source can be started only once"));
  if (::pipe2(impl_->wake.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    throw DeviceError("stdin", message("can't be read: {}", systemReason(errno)));
  }
  impl_->listener = &listener;
  impl_->stream.emplace(listener);
  impl_->stream->setPace(ClockCheck::Pace::Faster);
  impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
}

void StdinSource::stop() noexcept {
  if (!impl_->thread.joinable()) return;
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->stopping = true;
  }
  impl_->wakeUp();
  impl_->thread.join();
}

std::uint32_t StdinSource::send(const SkinCommand& /*command*/) {
  std::uint32_t number = 0;
  {
    const std::lock_guard lock(impl_->mutex);
    number = impl_->next_command++;
    impl_->commands.push_back(number);
  }
  if (impl_->thread.joinable()) impl_->wakeUp();
  return number;
}

std::string StdinSource::address() const { return "stdin"; }

}  // namespace hexoderm
