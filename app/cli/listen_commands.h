#pragma once

#include "hexoderm/device/skin_source.h"

#include <chrono>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
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

  void print() const;
  [[nodiscard]] nlohmann::ordered_json toJson() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Answer {
    bool done = false;
    Message message;
    Clock::time_point at;
  };
  struct Sent {
    std::uint32_t number = 0;
    Clock::time_point at;
  };
  [[nodiscard]] const Answer* answerTo(std::size_t command) const;

  std::vector<Named> commands_;
  std::vector<Sent> sent_;  ///< of all commands, or none
  mutable std::mutex mutex_;
  std::map<std::uint32_t, Answer> answers_;
};

}  // namespace hexoderm::cli
