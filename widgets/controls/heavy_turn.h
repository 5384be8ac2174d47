#pragma once

#include <QAbstractEventDispatcher>
#include <QObject>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <utility>

namespace hexoderm {

/// Work that takes a noticeable part of the time for which a window may stand still, such as drawing a scene or a large
/// graph. Several such pieces often fall due in one turn of the event loop, because everything that has changed follows
/// from one result, and a click would wait for all of them: here each gets a turn of its own.
class HeavyTurn : public QObject {
  Q_OBJECT

 public:
  /// `work` is done once, `after_ms` after start() or in one of the next few turns in which no other such work is done.
  HeavyTurn(int after_ms, std::function<void()> work) : work_(std::move(work)), after_ms_(after_ms) {
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &HeavyTurn::due);
  }

  /// Anew, if it was started before.
  void start() { timer_.start(after_ms_); }
  void stop() { timer_.stop(); }
  [[nodiscard]] bool isActive() const { return timer_.isActive(); }

  /// For heavy work that can't wait: this turn is taken.
  static void note() { static_cast<void>(take()); }

 private:
  /// Takes the turn that the event loop is in; false if it was taken before. A turn ends when the loop has waited, or
  /// looked, for what comes next.
  static bool take() {
    static bool is_taken = false;
    static QPointer<QAbstractEventDispatcher> watched;
    QAbstractEventDispatcher* dispatcher = QAbstractEventDispatcher::instance();
    if (watched != dispatcher) {
      watched = dispatcher;
      is_taken = false;
      QObject::connect(dispatcher, &QAbstractEventDispatcher::awake, dispatcher, [] { is_taken = false; });
    }
    return !std::exchange(is_taken, dispatcher != nullptr);
  }

  void due() {
    constexpr int kMaxOthers = 3;  // where something heavy is done in every turn, all come slowly, and none never
    if (!take() && ++waited_ <= kMaxOthers) {
      timer_.start(1);  // 0 may be in the same turn
      return;
    }
    waited_ = 0;
    work_();
  }

  std::function<void()> work_;
  int after_ms_;
  int waited_ = 0;  ///< turns that were others'
  QTimer timer_;
};

}  // namespace hexoderm
