#include "hexoderm/io/open_file.h"

#include "hexoderm/base/file.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using test::TemporaryFolder;

const std::filesystem::path kData = HEXODERM_TEST_DATA;

OpenedFile open(const std::filesystem::path& path) { return openFile(path, builtInCellModel("hex-bma150")); }

std::string complaint(const std::string& content) {
  const TemporaryFolder folder;
  const auto path = folder.put("f.dat", content);
  return messageOf<FormatError>([&] { open(path); });
}

TEST(OpenFile, TellsFilesApartByTheirContent) {
  const TemporaryFolder folder;
  const auto session = folder.put("a.dat", readFile(kData / "three_cells.session.json"));
  const auto calibration = folder.put(
      "b.dat", calibrationToJson(*reconstruct(*readSessionJson(kData / "three_cells.session.json").snapshot())));
  const auto tum = folder.put("c.dat", readFile(kData / "two_patches.tum.xml"));

  OpenedFile opened = open(session);
  ASSERT_TRUE(std::holds_alternative<Session>(opened));
  EXPECT_EQ(std::get<Session>(opened).neighbors().size(), 3U);
  EXPECT_EQ(std::get<Session>(opened).source().file, "a.dat");

  opened = open(calibration);
  ASSERT_TRUE(std::holds_alternative<std::shared_ptr<const Reconstruction>>(opened));
  EXPECT_EQ(std::get<std::shared_ptr<const Reconstruction>>(opened)->solver, "global");

  opened = open(tum);
  ASSERT_TRUE(std::holds_alternative<std::shared_ptr<const Reconstruction>>(opened));
  EXPECT_EQ(std::get<std::shared_ptr<const Reconstruction>>(opened)->solver, "imported");
}

TEST(OpenFile, OpensSessionStoresAlsoWhileTheyAreWritten) {
  const TemporaryFolder folder;
  const Session session = readSessionJson(kData / "three_cells.session.json");
  writeSessionStore(session, folder.path() / "d.dat");
  EXPECT_EQ(std::get<Session>(open(folder.path() / "d.dat")).poses().size(), 3U);
  SessionStore store = SessionStore::open(folder.path() / "d.dat");
  const StoreOperation operation = RemovePose{0};
  store.append({&operation, 1});
  const Session opened = std::get<Session>(open(folder.path() / "d.dat"));
  EXPECT_EQ(opened.poses().size(), 2U);
  EXPECT_EQ(opened.source().file, "d.dat");
}

TEST(SaveSession, WritesWhatTheNameSays) {
  const TemporaryFolder folder;
  const Session session = readSessionJson(kData / "three_cells.session.json");
  saveSession(session, folder.path() / "a.hexo");
  saveSession(session, folder.path() / "a.session.json");
  EXPECT_TRUE(isSessionStore(folder.path() / "a.hexo"));
  EXPECT_FALSE(isSessionStore(folder.path() / "a.session.json"));
  EXPECT_EQ(readFile(folder.path() / "a.session.json"), sessionToJson(session));
  saveSession(session, folder.path() / "a.session.json");
  EXPECT_THROW(saveSession(session, folder.path() / "a.hexo"), StorageError);
  EXPECT_TRUE(isSessionFileName("x/a.hexo"));
  EXPECT_TRUE(isSessionFileName("a.session.json"));
  EXPECT_FALSE(isSessionFileName("a.hexo/calibration.json"));
}

TEST(OpenFile, SkipsAByteOrderMarkAndWhiteSpace) {
  const TemporaryFolder folder;
  const std::string text = readFile(kData / "three_cells.session.json");
  EXPECT_TRUE(std::holds_alternative<Session>(open(folder.put("a", "\xEF\xBB\xBF" + text))));
  EXPECT_TRUE(std::holds_alternative<Session>(open(folder.put("b", "\r\n \t" + text))));
}

TEST(OpenFile, SaysWhatItReadsWhenAFileIsNoneOfIt) {
  EXPECT_THAT(complaint("\x7f"
                        "ELF"),
              saysAll("f.dat", "none of the files", "session", "calibration", "SkinConfig"));
  EXPECT_THAT(complaint(""), saysAll("f.dat", "empty", "session", "calibration"));
  EXPECT_THAT(complaint("{\"a\": 1}"), saysAll("f.dat", "format", "there is none"));
  EXPECT_THAT(complaint("{\"format\": \"hexoderm-manifest\"}"), saysAll("f.dat", "format", "\"hexoderm-manifest\""));
  EXPECT_THAT(complaint(std::string("SQLite format 3\0 and no more", 28)), saysAll("f.dat", "not a Hexoderm session"));
  EXPECT_THAT(complaint("<robot/>"), saysAll("f.dat", "SkinConfig", "robot"));
  EXPECT_THAT(complaint("SKINREC1 and no more"), saysAll("f.dat", "recording", "replay:"));
}

}  // namespace
}  // namespace hexoderm
