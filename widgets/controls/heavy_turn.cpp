#include "widgets/controls/heavy_turn.h"

#include <QAbstractEventDispatcher>
#include <QPointer>
#include <utility>

namespace hexoderm {
namespace {

/// Takes the turn that the event loop is in; false if it was taken before. A turn ends when the loop has waited, or
/// looked, for what comes next.
bool take() {
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

}  // namespace

HeavyTurn::HeavyTurn(int after_ms, std::function<void()> work) : work_(std::move(work)), after_ms_(after_ms) {
  timer_.setSingleShot(true);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &HeavyTurn::due);
}

void HeavyTurn::start() { timer_.start(after_ms_); }

void HeavyTurn::due() {
  constexpr int kMostOthers = 3;  // where something heavy is done in every turn, all come slowly, and none never
  if (!take() && ++waited_ <= kMostOthers) {
    timer_.start(1);  // 0 may be in the same turn
    return;
  }
  waited_ = 0;
  work_();
}

void HeavyTurn::note() { static_cast<void>(take()); }

}  // namespace hexoderm
