#pragma once

#include "hexoderm/base/message.h"
#include "hexoderm/session/session_edit.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hexoderm {

/// The origin of the session.
struct SetSource {
  SourceDescription source;
};
/// The truth of a simulated skin.
struct SetTruth {
  GroundTruth truth;
};
/// Options that were used, as the text of a JSON object.
struct SetOptions {
  std::string json;
};
/// An entry of a file's journal: an edit of the session, or a fact about it that nobody edits.
using StoreOperation = std::variant<SessionEdit, SetSource, SetTruth, SetOptions>;

/// The capture that the operation adds; null if it is another one.
const AddPose* addedPose(const StoreOperation& operation);

/// An entry of a file's journal, as people may want to see it.
struct JournalLine {
  std::uint64_t revision = 0;
  std::int64_t at_ms = 0;  ///< milliseconds since 1970, UTC
  std::string kind;        ///< "capture", "remove", ...: core/hexoderm/session/README.md lists them
};

/// A session file `*.hexo` (the layout is in core/hexoderm/session/README.md): an SQLite database with an append-only
/// journal of everything that was done. A capture is never changed and never removed.
///
/// Once append() has returned, its operations are on disk: killed at any moment, the session reopens with all of them,
/// and without parts of others. One writer at a time, across processes; any number of readers beside it. If a file
/// can't be written (full disk, read-only folder), it stays as it was, and the call can be repeated.
///
/// All functions throw StorageError (missing, not permitted, full, open elsewhere) or FormatError (not a session,
/// damaged, of a newer version), which name the file. Belongs to one thread at a time, and can be moved to another.
class SessionStore {
 public:
  /// Makes a file of the whole session and opens it for writing. It appears whole or not at all, and never replaces
  /// another: StorageError if there is something of that name. If it can't be opened, it is removed again.
  static SessionStore create(const std::filesystem::path& path, const Session& session);
  /// Opens a file for reading and appending. Finishes the work of a killed writer, and brings older versions to the
  /// newest.
  static SessionStore open(const std::filesystem::path& path);
  /// Never changes the file, and works where nothing can be written. If nobody is writing, nobody can begin to while
  /// the store is open, so it should be closed soon; if somebody is, it reads what was captured so far.
  static SessionStore openReadOnly(const std::filesystem::path& path);

  ~SessionStore();
  SessionStore(SessionStore&&) noexcept;
  SessionStore& operator=(SessionStore&&) noexcept;

  /// The session as it is now. Its source says what the stored one says; as file it names this one, with the digest of
  /// the journal.
  [[nodiscard]] Session readSession() const;
  /// Raw samples of the pose at `index`; empty if none were kept. Throws InvalidArgument if there is no such pose.
  [[nodiscard]] std::vector<SampleFrame> readRawSamples(std::size_t index) const;

  /// Writes all operations, in this order, in one transaction, and returns when it is on disk. Returns the new
  /// revision. If it throws, nothing of it is in the file: StorageError if it can be tried again, InvalidArgument if an
  /// operation makes no sense for the session as it is (no such pose, numbers that are not finite).
  std::uint64_t append(std::span<const StoreOperation> operations);
  /// Writes everything anew to path() if that does not name the open file any more, because somebody moved or removed
  /// it; says what happened then, and nothing otherwise. Throws StorageError if that is not possible, also where
  /// something else has the name by now.
  Message renewIfGone();
  /// Moves what was appended from SQLite's journal ("-wal") into the file itself, so that copying the file alone copies
  /// everything. Happens on closing too; not necessary for safety. Failure has no consequence.
  void tidy() noexcept;

  /// Number of the journal's last entry: grows with every change.
  [[nodiscard]] std::uint64_t revision() const;
  /// When the last change was made, milliseconds since 1970, UTC.
  [[nodiscard]] std::int64_t editedAtMs() const;
  /// Text of a JSON object; "{}" if none were set.
  [[nodiscard]] const std::string& options() const;
  [[nodiscard]] std::vector<JournalLine> history() const;   ///< all entries, the first one first
  [[nodiscard]] const std::filesystem::path& path() const;  ///< the file

 private:
  struct State;
  explicit SessionStore(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// The session in a file, as SessionStore::openReadOnly() and readSession().
Session readSessionStore(const std::filesystem::path& path);
/// The same for the bytes of a file, as they come from a pipe; `file` is named in errors. What SQLite keeps beside a
/// file that is being written is not among them.
Session parseSessionStore(std::string_view bytes, const std::string& file);
/// The whole session as a new file, as SessionStore::create().
void writeSessionStore(const Session& session, const std::filesystem::path& path);

/// By its first bytes; whether it is in order, reading will tell. Throws StorageError if it is there and can't be read.
bool isSessionStore(const std::filesystem::path& path);
/// The same for the bytes of a file.
bool beginsAsSessionStore(std::string_view bytes);

/// Moves a session that nobody has open, with what SQLite keeps beside it ("-wal", "-shm"). Throws StorageError if
/// somebody has it open, if something is at `to` already, or if it can't be moved: then it stays where it is.
void moveSessionStore(const std::filesystem::path& from, const std::filesystem::path& to);
/// Removes a session that nobody has open, with what SQLite keeps beside it. Nothing happens where there is none, or it
/// can't be removed.
void removeSessionStore(const std::filesystem::path& path) noexcept;

/// Whether somebody, here or in another process, has the session open for writing at this moment. A process that was
/// killed has not. Throws StorageError if the file can't be read.
bool isSessionStoreInUse(const std::filesystem::path& path);

}  // namespace hexoderm
