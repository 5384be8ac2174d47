#include "hexoderm/base/error.h"

#include "hexoderm/base/text.h"

#include <utility>

namespace hexoderm {
namespace {

/// What a file holds may be part of a complaint about it, and files may hold words of any length.
Message bounded(Message message) {
  constexpr std::size_t kLongest = 2000;
  const std::string english = message.english();
  return english.size() <= kLongest ? std::move(message) : Message::verbatim(shortened(english, kLongest));
}

}  // namespace

Error::Error(Message message) : Error(std::make_shared<const Message>(bounded(std::move(message)))) {}

Error::Error(std::shared_ptr<const Message> message)
    : std::runtime_error(message->english()), message_(std::move(message)) {}

Message messageOf(const std::exception& error) {
  const auto* known = dynamic_cast<const Error*>(&error);
  return known != nullptr ? known->message() : Message::verbatim(error.what());
}

}  // namespace hexoderm
