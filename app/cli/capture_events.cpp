#include "app/cli/capture_events.h"

#include <algorithm>
#include <utility>

namespace hexoderm::cli {

void ReadingsWait::begin(Clock::time_point now) {
  since_ = now;
  say_after_ = kFirst;
}

std::optional<double> ReadingsWait::toBeSaid(Clock::time_point now) {
  const Clock::duration waited = now - since_;
  if (waited < say_after_) return std::nullopt;
  say_after_ = 2 * waited;
  return std::chrono::duration<double>(waited).count();
}

std::optional<CaptureEvent> CaptureEvents::next(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  if (!arrived_.wait_for(lock, patience, [this] { return !events_.empty(); })) return std::nullopt;
  CaptureEvent event = std::move(events_.front());
  events_.pop_front();
  return event;
}

void CaptureEvents::push(CaptureEvent event) {
  {
    const std::lock_guard lock(mutex_);
    const bool is_state = std::holds_alternative<HoldStatus>(event) || std::holds_alternative<SourceStatus>(event);
    if (is_state && !events_.empty() && events_.back().index() == event.index()) {
      events_.back() = std::move(event);
    } else {
      events_.push_back(std::move(event));
    }
  }
  arrived_.notify_one();
}

HoldLedger CaptureEvents::ledger() const {
  const std::lock_guard lock(mutex_);
  return ledger_;
}

void CaptureEvents::onHold(const HoldStatus& status) {
  {
    const std::lock_guard lock(mutex_);
    ledger_.add(status);
  }
  push(status);
  if (std::optional<LongWait> wait = longWait(status)) push(std::move(*wait));
}

std::optional<LongWait> CaptureEvents::longWait(const HoldStatus& status) {
  constexpr double kFirst_s = 5;
  const Stillness& stillness = status.stillness;
  // That the part is to be moved after a capture is no obstacle.
  const bool is_blocked = status.phase == HoldPhase::Watching && stillness.blocker != Blocker::None &&
                          stillness.blocker != Blocker::NotMoved;
  if (!is_blocked || stillness.blocker != blocker_ || stillness.time_s < blocked_since_s_) {
    blocker_ = is_blocked ? stillness.blocker : Blocker::None;
    blocked_since_s_ = stillness.time_s;
    say_after_s_ = kFirst_s;
    return std::nullopt;
  }
  const double blocked_s = stillness.time_s - blocked_since_s_;
  if (blocked_s < say_after_s_) return std::nullopt;
  say_after_s_ = 2 * blocked_s;
  return LongWait{blocked_s, stillness.message};
}

void CaptureEvents::onSkin(const SkinDescription& skin) {
  recorder_.setSkin(skin);
  push(skin);
}

}  // namespace hexoderm::cli
