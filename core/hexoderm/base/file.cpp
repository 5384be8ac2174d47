#include "hexoderm/base/file.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/system_reason.h"
#include "hexoderm/base/temporary_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <optional>
#include <system_error>

namespace hexoderm {
namespace {

[[noreturn]] void failToWrite(const std::filesystem::path& path, const Message& why) {
  throw StorageError(path.string(), message("cannot be written: {}", why));
}

/// What lies at a path, links followed; nullopt if there is nothing.
std::optional<struct stat> statusAt(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) return status;
  if (errno != ENOENT) failToWrite(path, systemReason(errno));
  std::error_code error;
  const std::filesystem::path target = std::filesystem::read_symlink(path, error);
  if (error) return std::nullopt;
  throw StorageError(path.string(), message("is a link to {}, where there is nothing: make that file or remove "
                                            "the link first",
                                            target.string()));
}

/// The file itself where `path` is a link to it.
std::filesystem::path fileItself(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  std::filesystem::path file = std::filesystem::canonical(path, error);
  if (error) failToWrite(path, systemReason(error));
  return file;
}

/// While it lives, a reader of a pipe that goes away is an error of write() instead of the end of the program.
class BrokenPipeIsAnError {
 public:
  BrokenPipeIsAnError() {
    sigset_t pending;
    ::sigemptyset(&signal_);
    ::sigaddset(&signal_, SIGPIPE);
    ::sigpending(&pending);
    was_pending_ = ::sigismember(&pending, SIGPIPE) == 1;
    ::pthread_sigmask(SIG_BLOCK, &signal_, &before_);
  }
  ~BrokenPipeIsAnError() {
    constexpr struct timespec kAtOnce {};
    if (!was_pending_) {
      while (::sigtimedwait(&signal_, nullptr, &kAtOnce) < 0 && errno == EINTR) continue;
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  BrokenPipeIsAnError(const BrokenPipeIsAnError&) = delete;
  BrokenPipeIsAnError& operator=(const BrokenPipeIsAnError&) = delete;

 private:
  sigset_t signal_{};
  sigset_t before_{};
  bool was_pending_ = false;
};

void writeInto(const std::filesystem::path& path, const ProduceBytes& produce) {
  const BrokenPipeIsAnError guard;
  const FileDescriptor device(::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
  if (!device.valid()) failToWrite(path, systemReason(errno));
  produce([&](std::string_view bytes) { writeAll(device.get(), bytes, path.string()); });
}

void writeNew(const std::filesystem::path& path, const std::string& name, const ProduceBytes& produce,
              const std::optional<std::string_view>& whole, const std::optional<struct stat>& earlier) {
  TemporaryFile file(path, name);
  produce([&](std::string_view bytes) { file.write(bytes); });
  if (whole) file.requireContent(*whole);
  if (!earlier && file.becomeTarget()) return;
  if (earlier) file.keepOwnerAndRights(earlier->st_uid, earlier->st_gid, earlier->st_mode);
  file.replaceTarget();
}

/// `whole`: what `produce` gives, where it is in memory. `before_device` is called before the first byte goes where it
/// can't be taken back.
void writeDocument(const std::filesystem::path& path, const ProduceBytes& produce,
                   const std::optional<std::string_view>& whole, const std::function<void()>& before_device) {
  requireReplaceable(path, path.string());
  const std::optional<struct stat> earlier = statusAt(path);
  if (!earlier) return writeNew(path, path.string(), produce, whole, earlier);
  if (S_ISDIR(earlier->st_mode)) throw StorageError(path.string(), message("is a folder, cannot be written as a file"));
  if (S_ISFIFO(earlier->st_mode) || S_ISCHR(earlier->st_mode)) {
    before_device();
    return writeInto(path, produce);
  }
  if (!S_ISREG(earlier->st_mode))
    throw StorageError(path.string(), message("is a disk or a socket, nothing is written to it"));
  if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) failToWrite(path, systemReason(errno));
  writeNew(fileItself(path), path.string(), produce, whole, earlier);
}

}  // namespace

std::string readFile(const std::filesystem::path& path, std::uintmax_t most) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (!file.valid() || ::fstat(file.get(), &status) != 0)
    throw StorageError(path.string(), message("cannot be read: {}", systemReason(errno)));
  if (S_ISDIR(status.st_mode)) throw StorageError(path.string(), message("is a folder, expected a file"));
  const auto refuse = [&] {
    constexpr std::uintmax_t kMegabyte = 1'000'000;
    throw FormatError(path.string(), message("is too large or does not end: at most {} MB are read", most / kMegabyte));
  };
  noteRead(path);
  std::string content;
  if (S_ISREG(status.st_mode)) {
    if (static_cast<std::uintmax_t>(status.st_size) > most) refuse();
    content.reserve(static_cast<std::size_t>(status.st_size));
  }
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw StorageError(path.string(), message("cannot be read: {}", systemReason(errno)));
    if (count == 0) return content;
    content.append(buffer.data(), static_cast<std::size_t>(count));
    if (content.size() > most) refuse();
  }
}

void writeFileAtomically(const std::filesystem::path& path, std::string_view content) {
  writeDocument(
      path, [&](const WriteBytes& write) { write(content); }, content, [] {});
}

void writeFileAtomically(const std::filesystem::path& path, const ProduceBytes& produce) {
  writeDocument(path, produce, std::nullopt, [&] { produce([](std::string_view /*bytes*/) {}); });
}

}  // namespace hexoderm
