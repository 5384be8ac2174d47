#include "hexoderm/session/sqlite_database.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/system_reason.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <new>

namespace hexoderm {
namespace {

constexpr int kBusyMilliseconds = 2000;

/// "file:" address of a path: what has a meaning in addresses is escaped.
std::string immutableAddress(const std::string& path) {
  std::string address = "file://";
  for (const char c : path) {
    if (c == '%' || c == '?' || c == '#') {
      address += fmt::format("%{:02X}", static_cast<unsigned>(c));
    } else {
      address += c;
    }
  }
  return address + "?immutable=1";
}

[[noreturn]] void throwError(int code, const std::string& name, const std::string& detail, int system_error) {
  const Message reason = system_error != 0 ? systemReason(system_error) : Message::verbatim(detail);
  const auto full = [&] {
    return StorageError(name, message("the disk is full: free some space; what was stored before is intact"));
  };
  const auto read_only = [&] {
    return StorageError(
        name, message("cannot be written ({}): make the file and its folder writable, or save the session elsewhere",
                      reason));
  };
  switch (code & 0xFF) {
    case SQLITE_NOMEM:
      throw std::bad_alloc();
    case SQLITE_FULL:
      throw full();
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
      throw read_only();
    case SQLITE_CANTOPEN:
      throw StorageError(name, message("cannot be opened: {}", reason));
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_PROTOCOL:
      throw StorageError(name, message("another program is writing to it: close that program and try again"));
    case SQLITE_IOERR:
      if (system_error == ENOSPC || system_error == EDQUOT) throw full();
      if (system_error == EROFS || system_error == EACCES) throw read_only();
      if (code == SQLITE_IOERR_SHORT_READ) {
        throw FormatError(name, message("the file ends in the middle (truncated?), expected a whole Hexoderm session"));
      }
      throw StorageError(name, message("the disk does not read or write it ({}): check the disk and try again; "
                                       "what was stored before is kept as far as the disk has it",
                                       reason));
    case SQLITE_NOTADB:
      throw FormatError(name, message("is not a Hexoderm session, expected an SQLite database (*.hexo)"));
    default:
      throw FormatError(name, message("the file is damaged, expected the database of a Hexoderm session ({})", detail));
  }
}

}  // namespace

void Database::Close::operator()(sqlite3* handle) const noexcept { sqlite3_close(handle); }

Database::Database(const std::string& path, std::string name, Mode mode) : name_(std::move(name)) {
  // No SQLITE_OPEN_CREATE: who creates has made an empty file, so that nothing appears by mistake.
  int flags = SQLITE_OPEN_FULLMUTEX | SQLITE_OPEN_EXRESCODE;
  flags |= mode == Mode::Create || mode == Mode::ReadWrite ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY;
  if (mode == Mode::Immutable) flags |= SQLITE_OPEN_URI;
  sqlite3* handle = nullptr;
  const int code =
      sqlite3_open_v2(mode == Mode::Immutable ? immutableAddress(path).c_str() : path.c_str(), &handle, flags, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) fail(code);
  if (mode == Mode::ReadWrite && sqlite3_db_readonly(handle, "main") == 1) {
    throwError(SQLITE_READONLY, name_, "it is read-only", 0);
  }
  configure();
}

Database::Database(std::string name) : name_(std::move(name)) {
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(":memory:", &handle, SQLITE_OPEN_READWRITE | SQLITE_OPEN_EXRESCODE, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) fail(code);
  configure();
}

Database Database::ofBytes(std::string_view bytes, std::string name) {
  Database database(std::move(name));
  auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(std::max<std::size_t>(bytes.size(), 1)));
  if (copy == nullptr) throw std::bad_alloc();
  std::ranges::copy(bytes, copy);
  // A database in memory has no journal beside it: it must not say that it has.
  constexpr std::array<std::size_t, 2> kJournalModes = {18, 19};
  constexpr unsigned char kWithoutWal = 1;
  for (const std::size_t place : kJournalModes) {
    if (place < bytes.size()) copy[place] = kWithoutWal;
  }
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  const int code = sqlite3_deserialize(database.handle(), "main", copy, size, size,
                                       SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_READONLY);
  if (code != SQLITE_OK) database.fail(code);
  return database;
}

void Database::configure() {
  sqlite3_busy_timeout(handle(), kBusyMilliseconds);
  // A file may come from anywhere: its schema runs no functions, and it can't be damaged by statements.
  sqlite3_db_config(handle(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle(), SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  // A mapped file that shrinks would end the program.
  run("PRAGMA mmap_size=0; PRAGMA foreign_keys=ON; PRAGMA cell_size_check=ON");
}

void Database::run(const char* sql) {
  const int code = sqlite3_exec(handle(), sql, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code);
}

std::int64_t Database::number(const char* sql) {
  Statement statement(*this, sql);
  if (!statement.step()) failFormat(message("expected a number"));
  return statement.integer(0);
}

std::string Database::text(const char* sql) {
  Statement statement(*this, sql);
  if (!statement.step()) failFormat(message("expected a text"));
  return std::string(statement.text(0));
}

void Database::copyTo(Database& other) {
  sqlite3_backup* backup = sqlite3_backup_init(other.handle(), "main", handle(), "main");
  if (backup == nullptr) other.fail(sqlite3_extended_errcode(other.handle()));
  const int stepped = sqlite3_backup_step(backup, -1);
  const int finished = sqlite3_backup_finish(backup);
  if (stepped != SQLITE_DONE) fail(stepped);
  if (finished != SQLITE_OK) fail(finished);
}

Database Database::copyInMemory() {
  Database copy(name_);
  copyTo(copy);
  return copy;
}

void Database::limitWork(int steps) {
  int (*const give_up)(void*) = [](void*) { return 1; };
  sqlite3_progress_handler(handle(), steps, steps > 0 ? give_up : nullptr, nullptr);
}

void Database::fail(int code) const {
  if (handle_ == nullptr) throw std::bad_alloc();
  const int system_error = sqlite3_system_errno(handle());
  const int kind = code & 0xFF;
  // The number stays from earlier failures, so it says something only about those that come from the system.
  const bool from_system = kind == SQLITE_CANTOPEN || kind == SQLITE_IOERR;
  throwError(code, name_, sqlite3_errmsg(handle()), from_system ? system_error : 0);
}

void Database::failFormat(const Message& what) const { throw FormatError(name_, what); }

void Statement::Finalize::operator()(sqlite3_stmt* statement) const noexcept { sqlite3_finalize(statement); }

Statement::Statement(Database& database, std::string_view sql) : database_(&database) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(database.handle(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
  statement_.reset(statement);
  if (code != SQLITE_OK) database.fail(code);
}

Statement& Statement::bound(int code) {
  if (code != SQLITE_OK) database_->fail(code);
  return *this;
}

Statement& Statement::bind(int place, std::int64_t value) {
  return bound(sqlite3_bind_int64(statement_.get(), place, value));
}

Statement& Statement::bindText(int place, std::string_view value) {
  return bound(sqlite3_bind_text64(statement_.get(), place, value.data(), value.size(), SQLITE_STATIC, SQLITE_UTF8));
}

Statement& Statement::bindBlob(int place, std::span<const std::uint8_t> value) {
  // A null pointer would bind NULL, which is another value than nothing.
  static constexpr std::uint8_t kNothing = 0;
  return bound(sqlite3_bind_blob64(statement_.get(), place, value.empty() ? &kNothing : value.data(), value.size(),
                                   SQLITE_STATIC));
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  database_->fail(code);
}

void Statement::requireType(int column, int type, const Message& expected) const {
  if (sqlite3_column_type(statement_.get(), column) == type) return;
  database_->failFormat(
      message("the file is damaged: column {}: expected {}", sqlite3_column_name(statement_.get(), column), expected));
}

std::int64_t Statement::integer(int column) const {
  requireType(column, SQLITE_INTEGER, message("a whole number"));
  return sqlite3_column_int64(statement_.get(), column);
}

std::string_view Statement::text(int column) const {
  requireType(column, SQLITE_TEXT, message("a text"));
  const unsigned char* text = sqlite3_column_text(statement_.get(), column);
  if (text == nullptr) database_->fail(SQLITE_NOMEM);
  return {reinterpret_cast<const char*>(text),
          static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

std::span<const std::uint8_t> Statement::blob(int column) const {
  requireType(column, SQLITE_BLOB, message("binary data"));
  const void* blob = sqlite3_column_blob(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  if (blob == nullptr && size > 0) database_->fail(SQLITE_NOMEM);
  return {static_cast<const std::uint8_t*>(blob), static_cast<std::size_t>(size)};
}

bool Statement::isNull(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL; }

Transaction::Transaction(Database& database) : database_(&database) { database.run("BEGIN IMMEDIATE"); }

Transaction::~Transaction() {
  // SQLite has already rolled back where it had to.
  if (database_ != nullptr && sqlite3_get_autocommit(database_->handle()) == 0) {
    sqlite3_exec(database_->handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::commit() {
  database_->run("COMMIT");
  database_ = nullptr;
}

}  // namespace hexoderm
