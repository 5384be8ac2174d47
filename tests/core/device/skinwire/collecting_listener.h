#pragma once

#include "hexoderm/device/skin_source.h"
#include "tests/support/patience.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

namespace hexoderm {

/// Keeps everything that a source delivers, and waits for it.
class CollectingListener : public SkinListener {
 public:
  struct Delivered {
    std::vector<SkinDescription> skins;
    std::vector<SampleFrame> frames;
    std::vector<SourceStatus> statuses;
    std::vector<CommandOutcome> outcomes;
    std::vector<DeviceStatus> device_statuses;
    std::vector<JointReport> joints;

    [[nodiscard]] SourceStatus status() const { return statuses.empty() ? SourceStatus{} : statuses.back(); }
    [[nodiscard]] bool sawState(SourceState state) const { return saw(state, ""); }
    [[nodiscard]] bool saw(SourceState state, const std::string& text) const {
      return std::ranges::any_of(statuses, [&](const SourceStatus& status) {
        return status.state == state && status.message.english().find(text) != std::string::npos;
      });
    }
    [[nodiscard]] const CommandOutcome* outcomeOf(std::uint32_t command) const {
      const auto found = std::ranges::find(outcomes, command, &CommandOutcome::command);
      return found == outcomes.end() ? nullptr : &*found;
    }
  };

  void onSkin(const SkinDescription& skin) override { add(delivered_.skins, skin); }
  void onFrame(const SampleFrame& frame) override { add(delivered_.frames, frame); }
  void onStatus(const SourceStatus& status) override { add(delivered_.statuses, status); }
  void onCommandOutcome(const CommandOutcome& outcome) override { add(delivered_.outcomes, outcome); }
  void onDeviceStatus(const DeviceStatus& status) override { add(delivered_.device_statuses, status); }
  void onJoints(const JointReport& joints) override { add(delivered_.joints, joints); }

  /// False if it never comes.
  template <class Condition>
  bool waitFor(const Condition& condition) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, test::kPatience, [&] { return condition(delivered_); });
  }
  [[nodiscard]] Delivered delivered() {
    const std::lock_guard lock(mutex_);
    return delivered_;
  }

 private:
  template <class Event>
  void add(std::vector<Event>& events, const Event& event) {
    const std::lock_guard lock(mutex_);
    events.push_back(event);
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  Delivered delivered_;
};

}  // namespace hexoderm
