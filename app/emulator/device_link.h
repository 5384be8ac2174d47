#pragma once

#include "hexoderm/device/skinwire/framing.h"

#include <boost/asio/io_context.hpp>

#include <functional>
#include <memory>
#include <string>

namespace hexoderm::emulator {

/// The device's end of a wire. One host at a time; all of it on the io_context's thread, and nothing in it waits.
class DeviceLink {
 public:
  struct Callbacks {
    std::function<void()> host_came;  ///< it knows nothing yet
    std::function<void()> host_gone;
    std::function<void(const skinwire::Command&)> commanded;
  };

  virtual ~DeviceLink() = default;
  /// The address, for people and for the host: "tcp://127.0.0.1:7700".
  [[nodiscard]] virtual std::string address() const = 0;
  /// Longest body that should be sent, bytes.
  [[nodiscard]] virtual std::size_t maxBody() const = 0;
  virtual void start(Callbacks callbacks) = 0;
  [[nodiscard]] virtual skinwire::Bytes framed(const skinwire::Message& message) const = 0;
  /// So much waits to be taken that samples had better be dropped.
  [[nodiscard]] virtual bool isFull() const = 0;
  /// False: there is no host, or the network does not take it.
  virtual bool send(skinwire::Bytes frame) = 0;
  /// Takes leave of the host; it may come again.
  virtual void disconnect() = 0;
};

/// All throw DeviceError if the wire can't be had. Port 0: any that is free.
std::unique_ptr<DeviceLink> listenTcp(boost::asio::io_context& io, const std::string& host, std::uint16_t port,
                                      skinwire::Framing framing);
std::unique_ptr<DeviceLink> listenUdp(boost::asio::io_context& io, const std::string& host, std::uint16_t port);
std::unique_ptr<DeviceLink> openPseudoTerminal(boost::asio::io_context& io);

}  // namespace hexoderm::emulator
