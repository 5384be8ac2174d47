#include "hexoderm/util/file.h"

#include "hexoderm/util/error.h"
#include "tests/support/error_matchers.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

namespace hexoderm {
namespace {

using test::messageOf;
using test::saysAll;
using test::TemporaryFolder;

TEST(ReadFile, GivesTheBytesAsTheyAre) {
  const TemporaryFolder folder;
  const std::string bytes("a\r\n\0\xff z", 8);
  EXPECT_EQ(readFile(folder.put("bytes", bytes)), bytes);
  EXPECT_EQ(readFile(folder.put("empty", "")), "");
}

TEST(ReadFile, ReadsMoreThanOneBuffer) {
  const TemporaryFolder folder;
  std::string content(200'001, 'x');
  content.back() = 'y';
  EXPECT_EQ(readFile(folder.put("large", content)), content);
}

TEST(ReadFile, NamesAMissingFileAndWhy) {
  const TemporaryFolder folder;
  const std::string message = messageOf<StorageError>([&] { readFile(folder.path() / "missing.json"); });
  EXPECT_THAT(message, saysAll("missing.json", "No such file"));
}

TEST(ReadFile, RefusesAFolder) {
  const TemporaryFolder folder;
  const std::string message = messageOf<StorageError>([&] { readFile(folder.path()); });
  EXPECT_THAT(message, saysAll(folder.path().string(), "is a folder, expected a file"));
}

TEST(WriteFileAtomically, WritesNewAndReplacesOld) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "out.txt";
  writeFileAtomically(file, "first");
  EXPECT_EQ(readFile(file), "first");
  writeFileAtomically(file, "2");
  EXPECT_EQ(readFile(file), "2");
  EXPECT_EQ(folder.entryCount(), 1U) << "a temporary file was left behind";
}

TEST(WriteFileAtomically, FollowsTheUsersUmask) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "out.txt";
  const mode_t before = ::umask(0027);
  writeFileAtomically(file, "x");
  ::umask(before);
  EXPECT_EQ(std::filesystem::status(file).permissions(), std::filesystem::perms(0640));
}

TEST(WriteFileAtomically, LeavesAFolderInThePlaceAlone) {
  const TemporaryFolder folder;
  const auto target = folder.path() / "out.txt";
  std::filesystem::create_directory(target);
  const std::string message = messageOf<StorageError>([&] { writeFileAtomically(target, "x"); });
  EXPECT_THAT(message, saysAll("out.txt", "is a folder"));
  EXPECT_TRUE(std::filesystem::is_directory(target));
  EXPECT_EQ(folder.entryCount(), 1U) << "a temporary file was left behind";
}

TEST(WriteFileAtomically, FailsWithoutATraceWhereThereIsNoFolder) {
  const TemporaryFolder folder;
  const auto target = folder.path() / "nowhere" / "out.txt";
  const std::string message = messageOf<StorageError>([&] { writeFileAtomically(target, "x"); });
  EXPECT_THAT(message, saysAll("out.txt", "cannot be written", "No such file"));
  EXPECT_EQ(folder.entryCount(), 0U);
}

TEST(WriteFileAtomically, LeavesOtherFilesAloneWhenTheTemporaryOneCannotBeMade) {
  const TemporaryFolder folder;
  const auto file = folder.put("out.txt", "old");
  // A name that just fits; the temporary one beside it no longer does.
  EXPECT_THROW(writeFileAtomically(folder.path() / std::string(250, 'n'), "x"), StorageError);
  EXPECT_EQ(readFile(file), "old");
  EXPECT_EQ(folder.entryCount(), 1U);
}

TEST(WriteFileAtomically, KeepsTheOldFileWhenWritingFailsHalfWay) {
  const TemporaryFolder folder;
  const auto file = folder.put("out.txt", "old");
  // The limit on file sizes stands for a full disk.
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const struct rlimit small { 4096, before.rlim_max };
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = messageOf<StorageError>([&] { writeFileAtomically(file, std::string(100'000, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(message, saysAll("out.txt", "cannot be written"));
  EXPECT_EQ(readFile(file), "old");
  EXPECT_EQ(folder.entryCount(), 1U) << "a temporary file was left behind";
}

}  // namespace
}  // namespace hexoderm
