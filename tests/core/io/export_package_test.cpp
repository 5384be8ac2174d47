// Packages: what is in them, and that a stopped or failed one leaves nothing.

#include "hexoderm/io/export_package.h"

#include "hexoderm/base/sha256.h"
#include "hexoderm/io/calibration_json.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/failing_disk.h"
#include "tests/support/hand_made_skins.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

namespace hexoderm {
namespace {

using ::testing::Not;

class ExportPackage : public ExportTest {
 protected:
  static PackageContent severalFiles() {
    return {{ExportFormat::Urdf, ExportFormat::Csv, ExportFormat::Ply},
            true,
            {{"report.pdf", std::string("%PDF-1.4\0binary", 15), message("a report")},
             {"Grüße.txt", "", message("nothing at all")}}};
  }
  static std::vector<std::string> namesOf(const std::vector<PackageEntry>& entries) {
    return collect(entries, &PackageEntry::name);
  }

  /// As it is read back: a calibration has a residual, or none, for each link in each pose.
  static Reconstruction skin() {
    Reconstruction result = demoReconstruction();
    for (PatchReconstruction& patch : result.patches) {
      for (LinkEstimate& link : patch.links) link.pose_residual_rad.resize(result.poses.size());
    }
    return result;
  }

  const Reconstruction skin_ = skin();
};

TEST_F(ExportPackage, IsAFolderWithEverythingAndAManifestThatNamesIt) {
  const WrittenPackage written = exportPackage(skin_, severalFiles(), in("out"));
  EXPECT_THAT(namesOf(written.entries), Contains("skin.urdf"));
  EXPECT_THAT(namesOf(written.entries), Contains("cells.csv"));
  EXPECT_THAT(namesOf(written.entries), Contains("skin.calibration.json"));
  EXPECT_EQ(written.entries.back().name, "manifest.json");
  EXPECT_EQ(readFile(in("out/report.pdf")), std::string("%PDF-1.4\0binary", 15));
  EXPECT_EQ(readCalibrationJson(in("out/skin.calibration.json"))->cellCount(), skin_.cellCount());
  const auto manifest = nlohmann::json::parse(readFile(in("out/manifest.json")));
  EXPECT_EQ(manifest.at("files").size() + 1, written.entries.size());
  for (const auto& file : manifest.at("files")) {
    EXPECT_EQ(file.at("sha256"), sha256Hex(readFile(in("out") / file.at("file").get<std::string>())))
        << file.at("file");
  }
  for (const PackageEntry& entry : written.entries) {
    EXPECT_EQ(entry.size, std::filesystem::file_size(in("out") / entry.name)) << entry.name;
  }
  EXPECT_EQ(written.paths.size(), written.entries.size());
}

TEST_F(ExportPackage, IsAnArchiveThatAnotherProgramReads) {
  const WrittenPackage written = exportPackage(skin_, severalFiles(), in("arm.zip"));
  EXPECT_THAT(written.paths, ElementsAre(in("arm.zip")));
  EXPECT_THAT(names(), ElementsAre("arm.zip"));
  // Python's own reader, which compares the checksums, unpacks it beside the folder that should be the same.
  exportPackage(skin_, severalFiles(), in("folder"));
  const std::string program =
      "import sys, zipfile\n"
      "archive = zipfile.ZipFile(sys.argv[1])\n"
      "assert archive.testzip() is None\n"
      "assert any(i.compress_type == zipfile.ZIP_DEFLATED for i in archive.infolist())\n"
      "archive.extractall(sys.argv[2])\n";
  temporary_.put("unpack.py", program);
  const std::string command =
      "python3 '" + in("unpack.py").string() + "' '" + in("arm.zip").string() + "' '" + folder_.string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  for (const PackageEntry& entry : written.entries) {
    EXPECT_EQ(readFile(in("arm") / entry.name), readFile(in("folder") / entry.name)) << entry.name;
  }
}

TEST_F(ExportPackage, IsPreviewedWithFramesInWordsBeforeAnythingIsWritten) {
  const std::vector<PackageEntry> entries = previewPackage(skin_, severalFiles());
  EXPECT_THAT(names(), IsEmpty());
  ASSERT_THAT(namesOf(entries), ElementsAre("skin.urdf", "cells.csv, links.csv, ...", "skin.ply",
                                            "skin.calibration.json", "report.pdf", "Grüße.txt", "manifest.json"));
  EXPECT_THAT(entries[0].frame.english(), HasSubstr("its place on the robot is not known"));
  EXPECT_THAT(entries[2].frame.english(), HasSubstr("in the frame of cell 1, the origin of the patch"));
  EXPECT_THAT(entries[2].not_carried.english(), HasSubstr("no uncertainties"));
  EXPECT_TRUE(entries[4].frame.empty()) << "a report has no frame";
}

TEST_F(ExportPackage, SaysWhichLinkAPlacedPatchIsOn) {
  ExportOptions options;
  options.placements.push_back({skin_.patches.front().origin, "forearm", SE3(), std::nullopt});
  const auto entries = previewPackage(skin_, {{ExportFormat::Urdf}, false, {}}, options);
  EXPECT_THAT(entries[0].frame.english(), HasSubstr("in its place on link forearm"));
}

TEST_F(ExportPackage, ThatIsStoppedLeavesNothingButTheEarlierOne) {
  for (const std::string target : {"out", "arm.zip"}) {
    for (std::size_t after = 0; after < 5; ++after) {
      std::stop_source stop;
      std::size_t seen = 0;
      const auto progress = [&](const std::string&, std::size_t, std::size_t) {
        if (seen++ == after) stop.request_stop();
      };
      const WrittenPackage written = exportPackage(skin_, severalFiles(), in(target), {}, stop.get_token(), progress);
      EXPECT_TRUE(written.entries.empty()) << target << " after " << after;
      EXPECT_THAT(names(), IsEmpty()) << target << " after " << after;
    }
  }
  temporary_.put("arm.zip", "earlier");
  std::stop_source stop;
  stop.request_stop();
  exportPackage(skin_, severalFiles(), in("arm.zip"), {}, stop.get_token());
  EXPECT_EQ(readFile(in("arm.zip")), "earlier");
  EXPECT_THAT(names(), ElementsAre("arm.zip"));
}

TEST_F(ExportPackage, OnAFullDiskLeavesNothing) {
  for (const std::string target : {"out", "arm.zip"}) {
    const test::NoFileGrows full(100);
    EXPECT_THROW(exportPackage(skin_, severalFiles(), in(target)), StorageError) << target;
    EXPECT_THAT(names(), IsEmpty()) << target;
  }
}

TEST_F(ExportPackage, WhereNothingCanBeWrittenSaysSo) {
  EXPECT_THROW(exportPackage(skin_, severalFiles(), "/proc/out"), StorageError);
  EXPECT_THROW(exportPackage(skin_, severalFiles(), "/proc/arm.zip"), StorageError);
  temporary_.put("file", "1");
  EXPECT_THROW(exportPackage(skin_, severalFiles(), in("file")), StorageError);
  std::filesystem::create_directory(in("taken.zip"));
  EXPECT_THROW(exportPackage(skin_, severalFiles(), in("taken.zip")), StorageError);
}

TEST_F(ExportPackage, OfNothingOrWithANameTwiceIsRefused) {
  EXPECT_THROW(exportPackage(skin_, {}, in("out")), InvalidArgument);
  PackageContent twice;
  twice.attachments = {{"report.pdf", "1", message("one")}, {"report.pdf", "2", message("two")}};
  EXPECT_THROW(exportPackage(skin_, twice, in("out")), InvalidArgument);
  EXPECT_THROW(exportPackage(skin_, {{ExportFormat::RobotUrdf}, false, {}}, in("out")), InvalidArgument)
      << "the robot is missing";
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(ExportPackage, HasEachFormatOnce) {
  const WrittenPackage written = exportPackage(skin_, {{ExportFormat::Dot, ExportFormat::Dot}, false, {}}, in("out"));
  EXPECT_THAT(namesOf(written.entries), ElementsAre("skin.dot", "manifest.json"));
}

}  // namespace
}  // namespace hexoderm
