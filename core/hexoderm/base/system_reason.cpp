#include "hexoderm/base/system_reason.h"

#include <cerrno>
#include <map>

namespace hexoderm {

Message systemReason(int error_number) {
  static const std::map<int, Message> kReasons = {{ENOENT, message("No such file or directory")},
                                                  {EACCES, message("Permission denied")},
                                                  {EROFS, message("Read-only file system")},
                                                  {ENOSPC, message("No space left on device")},
                                                  {EISDIR, message("Is a directory")},
                                                  {ENOTDIR, message("Not a directory")},
                                                  {EIO, message("Input/output error")},
                                                  {ENODEV, message("No such device")},
                                                  {EBUSY, message("Device or resource busy")},
                                                  {ECONNREFUSED, message("Connection refused")},
                                                  {ECONNRESET, message("Connection reset by peer")},
                                                  {ETIMEDOUT, message("Connection timed out")},
                                                  {EHOSTUNREACH, message("No route to host")},
                                                  {ENETUNREACH, message("Network is unreachable")}};
  const auto known = kReasons.find(error_number);
  return known != kReasons.end() ? known->second : Message::verbatim(std::generic_category().message(error_number));
}

Message systemReason(const std::error_code& error) {
  const bool is_systems = error.category() == std::generic_category() || error.category() == std::system_category();
  return is_systems ? systemReason(error.value()) : Message::verbatim(error.message());
}

}  // namespace hexoderm
