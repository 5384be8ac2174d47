#include "app/cli/listen_commands.h"

#include <algorithm>

namespace hexoderm::cli {

void CommandTrial::sendOnce(SkinSource& source) {
  if (!sent_.empty()) return;
  for (const Named& named : commands_) {
    const Clock::time_point now = Clock::now();
    sent_.push_back({source.send(named.command), now});
  }
}

void CommandTrial::add(const CommandOutcome& outcome) {
  const std::lock_guard lock(mutex_);
  answers_[outcome.command] = {outcome, Clock::now()};
}

bool CommandTrial::isAnswered() const {
  const std::lock_guard lock(mutex_);
  return std::ranges::all_of(sent_, [this](const Sent& sent) { return answers_.contains(sent.number); });
}

std::vector<CommandTrial::Answered> CommandTrial::answers() const {
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

}  // namespace hexoderm::cli
