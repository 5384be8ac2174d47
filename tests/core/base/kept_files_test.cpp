#include "hexoderm/base/kept_files.h"

#include "hexoderm/base/file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

namespace fs = std::filesystem;

/// The header of an SQLite database, as far as its application ID.
std::string databaseOf(std::string_view id) {
  std::string bytes(kSqliteHeader);
  bytes.resize(68, '\1');
  return bytes.append(id).append(4000, '\2');
}

TEST(KeptFiles, ASessionIsToldByItsContentWhateverItIsCalled) {
  const test::TemporaryFolder folder;
  const std::string session = databaseOf("HEXO");
  const fs::path file = folder.put("old.calibration.json", session);
  fs::create_hard_link(file, folder.path() / "hard.json");
  fs::create_symlink(file, folder.path() / "soft.json");
  for (const fs::path& path :
       {file, folder.path() / "." / "old.calibration.json", folder.path() / "hard.json", folder.path() / "soft.json"}) {
    EXPECT_THAT(messageOf<StorageError>([&] { writeFileAtomically(path, "new"); }),
                saysAll(path.string(), "as a Hexoderm session", "take another name"));
    EXPECT_EQ(readFile(path), session);
  }
  EXPECT_EQ(folder.entryCount(), 3U);
}

TEST(KeptFiles, OtherDatabasesAndCutOffHeadersAreOrdinaryFiles) {
  const test::TemporaryFolder folder;
  for (const std::string& content :
       {databaseOf("HEXX"), databaseOf("HEXO").substr(0, 71), std::string("HEXO"), std::string()}) {
    const fs::path file = folder.put("ordinary.hexo", content);
    writeFileAtomically(file, "new");
    EXPECT_EQ(readFile(file), "new");
  }
}

TEST(KeptFiles, WhatBelongsToASessionIsNotReplacedNorMade) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.put("arm.hexo", databaseOf("HEXO"));
  folder.put("arm.hexo-wal", "journal");
  fs::create_symlink("arm.hexo-wal", folder.path() / "soft.json");
  for (const char* name : {"arm.hexo-wal", "arm.hexo-shm", "soft.json"}) {
    EXPECT_THAT(messageOf<StorageError>([&] { writeFileAtomically(folder.path() / name, "new"); }),
                saysAll(name, "belongs to the session " + fs::canonical(file).string()));
  }
  EXPECT_EQ(readFile(folder.path() / "arm.hexo-wal"), "journal");
  EXPECT_FALSE(fs::exists(folder.path() / "arm.hexo-shm"));
  writeFileAtomically(folder.path() / "notes-wal", "new");
}

TEST(KeptFiles, AFileThatBecomesASessionWhileItsSuccessorIsWrittenStays) {
  const test::TemporaryFolder folder;
  for (const bool had_earlier : {false, true}) {
    const fs::path file = folder.path() / (had_earlier ? "old.json" : "none.json");
    if (had_earlier) folder.put("old.json", "old");
    const auto produce = [&](const WriteBytes& write) {
      write("new");
      folder.put(file.filename().string(), databaseOf("HEXO"));
    };
    EXPECT_THAT(messageOf<StorageError>([&] { writeFileAtomically(file, produce); }), saysAll("as a Hexoderm session"));
    EXPECT_EQ(readFile(file), databaseOf("HEXO"));
  }
  EXPECT_EQ(folder.entryCount(), 2U) << "a temporary file was left behind";
}

TEST(KeptFiles, AKeptFileIsReplacedUnderNoNameUntilItIsLetGo) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.put("in.json", "old");
  fs::create_hard_link(file, folder.path() / "hard.json");
  std::optional<KeptFile> first(file);
  std::optional<KeptFile> second(file);
  first.reset();
  EXPECT_THAT(messageOf<InvalidArgument>([&] { writeFileAtomically(folder.path() / "hard.json", "new"); }),
              saysAll("hard.json", "is one of the inputs"));
  EXPECT_EQ(readFile(file), "old");
  second.reset();
  writeFileAtomically(file, "new");
  EXPECT_EQ(readFile(file), "new");
}

TEST(KeptFiles, WhatIsReadIsKeptOnlyByProgramsThatSaySo) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.put("in.json", "old");
  readFile(file);
  writeFileAtomically(file, "edited");
  EXPECT_EXIT(
      {
        keepWhatIsRead();
        writeFileAtomically(file, "before it is read");
        readFile(file);
        const std::string why = messageOf<InvalidArgument>([&] { writeFileAtomically(file, "new"); });
        std::exit(why.find("is one of the inputs") != std::string::npos ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
  EXPECT_EQ(readFile(file), "before it is read");
}

}  // namespace
}  // namespace hexoderm
