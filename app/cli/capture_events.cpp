#include "app/cli/capture_events.h"

#include <algorithm>
#include <utility>

namespace hexoderm::cli {

void LastingWait::begin(double now_s) {
  since_s_ = now_s;
  say_after_s_ = first_s_;
}

std::optional<double> LastingWait::toBeSaid(double now_s) {
  const double waited_s = now_s - since_s_;
  if (waited_s < say_after_s_) return std::nullopt;
  say_after_s_ = 2 * waited_s;
  return waited_s;
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
  const Stillness& stillness = status.stillness;
  // That the part is to be moved after a capture is no obstacle.
  const bool is_blocked = status.phase == HoldPhase::Watching && stillness.blocker != Blocker::None &&
                          stillness.blocker != Blocker::NotMoved;
  const bool is_set_back = stillness.time_s < std::exchange(last_s_, stillness.time_s);
  if (!is_blocked || stillness.blocker != blocker_ || is_set_back) {
    blocker_ = is_blocked ? stillness.blocker : Blocker::None;
    blocked_.begin(stillness.time_s);
    return std::nullopt;
  }
  const std::optional<double> blocked_s = blocked_.toBeSaid(stillness.time_s);
  return blocked_s ? std::optional(LongWait{*blocked_s, stillness.message}) : std::nullopt;
}

void CaptureEvents::onSkin(const SkinDescription& skin) {
  recorder_.setSkin(skin);
  push(skin);
}

}  // namespace hexoderm::cli
