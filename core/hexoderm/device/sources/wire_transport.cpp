#include "hexoderm/device/sources/wire_transport.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/system_reason.h"
#include "hexoderm/base/text.h"
#include "hexoderm/device/sources/write_queue.h"

#include <termios.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/serial_port.hpp>

#include <algorithm>
#include <array>
#include <thread>
#include <type_traits>
#include <vector>

namespace hexoderm {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using skinwire::Bytes;
using skinwire::ByteView;

Message reasonOf(const error_code& error) {
  if (error == asio::error::host_not_found) return message("Host not found (authoritative)");
  return systemReason(error);
}

/// Those that Linux has a name for and Boost.Asio knows, from 1,200 on.
constexpr std::array<unsigned, 19> kBaudRates = {
    1200,    2400,    4800,    9600,      19'200,    38'400,    57'600,    115'200,   230'400,  460'800,
    500'000, 576'000, 921'600, 1'000'000, 1'152'000, 2'000'000, 3'000'000, 3'500'000, 4'000'000};

[[noreturn]] void fail(std::string_view address, const Message& expected) {
  throw InvalidArgument(message("source \"{}\": expected {}", address, expected));
}

WireAddress parseNetwork(std::string_view address, std::string_view rest, WireAddress::Kind kind) {
  const Message expected =
      message("{}, the port from 1 to 65535 (for example {})",
              kind == WireAddress::Kind::Tcp ? "tcp://HOST:PORT" : "udp://HOST:PORT", "tcp://localhost:7700");
  const std::size_t colon = rest.rfind(':');
  if (colon == std::string_view::npos) fail(address, expected);
  std::string_view host = rest.substr(0, colon);
  const bool in_brackets = host.starts_with('[') && host.ends_with(']');
  if (in_brackets) host = host.substr(1, host.size() - 2);
  if (host.empty() || host.find_first_of("/ []") != std::string_view::npos ||
      (!in_brackets && host.find(':') != std::string_view::npos)) {
    fail(address, expected);
  }
  WireAddress parsed;
  parsed.kind = kind;
  parsed.host = host;
  unsigned port = 0;
  try {
    port = parseUnsigned(rest.substr(colon + 1), "port");
  } catch (const InvalidArgument&) {
    fail(address, expected);
  }
  if (port < 1 || port > UINT16_MAX) fail(address, expected);
  parsed.port = static_cast<std::uint16_t>(port);
  return parsed;
}

WireAddress parseSerial(std::string_view address, std::string_view rest) {
  const Message expected =
      message("{} or {} (for example {})", "serial:/dev/DEVICE", "serial:/dev/DEVICE?baud=N", "serial:/dev/ttyUSB0");
  const std::size_t query = rest.find('?');
  WireAddress parsed;
  parsed.kind = WireAddress::Kind::Serial;
  parsed.host = rest.substr(0, query);
  if (!parsed.host.starts_with('/')) fail(address, expected);
  if (query != std::string_view::npos) {
    constexpr std::string_view kBaud = "baud=";
    const std::string_view option = rest.substr(query + 1);
    if (!option.starts_with(kBaud)) fail(address, expected);
    try {
      parsed.baud = parseUnsigned(option.substr(kBaud.size()), "baud");
    } catch (const InvalidArgument&) {
      fail(address, expected);
    }
    if (std::ranges::find(kBaudRates, parsed.baud) == kBaudRates.end()) {
      fail(address,
           message("one of the baud rates {}", std::vector<std::uint64_t>(kBaudRates.begin(), kBaudRates.end())));
    }
  }
  return parsed;
}

/// Common to all wires: callbacks that stop with close(), and the queue of what is to be written.
template <class Channel>
class ChannelTransport : public WireTransport, public std::enable_shared_from_this<ChannelTransport<Channel>> {
 public:
  ChannelTransport(asio::io_context& io, Callbacks callbacks)
      : channel_(io),
        queue_(channel_, [this](const error_code& error) { end(reasonOf(error)); }),
        callbacks_(std::move(callbacks)) {}

  void write(Bytes bytes) final { queue_.push(std::move(bytes), this->shared_from_this()); }

  void close() final {
    if (closed_) return;
    closed_ = true;
    queue_.close();
    closeChannel();
  }

 protected:
  virtual void closeChannel() {
    error_code ignored;
    channel_.close(ignored);
  }

  void opened() {
    callbacks_.opened();
    if (!closed_) startReading();
  }

  void end(const Message& why) {
    if (closed_) return;
    close();
    callbacks_.ended(why);
  }

  [[nodiscard]] bool isClosed() const { return closed_; }

  Channel channel_;

 private:
  void startReading() {
    auto handler = [this, self = this->shared_from_this()](const error_code& error, std::size_t size) {
      received(error, size);
    };
    if constexpr (std::is_same_v<Channel, asio::serial_port>) {
      channel_.async_read_some(asio::buffer(buffer_), std::move(handler));
    } else {
      channel_.async_receive(asio::buffer(buffer_), std::move(handler));
    }
  }

  void received(const error_code& error, std::size_t size) {
    if (closed_) return;
    if (error) return end(error == asio::error::eof ? message("the device closed the connection") : reasonOf(error));
    callbacks_.received(ByteView(buffer_.data(), size));
    if (!closed_) startReading();
  }

  std::vector<std::uint8_t> buffer_ = std::vector<std::uint8_t>(65'536);
  WriteQueue<Channel> queue_;
  Callbacks callbacks_;
  bool closed_ = false;
};

template <class Protocol>
using Endpoints = std::vector<typename Protocol::endpoint>;

/// Looks a host up without ever holding up the io_context's thread. Asio's own resolver would be waited for at the end,
/// which takes as long as a name server that does not answer.
template <class Protocol>
void resolve(const std::shared_ptr<asio::io_context>& io, const WireAddress& address,
             std::function<void(error_code, Endpoints<Protocol>)> done) {
  error_code error;
  const asio::ip::address number = asio::ip::make_address(address.host, error);
  if (!error) {
    asio::post(*io, [done = std::move(done), endpoint = typename Protocol::endpoint(number, address.port)] {
      done({}, {endpoint});
    });
    return;
  }
  std::thread([io, address, done = std::move(done)]() mutable {
    asio::io_context own;
    typename Protocol::resolver resolver(own);
    error_code failure;
    Endpoints<Protocol> endpoints;
    for (const auto& entry : resolver.resolve(address.host, std::to_string(address.port), failure)) {
      endpoints.push_back(entry.endpoint());
    }
    asio::post(*io, [done = std::move(done), failure, endpoints = std::move(endpoints)] { done(failure, endpoints); });
  }).detach();
}

void prepare(asio::ip::tcp::socket& socket) {
  error_code ignored;
  socket.set_option(asio::ip::tcp::no_delay(true), ignored);
}

void prepare(asio::ip::udp::socket& socket) {
  constexpr int kReceiveBuffer = 4 << 20;  // some ten milliseconds of a large skin
  error_code ignored;
  socket.set_option(asio::socket_base::receive_buffer_size(kReceiveBuffer), ignored);
}

/// UDP is connected too, so that datagrams of others are not received and a port where nobody listens is an error.
template <class Protocol>
class NetworkTransport final : public ChannelTransport<typename Protocol::socket> {
 public:
  NetworkTransport(const std::shared_ptr<asio::io_context>& io, WireAddress address, WireTransport::Callbacks callbacks)
      : ChannelTransport<typename Protocol::socket>(*io, std::move(callbacks)), io_(io), address_(std::move(address)) {}

  void open() override {
    const auto io = io_.lock();
    if (!io) return;
    resolve<Protocol>(io, address_, [weak = this->weak_from_this(), this](error_code error, const auto& endpoints) {
      const auto self = weak.lock();
      if (!self || this->isClosed()) return;
      if (error) return this->end(message("the host is not known: {}", reasonOf(error)));
      asio::async_connect(this->channel_, endpoints, [this, self](const error_code& failure, const auto&) {
        if (this->isClosed()) return;
        if (failure) return this->end(reasonOf(failure));
        prepare(this->channel_);
        this->opened();
      });
    });
  }

 private:
  std::weak_ptr<asio::io_context> io_;
  WireAddress address_;
};

class SerialTransport final : public ChannelTransport<asio::serial_port> {
 public:
  SerialTransport(const std::shared_ptr<asio::io_context>& io, WireAddress address, Callbacks callbacks)
      : ChannelTransport(*io, std::move(callbacks)), address_(std::move(address)) {}

  void open() override {
    error_code error;
    channel_.open(address_.host, error);
    using Port = asio::serial_port_base;
    if (!error) channel_.set_option(Port::baud_rate(address_.baud), error);
    if (!error) channel_.set_option(Port::character_size(8), error);
    if (!error) channel_.set_option(Port::parity(Port::parity::none), error);
    if (!error) channel_.set_option(Port::stop_bits(Port::stop_bits::one), error);
    if (!error) channel_.set_option(Port::flow_control(Port::flow_control::none), error);
    // Not from within open(): the caller is still at it.
    asio::post(channel_.get_executor(), [this, self = shared_from_this(), error] {
      if (isClosed()) return;
      if (error) return end(reasonOf(error));
      opened();
    });
  }

 protected:
  void closeChannel() override {
    // Closing would wait for bytes that the device does not take.
    if (channel_.is_open()) ::tcflush(channel_.native_handle(), TCIOFLUSH);
    ChannelTransport::closeChannel();
  }

 private:
  WireAddress address_;
};

}  // namespace

WireAddress parseWireAddress(std::string_view address) {
  constexpr std::string_view kTcp = "tcp://";
  constexpr std::string_view kUdp = "udp://";
  constexpr std::string_view kSerial = "serial:";
  if (address.starts_with(kTcp)) return parseNetwork(address, address.substr(kTcp.size()), WireAddress::Kind::Tcp);
  if (address.starts_with(kUdp)) return parseNetwork(address, address.substr(kUdp.size()), WireAddress::Kind::Udp);
  if (address.starts_with(kSerial)) return parseSerial(address, address.substr(kSerial.size()));
  fail(address, message("tcp://HOST:PORT, udp://HOST:PORT or serial:/dev/DEVICE"));
}

std::shared_ptr<WireTransport> makeWireTransport(const std::shared_ptr<asio::io_context>& io,
                                                 const WireAddress& address, WireTransport::Callbacks callbacks) {
  switch (address.kind) {
    case WireAddress::Kind::Tcp:
      return std::make_shared<NetworkTransport<asio::ip::tcp>>(io, address, std::move(callbacks));
    case WireAddress::Kind::Udp:
      return std::make_shared<NetworkTransport<asio::ip::udp>>(io, address, std::move(callbacks));
    case WireAddress::Kind::Serial:
      return std::make_shared<SerialTransport>(io, address, std::move(callbacks));
  }
  return nullptr;
}

}  // namespace hexoderm
