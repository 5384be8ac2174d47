#pragma once

// Files that nothing is written in the place of.

#include "hexoderm/base/database_files.h"

#include <filesystem>
#include <optional>
#include <string>

namespace hexoderm {

/// Throws if what lies at `path`, links followed, must not be replaced; `name` is what the error calls it.
/// StorageError: a session (*.hexo), told by its content, what SQLite keeps beside one, under whatever name, and a name
/// beside which such a file lies. InvalidArgument: a file that is kept.
void requireReplaceable(const std::filesystem::path& path, const std::string& name);
/// StorageError if a file that SQLite would take for its own lies beside a session that is to be made.
void requireNothingBeside(const std::filesystem::path& path);
/// It is kept, under whatever name.
[[nodiscard]] bool isKept(const std::filesystem::path& path);

/// Keeps a file, if there is one, as long as it lives: under whatever name, nothing replaces it.
class KeptFile {
 public:
  explicit KeptFile(const std::filesystem::path& path);
  ~KeptFile();
  KeptFile(const KeptFile&) = delete;
  KeptFile& operator=(const KeptFile&) = delete;

 private:
  std::optional<FileIdentity> identity_;
};

/// From now on every file that this process reads is kept to its end. For programs that run one command.
void keepWhatIsRead();
[[nodiscard]] bool keepsWhatIsRead();
/// That a file is an input. Whatever reads one says so.
void noteRead(const std::filesystem::path& path);

}  // namespace hexoderm
