#pragma once

// Used here and by the emulator's end of the wire.

#include "hexoderm/device/skinwire/codec.h"

#include <boost/asio/buffer.hpp>
#include <boost/system/error_code.hpp>

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <utility>

namespace hexoderm {

/// Writes pieces of bytes to an Asio channel in the order they come, one after another: to a stream in as many parts as
/// it takes, to a connected datagram socket as one datagram each. Everything runs on the channel's io_context.
template <class Channel>
class WriteQueue {
 public:
  using Clock = std::chrono::steady_clock;
  using Failed = std::function<void(const boost::system::error_code&)>;

  /// `failed` is called once if the channel does not take a piece; nothing is written afterwards.
  WriteQueue(Channel& channel, Failed failed) : channel_(channel), failed_(std::move(failed)) {}
  WriteQueue(const WriteQueue&) = delete;
  WriteQueue& operator=(const WriteQueue&) = delete;

  /// `owner` of the channel and of this queue: kept until the channel has answered.
  void push(skinwire::Bytes bytes, std::shared_ptr<void> owner) {
    if (closed_) return;
    waiting_bytes_ += bytes.size();
    pieces_.push_back(std::move(bytes));
    if (pieces_.size() > 1) return;
    progress_ = Clock::now();
    writeNext(std::move(owner));
  }
  /// Bytes that the channel has not taken yet.
  [[nodiscard]] std::size_t waitingBytes() const { return waiting_bytes_; }
  /// Something waits, and the channel took nothing for this long.
  [[nodiscard]] bool isStalled(Clock::duration limit) const {
    return !pieces_.empty() && Clock::now() - progress_ > limit;
  }
  /// Gives up what waits, also what is partly written. Cancels everything that is under way on the channel, reading
  /// too.
  void forget() {
    if (pieces_.empty()) return;
    is_forgetting_ = true;
    channel_.cancel();
  }
  /// Nothing more is written, and `failed` is not called any more.
  void close() { closed_ = true; }

 private:
  void writeNext(std::shared_ptr<void> owner) {
    const auto rest = boost::asio::buffer(pieces_.front()) + written_;
    auto done = [this, owner](const boost::system::error_code& error, std::size_t size) { wrote(error, size, owner); };
    if constexpr (requires { channel_.async_write_some(rest, done); }) {
      channel_.async_write_some(rest, std::move(done));
    } else {
      channel_.async_send(rest, std::move(done));
    }
  }

  void wrote(const boost::system::error_code& error, std::size_t size, const std::shared_ptr<void>& owner) {
    if (closed_) return;
    if (std::exchange(is_forgetting_, false)) {
      pieces_.clear();
      written_ = waiting_bytes_ = 0;
      return;
    }
    if (error) {
      closed_ = true;
      return failed_(error);
    }
    progress_ = Clock::now();
    written_ += size;
    waiting_bytes_ -= size;
    if (written_ == pieces_.front().size()) {
      pieces_.pop_front();
      written_ = 0;
    }
    if (!pieces_.empty()) writeNext(owner);
  }

  Channel& channel_;
  Failed failed_;
  std::deque<skinwire::Bytes> pieces_;
  std::size_t written_ = 0;  ///< bytes of the first piece that are written
  std::size_t waiting_bytes_ = 0;
  Clock::time_point progress_{};
  bool is_forgetting_ = false;
  bool closed_ = false;
};

}  // namespace hexoderm
