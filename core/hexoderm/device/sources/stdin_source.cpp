#include "hexoderm/device/sources/stdin_source.h"

#include "hexoderm/base/system_reason.h"
#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/device/sources/skin_stream.h"
#include "hexoderm/device/sources/threaded_source.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <optional>
#include <utility>

namespace hexoderm {
namespace {

constexpr int kTick_ms = 50;

// Not by Asio: it would make the descriptor non-blocking for every program that shares the terminal.
class StdinSource final : public ThreadedSource<> {
 public:
  StdinSource(int descriptor, std::chrono::milliseconds silent_after)
      : ThreadedSource("stdin"), descriptor_(descriptor), silent_after_(silent_after) {}
  ~StdinSource() override { stop(); }

 private:
  using Clock = SkinStream::Clock;

  void run() override {
    stream_.emplace(*listener_);
    stream_->setPace(ClockCheck::Pace::Faster);
    alive_ = Clock::now();
    while (!stop_.stop_requested()) {
      refuseCommands(message("standard input takes no commands"));
      if (!ended_) reportState();
      pollfd waited{ended_ ? -1 : descriptor_, POLLIN, 0};
      if (::poll(&waited, 1, kTick_ms) > 0) read();
    }
    refuseCommands(message("standard input takes no commands"));
    say(SourceState::Stopped, message("stopped"));
  }

  void say(SourceState state, const Message& what) { stream_->report(state, located(address(), what), Clock::now()); }

  void end(const Message& why) {
    ended_ = true;
    stream_->tend(Clock::time_point::max());
    say(SourceState::Ended, why);
  }

  void decode() {
    while (auto decoded = decoder_.next()) {
      const SkinStream::Effect effect = stream_->take(std::move(*decoded), Clock::now());
      if (effect == SkinStream::Effect::Alive) alive_ = Clock::now();
      if (effect == SkinStream::Effect::Incompatible) {
        ended_ = true;
        return say(SourceState::Incompatible, stream_->lastRejection());
      }
    }
    if (!decoder_.stuck().empty()) end(message("what came is broken: {}", decoder_.stuck()));
  }

  void read() {
    std::array<std::uint8_t, 65'536> buffer;
    const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) return;
    if (count < 0) return end(systemReason(errno));
    if (count > 0) {
      decoder_.feed(skinwire::ByteView(buffer.data(), static_cast<std::size_t>(count)));
      return decode();
    }
    // The last line may lack its line feed.
    const std::uint8_t line_feed = '\n';
    if (decoder_.framing() == skinwire::Framing::Lines) decoder_.feed({&line_feed, 1});
    decode();
    if (!ended_) end(message("the input is over"));
  }

  void reportState() {
    const auto now = Clock::now();
    stream_->tend(now);
    if (now - alive_ >= silent_after_) {
      say(SourceState::Silent, message("nothing comes"));
    } else {
      const bool is_described = stream_->isDescribed();
      const Message what = is_described ? message("connected to {}", stream_->deviceName())
                                        : message("waiting for the device, {}", stream_->whatIsMissing());
      say(is_described ? SourceState::Streaming : SourceState::Waiting, inRow({what, stream_->deviceText()}, ": "));
    }
    stream_->noteOnce(decoder_.complaintOfWaiting());
    stream_->reportCounters(now);
  }

  int descriptor_;
  std::chrono::milliseconds silent_after_;
  std::optional<SkinStream> stream_;
  skinwire::FrameDecoder decoder_{std::nullopt};
  Clock::time_point alive_;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<SkinSource> stdinSource(int descriptor, std::chrono::milliseconds silent_after) {
  return std::make_unique<StdinSource>(descriptor, silent_after);
}

}  // namespace hexoderm
