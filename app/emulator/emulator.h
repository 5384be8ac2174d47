#pragma once

#include "app/emulator/device_link.h"
#include "hexoderm/sim/emulated_device.h"

#include <boost/asio/steady_timer.hpp>

#include <chrono>
#include <functional>
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
  Emulator(boost::asio::io_context& io, EmulatedDevice device, std::unique_ptr<DeviceLink> link, double speed);

  void start();
  void stop() { io_.stop(); }
  void disconnect() { link_->disconnect(); }
  [[nodiscard]] EmulatedDevice& device() { return device_; }
  [[nodiscard]] WireFaults& faults() { return faults_; }
  /// Runs an action on the device, and sends the messages that it leads to.
  void withDevice(const std::function<void(EmulatedDevice::Messages&)>& action);

 private:
  using Clock = std::chrono::steady_clock;

  void onTimer();
  void send();
  bool chance(double share);

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
};

}  // namespace hexoderm::emulator
