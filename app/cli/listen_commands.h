#pragma once

#include "hexoderm/device/skin_source.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace hexoderm::cli {

/// Commands that `listen` sends to a device to see how it answers. Outcomes come from the source's thread.
class CommandTrial {
 public:
  struct Named {
    std::string name;  ///< as in skinwire.proto, and what is asked: "set_led of cell 5"
    SkinCommand command;
  };
  explicit CommandTrial(std::vector<Named> commands) : commands_(std::move(commands)) {}

  /// Sends all of them, the first time; the device has described itself.
  void sendOnce(SkinSource& source) {
    if (!sent_.empty()) return;
    for (const Named& named : commands_) {
      const Clock::time_point now = Clock::now();
      sent_.push_back({source.send(named.command), now});
    }
  }

  void add(const CommandOutcome& outcome) {
    const std::lock_guard lock(mutex_);
    answers_[outcome.command] = {outcome, Clock::now()};
  }

  /// Whether every command that was sent has its outcome.
  [[nodiscard]] bool isAnswered() const {
    const std::lock_guard lock(mutex_);
    return std::ranges::all_of(sent_, [this](const Sent& sent) { return answers_.contains(sent.number); });
  }

  /// A command and how it was answered.
  struct Answered {
    std::string name;
    bool is_sent = false;
    bool is_done = false;
    std::string message{};
    std::optional<double> after_s{};  ///< nothing: no answer so far
  };

  [[nodiscard]] std::vector<Answered> answers() const {
    const std::lock_guard lock(mutex_);
    std::vector<Answered> all;
    for (std::size_t k = 0; k < commands_.size(); ++k) {
      Answered& command = all.emplace_back(Answered{commands_[k].name, !sent_.empty()});
      const auto found = sent_.empty() ? answers_.end() : answers_.find(sent_[k].number);
      if (found == answers_.end()) continue;
      const auto& [outcome, at] = found->second;
      command.is_done = outcome.done;
      command.message = outcome.message.english();
      command.after_s = std::chrono::duration<double>(at - sent_[k].at).count();
    }
    return all;
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct Sent {
    std::uint32_t number = 0;
    Clock::time_point at;
  };
  struct Answer {
    CommandOutcome outcome;
    Clock::time_point at;
  };

  std::vector<Named> commands_;
  std::vector<Sent> sent_;  ///< of all commands, or none
  mutable std::mutex mutex_;
  std::map<std::uint32_t, Answer> answers_;
};

}  // namespace hexoderm::cli
