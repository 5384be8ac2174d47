#include "app/cli/listen_commands.h"

#include "hexoderm/util/text.h"

#include <algorithm>
#include <iostream>

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
  answers_[outcome.command] = {outcome.done, outcome.message, Clock::now()};
}

bool CommandTrial::isAnswered() const {
  const std::lock_guard lock(mutex_);
  return std::ranges::all_of(sent_, [this](const Sent& sent) { return answers_.contains(sent.number); });
}

const CommandTrial::Answer* CommandTrial::answerTo(std::size_t command) const {
  if (command >= sent_.size()) return nullptr;
  const auto found = answers_.find(sent_[command].number);
  return found == answers_.end() ? nullptr : &found->second;
}

void CommandTrial::print() const {
  const std::lock_guard lock(mutex_);
  for (std::size_t k = 0; k < commands_.size(); ++k) {
    std::cout << "Command " << commands_[k].name << ": ";
    const Answer* answer = answerTo(k);
    if (answer == nullptr) {
      std::cout << (sent_.empty() ? "was not sent, for the device has not described itself\n" : "no answer yet\n");
      continue;
    }
    const double after_s = std::chrono::duration<double>(answer->at - sent_[k].at).count();
    std::cout << (answer->done ? "done" : "not done") << " after " << formatFixed(after_s, 2) << " s";
    if (!answer->message.empty()) std::cout << ": " << answer->message;
    std::cout << '\n';
  }
}

nlohmann::ordered_json CommandTrial::toJson() const {
  const std::lock_guard lock(mutex_);
  auto json = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < commands_.size(); ++k) {
    nlohmann::ordered_json entry = {{"command", commands_[k].name}, {"sent", !sent_.empty()}};
    const Answer* answer = answerTo(k);
    entry["done"] = answer != nullptr && answer->done;
    entry["message"] = answer == nullptr ? "" : answer->message.english();
    entry["after_s"] = answer == nullptr
                           ? nlohmann::ordered_json(nullptr)
                           : nlohmann::ordered_json(std::chrono::duration<double>(answer->at - sent_[k].at).count());
    json.push_back(std::move(entry));
  }
  return json;
}

}  // namespace hexoderm::cli
