#include "hexoderm/util/error.h"

#include <utility>

namespace hexoderm {

Error::Error(Message message)
    : std::runtime_error(message.english()), message_(std::make_shared<const Message>(std::move(message))) {}

Message messageOf(const std::exception& error) {
  const auto* known = dynamic_cast<const Error*>(&error);
  return known != nullptr ? known->message() : Message::verbatim(error.what());
}

}  // namespace hexoderm
