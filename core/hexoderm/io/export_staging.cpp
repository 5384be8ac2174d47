#include "hexoderm/io/export_staging.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/system_reason.h"
#include "hexoderm/base/temporary_file.h"

#include <string_view>
#include <system_error>
#include <utility>

namespace hexoderm {
namespace {

namespace fs = std::filesystem;

void renameOver(const fs::path& from, const fs::path& to) {
  requireReplaceable(to, to.string());
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw StorageError(to.string(), message("cannot be replaced: {}", systemReason(error)));
}

/// The kind of what has a name, itself if it is a link.
fs::file_status statusOf(const fs::path& path, bool follow) {
  std::error_code error;
  const fs::file_status status = follow ? fs::status(path, error) : fs::symlink_status(path, error);
  if (status.type() == fs::file_type::none)
    throw StorageError(path.string(), message("cannot be written: {}", systemReason(error)));
  return status;
}

void makeFolder(const fs::path& folder, const fs::path& target) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (error) throw StorageError(target.string(), message("cannot be written: {}", systemReason(error)));
}

/// What fails is said of `target`, where the file will be.
void writeStaged(const fs::path& staged, const fs::path& target, std::string_view content) {
  TemporaryFile file(staged, target.string());
  file.write(content);
  file.requireContent(content);
  file.replaceTarget();
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
    const fs::file_status earlier = statusOf(target, false);
    const bool had_earlier = fs::exists(earlier);
    if (had_earlier) {
      if (!fs::is_regular_file(earlier))
        throw StorageError(target.string(), message("is not a file, and is not replaced by one"));
      std::error_code error;
      fs::copy_file(target, backups_ / target.filename(), error);
      if (!error) fs::permissions(staged, earlier.permissions() & fs::perms::all, error);
      if (error) throw StorageError(target.string(), message("cannot be replaced: {}", systemReason(error)));
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

std::vector<fs::path> publishFolder(const fs::path& folder, const std::vector<StagedFile>& files,
                                    const std::function<void()>& before_each) {
  const fs::path target = folder.has_filename() ? folder : folder.parent_path();  // "out/" means "out"
  const fs::file_status status = statusOf(target, true);
  const bool there = fs::exists(status);
  if (there && !fs::is_directory(status)) throw StorageError(target.string(), message("is a file, expected a folder"));

  for (const StagedFile& file : files) requireReplaceable(target / file.name, (target / file.name).string());
  const TemporaryFolder temporary(there ? target : folderOf(target), target.string());
  // The temporary folder is private; these become the user's and follow the umask.
  const fs::path staged = temporary.path() / "new";
  const fs::path backups = temporary.path() / "old";
  makeFolder(staged, target);
  makeFolder(backups, target);
  std::vector<fs::path> paths;
  for (const StagedFile& file : files) {
    if (before_each) before_each();
    writeStaged(staged / file.name, target / file.name, file.content);
    paths.push_back(target / file.name);
  }
  if (before_each) before_each();

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
