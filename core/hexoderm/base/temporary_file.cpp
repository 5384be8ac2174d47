#include "hexoderm/base/temporary_file.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/sha256.h"
#include "hexoderm/base/system_reason.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>  // renameat2
#include <random>
#include <system_error>

namespace hexoderm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTemporaryDigits = 16;

fs::path newHiddenName(const fs::path& folder) {
  std::random_device random;
  std::array<std::uint8_t, kTemporaryDigits / 2> bytes{};
  std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(random()); });
  return folder / (std::string(kTemporaryPrefix) + hexDigits(bytes) + std::string(kTemporarySuffix));
}

bool isHiddenName(std::string_view name) {
  if (!name.starts_with(kTemporaryPrefix) || !name.ends_with(kTemporarySuffix)) return false;
  if (name.size() != kTemporaryPrefix.size() + kTemporaryDigits + kTemporarySuffix.size()) return false;
  const std::string_view digits = name.substr(kTemporaryPrefix.size(), kTemporaryDigits);
  return digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

bool isStillAt(const fs::path& path, int descriptor) {
  struct stat there {};
  return ::lstat(path.c_str(), &there) == 0 && identityOf(descriptor) == FileIdentity(there.st_dev, there.st_ino);
}

/// A file system without locks has nobody who removes what is locked either.
void lockAlone(int descriptor) {
  while (::flock(descriptor, LOCK_EX) != 0 && errno == EINTR) continue;
}

void removeIfLeft(const fs::path& path) {
  const FileDescriptor left(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC));
  struct stat status {};
  if (!left.valid() || ::fstat(left.get(), &status) != 0 || status.st_uid != ::geteuid()) return;
  if ((!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) || isKept(path)) return;
  if (::flock(left.get(), LOCK_EX | LOCK_NB) != 0 || !isStillAt(path, left.get())) return;
  for (const char* suffix : kBesideDatabases) ::unlink((path.string() + suffix).c_str());
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

[[noreturn]] void throwCannotBeWritten(const std::string& name) {
  throw StorageError(name, message("cannot be written: {}", systemReason(errno)));
}

/// Whether a file without a name can get one later.
bool canBeNamed(int descriptor) { return ::access(("/proc/self/fd/" + std::to_string(descriptor)).c_str(), F_OK) == 0; }

}  // namespace

FileDescriptor::~FileDescriptor() {
  if (descriptor_ >= 0) ::close(descriptor_);
}
FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

void removeLeftBehind(const fs::path& folder) noexcept {
  try {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
      if (isHiddenName(entry->path().filename().native())) removeIfLeft(entry->path());
    }
  } catch (const std::exception&) {  // out of memory: what is left will be there the next time
  }
}

TemporaryFile::TemporaryFile(const fs::path& target, std::string name, Naming naming)
    : folder_(folderOf(target)), target_(target), name_(std::move(name)) {
  removeLeftBehind(folder_);
  if (naming == Naming::AtTheEnd) {
    file_ = FileDescriptor(::open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666));
    if (file_.valid() && !canBeNamed(file_.get())) file_ = FileDescriptor();
  }
  if (!file_.valid()) {
    makeHidden();
  } else {
    lockAlone(file_.get());
  }
}

TemporaryFile::~TemporaryFile() {
  if (path_.empty()) return;
  for (const char* suffix : kBesideDatabases) ::unlink((path_.string() + suffix).c_str());
  ::unlink(path_.c_str());
}

void TemporaryFile::makeHidden() {
  while (true) {
    const fs::path hidden = newHiddenName(folder_);
    file_ = FileDescriptor(::open(hidden.c_str(), O_CREAT | O_EXCL | O_RDWR | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (!file_.valid() && errno == EEXIST) continue;
    if (!file_.valid()) fail();
    path_ = hidden;
    lockAlone(file_.get());
    if (isStillAt(path_, file_.get())) return;
    // Somebody took it for left behind before it was locked.
  }
}

void TemporaryFile::write(std::string_view content) { writeAll(file_.get(), content, name_); }

void TemporaryFile::requireContent(std::string_view content) const {
  std::array<char, 65536> buffer{};
  for (std::size_t at = 0; true;) {
    const ssize_t count = ::pread(file_.get(), buffer.data(), buffer.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    const std::string_view found(buffer.data(), static_cast<std::size_t>(count));
    const bool is_same = found.empty() ? at == content.size() : content.substr(at, found.size()) == found;
    if (!is_same) throw StorageError(name_, message("read back after writing, it holds other bytes than were written"));
    if (found.empty()) return;
    at += found.size();
  }
}

void TemporaryFile::keepOwnerAndRights(uid_t owner, gid_t group, mode_t rights) noexcept {
  rights &= 0777U;
  struct stat mine {};
  const bool is_same = ::fstat(file_.get(), &mine) == 0 && mine.st_uid == owner && mine.st_gid == group;
  if (!is_same && ::fchown(file_.get(), owner, group) != 0 &&
      ::fchown(file_.get(), static_cast<uid_t>(-1), group) != 0) {
    // It belongs to another group now, which must not be allowed more than everybody.
    rights &= 0707U | (rights & 07U) << 3U;
  }
  static_cast<void>(::fchmod(file_.get(), rights));  // some file systems have no rights
}

void TemporaryFile::replaceTarget() {
  sync();
  while (path_.empty()) {
    const fs::path hidden = newHiddenName(folder_);
    const std::string unnamed = "/proc/self/fd/" + std::to_string(file_.get());
    if (::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, hidden.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      path_ = hidden;
    } else if (errno != EEXIST) {
      fail();
    }
  }
  requireReplaceable(target_, name_);  // again: in the meantime a session may have got the name
  if (::rename(path_.c_str(), target_.c_str()) != 0)
    throw StorageError(name_, message("cannot be replaced: {}", systemReason(errno)));
  path_.clear();
  syncFolder(folder_);
}

bool TemporaryFile::becomeTarget() {
  sync();
  if (path_.empty()) {
    const std::string unnamed = "/proc/self/fd/" + std::to_string(file_.get());
    if (::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, target_.c_str(), AT_SYMLINK_FOLLOW) != 0) {
      if (errno == EEXIST) return false;
      fail();
    }
  } else if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) == 0) {
    path_.clear();
  } else {
    if (errno == EEXIST) return false;
    // File systems without that promise have links, as a rule; the hidden name goes with this object.
    if (errno != EINVAL && errno != ENOSYS) fail();
    if (::link(path_.c_str(), target_.c_str()) != 0) {
      if (errno == EEXIST) return false;
      fail();
    }
  }
  syncFolder(folder_);
  return true;
}

void TemporaryFile::sync() const {
  if (::fsync(file_.get()) != 0) fail();
}

void TemporaryFile::fail() const { throwCannotBeWritten(name_); }

TemporaryFolder::TemporaryFolder(const fs::path& parent, const std::string& name) {
  removeLeftBehind(parent);
  while (true) {
    path_ = newHiddenName(parent);
    if (::mkdir(path_.c_str(), 0700) != 0) {
      if (errno == EEXIST) continue;
      throwCannotBeWritten(name);
    }
    lock_ = FileDescriptor(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!lock_.valid()) {
      if (errno == ENOENT) continue;
      const int error = errno;
      ::rmdir(path_.c_str());
      errno = error;
      throwCannotBeWritten(name);
    }
    lockAlone(lock_.get());
    if (isStillAt(path_, lock_.get())) return;
    // Somebody took it for left behind before it was locked.
  }
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path folderOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

void syncFolder(const fs::path& folder) noexcept {
  const FileDescriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.valid()) ::fsync(directory.get());
}

void writeAll(int descriptor, std::string_view content, const std::string& name) {
  while (!content.empty()) {
    const ssize_t count = ::write(descriptor, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throwCannotBeWritten(name);
    content.remove_prefix(static_cast<std::size_t>(count));
  }
}

}  // namespace hexoderm
