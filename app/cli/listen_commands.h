#pragma once

#include "hexoderm/device/skin_source.h"

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
  void sendOnce(SkinSource& source);
  void add(const CommandOutcome& outcome);
  /// Whether every command that was sent has its outcome.
  [[nodiscard]] bool isAnswered() const;

  /// A command and how it was answered.
  struct Answered {
    std::string name;
    bool is_sent = false;
    bool is_done = false;
    std::string message{};
    std::optional<double> after_s{};  ///< nothing: no answer so far
  };
  [[nodiscard]] std::vector<Answered> answers() const;

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
