#pragma once

// A source at the host's end of a wire, and what tests wait for at it.

#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/core/device/sources/loopback_device.h"
#include "tests/core/device/sources/wire_host.h"

namespace hexoderm::wire_source_test {

using skinwire::Framing;
using std::chrono::milliseconds;
using Delivered = CollectingListener::Delivered;

/// Everything in a tenth of the time, for tests that wait for time-outs.
inline WireOptions quick() {
  return {milliseconds(10),  milliseconds(100), milliseconds(150),
          milliseconds(300), milliseconds(50),  milliseconds(300)};
}

/// Runs a test of timing with more and more patience, until `passes(options)`; false if no patience helps. A computer
/// that stands still for a moment looks like a device that does.
template <class Test>
bool passesWithPatience(const Test& passes) {
  for (const int times : {1, 5, 25}) {
    WireOptions options = quick();
    options.silent_after *= times;
    options.reconnect_after *= times;
    options.command_timeout *= times;
    if (passes(options)) return true;
  }
  return false;
}

/// A device, and a source that was started at its address; the source goes first.
template <class Device>
struct DeviceAndSource {
  Device device;
  CollectingListener listener;
  std::unique_ptr<SkinSource> source;

  DeviceAndSource(const WireOptions& options, const std::string& query)
      : source(wireSource(device.address() + query, options)) {
    source->start(listener);
  }
};

template <class Device>
DeviceAndSource<Device> started(const WireOptions& options = patient(), const std::string& query = "") {
  return {options, query};
}

template <class Device>
void describe(Device& device) {
  device.send(skinwire::helloMessage());
  device.send(skinwire::topologyMessage());
}

inline DeviceConnection described(TcpDevice& device, Framing framing = Framing::Length) {
  DeviceConnection connection = device.accept(framing);
  describe(connection);
  return connection;
}
/// As a device does on a wire on which nobody connects.
template <class Device>
void describeWhenAsked(Device& device) {
  device.receive();
  describe(device);
}

inline auto frames(std::size_t count) {
  return [count](const Delivered& d) { return d.frames.size() >= count; };
}
/// It has been so: it may have changed again before a busy computer looks.
inline auto state(SourceState wanted) {
  return [wanted](const Delivered& d) { return d.sawState(wanted); };
}
inline auto status(SourceState wanted, std::string text) {
  return [wanted, text = std::move(text)](const Delivered& d) { return d.saw(wanted, text); };
}
inline auto outcome(std::uint32_t command) {
  return [command](const Delivered& d) { return d.outcomeOf(command) != nullptr; };
}

}  // namespace hexoderm::wire_source_test
