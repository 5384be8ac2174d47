#include "hexoderm/base/kept_files.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/system_reason.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <map>
#include <mutex>
#include <set>
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

struct Kept {
  std::mutex mutex;
  std::multiset<FileIdentity> files;
};
Kept& keptFiles() {
  static Kept instance;
  return instance;
}
std::atomic<bool> keeps_what_is_read = false;

bool isSession(const std::filesystem::path& path) {
  if (!identityOf(path)) return false;
  if (isOpenDatabase(path)) return true;
  constexpr std::size_t kAt = 68;
  constexpr std::array kId = {char(kStoreApplicationId >> 24), char(kStoreApplicationId >> 16),
                              char(kStoreApplicationId >> 8), char(kStoreApplicationId)};
  const std::string bytes = firstBytes(path, kAt + kId.size());
  return bytes.starts_with(kSqliteHeader) && bytes.ends_with(std::string_view(kId.data(), kId.size()));
}

/// The log, its index or the rollback journal of a database, told by its content (https://sqlite.org/fileformat2.html,
/// https://sqlite.org/walformat.html).
bool isKeptBySqlite(const std::filesystem::path& path) {
  using namespace std::string_view_literals;
  if (!identityOf(path)) return false;
  const std::string bytes = firstBytes(path, 8);
  const auto begins = [&](std::string_view magic) { return bytes.starts_with(magic); };
  return begins("\x37\x7f\x06\x82"sv) || begins("\x37\x7f\x06\x83"sv) ||  // -wal
         begins("\x18\xe2\x2d\x00"sv) ||                                  // -shm, little-endian
         begins("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7"sv);                    // -journal
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

bool isKept(const std::filesystem::path& path) {
  const std::optional<FileIdentity> identity = identityOf(path);
  const std::lock_guard guard(keptFiles().mutex);
  return identity && keptFiles().files.contains(*identity);
}

void requireNothingBeside(const std::filesystem::path& path) {
  for (const char* suffix : kBesideDatabases) {
    const std::string beside = path.string() + suffix;
    std::error_code ignored;
    if (!std::filesystem::exists(std::filesystem::symlink_status(beside, ignored))) continue;
    throw StorageError(path.string(), message("{} lies beside it, and would be taken for a part of it: move that "
                                              "file away, or take another name",
                                              beside));
  }
}

void requireReplaceable(const std::filesystem::path& path, const std::string& name) {
  if (isSession(path)) {
    throw StorageError(name, message("exists already as a Hexoderm session, and what that has captured is never "
                                     "replaced: take another name"));
  }
  if (isKept(path)) {
    throw InvalidArgument(name, message("is one of the inputs, which are never replaced: take another name"));
  }
  if (isKeptBySqlite(path)) {
    throw StorageError(
        name, message("belongs to a session, and what that has captured is never replaced: take another name"));
  }
  std::error_code error;
  const std::string file = std::filesystem::weakly_canonical(path, error).string();
  for (const std::string_view beside : kBesideDatabases) {
    const std::string log = file + std::string(beside);
    if (isKeptBySqlite(log)) {
      throw StorageError(name, message("{} lies beside it, with what a session of that name has captured: move "
                                       "that file away, or take another name",
                                       log));
    }
    if (!file.ends_with(beside)) continue;
    const std::string session = file.substr(0, file.size() - beside.size());
    if (!isSession(session)) continue;
    throw StorageError(
        name,
        message("belongs to the session {}, and what that has captured is never replaced: take another name", session));
  }
}

KeptFile::KeptFile(const std::filesystem::path& path) : identity_(identityOf(path)) {
  const std::lock_guard guard(keptFiles().mutex);
  if (identity_) keptFiles().files.insert(*identity_);
}

KeptFile::~KeptFile() {
  const std::lock_guard guard(keptFiles().mutex);
  if (identity_) keptFiles().files.erase(keptFiles().files.find(*identity_));
}

void keepWhatIsRead() { keeps_what_is_read = true; }

bool keepsWhatIsRead() { return keeps_what_is_read; }

void noteRead(const std::filesystem::path& path) {
  if (!keeps_what_is_read) return;
  const std::optional<FileIdentity> identity = identityOf(path);
  const std::lock_guard guard(keptFiles().mutex);
  if (identity && !keptFiles().files.contains(*identity)) keptFiles().files.insert(*identity);
}

}  // namespace hexoderm
