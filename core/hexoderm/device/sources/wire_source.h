#pragma once

#include "hexoderm/device/skin_source.h"

#include <chrono>
#include <memory>
#include <string>

namespace hexoderm {

/// How patient a host is with its device.
struct WireOptions {
  std::chrono::milliseconds first_retry{250};  ///< wait before the first new try; doubles with each that fails
  std::chrono::milliseconds longest_retry{5000};
  std::chrono::milliseconds silent_after{kSilentAfter};  ///< nothing that makes sense for so long: Silent
  std::chrono::milliseconds reconnect_after{3000};       ///< ... for so long: the connection is made anew
  std::chrono::milliseconds describe_every{1000};        ///< how often the device is asked, where it has to be
  std::chrono::milliseconds command_timeout{3000};       ///< without an Ack
  std::chrono::milliseconds repeat_command{400};         ///< over UDP, until there is an Ack
  std::chrono::milliseconds repeat_working{1000};        ///< ... of which the last one may be lost like any other

  /// Throws InvalidArgument naming the option: everything above 0, and ends not before beginnings.
  void validate() const;
};

/// A skin that speaks SkinWire 1 (core/hexoderm/device/skinwire/README.md) on TCP, UDP, a serial port or a
/// pseudo-terminal: "tcp://HOST:PORT" (frames of bytes or lines of JSON, whichever the device begins with),
/// "udp://HOST:PORT" or "serial:/dev/tty...[?baud=N]". It keeps trying for as long as it runs; only another major
/// version of the protocol ends that (Incompatible). Broken messages are counted, named in the status and left out.
/// Throws InvalidArgument naming what was expected.
std::unique_ptr<SkinSource> wireSource(const std::string& address, WireOptions options = {});

}  // namespace hexoderm
