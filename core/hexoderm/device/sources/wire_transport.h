#pragma once

// One connection, by Boost.Asio.

#include "hexoderm/device/skinwire/codec.h"

#include "hexoderm/base/message.h"

#include <boost/asio/io_context.hpp>

#include <cstdint>
#include <functional>
#include <memory>
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

/// Opens once and then lives until it is closed, or until the other end or the network ends it. Everything runs on the
/// io_context's thread; after close() no callback comes.
class WireTransport {
 public:
  struct Callbacks {
    std::function<void()> opened;
    std::function<void(skinwire::ByteView)> received;  ///< a piece of the stream, or a whole datagram
    std::function<void(const Message& why)> ended;     ///< could not be opened, or is over; comes once, then nothing
  };

  virtual ~WireTransport() = default;
  virtual void open() = 0;
  virtual void write(skinwire::Bytes bytes) = 0;
  virtual void close() = 0;
};

/// The io_context must outlive the transport; it is shared because a name that is being looked up when everything ends
/// comes back to it later.
std::shared_ptr<WireTransport> makeWireTransport(const std::shared_ptr<boost::asio::io_context>& io,
                                                 const WireAddress& address, WireTransport::Callbacks callbacks);

}  // namespace hexoderm
