#pragma once

// SQLite with Hexoderm's errors.

#include "hexoderm/base/message.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace hexoderm {

/// A connection. Every error of SQLite becomes an Error that names the file as the user does and says what to do:
/// StorageError for what the disk, the rights or another program refuse, FormatError for content that is not what was
/// expected.
class Database {
 public:
  enum class Mode {
    Create,     ///< an existing empty file
    ReadWrite,  ///< an existing database
    ReadOnly,   ///< uses, and where it can makes, the index beside the journal ("-shm")
    Immutable,  ///< neither looks for a journal nor locks: only where nobody can write
  };
  /// `path` is opened; `name` is what errors call it.
  Database(const std::string& path, std::string name, Mode mode);
  /// Opens a database in memory.
  explicit Database(std::string name);

  /// Opens the bytes of a database file, in memory; nothing is written.
  static Database ofBytes(std::string_view bytes, std::string name);

  void run(const char* sql);  ///< one or several statements without results
  [[nodiscard]] std::int64_t number(const char* sql);
  [[nodiscard]] std::string text(const char* sql);
  /// Copies everything into an empty database.
  void copyTo(Database& other);
  /// A copy of everything, in memory.
  [[nodiscard]] Database copyInMemory();
  /// Gives up with a FormatError when the next queries take more than about this many steps of SQLite's machine; 0 ends
  /// the limit. Against databases that were made to keep a reader busy.
  void limitWork(int steps);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] sqlite3* handle() const { return handle_.get(); }
  /// Throws what `code` and the connection's last error mean.
  [[noreturn]] void fail(int code) const;
  [[noreturn]] void failFormat(const Message& what) const;

 private:
  struct Close {
    void operator()(sqlite3* handle) const noexcept;
  };
  void configure();

  std::string name_;
  std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement; bound values are numbered from 1, columns from 0.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);
  Statement& bind(int place, std::int64_t value);
  Statement& bindText(int place, std::string_view value);               ///< kept by the caller until done
  Statement& bindBlob(int place, std::span<const std::uint8_t> value);  ///< kept by the caller until done
  /// True: there is a row. Throws.
  bool step();
  /// Columns of the current row; FormatError where the type is another.
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] std::string_view text(int column) const;               ///< until the next step
  [[nodiscard]] std::span<const std::uint8_t> blob(int column) const;  ///< until the next step
  [[nodiscard]] bool isNull(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const noexcept;
  };
  Statement& bound(int code);
  void requireType(int column, int type, const Message& expected) const;

  Database* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// Rolled back unless committed.
class Transaction {
 public:
  explicit Transaction(Database& database);  ///< takes the right to write at once
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database* database_;
};

}  // namespace hexoderm
