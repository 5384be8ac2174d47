#pragma once

#include <stdexcept>
#include <string>

namespace hexoderm {

/// Base of everything Hexoderm throws. The message says what is wrong, where (file, key, cell, port) and what was
/// expected, so that a person can act on it. Outcomes that are expected in the field are values (`Finding`), not
/// errors.
class Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
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

}  // namespace hexoderm
