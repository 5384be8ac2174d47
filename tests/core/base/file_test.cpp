#include "hexoderm/base/file.h"

#include "hexoderm/base/temporary_file.h"
#include "tests/support/failing_disk.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace hexoderm {
namespace {

class FileTest : public testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "out.txt";
};
using ReadFile = FileTest;
using WriteFileAtomically = FileTest;
using WriteFileInPieces = FileTest;

TEST_F(ReadFile, GivesTheBytesAsTheyAre) {
  const std::string bytes("a\r\n\0\xff z", 8);
  EXPECT_EQ(readFile(folder_.put("bytes", bytes)), bytes);
  EXPECT_EQ(readFile(folder_.put("empty", "")), "");
}

TEST_F(ReadFile, NamesAMissingFileAndWhy) {
  const std::string message = messageOf<StorageError>([&] { readFile(folder_.path() / "missing.json"); });
  EXPECT_THAT(message, saysAll("missing.json", "No such file"));
}

TEST_F(ReadFile, RefusesAFolder) {
  const std::string message = messageOf<StorageError>([&] { readFile(folder_.path()); });
  EXPECT_THAT(message, saysAll(folder_.path().string(), "is a folder, expected a file"));
}

TEST_F(WriteFileAtomically, FollowsTheUsersUmask) {
  const mode_t before = ::umask(0027);
  writeFileAtomically(file_, "x");
  ::umask(before);
  EXPECT_EQ(std::filesystem::status(file_).permissions(), std::filesystem::perms(0640));
}

TEST_F(WriteFileAtomically, RefusesWhatIsNoPlaceForAFileAndLeavesNoTrace) {
  std::filesystem::create_directory(file_);
  std::filesystem::create_symlink("gone.txt", folder_.path() / "link");
  std::filesystem::create_symlink("b", folder_.path() / "a");
  std::filesystem::create_symlink("a", folder_.path() / "b");
  for (const auto& [name, says, why] : {std::array{"out.txt", "out.txt", "is a folder"},
                                        std::array{"nowhere/out.txt", "out.txt: cannot be written: ", "No such file"},
                                        std::array{"link", "link: is a link to gone.txt", "nothing"},
                                        std::array{"a", "a: cannot be written: ", "symbolic links"}}) {
    const auto target = folder_.path() / name;
    EXPECT_THAT(messageOf<StorageError>([&] { writeFileAtomically(target, "x"); }), saysAll(says, why));
  }
  EXPECT_TRUE(std::filesystem::is_directory(file_));
  EXPECT_EQ(folder_.entryCount(), 4U) << "a temporary file was left behind";
}

TEST_F(WriteFileAtomically, TakesEveryNameThatTheFileSystemTakes) {
  const auto longest = folder_.path() / std::string(255, 'n');
  writeFileAtomically(longest, "first");
  writeFileAtomically(longest, "second");
  EXPECT_EQ(readFile(longest), "second");
  EXPECT_THAT(messageOf<StorageError>([&] { writeFileAtomically(folder_.path() / std::string(256, 'n'), "x"); }),
              saysAll("cannot be written: ", "name too long"));
  EXPECT_EQ(folder_.entryCount(), 1U);
}

/// Whom this process may give a file to: root anybody, others themselves and the last of their groups.
std::pair<uid_t, gid_t> newOwnerAndGroup() {
  if (::geteuid() == 0) return {12345, 54321};
  std::vector<gid_t> groups(static_cast<std::size_t>(std::max(0, ::getgroups(0, nullptr))));
  const int count = ::getgroups(static_cast<int>(groups.size()), groups.data());
  return {::geteuid(), count > 0 ? groups[static_cast<std::size_t>(count - 1)] : ::getegid()};
}

TEST_F(WriteFileAtomically, KeepsOwnerAndGroupWhereItMay) {
  folder_.put("out.txt", "old");
  const auto [owner, group] = newOwnerAndGroup();
  ASSERT_EQ(::chown(file_.c_str(), owner, group), 0);
  writeFileAtomically(file_, "new");
  struct stat status {};
  ASSERT_EQ(::stat(file_.c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, owner);
  EXPECT_EQ(status.st_gid, group);
}

TEST_F(WriteFileAtomically, ReplacesNoFileThatTheUserMayNotWrite) {
  folder_.put("out.txt", "old");
  std::filesystem::permissions(file_, std::filesystem::perms(0444));
  std::filesystem::permissions(folder_.path(), std::filesystem::perms(0777));
  EXPECT_EQ(test::asOrdinaryUser([&] {
              const std::string why = messageOf<StorageError>([&] { writeFileAtomically(file_, "new"); });
              return why.ends_with("out.txt: cannot be written: Permission denied") ? 0 : 1;
            }),
            0);
  EXPECT_EQ(readFile(file_), "old");
  EXPECT_EQ(folder_.entryCount(), 1U);
}

TEST_F(WriteFileAtomically, WritesThroughALinkAndKeepsIt) {
  const test::TemporaryFolder elsewhere;
  const auto file = elsewhere.put("target.txt", "old");
  std::filesystem::create_symlink(file, folder_.path() / "first");
  std::filesystem::create_symlink("first", folder_.path() / "second");
  writeFileAtomically(folder_.path() / "second", "new");
  EXPECT_EQ(readFile(file), "new");
  EXPECT_FALSE(std::filesystem::is_symlink(file));
  EXPECT_TRUE(std::filesystem::is_symlink(folder_.path() / "first"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder_.path() / "second"));
  EXPECT_EQ(folder_.entryCount(), 2U);
  EXPECT_EQ(elsewhere.entryCount(), 1U);
}

TEST_F(WriteFileAtomically, SaysThatAReaderWentAway) {
  const auto fifo = folder_.path() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  std::thread reader([&] { std::ifstream(fifo).get(); });
  EXPECT_THAT(messageOf<StorageError>([&] { writeFileAtomically(fifo, std::string(1'000'000, 'x')); }),
              saysAll("fifo: cannot be written: ", "pipe"));
  reader.join();
}

TEST_F(WriteFileAtomically, WritesIntoADevice) {
  // A terminal of this test's own: no device of this machine is put at risk by a test that root runs.
  const int controller = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(controller, 0);
  ASSERT_EQ(::grantpt(controller), 0);
  ASSERT_EQ(::unlockpt(controller), 0);
  const std::string terminal = ::ptsname(controller);
  writeFileAtomically(terminal, "x");
  EXPECT_TRUE(std::filesystem::is_character_file(terminal));
  char written = 0;
  EXPECT_EQ(::read(controller, &written, 1), 1);
  EXPECT_EQ(written, 'x');
  ::close(controller);
  if (::geteuid() == 0) return;
  writeFileAtomically("/dev/null", "x");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_THAT(messageOf<StorageError>([] { writeFileAtomically("/dev/full", "x"); }), saysAll("/dev/full", "No space"));
}

TEST_F(WriteFileAtomically, RefusesASocket) {
  struct sockaddr_un address {};
  address.sun_family = AF_UNIX;
  const std::string path = (folder_.path() / "socket").string();
  ASSERT_LT(path.size(), sizeof address.sun_path);
  path.copy(std::begin(address.sun_path), path.size());
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_THAT(messageOf<StorageError>([&] { writeFileAtomically(path, "x"); }),
              saysAll("socket", "nothing is written"));
  EXPECT_TRUE(std::filesystem::is_socket(path));
  ::close(socket);
}

TEST(TemporaryFile, TellsItsContentFromOtherBytes) {
  const test::TemporaryFolder folder;
  TemporaryFile file(folder.path() / "a.stl", "a.stl");
  const std::string content(200'000, 'x');
  file.write(content);
  EXPECT_NO_THROW(file.requireContent(content));
  for (const std::string& other :
       {content.substr(1), content + "x", content.substr(1) + "y", "y" + content.substr(1), std::string()}) {
    EXPECT_THAT(messageOf<StorageError>([&] { file.requireContent(other); }), saysAll("a.stl", "other bytes"));
  }
}

/// Leaves a hidden file as a killed writer does where no file can be without a name.
void beKilledWhileWriting(const std::filesystem::path& target) {
  EXPECT_EQ(test::inAnotherProcess([&] {
              const TemporaryFile file(target, target.string(), TemporaryFile::Naming::AtTheStart);
              const hexoderm::TemporaryFolder folder(target.parent_path(), target.string());
              std::ofstream(folder.path() / "inside") << "x";
              return ::kill(::getpid(), SIGKILL);
            }),
            128 + SIGKILL);
}

TEST_F(WriteFileAtomically, RemovesWhatAKilledWriterLeft) {
  beKilledWhileWriting(file_);
  EXPECT_EQ(folder_.entryCount(), 2U) << "nothing to remove: the test shows nothing";
  const auto notes = folder_.put(".hexoderm-notes.tmp", "the user's own");
  writeFileAtomically(file_, "x");
  EXPECT_EQ(folder_.entryCount(), 2U);
  EXPECT_EQ(readFile(notes), "the user's own");
}

TEST_F(WriteFileAtomically, LeavesTheFilesOfOtherWritersAlone) {
  TemporaryFile other(folder_.path() / "other.txt", "other.txt", TemporaryFile::Naming::AtTheStart);
  other.write("whole");
  EXPECT_EQ(test::inAnotherProcess([&] {
              writeFileAtomically(file_, "x");
              return 0;
            }),
            0);
  other.replaceTarget();
  EXPECT_EQ(readFile(folder_.path() / "other.txt"), "whole");
  EXPECT_EQ(folder_.entryCount(), 2U);
}

TEST_F(WriteFileAtomically, HasNoHiddenNameWhileItWrites) {
  const int unnamed = ::open(folder_.path().c_str(), O_TMPFILE | O_RDWR, 0600);
  // Where a file system has no files without a name, there is the hidden one.
  const std::size_t named = unnamed < 0 ? 1 : 0;
  if (unnamed >= 0) ::close(unnamed);
  writeFileAtomically(file_, [&](const WriteBytes& write) {
    write("x");
    EXPECT_EQ(folder_.entryCount(), named);
  });
  EXPECT_EQ(folder_.entryCount(), 1U);
}

TEST_F(ReadFile, ReadsToALimit) {
  const auto file = folder_.put("large", std::string(2'000'001, 'x'));
  EXPECT_EQ(readFile(file, 2'000'001).size(), 2'000'001U);
  EXPECT_THAT(messageOf<FormatError>([&] { readFile(file, 2'000'000); }), saysAll("large", "at most 2 MB are read"));
  EXPECT_THAT(messageOf<FormatError>([] { readFile("/dev/zero", 3'000'000); }),
              saysAll("/dev/zero", "does not end: at most 3 MB are read"));
}

/// Pieces of a document, and how often they were asked for.
class Pieces {
 public:
  explicit Pieces(std::vector<std::string> pieces) : pieces_(std::move(pieces)) {}
  [[nodiscard]] ProduceBytes produce() {
    return [this](const WriteBytes& write) {
      ++calls;
      for (const std::string& piece : pieces_) {
        if (piece.empty()) throw InvalidArgument("a piece that can't be produced");
        write(piece);
      }
    };
  }
  int calls = 0;

 private:
  std::vector<std::string> pieces_;
};

TEST_F(WriteFileInPieces, WritesNewAndReplacesOldWithItsRights) {
  Pieces first({"fi", "r", "st"});
  writeFileAtomically(file_, first.produce());
  EXPECT_EQ(readFile(file_), "first");
  std::filesystem::permissions(file_, std::filesystem::perms(0600));
  Pieces second({std::string(100'000, 'a'), std::string(100'000, 'b')});
  writeFileAtomically(file_, second.produce());
  EXPECT_EQ(readFile(file_), std::string(100'000, 'a') + std::string(100'000, 'b'));
  EXPECT_EQ(std::filesystem::status(file_).permissions(), std::filesystem::perms(0600));
  EXPECT_EQ(folder_.entryCount(), 1U);
  EXPECT_EQ(first.calls + second.calls, 2) << "for files once each";
}

TEST_F(WriteFileInPieces, LeavesEverythingAsItWasWhereAPieceCannotBeProduced) {
  folder_.put("out.txt", "old");
  Pieces broken({"new", ""});
  EXPECT_THROW(writeFileAtomically(file_, broken.produce()), InvalidArgument);
  EXPECT_THROW(writeFileAtomically(folder_.path() / "other.txt", broken.produce()), InvalidArgument);
  EXPECT_EQ(readFile(file_), "old");
  EXPECT_EQ(folder_.entryCount(), 1U);
}

TEST_F(WriteFileInPieces, KeepsTheOldFileWhenTheDiskIsFull) {
  folder_.put("out.txt", "old");
  Pieces pieces({std::string(4000, 'a'), std::string(4000, 'b')});
  std::string message;
  std::string at_once;
  {
    const test::NoFileGrows full(6000);
    message = messageOf<StorageError>([&] { writeFileAtomically(file_, pieces.produce()); });
    at_once = messageOf<StorageError>([&] { writeFileAtomically(file_, std::string(8000, 'a')); });
  }
  EXPECT_THAT(message, saysAll("out.txt", "cannot be written"));
  EXPECT_EQ(message, at_once);
  EXPECT_EQ(readFile(file_), "old");
  EXPECT_EQ(folder_.entryCount(), 1U);
}

TEST_F(WriteFileInPieces, WritesIntoAFifoWhatCanBeProducedAsAWhole) {
  const auto fifo = folder_.path() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  Pieces broken({"new", ""});
  EXPECT_THROW(writeFileAtomically(fifo, broken.produce()), InvalidArgument) << "before anybody reads";
  Pieces pieces({"a", std::string(100'000, 'b'), "c"});
  std::string received;
  std::thread reader([&] { received = readFile(fifo); });
  writeFileAtomically(fifo, pieces.produce());
  reader.join();
  EXPECT_EQ(received, "a" + std::string(100'000, 'b') + "c");
  EXPECT_EQ(pieces.calls, 2);
  EXPECT_TRUE(std::filesystem::is_fifo(fifo));
  EXPECT_EQ(folder_.entryCount(), 1U);
}

}  // namespace
}  // namespace hexoderm
