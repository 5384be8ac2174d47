#pragma once

#include "app/emulator/device_link.h"
#include "hexoderm/sim/emulated_device.h"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <random>

namespace hexoderm::emulator {

/// Faults of the wire, switched while it runs.
struct WireFaults {
  double drop_share = 0;    ///< share of the messages of samples
  double garble_share = 0;  ///< share of all messages
  bool is_silent = false;
};

/// Lets an emulated device tick in real time, or `speed` times as fast, and puts it on a wire. If the host or this
/// computer is too slow, samples are dropped and counted; the device's clock goes on.
class Emulator {
 public:
  Emulator(boost::asio::io_context& io, EmulatedDevice device, std::unique_ptr<DeviceLink> link, double speed)
      : io_(io), device_(std::move(device)), link_(std::move(link)), speed_(speed), timer_(io) {}

  void start() {
    link_->start({[this] { withDevice([&](EmulatedDevice::Messages& out) { device_.greet(out); }); },
                  [this] { device_.forgetHost(); },
                  [this](const skinwire::Command& command) {
                    withDevice([&](EmulatedDevice::Messages& out) { device_.take(command, out); });
                  }});
    began_ = Clock::now();
    onTimer();
  }

  void stop() { io_.stop(); }
  void disconnect() { link_->disconnect(); }
  [[nodiscard]] EmulatedDevice& device() { return device_; }
  [[nodiscard]] WireFaults& faults() { return faults_; }

  /// Runs an action on the device, and sends the messages that it leads to.
  void withDevice(const std::function<void(EmulatedDevice::Messages&)>& action) {
    action(messages_);
    send();
  }

 private:
  using Clock = std::chrono::steady_clock;

  void onTimer() {
    const Clock::time_point now = Clock::now();
    const double tick_s = device_.tick_s() / speed_;
    const double due = std::chrono::duration<double>(now - began_).count() / tick_s;
    if (due - ticks_done_ > kTooFarBehind_s / tick_s) {
      const auto late = static_cast<std::size_t>(due - ticks_done_);
      device_.skip(late, messages_);
      ticks_done_ += static_cast<double>(late);
      send();
    }
    while (ticks_done_ + 1 <= due && Clock::now() - now < kLongestWork) {
      const std::size_t together = device_.ticksPerMessage();
      const bool must_hurry = due - ticks_done_ > kMuchBehind_s / tick_s && !device_.isExploring();
      for (std::size_t k = 0; k < together && ticks_done_ + 1 <= due; ++k, ++ticks_done_) device_.tick(messages_);
      if (must_hurry) {
        device_.skip(together, messages_);
        ticks_done_ += static_cast<double>(together);
      }
      if (!messages_.empty()) send();
    }
    if (ticks_done_ + 1 <= due) return boost::asio::post(io_, [this] { onTimer(); });
    timer_.expires_after(kPause);
    timer_.async_wait([this](const boost::system::error_code& error) {
      if (!error) onTimer();
    });
  }

  void send() {
    // A status behind them in the queue was made when the samples dropped here still counted as sent.
    std::uint64_t dropped = 0;
    const auto drop = [&](const skinwire::Samples& samples) {
      device_.countDropped(samples);
      dropped += samples.ticks() * samples.cells.size();
    };
    // Sending may end the connection, which calls back.
    for (skinwire::Message& message : std::exchange(messages_, {})) {
      const auto* samples = std::get_if<skinwire::Samples>(&message);
      if (auto* status = std::get_if<skinwire::Status>(&message)) {
        status->samples_sent -= std::min(status->samples_sent, dropped);
        status->samples_dropped += dropped;
      }
      if (faults_.is_silent || (samples != nullptr && chance(faults_.drop_share))) continue;
      if (samples != nullptr && link_->isFull()) {
        drop(*samples);
        continue;
      }
      skinwire::Bytes frame = link_->framed(message);
      if (chance(faults_.garble_share)) {
        frame[random_() % frame.size()] ^= static_cast<std::uint8_t>(1U << (random_() % 8));
      }
      if (!link_->send(std::move(frame)) && samples != nullptr) drop(*samples);
    }
  }

  bool chance(double share) { return share > 0 && static_cast<double>(random_() >> 11U) * 0x1p-53 < share; }

  boost::asio::io_context& io_;
  EmulatedDevice device_;
  std::unique_ptr<DeviceLink> link_;
  double speed_;
  WireFaults faults_;
  std::mt19937_64 random_;
  boost::asio::steady_timer timer_;
  Clock::time_point began_{};
  double ticks_done_ = 0;
  EmulatedDevice::Messages messages_;

  static constexpr std::chrono::milliseconds kPause{1};
  static constexpr std::chrono::milliseconds kLongestWork{10};  // then the wire is looked at
  // Seconds of the wall clock. A computer that was busy elsewhere for a moment may catch up; one that is too slow
  // leaves out the samples of every second message; one that stood still goes on with the present.
  static constexpr double kMuchBehind_s = 0.3;
  static constexpr double kTooFarBehind_s = 1;
};

}  // namespace hexoderm::emulator
