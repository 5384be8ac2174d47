#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hexoderm {

struct WireAddress {
  enum class Kind { Tcp, Udp, Serial };
  Kind kind = Kind::Tcp;
  std::string host;         ///< name or number; of a serial port its path
  std::uint16_t port = 0;   ///< Tcp and Udp
  unsigned baud = 115'200;  ///< Serial
};

/// "tcp://HOST:PORT", "udp://HOST:PORT" (an IPv6 number in brackets) or "serial:/dev/tty...[?baud=N]". Throws
/// InvalidArgument naming what was expected.
WireAddress parseWireAddress(std::string_view address);

}  // namespace hexoderm
