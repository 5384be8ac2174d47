#include "app/cli/capture_events.h"

#include <algorithm>

namespace hexoderm::cli {

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
}

void CaptureEvents::onSkin(const SkinDescription& skin) {
  recorder_.setSkin(skin);
  push(skin);
}

}  // namespace hexoderm::cli
