#include "hexoderm/util/file_place.h"

#include <sys/stat.h>

#include <string>
#include <system_error>

namespace hexoderm {

bool isAt(const std::filesystem::path& path, int descriptor) {
  struct stat held {};
  struct stat there {};
  return ::fstat(descriptor, &held) == 0 && ::stat(path.c_str(), &there) == 0 && held.st_dev == there.st_dev &&
         held.st_ino == there.st_ino;
}

std::optional<std::filesystem::path> placeOf(int descriptor) {
  std::error_code unknown;
  const auto place = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), unknown);
  if (unknown || !isAt(place, descriptor)) return std::nullopt;
  return place;
}

}  // namespace hexoderm
