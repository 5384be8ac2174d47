#pragma once

// The other end of a source, in the test's own thread.

#include "hexoderm/device/skinwire/framing.h"
#include "tests/support/patience.h"

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/write.hpp>

#include <array>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

namespace hexoderm {

/// One accepted connection. Blocking.
class DeviceConnection {
 public:
  DeviceConnection(boost::asio::ip::tcp::socket socket, skinwire::Framing framing)
      : socket_(std::move(socket)), framing_(framing), decoder_(framing) {}

  void send(const skinwire::Message& message) { sendBytes(skinwire::encodeFrame(framing_, message)); }
  void sendBytes(skinwire::ByteView bytes) {
    boost::system::error_code ignored;  // the source may have gone already
    boost::asio::write(socket_, boost::asio::buffer(bytes.data(), bytes.size()), ignored);
  }
  /// The next command other than Describe.
  skinwire::Command receive() {
    while (true) {
      while (auto decoded = decoder_.next()) {
        auto command = std::get<skinwire::Command>(decoded->message);
        if (!std::holds_alternative<skinwire::Describe>(command.request)) return command;
      }
      std::array<std::uint8_t, 4096> bytes;
      const std::size_t count = socket_.read_some(boost::asio::buffer(bytes));
      decoder_.feed({bytes.data(), count});
    }
  }
  void close() { socket_.close(); }
  /// A device's own pace, in real time, for it is a source's time-outs in real time that are looked at.
  static void pause(std::chrono::milliseconds time) { std::this_thread::sleep_for(time); }

 private:
  boost::asio::ip::tcp::socket socket_;
  skinwire::Framing framing_;
  skinwire::FrameDecoder decoder_;
};

class TcpDevice {
 public:
  TcpDevice() = default;
  [[nodiscard]] std::string address(const std::string& host = "127.0.0.1") const {
    return "tcp://" + host + ":" + std::to_string(acceptor_.local_endpoint().port());
  }
  DeviceConnection accept(skinwire::Framing framing = skinwire::Framing::Length) {
    return {acceptor_.accept(), framing};
  }
  /// True if a connection waits to be accepted.
  bool hasCaller() {
    acceptor_.non_blocking(true);
    boost::system::error_code error;
    boost::asio::ip::tcp::socket socket(io_);
    acceptor_.accept(socket, error);
    acceptor_.non_blocking(false);
    return !error;
  }

 private:
  boost::asio::io_context io_;
  boost::asio::ip::tcp::acceptor acceptor_{io_,
                                           boost::asio::ip::tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0)};
};

class UdpDevice {
 public:
  [[nodiscard]] std::string address() const {
    return "udp://127.0.0.1:" + std::to_string(socket_.local_endpoint().port());
  }
  skinwire::Command receive() {
    std::array<std::uint8_t, 4096> bytes;
    const std::size_t count = socket_.receive_from(boost::asio::buffer(bytes), host_);
    return std::get<skinwire::Command>(skinwire::decodeBody({bytes.data(), count}).message);
  }
  void send(const skinwire::Message& message) { sendBytes(skinwire::encodeBody(message)); }
  void sendBytes(skinwire::ByteView bytes) { socket_.send_to(boost::asio::buffer(bytes.data(), bytes.size()), host_); }

 private:
  boost::asio::io_context io_;
  boost::asio::ip::udp::socket socket_{io_, boost::asio::ip::udp::endpoint(boost::asio::ip::address_v4::loopback(), 0)};
  boost::asio::ip::udp::endpoint host_;
};

/// An end of a serial line.
class SerialEnd {
 public:
  explicit SerialEnd(int descriptor) : descriptor_(descriptor) {
    // Until the other end makes it raw, a terminal would change bytes and send them back.
    termios settings{};
    ::tcgetattr(descriptor_, &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(descriptor_, TCSANOW, &settings);
  }
  ~SerialEnd() { unplug(); }
  SerialEnd(const SerialEnd&) = delete;
  SerialEnd& operator=(const SerialEnd&) = delete;

  void unplug() {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
  }
  void send(const skinwire::Message& message) { sendBytes(skinwire::encodeFrame(skinwire::Framing::Cobs, message)); }
  void sendBytes(skinwire::ByteView bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count <= 0) throw std::runtime_error("the terminal takes nothing");
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }
  /// The next message of a kind.
  template <class Kind = skinwire::Command>
  Kind receive() {
    const auto until = std::chrono::steady_clock::now() + test::kPatience;
    while (std::chrono::steady_clock::now() < until) {
      while (auto decoded = decoder_.next()) {
        if (const auto* message = std::get_if<Kind>(&decoded->message)) return *message;
      }
      std::array<std::uint8_t, 4096> bytes;
      const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
      // Nobody has opened the other end yet, or the source is about to open it again.
      if (count > 0) decoder_.feed({bytes.data(), static_cast<std::size_t>(count)});
    }
    throw std::runtime_error("nothing comes from the terminal");
  }

 private:
  int descriptor_;
  skinwire::FrameDecoder decoder_{skinwire::Framing::Cobs};
};

/// The master's end of a pseudo-terminal.
class SerialDevice : public SerialEnd {
 public:
  SerialDevice() : SerialDevice(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {}
  [[nodiscard]] std::string address() const { return "serial:" + path_; }

 private:
  explicit SerialDevice(int master) : SerialEnd(master) {
    std::array<char, 128> name{};
    if (::grantpt(master) != 0 || ::unlockpt(master) != 0 || ::ptsname_r(master, name.data(), name.size()) != 0) {
      throw std::runtime_error("no terminal");
    }
    path_ = name.data();
  }

  std::string path_;
};

}  // namespace hexoderm
