#include "hexoderm/session/session_store.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/sha256.h"
#include "hexoderm/base/system_reason.h"
#include "hexoderm/base/temporary_file.h"
#include "hexoderm/session/journal.h"
#include "hexoderm/session/store_file.h"

#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::string_view kInsertEntry =
    "INSERT INTO journal (entry, at_ms, kind, detail, samples, digest) VALUES (?1, ?2, ?3, ?4, ?5, ?6)";

/// A session's file, and what SQLite keeps beside it.
constexpr std::array<const char*, 3> kParts = {"", "-wal", "-shm"};
std::filesystem::path with(std::filesystem::path path, const char* part) { return path += part; }

std::int64_t nowMs() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::string sha256Of(const Bytes& bytes) {
  return sha256Hex({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// Everything that a journal says, and when.
struct Journal {
  JournalState state;
  std::vector<JournalLine> lines;

  void read(const JournalEntry& entry, const std::string& file) {
    state.read(entry, file);
    lines.push_back({static_cast<std::uint64_t>(entry.entry), entry.at_ms, entry.kind});
  }
};

Journal readJournal(Database& database) {
  Journal journal;
  Statement rows(database, "SELECT entry, at_ms, kind, detail, samples, digest FROM journal ORDER BY entry");
  while (rows.step()) {
    JournalEntry entry;
    entry.entry = rows.integer(0);
    entry.at_ms = rows.integer(1);
    entry.kind = rows.text(2);
    entry.detail = rows.text(3);
    if (!rows.isNull(4)) {
      const auto samples = rows.blob(4);
      entry.samples.emplace(samples.begin(), samples.end());
    }
    const auto digest = rows.blob(5);
    if (digest.size() != entry.digest.size())
      database.failFormat(message("the file is damaged: expected digests of 32 bytes"));
    std::ranges::copy(digest, entry.digest.begin());
    journal.read(entry, database.name());
  }
  if (!journal.state.hasSkin())
    database.failFormat(message("the journal is empty, expected a skin as its first entry"));
  return journal;
}

void insert(Database& database, const JournalEntry& entry) {
  Statement row(database, kInsertEntry);
  row.bind(1, entry.entry).bind(2, entry.at_ms).bindText(3, entry.kind).bindText(4, entry.detail);
  if (entry.samples) row.bindBlob(5, *entry.samples);
  row.bindBlob(6, entry.digest);
  row.step();
}

/// Writes the entry of an operation, in a transaction of the caller's, and appends it to `journal`.
void write(Database& database, const StoreOperation& operation, std::int64_t at_ms, Journal& journal) {
  Bytes raw;
  const AddPose* add = addedPose(operation);
  if (add != nullptr && add->raw) raw = encodeFrames(*add->raw, journal.state.lsb_g());
  const JournalEntry entry = journal.state.entryFor(operation, at_ms, raw.empty() ? "" : sha256Of(raw));
  try {
    journal.read(entry, "what is to be stored");  // so that nothing is written that can't be read again
  } catch (const FormatError& error) {
    throw InvalidArgument(error.message());
  }
  insert(database, entry);
  if (raw.empty()) return;
  Statement row(database, "INSERT INTO raw_samples (entry, frames) VALUES (?1, ?2)");
  row.bind(1, entry.entry).bindBlob(2, raw);
  row.step();
}

/// Calls `visit` with the operations that make a session. One at a time: each may hold a large part of the session.
template <class Visit>
void forEachOperationThatMakes(const Session& session, Visit visit) {
  visit(SetSkin{std::make_shared<const CellModel>(session.model()), session.neighbors()});
  visit(SetSource{session.source()});
  if (session.truth()) visit(SetTruth{*session.truth()});
  for (const SessionPose& pose : session.poses()) visit(AddPose{pose});
  for (const MutedLink& link : session.mutedLinks()) visit(SetLinkMuted{link.source, link.target, true, link.why});
  if (session.robot()) visit(SetRobot{session.robot()});
  for (const PatchPlacement& placement : session.placements()) visit(SetPatchPlacement{placement});
  if (session.side() != SkinSide::Unknown) visit(SetSkinSide{session.side()});
}

[[noreturn]] void failExists(const std::filesystem::path& path) {
  throw StorageError(path.string(), message("exists already, and what a session has captured is never "
                                            "replaced: take another name, or remove the file first"));
}

/// Not even a link that leads nowhere: it is somebody's.
void requireNothingAt(const std::filesystem::path& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) == 0) failExists(path);
  if (errno != ENOENT) throw StorageError(path.string(), message("cannot be written: {}", systemReason(errno)));
  requireNothingBeside(path);
}

/// Calls `open`, which opens a session that was just made; if it can't, the session goes again.
template <class Open>
auto openMade(const std::filesystem::path& path, Open open) {
  const std::optional<FileIdentity> made = identityOf(path);
  try {
    return open();
  } catch (const Error&) {
    // Somebody may have found it already, and may be writing.
    if (made && identityOf(path) == made && !isSessionStoreInUse(path)) removeSessionStore(path);
    throw;
  }
}

/// What SQLite keeps beside a session that is open.
std::vector<std::pair<std::filesystem::path, FileIdentity>> logBeside(const std::filesystem::path& path) {
  std::vector<std::pair<std::filesystem::path, FileIdentity>> log;
  for (const char* suffix : kBesideDatabases) {
    const std::filesystem::path beside = with(path, suffix);
    if (const std::optional<FileIdentity> identity = identityOf(beside)) log.emplace_back(beside, *identity);
  }
  return log;
}

}  // namespace

const AddPose* addedPose(const StoreOperation& operation) {
  const auto* edit = std::get_if<SessionEdit>(&operation);
  return edit != nullptr ? std::get_if<AddPose>(edit) : nullptr;
}

struct SessionStore::State {
  std::filesystem::path path;
  StoreFile file;
  Journal journal;
  bool is_read_only = false;
  std::vector<std::pair<std::filesystem::path, FileIdentity>> log{};  ///< as logBeside(), of one that is written

  void writeAnew();
};

SessionStore::SessionStore(std::unique_ptr<State> state) : state_(std::move(state)) {}
SessionStore::~SessionStore() = default;
SessionStore::SessionStore(SessionStore&&) noexcept = default;
SessionStore& SessionStore::operator=(SessionStore&&) noexcept = default;

void writeSessionStore(const Session& session, const std::filesystem::path& path) {
  requireNothingAt(path);
  TemporaryFile file(path, path.string(), TemporaryFile::Naming::AtTheStart);
  {
    Database database(file.path().string(), path.string(), Database::Mode::Create);
    // Nobody reads the file before it is whole, and it is synced then.
    database.run("PRAGMA journal_mode=MEMORY; PRAGMA synchronous=OFF");
    migrate(database, storeMigrations());
    Transaction transaction(database);
    Journal journal;
    const std::int64_t at_ms = nowMs();
    try {
      forEachOperationThatMakes(session,
                                [&](const StoreOperation& operation) { write(database, operation, at_ms, journal); });
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(path.string(), error.message());
    }
    transaction.commit();
    database.run("PRAGMA journal_mode=WAL");
  }
  if (!file.becomeTarget()) failExists(path);
}

SessionStore SessionStore::create(const std::filesystem::path& path, const Session& session) {
  writeSessionStore(session, path);
  return openMade(path, [&] { return open(path); });
}

SessionStore SessionStore::open(const std::filesystem::path& path) {
  StoreFile file = openStoreForWriting(path);
  Journal journal = readJournal(file.database);
  auto log = logBeside(path);
  return SessionStore(std::make_unique<State>(State{path, std::move(file), std::move(journal), false, std::move(log)}));
}

SessionStore SessionStore::openReadOnly(const std::filesystem::path& path) {
  StoreFile file = openStoreForReading(path);
  Journal journal = readJournal(file.database);
  return SessionStore(std::make_unique<State>(State{path, std::move(file), std::move(journal), true}));
}

Session SessionStore::readSession() const { return state_->journal.state.session(state_->path.filename().string()); }

std::vector<SampleFrame> SessionStore::readRawSamples(std::size_t index) const {
  const std::int64_t capture = state_->journal.state.captureAt(index);
  const std::string sha256 = state_->journal.state.rawSha256(capture);
  if (sha256.empty()) return {};
  Database& database = state_->file.database;
  const std::string where = database.name() + ": raw samples of journal entry " + std::to_string(capture);
  Statement row(database, "SELECT frames FROM raw_samples WHERE entry = ?1");
  row.bind(1, capture);
  if (!row.step()) throw FormatError(where, message("the file is damaged: they are missing"));
  const auto frames = row.blob(0);
  if (sha256Hex({reinterpret_cast<const char*>(frames.data()), frames.size()}) != sha256) {
    throw FormatError(where, message("the file is damaged: they do not match their digest"));
  }
  return decodeFrames(frames, where);
}

std::uint64_t SessionStore::append(std::span<const StoreOperation> operations) {
  if (state_->is_read_only) {
    throw StorageError(state_->path.string(), message("is open for reading only: save the session elsewhere to go on"));
  }
  if (operations.empty()) return revision();
  Database& database = state_->file.database;
  Journal after = state_->journal;
  Transaction transaction(database);
  const std::int64_t at_ms = nowMs();
  for (const StoreOperation& operation : operations) write(database, operation, at_ms, after);
  transaction.commit();
  state_->journal = std::move(after);
  return revision();
}

/// The open file can be read to its end, whatever became of its name.
void SessionStore::State::writeAnew() {
  // Its log may have been left where it was, and would be taken for one of the new file.
  for (const auto& [beside, identity] : log) {
    if (identityOf(beside) == identity) ::unlink(beside.c_str());
  }
  requireNothingAt(path);
  TemporaryFile copy(path, path.string(), TemporaryFile::Naming::AtTheStart);
  {
    Database database(copy.path().string(), path.string(), Database::Mode::Create);
    database.run("PRAGMA journal_mode=MEMORY; PRAGMA synchronous=OFF");  // as writeSessionStore()
    file.database.copyTo(database);
    database.run("PRAGMA journal_mode=WAL");
  }
  if (!copy.becomeTarget()) failExists(path);
}

Message SessionStore::renewIfGone() {
  const std::filesystem::path path = state_->path;
  if (state_->is_read_only || isAt(path, state_->file.lock->descriptor())) return {};
  tidy();  // into the file itself, wherever it is now
  const std::optional<std::filesystem::path> place = placeOf(state_->file.lock->descriptor());
  const Message what =
      place ? message("was moved to {} while it was open", place->string()) : message("was removed while it was open");
  try {
    state_->writeAnew();
    StoreFile file = openMade(path, [&] { return openStoreForWriting(path); });
    auto log = logBeside(path);
    state_ = std::make_unique<State>(State{path, std::move(file), std::move(state_->journal), false, std::move(log)});
  } catch (const Error& error) {
    throw StorageError(located(
        path.string(), message("{}, with what was stored in it; it can't be written anew: {}", what, error.message())));
  }
  return located(path.string(), message("{}; the whole session was written anew", what));
}

void SessionStore::tidy() noexcept {
  if (state_->is_read_only) return;
  sqlite3_wal_checkpoint_v2(state_->file.database.handle(), nullptr, SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
}

std::uint64_t SessionStore::revision() const { return static_cast<std::uint64_t>(state_->journal.state.lastEntry()); }
std::int64_t SessionStore::editedAtMs() const { return state_->journal.state.editedAtMs(); }
const std::string& SessionStore::options() const { return state_->journal.state.options(); }
std::vector<JournalLine> SessionStore::history() const { return state_->journal.lines; }
const std::filesystem::path& SessionStore::path() const { return state_->path; }

Session parseSessionStore(std::string_view bytes, const std::string& file) {
  StoreFile store = openStoreBytes(bytes, file);
  return readJournal(store.database).state.session(std::filesystem::path(file).filename().string());
}

Session readSessionStore(const std::filesystem::path& path) { return SessionStore::openReadOnly(path).readSession(); }

bool isSessionStore(const std::filesystem::path& path) { return looksLikeStore(path); }

bool beginsAsSessionStore(std::string_view bytes) { return beginsAsStore(bytes); }

bool isSessionStoreInUse(const std::filesystem::path& path) {
  return !StoreLock::forReading(path, path.string()).has_value();
}

void moveSessionStore(const std::filesystem::path& from, const std::filesystem::path& to) {
  const auto fail = [&](const Message& why) {
    throw StorageError(from.string(), message("cannot be moved to {}: {}", to.string(), why));
  };
  if (isSessionStoreInUse(from))
    throw StorageError(from.string(), message("is open in another window, close it there first"));
  std::error_code error;
  for (const char* part : kParts) {
    if (std::filesystem::exists(with(to, part), error)) fail(message("something of that name is there"));
  }
  // The journal first: a session without its newest part must never be mistaken for a whole one.
  std::vector<const char*> moved;
  for (auto part = kParts.rbegin(); part != kParts.rend(); ++part) {
    if (!std::filesystem::exists(with(from, *part), error)) continue;
    std::filesystem::rename(with(from, *part), with(to, *part), error);
    if (error) {
      std::error_code ignored;
      for (const char* before : moved) std::filesystem::rename(with(to, before), with(from, before), ignored);
      fail(systemReason(error));
    }
    moved.push_back(*part);
  }
}

void removeSessionStore(const std::filesystem::path& path) noexcept {
  for (const char* part : kParts) ::unlink(with(path, part).c_str());
}

}  // namespace hexoderm
