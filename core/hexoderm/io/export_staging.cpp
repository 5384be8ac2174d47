#include "hexoderm/io/export_staging.h"

#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/system_reason.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

namespace hexoderm {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// A private folder on the target's file system, gone with everything in it at the end of the scope.
class TemporaryFolder {
 public:
  TemporaryFolder(const fs::path& parent, const fs::path& target) {
    std::string name = (parent / ("." + target.filename().string() + ".XXXXXX")).string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw StorageError(located(target.string(), message("cannot be written: {}", systemReason(errno))));
    }
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void renameOver(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw StorageError(located(to.string(), message("cannot be replaced: {}", systemReason(error))));
}

/// Makes a rename last through a power cut; some file systems can't sync a folder, and the rename itself is done.
void syncFolder(const fs::path& folder) {
  const int directory = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (directory < 0) return;
  ::fsync(directory);
  ::close(directory);
}

void writeAndVerify(const StagedFile& file, const fs::path& folder) {
  const fs::path staged = folder / file.name;
  writeFileAtomically(staged, file.content);
  file.verify(readFile(staged));
}

/// Puts back what was there before, unless told that all went well.
class Replacements {
 public:
  explicit Replacements(fs::path backups) : backups_(std::move(backups)) {}
  ~Replacements() {
    if (kept_) return;
    std::error_code ignored;
    for (auto done = done_.rbegin(); done != done_.rend(); ++done) {
      if (done->had_earlier) {
        fs::rename(backups_ / done->target.filename(), done->target, ignored);
      } else {
        fs::remove(done->target, ignored);
      }
    }
  }
  Replacements(const Replacements&) = delete;
  Replacements& operator=(const Replacements&) = delete;

  void replace(const fs::path& staged, const fs::path& target) {
    const bool had_earlier = fs::exists(target);
    if (had_earlier) {
      std::error_code error;
      fs::copy_file(target, backups_ / target.filename(), error);
      if (error) throw StorageError(located(target.string(), message("cannot be replaced: {}", systemReason(error))));
    }
    renameOver(staged, target);
    done_.push_back({target, had_earlier});
  }
  void keep() { kept_ = true; }

 private:
  struct Done {
    fs::path target;
    bool had_earlier = false;
  };
  fs::path backups_;
  std::vector<Done> done_;
  bool kept_ = false;
};

}  // namespace

void publishFile(const fs::path& path, std::string content, VerifyBytes verify) {
  if (fs::is_directory(path))
    throw StorageError(located(path.string(), message("is a folder, cannot be written as a file")));
  const TemporaryFolder temporary(folderOf(path), path);
  const StagedFile file{path.filename().string(), std::move(content), std::move(verify)};
  writeAndVerify(file, temporary.path());
  renameOver(temporary.path() / file.name, path);
  syncFolder(folderOf(path));
}

std::vector<fs::path> publishFolder(const fs::path& folder, const std::vector<StagedFile>& files) {
  const fs::path target = folder.has_filename() ? folder : folder.parent_path();  // "out/" means "out"
  const bool there = fs::exists(target);
  if (there && !fs::is_directory(target))
    throw StorageError(located(target.string(), message("is a file, expected a folder")));

  const TemporaryFolder temporary(there ? target : folderOf(target), target);
  // The temporary folder is private; these become the user's and follow the umask.
  const fs::path staged = temporary.path() / "new";
  const fs::path backups = temporary.path() / "old";
  fs::create_directory(staged);
  fs::create_directory(backups);
  std::vector<fs::path> paths;
  for (const StagedFile& file : files) {
    writeAndVerify(file, staged);
    paths.push_back(target / file.name);
  }

  if (there) {
    Replacements replacements(backups);
    for (const StagedFile& file : files) replacements.replace(staged / file.name, target / file.name);
    replacements.keep();
    syncFolder(target);
  } else {
    renameOver(staged, target);
    syncFolder(folderOf(target));
  }
  return paths;
}

}  // namespace hexoderm
