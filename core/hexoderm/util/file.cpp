#include "hexoderm/util/file.h"

#include "hexoderm/util/error.h"
#include "hexoderm/util/system_reason.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <memory>
#include <system_error>

namespace hexoderm {
namespace {

Message reason() { return systemReason(errno); }

class FileDescriptor {
 public:
  explicit FileDescriptor(int fd) : fd_(fd) {}
  ~FileDescriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool valid() const { return fd_ >= 0; }
  int close() {
    const int result = ::close(fd_);
    fd_ = -1;
    return result;
  }

 private:
  int fd_;
};

}  // namespace

std::string readFile(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw StorageError(located(path.string(), message("is a folder, expected a file")));
  }
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.valid()) throw StorageError(located(path.string(), message("cannot be read: {}", reason())));
  std::string content;
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw StorageError(located(path.string(), message("cannot be read: {}", reason())));
    if (count == 0) return content;
    content.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

void writeFileAtomically(const std::filesystem::path& path, std::string_view content) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  std::string temporary = (folder / ("." + path.filename().string() + ".XXXXXX")).string();
  const auto fail = [&](const Message& what) {
    ::unlink(temporary.c_str());
    throw StorageError(located(path.string(), what));
  };

  if (std::filesystem::is_directory(path))
    throw StorageError(located(path.string(), message("is a folder, cannot be written as a file")));
  FileDescriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
  if (!file.valid()) throw StorageError(located(path.string(), message("cannot be written: {}", reason())));
  // mkostemp makes a private file; a saved document follows the user's umask like any other.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(file.get(), 0666 & ~mask) != 0) fail(message("cannot be written: {}", reason()));

  std::string_view rest = content;
  while (!rest.empty()) {
    const ssize_t count = ::write(file.get(), rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(message("cannot be written: {}", reason()));
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  if (::fsync(file.get()) != 0 || file.close() != 0) fail(message("cannot be written: {}", reason()));
  if (::rename(temporary.c_str(), path.c_str()) != 0) fail(message("cannot be replaced: {}", reason()));
  const FileDescriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.valid()) ::fsync(directory.get());  // some file systems can't sync a folder; the rename itself is done
}

}  // namespace hexoderm
