#pragma once

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/latest_worker.h"
#include "widgets/words/words.h"

#include <QMetaObject>
#include <QObject>
#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <stop_token>
#include <utility>

namespace hexoderm {

/// Work of several kinds, which an enumeration names, on a thread of its own. The newest request of a kind wins: one
/// that waits is dropped, one that runs is asked to stop, and its result is not announced. The destructor waits for the
/// running work to end.
template <class Kind>
class NewestRequests {
 public:
  using Announcement = std::function<void()>;
  using Work = std::function<Announcement(const std::stop_token& stop)>;

  /// Announcements, `running_changed` and `failed`, which an exception of the work leads to, are called on the thread
  /// of `context`, which outlives this object.
  NewestRequests(QObject& context, std::function<void(Kind, bool)> running_changed,
                 std::function<void(Kind, const QString&)> failed)
      : context_(context),
        running_changed_(std::move(running_changed)),
        failed_(std::move(failed)),
        worker_(states_.size()) {}

  void request(Kind kind, Work work) {
    const auto slot = static_cast<std::size_t>(kind);
    worker_.cancel(slot);
    const std::uint64_t number = ++states_.at(slot).newest;
    worker_.submit(
        [this, kind, slot, number, work = std::move(work)](const std::stop_token& stop) {
          Announcement announce;
          try {
            announce = work(stop);
          } catch (const std::exception& error) {
            announce = [this, kind, message = words(error)] { failed_(kind, message); };
          }
          const auto finish = [this, kind, slot, number, announce = std::move(announce)] {
            if (states_.at(slot).newest != number) return;
            setRunning(kind, false);
            announce();
          };
          QMetaObject::invokeMethod(&context_, finish, Qt::QueuedConnection);
        },
        slot);
    setRunning(kind, true);
  }

  void cancel(Kind kind) {
    worker_.cancel(static_cast<std::size_t>(kind));
    ++states_.at(static_cast<std::size_t>(kind)).newest;
    setRunning(kind, false);
  }

  [[nodiscard]] bool isRunning(Kind kind) const { return states_.at(static_cast<std::size_t>(kind)).running; }

 private:
  void setRunning(Kind kind, bool running) {
    bool& told = states_.at(static_cast<std::size_t>(kind)).running;
    if (std::exchange(told, running) != running) running_changed_(kind, running);
  }

  struct State {
    std::uint64_t newest = 0;  ///< results of older requests are dropped
    bool running = false;      ///< as it was said last
  };
  QObject& context_;
  std::function<void(Kind, bool)> running_changed_;
  std::function<void(Kind, const QString&)> failed_;
  std::array<State, enumeratorCount<Kind>()> states_;
  LatestWorker worker_;  // a mailbox per kind; last: it has ended before anything that it uses is destroyed
};

}  // namespace hexoderm
