#pragma once

#include <QObject>
#include <QTimer>
#include <functional>

namespace hexoderm {

/// Work that takes a noticeable part of the time for which a window may stand still, such as drawing a scene or a large
/// graph. Several such pieces often fall due in one turn of the event loop, because everything that has changed follows
/// from one result, and a click would wait for all of them: here each gets a turn of its own.
class HeavyTurn : public QObject {
  Q_OBJECT

 public:
  /// `work` is done once, `after_ms` after start() or in one of the next few turns in which no other such work is done.
  HeavyTurn(int after_ms, std::function<void()> work);

  /// Anew, if it was started before.
  void start();
  void stop() { timer_.stop(); }
  [[nodiscard]] bool isActive() const { return timer_.isActive(); }

  /// For heavy work that can't wait: this turn is taken.
  static void note();

 private:
  void due();

  std::function<void()> work_;
  int after_ms_;
  int waited_ = 0;  ///< turns that were others'
  QTimer timer_;
};

}  // namespace hexoderm
