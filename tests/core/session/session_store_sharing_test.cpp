// Access to a session by several programs, and in places where nothing can be written.

#include "hexoderm/session/session_store.h"

#include "tests/core/session/store_test.h"
#include "tests/support/pipe.h"

#include <sys/stat.h>

#include <future>
#include <iostream>

namespace hexoderm::store_test {
namespace {

/// What another process returns: 0 if a text has these words.
int lacks(const std::string& text, const std::string& words) { return text.find(words) == std::string::npos ? 1 : 0; }

std::map<std::string, std::string> contentOf(const fs::path& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : fs::directory_iterator(folder)) content[entry.path().filename()] = readFile(entry.path());
  return content;
}

/// Copies the remains of a killed writer: the file and its journal with `removed` poses removed, not tidied, and the
/// index too if asked for.
void leaveBehindAKilledWriter(const fs::path& from, const fs::path& to, std::size_t removed, bool with_index) {
  SessionStore store = SessionStore::open(from);
  for (std::size_t i = 0; i < removed; ++i) appendTo(store, RemovePose{0});
  for (const char* suffix : {"", "-wal", "-shm"}) {
    if (suffix == std::string("-shm") && !with_index) continue;
    fs::copy_file(from.string() + suffix, to.string() + suffix);
  }
}

class SharedStore : public StoreTest {
 protected:
  SharedStore() {
    fs::permissions(folder_.path(), fs::perms::all);
    writeSessionStore(sessionWithEverything(), path_);
  }
};

TEST_F(SharedStore, IsInUseAsLongAsSomebodyWritesIt) {
  EXPECT_FALSE(isSessionStoreInUse(path_));
  {
    const SessionStore writer = SessionStore::open(path_);
    EXPECT_TRUE(isSessionStoreInUse(path_));
  }
  EXPECT_FALSE(isSessionStoreInUse(path_));
  const SessionStore reader = SessionStore::openReadOnly(path_);
  EXPECT_FALSE(isSessionStoreInUse(path_));
  EXPECT_THAT(messageOf<StorageError>([&] { isSessionStoreInUse(folder_.path() / "none.hexo"); }),
              saysAll("none.hexo", "cannot be read"));
}

TEST_F(SharedStore, HasOneWriterInThisProcess) {
  {
    const SessionStore store = SessionStore::open(path_);
    EXPECT_THAT(whyNotOpened(path_), saysAll("arm.hexo", "already open", "this Hexoderm"));
    fs::create_symlink(path_, folder_.path() / "link.hexo");
    EXPECT_THAT(whyNotOpened(folder_.path() / "link.hexo"), saysAll("link.hexo", "already open"));
  }
  EXPECT_NO_THROW(SessionStore::open(folder_.path() / "link.hexo"));
}

TEST_F(SharedStore, HasOneWriterAmongAllProcesses) {
  {
    SessionStore store = SessionStore::open(path_);
    // Looking at the file and failing to open it must not undo the locks that this process has.
    EXPECT_THROW(SessionStore::open(path_), StorageError);
    EXPECT_TRUE(isSessionStore(path_));
    EXPECT_EQ(readSessionStore(path_).poses().size(), 3U);
    EXPECT_EQ(test::inAnotherProcess([&] { return lacks(whyNotOpened(path_), "arm.hexo: "); }), 0);
    appendTo(store, RemovePose{0});
  }
  EXPECT_EQ(test::inAnotherProcess([&] {
              SessionStore store = SessionStore::open(path_);
              appendTo(store, RemovePose{0});
              return 0;
            }),
            0);
  EXPECT_EQ(readSessionStore(path_).poses().size(), 1U);
}

/// A process that opens the store, removes a pose, and stays until it is killed.
class OtherWriter {
 public:
  explicit OtherWriter(const fs::path& path) {
    child_ = ::fork();
    if (child_ == 0) {
      try {
        SessionStore store = SessionStore::open(path);
        appendTo(store, RemovePose{0});
        static_cast<void>(!::write(pipe_.ends[1], "x", 1));
        while (true) ::pause();
      } catch (...) {
        ::_exit(1);
      }
    }
    pipe_.closeEnd(1);
    char ready = 0;
    has_begun_ = ::read(pipe_.ends[0], &ready, 1) == 1;
  }
  ~OtherWriter() { kill(); }
  OtherWriter(const OtherWriter&) = delete;
  OtherWriter& operator=(const OtherWriter&) = delete;

  [[nodiscard]] bool hasBegun() const { return has_begun_; }
  void kill() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
    child_ = 0;
  }

 private:
  test::Pipe pipe_;
  pid_t child_ = 0;
  bool has_begun_ = false;
};

TEST_F(SharedStore, NothingIsWrittenInItsPlaceWhileItIsOpenAndItsLocksStay) {
  SessionStore store = SessionStore::open(path_);
  appendTo(store, RemovePose{0});
  for (const char* suffix : {"", "-wal", "-shm"}) {
    EXPECT_THAT(messageOf<StorageError>([&] { writeFileAtomically(path_.string() + suffix, "new"); }),
                saysAll("arm.hexo", "never replaced"));
  }
  EXPECT_EQ(test::inAnotherProcess([&] {
              const std::string message = messageOf<StorageError>([&] { writeFileAtomically(path_, "new"); });
              return lacks(message, "as a Hexoderm session") + lacks(whyNotOpened(path_), "arm.hexo: ");
            }),
            0);
  appendTo(store, RemovePose{0});
  EXPECT_EQ(readSessionStore(path_).poses().size(), 1U);
}

TEST_F(SharedStore, IsReadWhileAnotherProcessWritesAndIsFreeWhenThatIsKilled) {
  OtherWriter other(path_);
  ASSERT_TRUE(other.hasBegun());
  EXPECT_THAT(whyNotOpened(path_), saysAll("arm.hexo", "another Hexoderm has it open for writing"));
  EXPECT_EQ(readSessionStore(path_).poses().size(), 2U) << "readers see what was captured so far";
  other.kill();
  EXPECT_EQ(readSessionStore(path_).poses().size(), 2U);
  SessionStore store = SessionStore::open(path_);
  EXPECT_EQ(store.readSession().poses().size(), 2U);
  appendTo(store, RemovePose{0});
  EXPECT_EQ(readSessionStore(path_).poses().size(), 1U);
}

TEST_F(SharedStore, AReaderKeepsTheStateItBeganWith) {
  SessionStore store = SessionStore::open(path_);
  const SessionStore reader = SessionStore::openReadOnly(path_);
  appendTo(store, RemovePose{0});
  store.tidy();
  EXPECT_EQ(reader.readSession().poses().size(), 3U);
  EXPECT_EQ(readSessionStore(path_).poses().size(), 2U);
}

TEST_F(SharedStore, AWriterWaitsForAReaderThatHasNoJournalToReadThrough) {
  std::optional<SessionStore> reader = SessionStore::openReadOnly(path_);
  auto writer = std::async(std::launch::async, [&] { return SessionStore::open(path_).revision(); });
  reader.reset();
  EXPECT_GT(writer.get(), 0U);
}

TEST_F(SharedStore, IsNotWrittenThroughAReader) {
  SessionStore reader = SessionStore::openReadOnly(path_);
  EXPECT_THAT(messageOf<StorageError>([&] { appendTo(reader, RemovePose{0}); }),
              saysAll("arm.hexo", "reading only", "save"));
}

TEST_F(SharedStore, ReadingWhatAKilledWriterLeftFindsEverythingAndChangesNothing) {
  for (const bool with_index : {true, false}) {
    const TemporaryFolder other;
    const fs::path killed = other.path() / "killed.hexo";
    leaveBehindAKilledWriter(path_, killed, 1, with_index);
    const std::string file = readFile(killed);
    const std::string journal = readFile(killed.string() + "-wal");
    const std::size_t poses = readSessionStore(path_).poses().size();
    EXPECT_EQ(readSessionStore(killed).poses().size(), poses);
    EXPECT_EQ(readFile(killed), file);
    EXPECT_EQ(readFile(killed.string() + "-wal"), journal);
    EXPECT_EQ(SessionStore::open(killed).readSession().poses().size(), poses);
    EXPECT_EQ(other.entryCount(), 1U) << "the writer has tidied up";
    EXPECT_EQ(readSessionStore(killed).poses().size(), poses);
  }
}

TEST_F(SharedStore, IsReadInAReadOnlyFolder) {
  for (const int journal : {0, 1, 2}) {  // none, one, one with its index
    SCOPED_TRACE(journal);
    const TemporaryFolder other;
    const fs::path file = other.path() / "arm.hexo";
    if (journal == 0) {
      fs::copy_file(path_, file);
    } else {
      leaveBehindAKilledWriter(path_, file, 1, journal == 2);
    }
    const std::size_t poses = readSessionStore(path_).poses().size();
    const auto before = contentOf(other.path());
    for (const auto& entry : fs::directory_iterator(other.path())) ::chmod(entry.path().c_str(), 0444);
    ::chmod(other.path().c_str(), 0555);
    EXPECT_EQ(test::asOrdinaryUser([&] { return readSessionStore(file).poses().size() == poses ? 0 : 1; }), 0);
    EXPECT_EQ(test::asOrdinaryUser(
                  [&] { return lacks(whyNotOpened(file), "arm.hexo: cannot be written: Permission denied"); }),
              0);
    ::chmod(other.path().c_str(), 0755);
    EXPECT_EQ(contentOf(other.path()), before);
  }
}

TEST_F(SharedStore, IsMovedAndRemovedWithItsJournal) {
  const fs::path left = folder_.path() / "left.hexo";
  const fs::path moved = folder_.path() / "moved.hexo";
  leaveBehindAKilledWriter(path_, left, 1, true);
  const SessionStore writer = SessionStore::open(path_);

  EXPECT_THAT(messageOf<StorageError>([&] { moveSessionStore(path_, moved); }), saysAll("arm.hexo", "close it there"));
  EXPECT_THAT(messageOf<StorageError>([&] { moveSessionStore(left, path_); }), saysAll("left.hexo", "is there"));
  EXPECT_THAT(messageOf<StorageError>([&] { moveSessionStore(left, folder_.path() / "none" / "a.hexo"); }),
              saysAll("left.hexo", "cannot be moved"));
  EXPECT_EQ(readSessionStore(left).poses().size(), 2U) << "where it cannot be moved it stays";

  moveSessionStore(left, moved);
  EXPECT_FALSE(fs::exists(left));
  EXPECT_FALSE(fs::exists(left.string() + "-wal"));
  EXPECT_EQ(readSessionStore(moved).poses().size(), 2U);
  removeSessionStore(moved);
  removeSessionStore(moved);
  for (const auto& entry : fs::directory_iterator(folder_.path())) {
    EXPECT_TRUE(entry.path().filename().string().starts_with("arm.hexo")) << entry.path();
  }
}

TEST_F(SharedStore, AWritableFileInAReadOnlyFolderIsNotOpenedForWriting) {
  ::chmod(path_.c_str(), 0666);
  ::chmod(folder_.path().c_str(), 0555);
  EXPECT_EQ(test::asOrdinaryUser([&] {
              if (lacks(whyNotOpened(path_), "arm.hexo: ") != 0) return 1;
              if (readSessionStore(path_).poses().size() != 3) return 2;
              const fs::path other = folder_.path() / "new.hexo";
              return lacks(messageOf<StorageError>([&] { writeSessionStore(sessionWithEverything(), other); }),
                           "new.hexo: cannot be written: Permission denied");
            }),
            0);
  ::chmod(folder_.path().c_str(), 0755);
  EXPECT_EQ(folder_.entryCount(), 1U);
}

TEST_F(SharedStore, ADiskThatRefusesLeavesTheEarlierStateAndTheCallCanBeRepeated) {
  SessionStore store = SessionStore::open(path_);
  const Session before = store.readSession();
  const std::uint64_t revision = store.revision();
  {
    const test::NoFileGrows full;
    EXPECT_THAT(messageOf<StorageError>([&] { appendTo(store, RemovePose{0}); }), saysAll("arm.hexo", "try again"));
    EXPECT_THROW(appendTo(store, RemovePose{0}), StorageError);
    EXPECT_EQ(store.revision(), revision);
    expectSameSession(store.readSession(), before);
    const fs::path other = folder_.path() / "new.hexo";
    EXPECT_THROW(writeSessionStore(before, other), StorageError);
    EXPECT_FALSE(fs::exists(other));
  }
  expectSameSession(readSessionStore(path_), before);
  EXPECT_EQ(appendTo(store, RemovePose{0}), revision + 1);
  EXPECT_EQ(readSessionStore(path_).poses().size(), 2U);
}

/// Captures until a small disk is full, makes room, repeats the last: 0 if everything was as it should be.
int fillTheDisk(const fs::path& folder) {
  const fs::path file = folder / "arm.hexo";
  const fs::path ballast = folder / "ballast";
  std::ofstream(ballast) << std::string(200'000, 'x') << std::flush;
  SessionStore store = SessionStore::create(file, sessionWithEverything());
  auto capture = std::make_shared<PoseCapture>(*sessionWithEverything().poses()[0].capture);
  for (std::uint32_t i = 0; i < 200; ++i) capture->samples.push_back(capture->samples[0]);
  std::string message;
  while (message.empty()) {
    try {
      appendTo(store, AddPose{{capture}});
      store.tidy();
    } catch (const StorageError& error) {
      message = error.what();
    }
  }
  if (message.find("arm.hexo: the disk is full: free some space; what was stored before is intact") ==
      std::string::npos) {
    std::cerr << message << '\n';
    return 1;
  }
  const std::size_t poses = store.readSession().poses().size();
  if (poses < 5) return 2;
  if (messageOf<StorageError>([&] { appendTo(store, AddPose{{capture}}); }).empty()) return 3;
  if (messageOf<StorageError>([&] { writeSessionStore(store.readSession(), folder / "copy.hexo"); }).empty()) return 4;
  if (fs::exists(folder / "copy.hexo")) return 5;
  if (readSessionStore(file).poses().size() != poses) return 6;
  fs::remove(ballast);
  appendTo(store, AddPose{{capture}});
  if (readSessionStore(file).poses().size() != poses + 1) return 7;
  store = SessionStore(SessionStore::openReadOnly(file));
  return SessionStore::open(file).readSession().poses().size() == poses + 1 ? 0 : 8;
}

TEST_F(SharedStore, AFullDiskIsSaidAndNothingIsLost) {
  const TemporaryFolder disk;
  const int result = test::withSmallDisk(disk.path(), 1 << 20, [&] { return fillTheDisk(disk.path()); });
  if (result < 0) {
    std::cout << "no small disk can be mounted here; ADiskThatRefuses... covers the same path of errors\n";
    return;
  }
  EXPECT_EQ(result, 0);
}

TEST_F(SharedStore, SaysWhatIsNotThereOrNoFile) {
  EXPECT_THAT(whyNotOpened(folder_.path() / "none.hexo"), saysAll("none.hexo", "No such file"));
  EXPECT_THAT(messageOf<StorageError>([&] { readSessionStore(folder_.path() / "none.hexo"); }),
              saysAll("none.hexo", "No such file"));
  EXPECT_THAT(messageOf<StorageError>([&] { readSessionStore(folder_.path()); }), saysAll("is a folder"));
  EXPECT_EQ(folder_.entryCount(), 1U) << "nothing is made by opening";
}

TEST_F(SharedStore, NamesWithCharactersOfAddressesAreNames) {
  const fs::path odd = folder_.path() / "a?mode=memory&b#c%41 ü.hexo";
  writeSessionStore(sessionWithEverything(), odd);
  expectSameSession(readSessionStore(odd), sessionWithEverything());
  EXPECT_EQ(SessionStore::open(odd).readSession().poses().size(), 3U);
}

}  // namespace
}  // namespace hexoderm::store_test
