#include "hexoderm/io/export_formats.h"

#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/io/exporter.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/other_programs.h"

#include <nlohmann/json.hpp>

namespace hexoderm {
namespace {

class ExportCsv : public ExportTest {
 protected:
  /// One of the tables.
  std::string exported(const std::string& table, const Reconstruction& reconstruction = makeTestReconstruction()) {
    exportReconstruction(reconstruction, ExportFormat::Csv, in("out"));
    return readFile(in("out") / table);
  }
};

/// The fields of column `name` below the header, by a reader of the test's own that knows no quoting.
std::vector<std::string> column(const std::string& text, const std::string& name) {
  std::vector<std::string> lines = split(text, '\n');
  const std::vector<std::string> header = split(lines.front(), ',');
  const auto at = static_cast<std::size_t>(std::ranges::find(header, name) - header.begin());
  std::vector<std::string> values;
  for (std::size_t k = 1; k + 1 < lines.size(); ++k) values.push_back(split(lines[k], ',').at(at));
  return values;
}

/// The rows of a file with its header, as Python's csv reads them strictly.
std::vector<std::vector<std::string>> rowsByPython(const std::filesystem::path& file) {
  const auto outcome = test::runProgram(
      "python3 -c 'import csv, json, sys; print(json.dumps(list(csv.reader(open(sys.argv[1], encoding=\"utf-8\", "
      "newline=\"\"), strict=True))))' " +
      file.string());
  EXPECT_TRUE(outcome && outcome->exit_code == 0) << (outcome ? outcome->out : "there is no python3");
  if (!outcome || outcome->exit_code != 0) return {};
  return nlohmann::json::parse(outcome->out).get<std::vector<std::vector<std::string>>>();
}

/// Whether a field of a file says what was meant, a number to the last bit.
bool isMeant(const std::string& found, const CsvField& meant) {
  if (const auto* value = std::get_if<double>(&meant)) return std::stod(found) == *value;
  if (const auto* value = std::get_if<std::uint64_t>(&meant)) return found == std::to_string(*value);
  const auto* text = std::get_if<std::string>(&meant);
  return found == (text != nullptr ? *text : "");
}

TEST_F(ExportCsv, WritesSixTablesAndWhatTheyAre) {
  const auto paths = exportReconstruction(makeTestReconstruction(), ExportFormat::Csv, in("out"));
  EXPECT_THAT(paths, ElementsAre(in("out/cells.csv"), in("out/sensors.csv"), in("out/links.csv"), in("out/poses.csv"),
                                 in("out/residuals.csv"), in("out/covariances.csv"), in("out/manifest.json")));
  EXPECT_THAT(names(), ElementsAre("out", "out/cells.csv", "out/covariances.csv", "out/links.csv", "out/manifest.json",
                                   "out/poses.csv", "out/residuals.csv", "out/sensors.csv"));
}

TEST_F(ExportCsv, HoldsLinksAndTheirMetrics) {
  const std::string links = exported("links.csv");
  EXPECT_THAT(column(links, "source_cell"), ElementsAre("3", "7", "7", "7"));
  EXPECT_THAT(column(links, "target_port"), ElementsAre("3", "4", "3", "1"));
  EXPECT_THAT(column(links, "quality"), ElementsAre("fully", "un", "over", "un"));
  EXPECT_THAT(column(links, "used"), ElementsAre("1", "0", "1", "0"));
  EXPECT_THAT(column(links, "muted_by"), ElementsAre("", "one-sided-link", "", "body-part-boundary"));
  EXPECT_EQ(column(links, "singular_2")[0], "0.5000000000000001");
  EXPECT_EQ(std::stod(column(links, "yaw_deg")[0]), toDegrees(1.0 / 3));
}

TEST_F(ExportCsv, LeavesResidualsEmptyWhereThereAreNone) {
  const std::string residuals = exported("residuals.csv");
  EXPECT_THAT(residuals,
              ::testing::StartsWith("source_cell,source_port,target_cell,target_port,pose1_deg,pose2_deg,pose4_deg\n"));
  EXPECT_THAT(column(residuals, "pose2_deg")[0], "");
  EXPECT_DOUBLE_EQ(std::stod(column(residuals, "pose1_deg")[0]), toDegrees(0.011));
  EXPECT_DOUBLE_EQ(std::stod(column(residuals, "pose4_deg")[0]), toDegrees(0.5));
  EXPECT_THAT(column(residuals, "pose1_deg")[1], "");
}

TEST_F(ExportCsv, HoldsEveryFieldForPython) {
  const Reconstruction reconstruction = makeTestReconstruction();
  exportReconstruction(reconstruction, ExportFormat::Csv, in("out"));
  for (const CsvTable& table : csvTables(reconstruction)) {
    const auto rows = rowsByPython(in("out") / table.file);
    ASSERT_EQ(rows.size(), 1 + table.rows.size()) << table.file;
    EXPECT_EQ(rows.front(), table.header);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      ASSERT_EQ(rows[row + 1].size(), table.header.size()) << table.file;
      ASSERT_EQ(table.rows[row].size(), table.header.size()) << table.file;
      for (std::size_t k = 0; k < table.header.size(); ++k) {
        EXPECT_TRUE(isMeant(rows[row + 1][k], table.rows[row][k]))
            << table.file << ", row " << row + 1 << ", " << table.header[k] << ": " << rows[row + 1][k];
      }
    }
  }
}

TEST_F(ExportCsv, HoldsPlacementsToTheLastBit) {
  const Reconstruction reconstruction = makeTestReconstruction();
  exportReconstruction(reconstruction, ExportFormat::Csv, in("out"));
  const auto rows = rowsByPython(in("out/cells.csv"));
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[3][5], "0.0123456789012345");
  EXPECT_EQ(rows[3][7], "-0.012");
  const Eigen::Quaterniond q(std::stod(rows[1][8]), std::stod(rows[1][9]), std::stod(rows[1][10]),
                             std::stod(rows[1][11]));
  EXPECT_LT((q.toRotationMatrix() - reconstruction.patches[0].cells[0].T_o_u.R).norm(), 1e-15);
  EXPECT_EQ(rows[1][12], "0.001");  // sigma_x_m
  EXPECT_EQ(rows[3][12], "");       // not known
  EXPECT_EQ(rows[1].back(), "7");   // predecessor
}

TEST_F(ExportCsv, HoldsDeviationsAndSensorErrorsWhereTheyAreKnown) {
  Reconstruction reconstruction = makeTestReconstruction();
  CellPlacement& cell = reconstruction.patches[0].cells[0];
  cell.cov_t_r->diagonal() << 1e-6, 4e-6, 9e-6, 0.01, 0.04, 0.09;
  (*cell.cov_t_r)(1, 4) = (*cell.cov_t_r)(4, 1) = -2e-5;
  cell.accel_offset_g = {0.06, -1.0 / 3, 0};
  cell.accel_scale = {1.02, 0.98, 1};
  const std::string cells = exported("cells.csv", reconstruction);
  EXPECT_EQ(column(cells, "sigma_y_m")[0], "0.002");
  EXPECT_DOUBLE_EQ(std::stod(column(cells, "sigma_rz_deg")[0]), toDegrees(0.3));
  EXPECT_EQ(column(cells, "accel_offset_x_g")[0], "0.06");
  EXPECT_EQ(column(cells, "accel_offset_y_g")[0], formatExact(-1.0 / 3));
  EXPECT_EQ(column(cells, "accel_scale_y")[0], "0.98");
  EXPECT_EQ(column(cells, "accel_offset_z_g")[1], "");
  EXPECT_EQ(column(cells, "accel_scale_z")[1], "");
  EXPECT_DOUBLE_EQ(std::stod(column(readFile(in("out/links.csv")), "sigma_deg")[0]), toDegrees(0.02));

  const std::string covariances = readFile(in("out/covariances.csv"));
  EXPECT_THAT(column(covariances, "cell"), ElementsAre("3", "7", "12", "20"));
  EXPECT_EQ(split(split(covariances, '\n').front(), ',').size(), 3U + 21U);
  EXPECT_EQ(column(covariances, "cov_y_y_m2")[0], "4e-06");
  EXPECT_EQ(column(covariances, "cov_y_ry_m_rad")[0], "-2e-05");
  EXPECT_EQ(column(covariances, "cov_rz_rz_rad2")[0], "0.09");
  EXPECT_EQ(column(covariances, "cov_x_x_m2")[2], "") << "not known";
}

TEST_F(ExportCsv, HoldsTheUpDirectionOfEveryPatch) {
  exportReconstruction(makeTestReconstruction(), ExportFormat::Csv, in("out"));
  const auto rows = rowsByPython(in("out/poses.csv"));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0][7], "patch0_up_x");
  EXPECT_THAT(rows[2], ElementsAre("2", "", "1", "3", "0.0015", formatExact(toDegrees(0.6435011087932844)),
                                   formatExact(toDegrees(0.02)), "0.6", "0", "0.8", formatExact(toDegrees(0.02)), "",
                                   "", "", ""));
}

TEST_F(ExportCsv, EmptyReconstructionGivesHeadersOnly) {
  const auto paths = exportReconstruction(test::ResultBuilder().build(), ExportFormat::Csv, in("out"));
  ASSERT_FALSE(paths.empty());
  for (const auto& path : paths) {
    if (path.extension() != ".csv") continue;  // the manifest
    const std::string text = readFile(path);
    EXPECT_EQ(std::ranges::count(text, '\n'), 1) << path;
  }
}

TEST_F(ExportCsv, ANumberThatIsNotFiniteIsNamedAndLeavesNoFolder) {
  Reconstruction reconstruction = makeTestReconstruction();
  reconstruction.patches[0].links[0].sigma_rad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(messageOf<InvalidArgument>([&] { exportReconstruction(reconstruction, ExportFormat::Csv, in("new")); }),
              HasSubstr("links.csv: row 1, sigma_deg is not a finite number"));
  EXPECT_THAT(names(), ::testing::IsEmpty());
}

}  // namespace
}  // namespace hexoderm
