#include "hexoderm/io/exporter.h"

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/options.h"
#include "tests/support/solvers.h"

namespace hexoderm {
namespace {

class EveryExport : public ExportTest, public ::testing::WithParamInterface<ExportFormat> {
 protected:
  static const ExportFormatDescription& description() {
    return *std::ranges::find(exportFormats(), GetParam(), &ExportFormatDescription::format);
  }
  [[nodiscard]] std::filesystem::path target() const { return in("skin" + std::string(description().extension)); }
  /// The options that every test of the format needs.
  [[nodiscard]] ExportOptions needed() const {
    ExportOptions options;
    if (GetParam() == ExportFormat::RobotUrdf) {
      options.robot_urdf =
          elsewhere_.put("robot.urdf", "<robot name=\"arm\">\n  <link name=\"base_link\"/>\n</robot>\n");
    }
    return options;
  }
  std::vector<std::filesystem::path> exported(const Reconstruction& reconstruction = makeTestReconstruction()) const {
    return exportReconstruction(reconstruction, GetParam(), target(), needed());
  }

 private:
  const test::TemporaryFolder elsewhere_;  ///< for what is no export: the files of the folder are counted
};

TEST_P(EveryExport, WritesTheSameFilesAgainAndNoOthers) {
  const auto paths = exported();
  std::map<std::filesystem::path, std::string> first;
  for (const auto& path : paths) first[path] = readFile(path);
  EXPECT_EQ(exported(), paths);
  std::map<std::filesystem::path, std::string> written;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    if (entry.is_regular_file()) written[entry.path()] = readFile(entry.path());
  }
  EXPECT_EQ(written, first);
  if (GetParam() == ExportFormat::Csv) {
    EXPECT_THAT(messageOf<InvalidArgument>([] { exportBytes(makeTestReconstruction(), ExportFormat::Csv, {}); }),
                HasSubstr("folder of several files"));
    return;
  }
  EXPECT_EQ(exportBytes(makeTestReconstruction(), GetParam(), needed()), first.at(paths.at(0)));
}

TEST_P(EveryExport, RefusesNumbersThatAreNotFiniteAndKeepsTheEarlierFile) {
  Reconstruction reconstruction = makeTestReconstruction();
  const auto paths = exported(reconstruction);
  const std::string earlier = readFile(paths.front());
  reconstruction.patches[0].cells[1].T_o_u.t.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(messageOf<InvalidArgument>([&] { exported(reconstruction); }),
              HasSubstr("cell 7: its placement is not a finite number"));
  EXPECT_EQ(readFile(paths.front()), earlier);
}

TEST_P(EveryExport, TakesWhatEverySolverFinds) {
  SimulatedSkin skin(builtInCellModel("hex-bma150"), {});
  const Session session = simulateSession(skin, 3);
  for (const Solver solver : {Solver::Global, Solver::Tree}) {
    const auto result = reconstruct(*session.snapshot(), test::by(solver));
    const auto paths = exported(*result);
    ASSERT_FALSE(paths.empty());
    for (const auto& path : paths) EXPECT_FALSE(readFile(path).empty()) << path;
    // A calibration that was written to a file and read again is exported just the same.
    const auto back = parseCalibrationJson(calibrationToJson(*result), "c.json");
    EXPECT_NO_THROW(exported(*back));
  }
}

/// The skin as if it had only this one of its patches.
Reconstruction withPatch(std::size_t index) {
  Reconstruction part = makeTestReconstruction();
  part.patches = {part.patches[index]};
  std::erase_if(part.layout.cells, [&](const FlatCell& cell) { return part.find(cell.cell).cell == nullptr; });
  return part;
}

class EveryExportOfPatches : public EveryExport {
 protected:
  /// The contents of the files that an export writes, but for the manifest, which names the patches left out.
  std::vector<std::string> contents(const Reconstruction& reconstruction, std::optional<ExportOptions> options = {}) {
    std::vector<std::string> found;
    for (const auto& path : exportReconstruction(reconstruction, GetParam(), target(), options.value_or(needed()))) {
      if (path.filename() != "manifest.json") found.push_back(readFile(path));
    }
    return found;
  }
};

TEST_P(EveryExportOfPatches, NeverHoldsTwoPatchesAtOnePlaceUnasked) {
  const Reconstruction two = makeTestReconstruction();
  const std::vector<PatchLeftOut> left_out = patchesLeftOut(two, GetParam());
  if (description().patches == PatchesInFile::All) {
    EXPECT_THAT(left_out, IsEmpty());
    EXPECT_NE(contents(two), contents(withPatch(0)));
    return;
  }
  ASSERT_EQ(left_out.size(), 1U);
  EXPECT_EQ(left_out[0].patch, PatchId(1));
  EXPECT_EQ(left_out[0].origin, CellId(20));
  EXPECT_THAT(left_out[0].cells, ::testing::ElementsAre(CellId(20)));
  EXPECT_EQ(contents(two), contents(withPatch(0)));
  EXPECT_THAT(patchesLeftOut(withPatch(0), GetParam()), IsEmpty());
}

TEST_P(EveryExportOfPatches, HoldsThePatchOfACellAlone) {
  const Reconstruction two = makeTestReconstruction();
  for (const auto& [cell, index] : {std::pair(3U, 0U), std::pair(7U, 0U), std::pair(20U, 1U)}) {
    const ExportOptions options = test::with(needed(), &ExportOptions::patch, CellId(cell));
    EXPECT_EQ(contents(two, options), contents(withPatch(index))) << cell;
    const std::vector<PatchLeftOut> left_out = patchesLeftOut(two, GetParam(), options);
    ASSERT_EQ(left_out.size(), 1U);
    EXPECT_EQ(left_out[0].patch, PatchId(1 - index));
  }
  ExportOptions options = test::with(needed(), &ExportOptions::patch, CellId(99));
  EXPECT_THAT(messageOf<InvalidArgument>([&] { contents(two, options); }), HasSubstr("no patch holds a cell 99"));
  options.patch = CellId(7);
  options.all_patches = true;
  EXPECT_THAT(messageOf<InvalidArgument>([&] { contents(two, options); }), HasSubstr("all_patches"));
}

TEST_P(EveryExportOfPatches, HoldsAllOfThemWhereItCanTellThemApart) {
  const Reconstruction two = makeTestReconstruction();
  const ExportOptions options = test::with(needed(), &ExportOptions::all_patches, true);
  if (description().patches != PatchesInFile::All && description().patches != PatchesInFile::AllIfAsked) {
    EXPECT_THAT(messageOf<InvalidArgument>([&] { contents(two, options); }), HasSubstr("has one frame"));
    EXPECT_THROW(patchesLeftOut(two, GetParam(), options), InvalidArgument);
    EXPECT_THAT(names(), IsEmpty());
    return;
  }
  EXPECT_THAT(patchesLeftOut(two, GetParam(), options), IsEmpty());
  EXPECT_NE(contents(two, options), contents(withPatch(0)));
}

TEST_P(EveryExportOfPatches, IsNotHeldUpByAPatchThatIsLeftOut) {
  if (description().patches == PatchesInFile::All) return;
  Reconstruction two = makeTestReconstruction();
  two.patches[1].cells[0].T_o_u.t.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(contents(two), contents(withPatch(0)));
}

TEST_P(EveryExport, NamesATargetThatCannotBeWritten) {
  temporary_.put("file", "mine");
  for (const char* parent : {"missing", "file"}) {
    const std::filesystem::path path = in(parent) / target().filename();
    EXPECT_THAT(
        messageOf<StorageError>([&] { exportReconstruction(makeTestReconstruction(), GetParam(), path, needed()); }),
        HasSubstr(path.string()));
  }
  EXPECT_THAT(names(), ::testing::ElementsAre("file"));
  EXPECT_THROW(exportReconstruction(makeTestReconstruction(), GetParam(), ""), InvalidArgument);
}

std::string nameOf(const ::testing::TestParamInfo<ExportFormat>& parameter) {
  std::string name(exportFormatDescription(parameter.param).name);
  std::erase(name, '-');
  return name;
}

const auto kEveryFormat = ::testing::ValuesIn(collect(exportFormats(), &ExportFormatDescription::format));
INSTANTIATE_TEST_SUITE_P(Formats, EveryExport, kEveryFormat, nameOf);
INSTANTIATE_TEST_SUITE_P(Formats, EveryExportOfPatches, kEveryFormat, nameOf);

TEST(PatchesLeftOut, AreNamedOrCounted) {
  EXPECT_TRUE(leftOutText({}).empty());
  const PatchLeftOut one{PatchId(1), CellId(20), {CellId(20)}};
  EXPECT_EQ(leftOutText({one}).english(),
            "Not in the file: the patch of cell 20 (1 cell), because how it lies to the exported patch is not known.");
  const PatchLeftOut other{PatchId(2), CellId(31), {CellId(31), CellId(32)}};
  EXPECT_EQ(leftOutText({one, other}).english(),
            "Not in the file: the patches of cells 20 and 31 (3 cells), because how they lie to the exported patch is "
            "not known.");
  EXPECT_THAT(leftOutText(std::vector<PatchLeftOut>(4000, one)).english(),
              HasSubstr("Not in the file: 4000 patches (4000 cells)"));
}

TEST(MeshFormats, RefuseNoCellsAndPlacesThatSinglePrecisionCannotHold) {
  Reconstruction reconstruction = makeTestReconstruction();
  for (const ExportFormat format : {ExportFormat::Ply, ExportFormat::Stl, ExportFormat::Obj, ExportFormat::Gltf}) {
    reconstruction.patches[0].cells[2].T_o_u.t.x() = kMaxLength_m;
    EXPECT_NO_THROW(exportBytes(reconstruction, format, {}));
    reconstruction.patches[0].cells[2].T_o_u.t.x() = -1e36;
    EXPECT_THAT(messageOf<InvalidArgument>([&] { exportBytes(reconstruction, format, {}); }),
                HasSubstr("cell 12: the single precision"));
    EXPECT_THAT(messageOf<InvalidArgument>([&] { exportBytes(test::ResultBuilder().build(), format, {}); }),
                HasSubstr("no cells"));
  }
}

TEST(ExportFormats, AreFoundByName) {
  std::set<std::string_view> extensions;
  for (const ExportFormatDescription& format : exportFormats()) {
    EXPECT_EQ(exportFormatFromName(format.name), format.format);
    EXPECT_FALSE(format.summary.empty());
    EXPECT_EQ(format.extension.empty(), format.format == ExportFormat::Csv);
    extensions.insert(format.extension);
  }
  EXPECT_EQ(exportFormats().size(), enumeratorCount<ExportFormat>()) << "a format without a row";
  EXPECT_EQ(extensions.size(), exportFormats().size()) << "files of a bundle need names of their own";
}

TEST(ExportFormats, UnknownNameListsTheKnownOnes) {
  EXPECT_THAT(messageOf<InvalidArgument>([] { exportFormatFromName("step"); }),
              AllOf(HasSubstr("\"step\""), HasSubstr("csv, dot, ply, stl, vtp, urdf, robot-urdf, tf-ros1")));
}

TEST(ExportOptions, NamesTheOptionThatMakesNoSense) {
  EXPECT_NO_THROW(ExportOptions().validate());
  const std::pair<ExportOptions, const char*> senseless[] = {
      {test::with(&ExportOptions::model_name, ""), "model_name"},
      {test::with(&ExportOptions::parent_link, "base link"), "parent_link"},
      {test::with(&ExportOptions::prefix, "größe_"), "prefix"}};
  for (const auto& [options, name] : senseless) {
    EXPECT_THAT(messageOf<InvalidArgument>([&options = options] { options.validate(); }), HasSubstr(name));
  }
}

}  // namespace
}  // namespace hexoderm
