#pragma once

// What sources have in common, each of which has a thread of its own.

#include "hexoderm/base/error.h"
#include "hexoderm/device/skin_source.h"

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace hexoderm {

/// A source whose commands wait until its thread takes them. A class that is made of it calls stop() as it goes.
template <class Source = SkinSource>
class ThreadedSource : public Source {
 public:
  void start(SkinListener& listener) final {
    if (listener_ != nullptr) throw InvalidArgument(address_, message("a source can be started only once"));
    open();
    listener_ = &listener;
    thread_ = std::jthread([this](std::stop_token stop) {
      stop_ = std::move(stop);
      run();
    });
  }
  void stop() noexcept final {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
  }
  std::uint32_t send(const SkinCommand& command) final {
    std::uint32_t number = 0;
    {
      const std::lock_guard lock(mutex_);
      number = ++last_number_;
      queue_.push_back({number, command});
    }
    wake();
    return number;
  }
  [[nodiscard]] std::string address() const final { return address_; }

 protected:
  struct Queued {
    std::uint32_t number = 0;
    SkinCommand command;
  };

  explicit ThreadedSource(std::string address) : address_(std::move(address)) {}

  /// In start(), before there is a thread. What it throws is thrown by start(), which may then be called again.
  virtual void open() {}
  /// On the thread, until stop_ says so.
  virtual void run() = 0;
  /// There is something new for the thread. From any thread.
  virtual void wake() { changed_.notify_all(); }

  // On the thread:
  std::vector<Queued> takeCommands() {
    const std::lock_guard lock(mutex_);
    return std::exchange(queue_, {});
  }
  void refuseCommands(const Message& why) {
    for (const Queued& command : takeCommands()) listener_->onCommandOutcome({command.number, false, why});
  }

  SkinListener* listener_ = nullptr;
  std::stop_token stop_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::vector<Queued> queue_;  ///< guarded

 private:
  std::string address_;
  std::uint32_t last_number_ = 0;  ///< guarded
  std::jthread thread_;
};

}  // namespace hexoderm
