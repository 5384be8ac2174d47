#pragma once

#include "hexoderm/base/message.h"

#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace hexoderm {

/// Base of everything Hexoderm throws. The message says what is wrong, where (file, key, cell, port) and what was
/// expected, so that a person can act on it; `what()` is its English, of at most 2000 bytes. It may quote names and
/// contents of files as they are: forTerminal() makes a line for a terminal of it. Outcomes that are expected in the
/// field are values (`Finding`), not errors.
class Error : public std::runtime_error {
 public:
  explicit Error(Message message);  ///< a text that is translated where it is shown
  /// What is wrong at a place: a file, an option, a device.
  Error(MessageArgument place, Message what) : Error(located(std::move(place), std::move(what))) {}
  /// A text that is not translated: for mistakes of a caller, and for the words of others.
  explicit Error(const std::string& verbatim) : Error(Message::verbatim(verbatim)) {}
  /// What is wrong, where, and what was expected.
  [[nodiscard]] const Message& message() const noexcept { return *message_; }

 private:
  explicit Error(std::shared_ptr<const Message> message);

  std::shared_ptr<const Message> message_;  ///< shared, because the copy of an exception must not throw
};

/// A caller's argument or option is out of its documented range.
class InvalidArgument : public Error {
  using Error::Error;
};

/// A file or message is not what its format says.
class FormatError : public Error {
  using Error::Error;
};

/// Reading or writing storage failed (missing, not permitted, full).
class StorageError : public Error {
  using Error::Error;
};

/// A device or the way to it failed.
class DeviceError : public Error {
  using Error::Error;
};

/// The message of an Error; of any other exception its text, verbatim.
Message messageOf(const std::exception& error);

}  // namespace hexoderm
