// Access to a session by several programs, and in places where nothing can be written.

#include "hexoderm/session/session_store.h"

#include "tests/core/session/store_test.h"
#include "tests/support/pipe.h"

#include <sys/prctl.h>
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
  test::Pipe pipe;
  const auto writeUntilKilled = [&]() noexcept {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    SessionStore store = SessionStore::open(path_);
    appendTo(store, RemovePose{0});
    pipe.write("x");
    while (true) ::pause();
  };
  const pid_t writer = ::fork();
  if (writer == 0) writeUntilKilled();
  pipe.closeEnd(1);
  char ready = 0;
  ASSERT_EQ(::read(pipe.ends[0], &ready, 1), 1);
  EXPECT_THAT(whyNotOpened(path_), saysAll("arm.hexo", "another Hexoderm has it open for writing"));
  EXPECT_EQ(readSessionStore(path_).poses().size(), 2U) << "readers see what was captured so far";
  ::kill(writer, SIGKILL);
  ::waitpid(writer, nullptr, 0);
  EXPECT_EQ(readSessionStore(path_).poses().size(), 2U);
  SessionStore store = SessionStore::open(path_);
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

TEST_F(SharedStore, IsReadAndNotWrittenInAReadOnlyFolder) {
  // No journal, also of a file that could be written; a journal, and one with its index.
  for (const auto& [journal, mode] :
       {std::pair(0, 0444U), std::pair(0, 0666U), std::pair(1, 0444U), std::pair(2, 0444U)}) {
    SCOPED_TRACE(journal);
    const bool is_writable = mode == 0666U;
    const TemporaryFolder other;
    const fs::path file = other.path() / "arm.hexo";
    if (journal == 0) {
      fs::copy_file(path_, file);
    } else {
      leaveBehindAKilledWriter(path_, file, 1, journal == 2);
    }
    const std::size_t poses = readSessionStore(path_).poses().size();
    const auto before = contentOf(other.path());
    for (const auto& entry : fs::directory_iterator(other.path())) ::chmod(entry.path().c_str(), mode);
    ::chmod(other.path().c_str(), 0555);
    EXPECT_EQ(test::asOrdinaryUser([&] {
                if (readSessionStore(file).poses().size() != poses) return 2;
                const auto write = [&] { writeSessionStore(sessionWithEverything(), other.path() / "new.hexo"); };
                const char* refused = is_writable ? "arm.hexo: " : "arm.hexo: cannot be written: Permission denied";
                return lacks(whyNotOpened(file), refused) +
                       lacks(messageOf<StorageError>(write), "new.hexo: cannot be written: Permission denied");
              }),
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

/// Captures until a small disk is full: 0 if that is said and nothing is lost.
int fillTheDisk(const fs::path& folder) {
  const fs::path file = folder / "arm.hexo";
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
  const std::size_t poses = readSessionStore(file).poses().size();
  if (poses < 5 || poses != store.readSession().poses().size()) return 2;
  return lacks(message, "arm.hexo: the disk is full: free some space; what was stored before is intact");
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
