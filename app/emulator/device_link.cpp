#include "app/emulator/device_link.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/temporary_file.h"
#include "hexoderm/device/sources/write_queue.h"

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>

#include <array>
#include <cerrno>
#include <cstring>

namespace hexoderm::emulator {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using asio::ip::udp;
using boost::system::error_code;
using skinwire::Bytes;
using skinwire::ByteView;
using Clock = std::chrono::steady_clock;

// A host that falls back this far gets no samples until it has caught up, and is left if it falls back further.
constexpr std::size_t kFullBytes = 1U << 20U;
constexpr std::size_t kMaxBytes = 64U << 20U;
constexpr std::chrono::seconds kUdpHostLives(5);
constexpr std::chrono::seconds kStalledHostLives(3);

/// A stream of bytes in both directions, from when it is open until it is closed.
template <class Channel>
class Stream : public std::enable_shared_from_this<Stream<Channel>> {
 public:
  struct Callbacks {
    std::function<void(const skinwire::Command&)> commanded;
    std::function<void()> ended;  ///< by the other end or by the network; not by close()
  };

  Stream(Channel channel, skinwire::Framing framing, Callbacks callbacks)
      : channel_(std::move(channel)),
        queue_(channel_, [this](const error_code&) { end(); }),
        decoder_(framing),
        callbacks_(std::move(callbacks)) {}

  void start() { read(); }
  void close() {
    closed_ = true;
    queue_.close();
    error_code ignored;
    channel_.close(ignored);
  }

  bool send(Bytes bytes) {
    if (closed_) return false;
    queue_.push(std::move(bytes), this->shared_from_this());
    return true;
  }
  [[nodiscard]] std::size_t waitingBytes() const { return queue_.waitingBytes(); }
  /// Something waits, and the host took nothing for this long.
  [[nodiscard]] bool isStalled(Clock::duration limit) const { return queue_.isStalled(limit); }
  /// Gives up what waits, also what is partly sent.
  void forgetWaiting() { queue_.forget(); }

 private:
  void read() {
    channel_.async_read_some(asio::buffer(buffer_),
                             [self = this->shared_from_this()](const error_code& error, std::size_t size) {
                               if (self->closed_) return;
                               if (error == asio::error::operation_aborted) return self->read();
                               if (error) return self->end();
                               self->decode(size);
                             });
  }

  void decode(std::size_t size) {
    decoder_.feed(ByteView(buffer_.data(), size));
    while (!closed_) {
      const std::optional<skinwire::Decoded> decoded = decoder_.next();
      if (!decoded) break;
      if (decoded->outcome != skinwire::DecodeOutcome::Understood) continue;
      if (const auto* command = std::get_if<skinwire::Command>(&decoded->message)) callbacks_.commanded(*command);
    }
    if (closed_) return;
    if (!decoder_.stuck().empty()) return end();
    read();
  }

  void end() {
    close();
    callbacks_.ended();
  }

  Channel channel_;
  WriteQueue<Channel> queue_;
  skinwire::FrameDecoder decoder_;
  Callbacks callbacks_;
  std::array<std::uint8_t, 4096> buffer_{};
  bool closed_ = false;
};

[[noreturn]] void fail(const std::string& address, const std::string& why) { throw DeviceError(address + ": " + why); }

template <class Protocol>
std::string addressOf(const char* scheme, const typename Protocol::endpoint& at) {
  const std::string host = at.address().is_v6() ? "[" + at.address().to_string() + "]" : at.address().to_string();
  return std::string(scheme) + "://" + host + ":" + std::to_string(at.port());
}

template <class Protocol>
typename Protocol::endpoint endpointOf(const std::string& host, std::uint16_t port) {
  error_code error;
  const asio::ip::address address = asio::ip::make_address(host, error);
  if (error) throw InvalidArgument("--bind: expected the number of an address, found \"" + host + "\"");
  return {address, port};
}

/// A connection is a host once it sends a command, and then keeps the device until it goes or takes nothing any more.
/// One that says nothing (a scanner of ports, a terminal that was forgotten) gives way to the next.
class TcpLink final : public DeviceLink {
 public:
  TcpLink(asio::io_context& io, const tcp::endpoint& at, skinwire::Framing framing)
      : DeviceLink(io, framing, skinwire::kMaxBody), acceptor_(io) {
    error_code error;
    acceptor_.open(at.protocol(), error);
    if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor_.bind(at, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (error) fail(addressOf<tcp>("tcp", at), error.message());
    address_ = addressOf<tcp>("tcp", acceptor_.local_endpoint());
  }
  ~TcpLink() override {
    if (stream_) stream_->close();
  }

  [[nodiscard]] bool isFull() const override { return stream_ && stream_->waitingBytes() > kFullBytes; }
  bool send(Bytes frame) override {
    if (!stream_) return false;
    if (stream_->waitingBytes() > kMaxBytes) {
      disconnect();
      return false;
    }
    return stream_->send(std::move(frame));
  }
  void disconnect() override {
    if (!stream_) return;
    stream_->close();
    leave();
  }

 private:
  using TcpStream = Stream<tcp::socket>;

  void begin() override { accept(); }

  void accept() {
    if (std::exchange(is_accepting_, true)) return;
    acceptor_.async_accept([this](const error_code& error, tcp::socket socket) {
      is_accepting_ = false;
      if (error) return;  // watch() tries again
      if (stream_ && has_spoken_) {
        next_.emplace(std::move(socket));
        return;
      }
      if (stream_) {
        stream_->close();
        stream_.reset();
        callbacks_.host_gone();
      }
      welcome(std::move(socket));
    });
  }

  void welcome(tcp::socket socket) {
    error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    has_spoken_ = false;
    const auto take = [this](const skinwire::Command& command) {
      has_spoken_ = true;
      callbacks_.commanded(command);
    };
    stream_ =
        std::make_shared<TcpStream>(std::move(socket), *framing_, TcpStream::Callbacks{take, [this] { leave(); }});
    callbacks_.host_came();
    if (stream_) stream_->start();
    accept();
  }

  void leave() {
    stream_.reset();
    callbacks_.host_gone();
    // Not from within: what was meant for the one before may still be on its way here.
    asio::post(acceptor_.get_executor(), [this] {
      if (!stream_ && next_) {
        welcome(*std::exchange(next_, std::nullopt));
      } else if (!next_) {
        accept();
      }
    });
  }

  void watch() override {
    if (stream_ && stream_->isStalled(kStalledHostLives)) disconnect();
    if (!next_) accept();
  }

  tcp::acceptor acceptor_;
  std::shared_ptr<TcpStream> stream_;
  bool has_spoken_ = false;
  bool is_accepting_ = false;
  std::optional<tcp::socket> next_;  ///< waits until the host has gone; more wait in the acceptor
};

class UdpLink final : public DeviceLink {
 public:
  UdpLink(asio::io_context& io, const udp::endpoint& at)
      : DeviceLink(io, std::nullopt, skinwire::kMaxDatagram), socket_(io) {
    error_code error;
    socket_.open(at.protocol(), error);
    if (!error) socket_.bind(at, error);
    if (!error) socket_.non_blocking(true, error);
    if (error) fail(addressOf<udp>("udp", at), error.message());
    address_ = addressOf<udp>("udp", socket_.local_endpoint());
    error_code ignored;
    socket_.set_option(asio::socket_base::send_buffer_size(kFullBytes), ignored);
  }

  [[nodiscard]] bool isFull() const override { return false; }
  bool send(Bytes frame) override {
    if (!has_host_) return false;
    error_code error;
    socket_.send_to(asio::buffer(frame), host_, 0, error);
    return !error;
  }
  void disconnect() override {
    if (!has_host_) return;
    has_host_ = false;
    callbacks_.host_gone();
  }

 private:
  void begin() override { receive(); }

  void receive() {
    socket_.async_receive_from(asio::buffer(buffer_), sender_, [this](const error_code& error, std::size_t size) {
      if (error == asio::error::operation_aborted) return;
      // Errors are those of datagrams that were sent to a host that is gone.
      if (!error) decode(ByteView(buffer_.data(), size));
      receive();
    });
  }

  void decode(ByteView body) {
    const skinwire::Decoded decoded = skinwire::decodeBody(body);
    const auto* command = std::get_if<skinwire::Command>(&decoded.message);
    if (decoded.outcome != skinwire::DecodeOutcome::Understood || command == nullptr) return;
    const bool is_host = has_host_ && sender_ == host_;
    if (has_host_ && !is_host) return;  // the device streams to another one, and its answer would be a flood
    if (std::holds_alternative<skinwire::Describe>(command->request)) {
      asked_ = Clock::now();
      if (!is_host) {
        host_ = sender_;
        has_host_ = true;
        return callbacks_.host_came();
      }
    }
    if (is_host) callbacks_.commanded(*command);
  }

  void watch() override {
    if (has_host_ && Clock::now() - asked_ > kUdpHostLives) disconnect();
  }

  udp::socket socket_;
  std::array<std::uint8_t, 65'536> buffer_{};
  udp::endpoint sender_;
  udp::endpoint host_;
  bool has_host_ = false;
  Clock::time_point asked_{};
};

class PseudoTerminalLink final : public DeviceLink {
 public:
  explicit PseudoTerminalLink(asio::io_context& io)
      : DeviceLink(io, skinwire::Framing::Cobs, 4096) {  // little is lost with a broken byte
    FileDescriptor near_end(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
    const auto failed = [] { fail("pseudo-terminal", std::strerror(errno)); };
    if (near_end.get() < 0 || ::grantpt(near_end.get()) != 0 || ::unlockpt(near_end.get()) != 0) failed();
    std::array<char, 256> name{};
    if (::ptsname_r(near_end.get(), name.data(), name.size()) != 0) failed();
    address_ = std::string("serial:") + name.data();
    // Kept open: reading would end whenever a host goes.
    far_end_ = FileDescriptor(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    if (!far_end_.valid()) failed();
    termios settings{};
    if (::tcgetattr(far_end_.get(), &settings) != 0) failed();
    ::cfmakeraw(&settings);
    if (::tcsetattr(far_end_.get(), TCSANOW, &settings) != 0) failed();
    stream_ = std::make_shared<SerialStream>(
        asio::posix::stream_descriptor(io, near_end.release()), *framing_,
        SerialStream::Callbacks{[this](const skinwire::Command& command) { take(command); }, [this] { disconnect(); }});
  }
  ~PseudoTerminalLink() override { stream_->close(); }

  [[nodiscard]] bool isFull() const override { return stream_->waitingBytes() > kFullBytes / 16; }
  bool send(Bytes frame) override { return has_host_ && stream_->send(std::move(frame)); }
  void disconnect() override {
    if (!std::exchange(has_host_, false)) return;
    stream_->forgetWaiting();
    ::tcflush(far_end_.get(), TCIFLUSH);
    callbacks_.host_gone();
  }

 private:
  using SerialStream = Stream<asio::posix::stream_descriptor>;

  void begin() override { stream_->start(); }

  void take(const skinwire::Command& command) {
    const auto* describe = std::get_if<skinwire::Describe>(&command.request);
    // A pseudo-terminal does not tell when a host opens it. A host that has no topology yet has just come.
    const bool is_new = !has_host_ || (describe != nullptr && !describe->known_topology);
    if (is_new && describe != nullptr) {
      has_host_ = true;
      stream_->send({0});
      return callbacks_.host_came();
    }
    if (has_host_) callbacks_.commanded(command);
  }

  /// Nor when it closes it: but then nobody reads.
  void watch() override {
    if (has_host_ && stream_->isStalled(kStalledHostLives)) disconnect();
  }

  FileDescriptor far_end_;
  std::shared_ptr<SerialStream> stream_;
  bool has_host_ = false;
};

}  // namespace

std::unique_ptr<DeviceLink> listenTcp(asio::io_context& io, const std::string& host, std::uint16_t port,
                                      skinwire::Framing framing) {
  return std::make_unique<TcpLink>(io, endpointOf<tcp>(host, port), framing);
}

std::unique_ptr<DeviceLink> listenUdp(asio::io_context& io, const std::string& host, std::uint16_t port) {
  return std::make_unique<UdpLink>(io, endpointOf<udp>(host, port));
}

std::unique_ptr<DeviceLink> openPseudoTerminal(asio::io_context& io) {
  return std::make_unique<PseudoTerminalLink>(io);
}

}  // namespace hexoderm::emulator
