#include "hexoderm/io/export_staging.h"

#include "tests/core/io/export_test_folder.h"
#include "tests/support/failing_disk.h"

namespace hexoderm {
namespace {

class ExportStaging : public ExportTest {
 protected:
  /// Why the folder of this name does not take these files.
  [[nodiscard]] std::string refusal(const std::string& name, const std::vector<StagedFile>& files) const {
    return messageOf<StorageError>([&] { publishFolder(in(name), files); });
  }
};

TEST_F(ExportStaging, MakesAFolderForItsFiles) {
  const auto paths = publishFolder(in("out/"), {{"a.csv", "1"}, {"b.csv", "2"}});
  EXPECT_THAT(paths, ElementsAre(in("out/a.csv"), in("out/b.csv")));
  EXPECT_EQ(readFile(paths[1]), "2");
  EXPECT_THAT(names(), ElementsAre("out", "out/a.csv", "out/b.csv"));
  // Others may look into it as into any folder that the user makes.
  std::filesystem::create_directory(in("reference"));
  EXPECT_EQ(std::filesystem::status(in("out")).permissions(), std::filesystem::status(in("reference")).permissions());
}

TEST_F(ExportStaging, ReplacesOnlyItsOwnFilesInAFolder) {
  std::filesystem::create_directory(in("out"));
  temporary_.put("out/a.csv", "earlier");
  temporary_.put("out/notes.txt", "mine");
  publishFolder(in("out"), {{"a.csv", "1"}, {"b.csv", "2"}});
  EXPECT_EQ(readFile(in("out/a.csv")), "1");
  EXPECT_EQ(readFile(in("out/notes.txt")), "mine");
  EXPECT_THAT(names(), ElementsAre("out", "out/a.csv", "out/b.csv", "out/notes.txt"));
}

TEST_F(ExportStaging, LeavesWhatWasThereIfOneOfItsFilesFails) {
  for (const bool has_earlier : {false, true}) {
    if (has_earlier) {
      std::filesystem::create_directory(in("out"));
      temporary_.put("out/a.csv", "earlier");
    }
    {
      const test::NoFileGrows full(1);
      EXPECT_THAT(refusal("out", {{"a.csv", "1"}, {"b.csv", "two"}}),
                  StartsWith(in("out/b.csv").string() + ": cannot be written: "));
    }
    EXPECT_EQ(names(), has_earlier ? std::vector<std::string>({"out", "out/a.csv"}) : std::vector<std::string>());
  }
  EXPECT_EQ(readFile(in("out/a.csv")), "earlier");
}

TEST_F(ExportStaging, PutsFilesBackIfALaterOneCannotBeReplaced) {
  std::filesystem::create_directories(in("out/c.csv"));  // a folder where the third file should go
  temporary_.put("out/a.csv", "earlier");
  EXPECT_THROW(publishFolder(in("out"), {{"a.csv", "1"}, {"b.csv", "2"}, {"c.csv", "3"}}), StorageError);
  EXPECT_EQ(readFile(in("out/a.csv")), "earlier");
  EXPECT_THAT(names(), ElementsAre("out", "out/a.csv", "out/c.csv"));
}

TEST_F(ExportStaging, RefusesAFileWhereAFolderIsMeant) {
  temporary_.put("out", "mine");
  EXPECT_THAT(refusal("out", {{"a.csv", "1"}}), HasSubstr("is a file, expected a folder"));
  EXPECT_EQ(readFile(in("out")), "mine");
}

TEST_F(ExportStaging, ReplacesNothingThatIsNoFile) {
  std::filesystem::create_directory(in("out"));
  temporary_.put("elsewhere.csv", "mine");
  temporary_.put("out/a.csv", "earlier");
  std::filesystem::create_symlink("../elsewhere.csv", in("out/b.csv"));
  EXPECT_THAT(refusal("out", {{"a.csv", "1"}, {"b.csv", "2"}}), HasSubstr("b.csv: is not a file"));
  EXPECT_EQ(readFile(in("elsewhere.csv")), "mine");
  EXPECT_EQ(readFile(in("out/a.csv")), "earlier");
  EXPECT_THAT(names(), ElementsAre("elsewhere.csv", "out", "out/a.csv", "out/b.csv"));
}

TEST_F(ExportStaging, KeepsTheRightsOfFilesThatItReplaces) {
  std::filesystem::create_directory(in("out"));
  temporary_.put("out/a.csv", "earlier");
  std::filesystem::permissions(in("out/a.csv"), std::filesystem::perms(0640));
  publishFolder(in("out"), {{"a.csv", "1"}});
  EXPECT_EQ(std::filesystem::status(in("out/a.csv")).permissions(), std::filesystem::perms(0640));
}

TEST_F(ExportStaging, NamesAFolderThatCannotBe) {
  temporary_.put("file", "");
  std::filesystem::create_symlink("loop", in("loop"));
  for (const std::string& name :
       {std::string(256, 'n'), std::string("loop"), std::string("file/out"), std::string("missing/out")}) {
    EXPECT_THAT(refusal(name, {{"a.csv", "1"}}), HasSubstr(in(name).string()));
  }
  EXPECT_THAT(names(), ElementsAre("file", "loop"));
}

}  // namespace
}  // namespace hexoderm
