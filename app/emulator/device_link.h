#pragma once

#include "hexoderm/device/skinwire/framing.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

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
  [[nodiscard]] const std::string& address() const { return address_; }
  /// Longest body that should be sent, bytes.
  [[nodiscard]] std::size_t maxBody() const { return max_body_; }
  void start(Callbacks callbacks) {
    callbacks_ = std::move(callbacks);
    begin();
    watchLater();
  }
  [[nodiscard]] skinwire::Bytes framed(const skinwire::Message& message) const {
    return framing_ ? skinwire::encodeFrame(*framing_, message) : skinwire::encodeBody(message);
  }
  /// So much waits to be taken that samples had better be dropped.
  [[nodiscard]] virtual bool isFull() const = 0;
  /// False: there is no host, or the network does not take it.
  virtual bool send(skinwire::Bytes frame) = 0;
  /// Takes leave of the host; it may come again.
  virtual void disconnect() = 0;

 protected:
  /// Without framing, each body is a datagram.
  DeviceLink(boost::asio::io_context& io, std::optional<skinwire::Framing> framing, std::size_t max_body)
      : framing_(framing), max_body_(max_body), timer_(io) {}

  virtual void begin() = 0;
  virtual void watch() = 0;  ///< a look now and then at the host

  std::optional<skinwire::Framing> framing_;
  std::string address_;
  Callbacks callbacks_;

 private:
  void watchLater() {
    timer_.expires_after(std::chrono::milliseconds(250));
    timer_.async_wait([this](const boost::system::error_code& error) {
      if (error) return;
      watch();
      watchLater();
    });
  }

  std::size_t max_body_;
  boost::asio::steady_timer timer_;
};

/// All throw DeviceError if the wire can't be had. Port 0: any that is free.
std::unique_ptr<DeviceLink> listenTcp(boost::asio::io_context& io, const std::string& host, std::uint16_t port,
                                      skinwire::Framing framing);
std::unique_ptr<DeviceLink> listenUdp(boost::asio::io_context& io, const std::string& host, std::uint16_t port);
std::unique_ptr<DeviceLink> openPseudoTerminal(boost::asio::io_context& io);

}  // namespace hexoderm::emulator
