#pragma once

// Who may open a *.hexo, and how, so that reading changes nothing and only one writes.

#include "hexoderm/session/store_schema.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hexoderm {

/// Keeps others from writing, or from beginning to write, as long as it lives; gone with the process that holds it.
///
/// An open-file-description lock on one byte of the database file, far behind those that SQLite locks. Its descriptor
/// goes by closeWhenHarmless().
class StoreLock {
 public:
  /// Throws StorageError: missing, not writable, open in another Hexoderm or in this one.
  static StoreLock forWriting(const std::filesystem::path& path, const std::string& name);
  /// nullopt if somebody has it open for writing, here or elsewhere: then its journal is in use, and a reader goes
  /// through that. Throws StorageError if it can't be read.
  static std::optional<StoreLock> forReading(const std::filesystem::path& path, const std::string& name);

  ~StoreLock();
  StoreLock(StoreLock&& other) noexcept;
  StoreLock& operator=(StoreLock&&) = delete;

  /// Of the locked file.
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  explicit StoreLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
  bool is_writer_ = false;
};

/// An open store. Members go in reverse order: the database first, the lock last.
struct StoreFile {
  struct RemoveFolder {
    explicit RemoveFolder(std::filesystem::path folder) : path(std::move(folder)) {}
    ~RemoveFolder();
    RemoveFolder(const RemoveFolder&) = delete;
    RemoveFolder& operator=(const RemoveFolder&) = delete;
    std::filesystem::path path;
  };

  std::optional<StoreLock> lock;
  std::unique_ptr<RemoveFolder> copy{};  ///< the folder of a file that was copied to be read
  Database database;
};

/// Throw StorageError or FormatError; the file is of the newest version then, in memory if it can't be changed.
StoreFile openStoreForWriting(const std::filesystem::path& path, Migrations migrations = storeMigrations());
StoreFile openStoreForReading(const std::filesystem::path& path, Migrations migrations = storeMigrations());

/// The same for the bytes of a file.
StoreFile openStoreBytes(std::string_view bytes, const std::string& name, Migrations migrations = storeMigrations());

/// True for a regular file that begins as every session store does. Throws StorageError if a file that is there can't
/// be read.
bool looksLikeStore(const std::filesystem::path& path);
bool beginsAsStore(std::string_view bytes);

}  // namespace hexoderm
