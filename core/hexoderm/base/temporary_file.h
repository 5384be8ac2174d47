#pragma once

// Files and folders on their way to their names.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace hexoderm {

/// What the hidden files and folders of writers are called: ".hexoderm-", 16 hexadecimal digits, ".tmp". A writer keeps
/// a lock (flock) on its own, which falls with its process.
inline constexpr std::string_view kTemporaryPrefix = ".hexoderm-";
inline constexpr std::string_view kTemporarySuffix = ".tmp";

/// A descriptor that is closed with its owner.
class FileDescriptor {
 public:
  explicit FileDescriptor(int descriptor = -1) : descriptor_(descriptor) {}
  ~FileDescriptor();
  FileDescriptor(FileDescriptor&& other) noexcept;
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  [[nodiscard]] int get() const { return descriptor_; }
  int release() { return std::exchange(descriptor_, -1); }
  [[nodiscard]] bool valid() const { return descriptor_ >= 0; }

 private:
  int descriptor_;
};

/// Removes what killed writers of this user left in a folder: hidden files and folders that nobody has locked.
void removeLeftBehind(const std::filesystem::path& folder) noexcept;

/// A new file that becomes `target` once it is whole, on the same file system. Until then it has no name at all where
/// the file system can do that (O_TMPFILE), else a hidden one beside the target; it goes away unless it gets its name,
/// also if its process is killed: at once, or with the next file that is written into the folder. Its rights follow the
/// user's umask. All functions throw StorageError, which names `name`.
class TemporaryFile {
 public:
  enum class Naming {
    AtTheEnd,   ///< no name until then, if possible
    AtTheStart  ///< path() is wanted, by somebody who opens files by name
  };
  /// `name` is what errors call the target.
  TemporaryFile(const std::filesystem::path& target, std::string name, Naming naming = Naming::AtTheEnd);
  ~TemporaryFile();

  [[nodiscard]] int descriptor() const { return file_.get(); }
  /// Empty as long as it has no name.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  void write(std::string_view content);
  /// Reads it from the beginning. Throws unless it holds exactly these bytes.
  void requireContent(std::string_view content) const;
  /// Gives it the rights of a file that it is to replace, and its owner and group as far as this user may.
  void keepOwnerAndRights(uid_t owner, gid_t group, mode_t rights) noexcept;
  /// Syncs it and gives it the target's name, in place of a file of that name if requireReplaceable() lets it.
  void replaceTarget();
  /// The same if there is nothing of that name; false if there is.
  [[nodiscard]] bool becomeTarget();

 private:
  void makeHidden();
  void sync() const;
  [[noreturn]] void fail() const;  ///< for the present errno

  std::filesystem::path folder_;
  std::filesystem::path target_;
  std::string name_;
  FileDescriptor file_;
  std::filesystem::path path_;
};

/// A private hidden folder in `parent`, gone with everything in it at the end of the scope; if its process is killed,
/// with the next file that is written into `parent`. Throws StorageError, which names `name`.
class TemporaryFolder {
 public:
  TemporaryFolder(const std::filesystem::path& parent, const std::string& name);
  ~TemporaryFolder();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  FileDescriptor lock_;
};

/// The folder that a file lies in.
std::filesystem::path folderOf(const std::filesystem::path& path);

/// Makes a new name in a folder last through a power cut. Some file systems can't; the name itself is there.
void syncFolder(const std::filesystem::path& folder) noexcept;

/// Writes everything, or throws StorageError, which names `name`.
void writeAll(int descriptor, std::string_view content, const std::string& name);

}  // namespace hexoderm
