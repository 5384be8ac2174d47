#include "hexoderm/base/database_files.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/system_reason.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <mutex>
#include <system_error>
#include <vector>

namespace hexoderm {
namespace {

/// The files that this process has open for writing, with the descriptors that are closed when they are.
struct Registry {
  std::mutex mutex;
  std::map<FileIdentity, std::vector<int>> writing;
};
Registry& registry() {
  static Registry instance;
  return instance;
}

}  // namespace

std::optional<FileIdentity> identityOf(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileIdentity(status.st_dev, status.st_ino);
}

std::optional<FileIdentity> identityOf(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return std::nullopt;
  return FileIdentity(status.st_dev, status.st_ino);
}

bool isAt(const std::filesystem::path& path, int descriptor) {
  struct stat there {};
  return ::stat(path.c_str(), &there) == 0 && identityOf(descriptor) == FileIdentity(there.st_dev, there.st_ino);
}

std::optional<std::filesystem::path> placeOf(int descriptor) {
  std::error_code unknown;
  const auto place = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), unknown);
  if (unknown || !isAt(place, descriptor)) return std::nullopt;
  return place;
}

bool isOpenDatabase(const std::filesystem::path& path) {
  const std::optional<FileIdentity> identity = identityOf(path);
  const std::lock_guard guard(registry().mutex);
  return identity && registry().writing.contains(*identity);
}

void addOpenDatabase(int descriptor) {
  const std::optional<FileIdentity> identity = identityOf(descriptor);
  const std::lock_guard guard(registry().mutex);
  if (identity) registry().writing[*identity];
}

void closeWhenHarmless(int descriptor, bool is_writer) {
  if (descriptor < 0) return;
  const std::optional<FileIdentity> identity = identityOf(descriptor);
  const std::lock_guard guard(registry().mutex);
  const auto found = identity ? registry().writing.find(*identity) : registry().writing.end();
  if (found == registry().writing.end()) {
    ::close(descriptor);
  } else if (is_writer) {
    for (const int parked : found->second) ::close(parked);
    registry().writing.erase(found);
    ::close(descriptor);
  } else {
    found->second.push_back(descriptor);
  }
}

std::string firstBytes(const std::filesystem::path& path, std::size_t count) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw StorageError(path.string(), message("cannot be read: {}", systemReason(errno)));
  std::string bytes(count, '\0');
  const ssize_t found = ::pread(descriptor, bytes.data(), bytes.size(), 0);
  closeWhenHarmless(descriptor, false);
  bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(found, 0)));
  return bytes;
}

}  // namespace hexoderm
