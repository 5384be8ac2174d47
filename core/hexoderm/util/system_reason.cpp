#include "hexoderm/util/system_reason.h"

#include <cerrno>

namespace hexoderm {

Message systemReason(int error_number) {
  switch (error_number) {
    case ENOENT:
      return message("No such file or directory");
    case EACCES:
      return message("Permission denied");
    case EROFS:
      return message("Read-only file system");
    case ENOSPC:
      return message("No space left on device");
    case EISDIR:
      return message("Is a directory");
    case ENOTDIR:
      return message("Not a directory");
    case EIO:
      return message("Input/output error");
    case ENODEV:
      return message("No such device");
    case EBUSY:
      return message("Device or resource busy");
    case ECONNREFUSED:
      return message("Connection refused");
    case ECONNRESET:
      return message("Connection reset by peer");
    case ETIMEDOUT:
      return message("Connection timed out");
    case EHOSTUNREACH:
      return message("No route to host");
    case ENETUNREACH:
      return message("Network is unreachable");
    default:
      return Message::verbatim(std::generic_category().message(error_number));
  }
}

Message systemReason(const std::error_code& error) {
  const bool is_systems = error.category() == std::generic_category() || error.category() == std::system_category();
  return is_systems ? systemReason(error.value()) : Message::verbatim(error.message());
}

}  // namespace hexoderm
