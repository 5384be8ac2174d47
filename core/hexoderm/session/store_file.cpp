#include "hexoderm/session/store_file.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/system_reason.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>

namespace hexoderm {
namespace {

/// SQLite locks 512 bytes from 0x40000000 on and stores nothing in the page around them.
constexpr off_t kLockedByte = 0x40000000 + 2048;
/// A reader holds a file for the time that it takes to load it.
constexpr auto kPatienceWithReaders = std::chrono::seconds(2);

struct flock lockOf(short type) {
  struct flock lock {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = kLockedByte;
  lock.l_len = 1;
  return lock;
}

enum class Locked { Yes, ByReader, ByWriter, NotPossible };

Locked tryLock(int descriptor, short type) {
  while (true) {
    struct flock lock = lockOf(type);
    if (::fcntl(descriptor, F_OFD_SETLK, &lock) == 0) return Locked::Yes;
    if (errno == EINTR) continue;
    if (errno != EAGAIN && errno != EACCES) return Locked::NotPossible;
    lock = lockOf(type);
    if (::fcntl(descriptor, F_OFD_GETLK, &lock) != 0) return Locked::NotPossible;
    if (lock.l_type == F_UNLCK) continue;  // let go in between
    return lock.l_type == F_WRLCK ? Locked::ByWriter : Locked::ByReader;
  }
}

/// The file itself where `path` is a link to it: SQLite's journal lies beside the file.
std::filesystem::path fileBehind(const std::filesystem::path& path, const std::string& name) {
  std::error_code error;
  std::filesystem::path real = std::filesystem::canonical(path, error);
  if (error) throw StorageError(name, message("cannot be opened: {}", systemReason(error)));
  if (std::filesystem::is_directory(real, error)) throw StorageError(name, message("is a folder, expected a file"));
  if (!std::filesystem::is_regular_file(real, error)) throw StorageError(name, message("is not a file, expected one"));
  return real;
}

bool hasJournal(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file.string() + "-wal", error);
  return !error && size > 0;
}

/// SQLite takes an empty file for an empty database; to us it is a file that lost its content.
void requireContent(const std::filesystem::path& file, const std::string& name) {
  std::error_code error;
  if (std::filesystem::file_size(file, error) == 0 && !error && !hasJournal(file)) {
    throw FormatError(name, message("the file is empty, expected a Hexoderm session"));
  }
}

std::unique_ptr<StoreFile::RemoveFolder> copyToTemporaryFolder(const std::filesystem::path& file,
                                                               const std::string& name) {
  try {
    std::string folder = (std::filesystem::temp_directory_path() / "hexoderm-read-XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr)
      throw StorageError(name, message("no copy can be made to read it: {}", systemReason(errno)));
    auto copy = std::make_unique<StoreFile::RemoveFolder>(folder);
    std::filesystem::copy_file(file, copy->path / "session.hexo");
    if (hasJournal(file)) std::filesystem::copy_file(file.string() + "-wal", copy->path / "session.hexo-wal");
    for (const auto& entry : std::filesystem::directory_iterator(copy->path)) {
      std::filesystem::permissions(entry.path(),
                                   std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    }
    return copy;
  } catch (const std::filesystem::filesystem_error& error) {
    throw StorageError(name, message("no copy can be made to read it: {}", systemReason(error.code())));
  }
}

/// Opens it and reads one number, which makes SQLite look at the journal.
Database tried(const std::filesystem::path& file, const std::string& name, Database::Mode mode) {
  Database database(file.string(), name, mode);
  static_cast<void>(database.number("SELECT count(*) FROM (SELECT 1 FROM sqlite_schema LIMIT 1)"));
  return database;
}

/// SQLite reads a last page that is cut off as if the rest were zero. Only for files without a journal, which may hold
/// the rest.
void requireWholePages(Database& database, std::uintmax_t size) {
  const std::int64_t expected = database.number("PRAGMA page_count") * database.number("PRAGMA page_size");
  if (size < static_cast<std::uintmax_t>(expected)) {
    database.failFormat(
        message("the file ends in the middle (truncated?): expected {} bytes, found {}", expected, size));
  }
}
void requireWholePages(Database& database, const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (!error) requireWholePages(database, size);
}

StoreFile openUnchanged(const std::filesystem::path& path, const std::string& name) {
  const std::filesystem::path file = fileBehind(path, name);
  noteRead(file);
  std::optional<StoreLock> lock = StoreLock::forReading(file, name);
  requireContent(file, name);
  if (lock && !hasJournal(file)) {
    Database database = tried(file, name, Database::Mode::Immutable);
    requireWholePages(database, file);
    return {std::move(lock), nullptr, std::move(database)};
  }
  // There is a journal, of a process that is writing or was killed. SQLite reads through it, but wants to keep an index
  // beside it; where it can't, a copy is read.
  try {
    Database database = tried(file, name, Database::Mode::ReadOnly);
    return {std::move(lock), nullptr, std::move(database)};
  } catch (const StorageError&) {
    auto copy = copyToTemporaryFolder(file, name);
    Database database = tried(copy->path / "session.hexo", name, Database::Mode::ReadWrite);
    return {std::move(lock), std::move(copy), std::move(database)};
  }
}

}  // namespace

StoreLock StoreLock::forWriting(const std::filesystem::path& path, const std::string& name) {
  const auto open_here = [&] {
    return StorageError(name, message("is already open for writing in this Hexoderm: close it there first"));
  };
  if (isOpenDatabase(path)) throw open_here();
  StoreLock lock(::open(path.c_str(), O_RDWR | O_CLOEXEC));
  if (lock.descriptor_ < 0) {
    throw StorageError(
        name, message("cannot be written: {}; make the file writable, or open it for reading and save it elsewhere",
                      systemReason(errno)));
  }
  const auto deadline = std::chrono::steady_clock::now() + kPatienceWithReaders;
  Locked locked = tryLock(lock.descriptor_, F_WRLCK);
  while (locked == Locked::ByReader && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    locked = tryLock(lock.descriptor_, F_WRLCK);
  }
  switch (locked) {
    case Locked::Yes:
      break;
    case Locked::ByWriter:
      if (isOpenDatabase(path)) throw open_here();
      throw StorageError(name,
                         message("another Hexoderm has it open for writing: close it there, or open it for reading"));
    case Locked::ByReader:
      throw StorageError(name, message("another Hexoderm is reading it: wait until it has done and try again"));
    case Locked::NotPossible:
      throw StorageError(
          name, message("cannot be locked against a second writer: {}; keep sessions on a disk of this machine",
                        systemReason(errno)));
  }
  addOpenDatabase(lock.descriptor_);
  lock.is_writer_ = true;
  return lock;
}

std::optional<StoreLock> StoreLock::forReading(const std::filesystem::path& path, const std::string& name) {
  if (isOpenDatabase(path)) return std::nullopt;
  StoreLock lock(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (lock.descriptor_ < 0) throw StorageError(name, message("cannot be read: {}", systemReason(errno)));
  // A file system without locks has no second reader to be careful of either.
  if (tryLock(lock.descriptor_, F_RDLCK) == Locked::ByWriter) return std::nullopt;
  return lock;
}

StoreLock::StoreLock(StoreLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), is_writer_(std::exchange(other.is_writer_, false)) {}

StoreLock::~StoreLock() { closeWhenHarmless(descriptor_, is_writer_); }

StoreFile::RemoveFolder::~RemoveFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

StoreFile openStoreForWriting(const std::filesystem::path& path, Migrations migrations) {
  const std::string name = path.string();
  const std::filesystem::path file = fileBehind(path, name);
  StoreLock lock = StoreLock::forWriting(file, name);
  requireContent(file, name);
  const bool has_journal = hasJournal(file);
  StoreFile store{std::move(lock), nullptr, tried(file, name, Database::Mode::ReadWrite)};
  Database& database = store.database;
  if (!has_journal) requireWholePages(database, file);
  const std::size_t version = requireStoreVersion(database, migrations);
  requireSchema(database, migrations, version);
  // Entries appended to a damaged file might be lost with it.
  const std::string damage = database.text("PRAGMA quick_check(1)");
  if (damage != "ok") database.failFormat(message("the file is damaged, expected a whole database: {}", damage));
  if (database.text("PRAGMA journal_mode=WAL") != "wal") {
    throw StorageError(name,
                       message("its file system can't keep a journal (WAL): keep sessions on a disk of this machine"));
  }
  database.run("PRAGMA synchronous=FULL");
  migrate(database, migrations);
  return store;
}

namespace {

/// Checks an open store and brings it to the newest version in memory.
StoreFile requireStore(StoreFile store, Migrations migrations) {
  const std::size_t version = requireStoreVersion(store.database, migrations);
  requireSchema(store.database, migrations, version);
  if (version == migrations.size()) return store;
  Database newer = store.database.copyInMemory();
  migrate(newer, migrations);
  return {std::nullopt, nullptr, std::move(newer)};
}

}  // namespace

StoreFile openStoreForReading(const std::filesystem::path& path, Migrations migrations) {
  return requireStore(openUnchanged(path, path.string()), migrations);
}

StoreFile openStoreBytes(std::string_view bytes, const std::string& name, Migrations migrations) {
  Database database = Database::ofBytes(bytes, name);
  requireWholePages(database, bytes.size());
  return requireStore({std::nullopt, nullptr, std::move(database)}, migrations);
}

bool looksLikeStore(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  if (isOpenDatabase(path)) return true;
  return beginsAsStore(firstBytes(path, kSqliteHeader.size()));
}

bool beginsAsStore(std::string_view bytes) { return bytes.starts_with(kSqliteHeader); }

}  // namespace hexoderm
