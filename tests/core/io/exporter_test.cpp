#include "hexoderm/io/exporter.h"

#include "hexoderm/io/calibration_json.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/error.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>

#include <limits>
#include <set>

namespace hexoderm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class EveryExport : public ExportTest, public ::testing::WithParamInterface<ExportFormat> {
 protected:
  static const ExportFormatDescription& description() {
    return *std::ranges::find(exportFormats(), GetParam(), &ExportFormatDescription::format);
  }
  [[nodiscard]] std::filesystem::path target() const { return in("skin" + std::string(description().extension)); }
};

TEST_P(EveryExport, ReturnsTheFilesItWroteAndNoOthersAreLeft) {
  const auto paths = exportReconstruction(makeTestReconstruction(), GetParam(), target());
  std::set<std::filesystem::path> written;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    if (entry.is_regular_file()) written.insert(entry.path());
  }
  EXPECT_EQ(written, std::set<std::filesystem::path>(paths.begin(), paths.end()));
}

TEST_P(EveryExport, GivesTheBytesOfItsFileWithoutAFile) {
  if (GetParam() == ExportFormat::Csv) {
    EXPECT_THAT(messageOf<InvalidArgument>([] { exportBytes(makeTestReconstruction(), ExportFormat::Csv, {}, "x"); }),
                HasSubstr("folder of several files"));
    return;
  }
  const auto paths = exportReconstruction(makeTestReconstruction(), GetParam(), target());
  EXPECT_EQ(exportBytes(makeTestReconstruction(), GetParam(), {}, "standard output"), read(paths.at(0)));
}

TEST_P(EveryExport, GivesTheSameBytesAgainOverAnEarlierExport) {
  const auto paths = exportReconstruction(makeTestReconstruction(), GetParam(), target());
  std::vector<std::string> first;
  for (const auto& path : paths) first.push_back(read(path));
  EXPECT_EQ(exportReconstruction(makeTestReconstruction(), GetParam(), target()), paths);
  for (std::size_t k = 0; k < paths.size(); ++k) EXPECT_EQ(read(paths[k]), first[k]);
}

TEST_P(EveryExport, RefusesNumbersThatAreNotFiniteAndKeepsTheEarlierFile) {
  Reconstruction reconstruction = makeTestReconstruction();
  const auto paths = exportReconstruction(reconstruction, GetParam(), target());
  const std::string earlier = read(paths.front());
  reconstruction.patches[0].cells[1].T_o_u.t.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(messageOf<InvalidArgument>([&] { exportReconstruction(reconstruction, GetParam(), target()); }),
              HasSubstr("cell 7: its placement is not a finite number"));
  EXPECT_EQ(read(paths.front()), earlier);
}

TEST_P(EveryExport, TakesWhatEverySolverFinds) {
  SimulatedSkin skin(builtInCellModel("hex-bma150"), {});
  const Session session = simulateSession(skin, 3);
  for (const Solver solver : {Solver::Global, Solver::Tree}) {
    SolverOptions options;
    options.solver = solver;
    const auto result = reconstruct(*session.snapshot(), options);
    const auto paths = exportReconstruction(*result, GetParam(), target());
    ASSERT_FALSE(paths.empty());
    for (const auto& path : paths) EXPECT_FALSE(read(path).empty()) << path;
    // A calibration that was written to a file and read again is exported just the same.
    const auto back = parseCalibrationJson(calibrationToJson(*result), "c.json");
    EXPECT_NO_THROW(exportReconstruction(*back, GetParam(), target()));
  }
}

TEST_P(EveryExport, NamesATargetThatCannotBeWritten) {
  write(in("file"), "mine");
  for (const char* parent : {"missing", "file"}) {
    const std::filesystem::path path = in(parent) / target().filename();
    EXPECT_THAT(messageOf<StorageError>([&] { exportReconstruction(makeTestReconstruction(), GetParam(), path); }),
                HasSubstr(path.string()));
  }
  EXPECT_THAT(names(), ::testing::ElementsAre("file"));
  EXPECT_THROW(exportReconstruction(makeTestReconstruction(), GetParam(), ""), InvalidArgument);
}

std::string nameOf(const ::testing::TestParamInfo<ExportFormat>& parameter) {
  return std::string(std::ranges::find(exportFormats(), parameter.param, &ExportFormatDescription::format)->name);
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryExport,
                         ::testing::Values(ExportFormat::Csv, ExportFormat::Dot, ExportFormat::Ply, ExportFormat::Stl,
                                           ExportFormat::Vtp, ExportFormat::Urdf),
                         nameOf);

TEST(ExportFormats, AreFoundByName) {
  for (const ExportFormatDescription& format : exportFormats()) {
    EXPECT_EQ(exportFormatFromName(format.name), format.format);
    EXPECT_FALSE(format.summary.empty());
    EXPECT_EQ(format.extension.empty(), format.format == ExportFormat::Csv);
  }
  EXPECT_EQ(exportFormats().size(), 6U);
}

TEST(ExportFormats, UnknownNameListsTheKnownOnes) {
  EXPECT_THAT(messageOf<InvalidArgument>([] { exportFormatFromName("obj"); }),
              AllOf(HasSubstr("\"obj\""), HasSubstr("csv, dot, ply, stl, vtp, urdf")));
}

TEST(ExportOptions, NamesTheOptionThatMakesNoSense) {
  EXPECT_NO_THROW(ExportOptions().validate());
  ExportOptions options;
  options.urdf_robot = "";
  EXPECT_THAT(messageOf<InvalidArgument>([&] { options.validate(); }), HasSubstr("urdf_robot"));
  options = {};
  options.urdf_parent_link = "base link";
  EXPECT_THAT(messageOf<InvalidArgument>([&] { options.validate(); }), HasSubstr("urdf_parent_link"));
  options = {};
  options.urdf_prefix = "größe_";
  EXPECT_THAT(messageOf<InvalidArgument>([&] { options.validate(); }), HasSubstr("urdf_prefix"));
}

}  // namespace
}  // namespace hexoderm
