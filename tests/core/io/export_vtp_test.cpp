// What a VTK file is to hold; that VTK reads just that is in vtp_reader_test.cpp.

#include "hexoderm/io/export_formats.h"

#include "hexoderm/io/exporter.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/testing.h"

#include <variant>

namespace hexoderm {
namespace {

/// The values of an array; no values if there is none of its name.
template <class T>
std::vector<T> values(const std::vector<VtpArray>& arrays, const std::string& name) {
  const auto found = std::ranges::find(arrays, name, &VtpArray::name);
  EXPECT_NE(found, arrays.end()) << name;
  return found == arrays.end() ? std::vector<T>() : std::get<std::vector<T>>(found->values);
}

const std::vector<VtpArray>& section(const VtpData& data, const std::string& name) {
  return std::ranges::find(data.sections, name, &VtpSection::name)->arrays;
}

std::vector<std::string> strings(const std::vector<VtpArray>& arrays, const std::string& name) {
  return values<std::string>(arrays, name);
}

class ExportVtp : public ::testing::Test {
 protected:
  [[nodiscard]] const std::vector<VtpArray>& cellData() const { return section(data_, "CellData"); }

  Reconstruction reconstruction_ = makeTestReconstruction();
  VtpData data_ = vtpData(reconstruction_);
};

TEST_F(ExportVtp, HoldsSensorsAsVerticesAndPrismsAsPolygons) {
  EXPECT_EQ(data_.points, 4U * 12U + 4U);
  EXPECT_EQ(data_.verts, 4U);
  EXPECT_EQ(data_.polys, 4U * 8U);
  EXPECT_THAT(values<std::int64_t>(section(data_, "Verts"), "connectivity"), ElementsAre(48, 49, 50, 51));
  const auto offsets = values<std::int64_t>(section(data_, "Polys"), "offsets");
  ASSERT_EQ(offsets.size(), 32U);
  EXPECT_EQ(offsets[0], 6);
  EXPECT_EQ(offsets[31], 4 * (2 * 6 + 6 * 4));
  const auto points = values<double>(section(data_, "Points"), "Points");
  const Eigen::Vector3d corner = reconstruction_.patches[0].cells[0].T_o_u * Eigen::Vector3d(0.01502, 0, 0);
  EXPECT_EQ(Eigen::Vector3d(points[0], points[1], points[2]), corner);
  const Eigen::Vector3d& sensor = reconstruction_.patches[0].cells[2].sensors[0].T_o_s.t;
  EXPECT_EQ(Eigen::Vector3d(points[153], points[154], points[155]), sensor);
}

TEST_F(ExportVtp, HoldsWhatIsKnownOfEachCell) {
  const auto ids = values<std::int64_t>(cellData(), "cell_id");
  EXPECT_THAT((std::vector<std::int64_t>{ids[0], ids[1], ids[3], ids[4], ids[12], ids[20], ids[28]}),
              ElementsAre(3, 7, 12, 3, 7, 12, 20));
  const auto quality = values<std::int64_t>(cellData(), "quality");
  EXPECT_THAT((std::vector<std::int64_t>{quality[4], quality[12], quality[20], quality[28]}), ElementsAre(2, 2, 3, -1));
  EXPECT_EQ(values<std::int64_t>(cellData(), "patch")[28], 1);
  EXPECT_EQ(values<std::int64_t>(cellData(), "patch_origin")[20], 7);
  EXPECT_EQ(values<std::int64_t>(cellData(), "placed_by")[20], 1);
  EXPECT_EQ(values<double>(cellData(), "position_m")[3 * 20], 0.0123456789012345);
  const auto q = values<double>(cellData(), "orientation_wxyz");
  const Eigen::Quaterniond orientation(q[4 * 20], q[4 * 20 + 1], q[4 * 20 + 2], q[4 * 20 + 3]);
  EXPECT_LT((orientation.toRotationMatrix() - reconstruction_.patches[0].cells[2].T_o_u.R).norm(), 1e-14);
  EXPECT_EQ(values<double>(cellData(), "sigma_position_m")[3 * 4], 0.001);
  EXPECT_TRUE(std::isnan(values<double>(cellData(), "sigma_position_m")[3 * 20]));
  EXPECT_EQ(strings(cellData(), "body_part")[20], kAwkwardText);
  EXPECT_EQ(strings(cellData(), "sensor")[1], "force \"1\"/größe");
  EXPECT_EQ(strings(cellData(), "sensor_type")[1], "force, normal");
  EXPECT_EQ(strings(cellData(), "sensor")[12], "");
}

TEST_F(ExportVtp, HoldsTheCovarianceOfEachCell) {
  EXPECT_THAT(values<std::int64_t>(data_.field_data, "cells"), ElementsAre(3, 7, 12, 20));
  const auto covariances = values<double>(data_.field_data, "cov_t_r");
  ASSERT_EQ(covariances.size(), 4U * 21U);
  EXPECT_EQ(covariances[0], 1e-6);
  EXPECT_EQ(covariances[1], 0);
  EXPECT_EQ(covariances[20], 1e-6);
  EXPECT_EQ(covariances[21], 0);
  EXPECT_TRUE(std::isnan(covariances[42]));
}

TEST_F(ExportVtp, HoldsTheErrorsOfEachCellsSensor) {
  reconstruction_.patches[0].cells[1].accel_offset_g = {0.06, -0.01, 0.02};
  reconstruction_.patches[0].cells[1].accel_scale = {1.02, 0.98, 1};
  const VtpData data = vtpData(reconstruction_);
  const auto offsets = values<double>(data.field_data, "accel_offset_g");
  const auto scales = values<double>(data.field_data, "accel_scale");
  ASSERT_EQ(offsets.size(), 4U * 3U);
  ASSERT_EQ(scales.size(), 4U * 3U);
  EXPECT_EQ(offsets[4], -0.01);
  EXPECT_EQ(scales[3], 1.02);
  EXPECT_TRUE(std::isnan(offsets[0])) << "not known";
  EXPECT_TRUE(std::isnan(scales[11]));
}

TEST_F(ExportVtp, SaysUnitsAndFrames) {
  EXPECT_THAT(strings(data_.field_data, "units"), ElementsAre("positions in metres, rotations in radians"));
  EXPECT_THAT(strings(data_.field_data, "frame"), ElementsAre("each patch in the frame of its origin cell"));
  EXPECT_THAT(strings(data_.field_data, "source_file"), ElementsAre("hand \"made\".session.json"));
  EXPECT_THAT(strings(data_.field_data, "verdict"), ElementsAre("usable"));
  const ExportSelection largest = selectForExport(reconstruction_, exportFormatDescription(ExportFormat::Vtp), {});
  EXPECT_THAT(strings(vtpData(exportedPart(reconstruction_, largest, {}), largest).field_data, "frame"),
              ElementsAre("in the frame of cell 7, the origin of the patch"));
}

TEST_F(ExportVtp, EmptyReconstructionGivesAnEmptyMesh) {
  const Reconstruction empty = test::ResultBuilder().build();
  EXPECT_EQ(vtpData(empty).points, 0U);
  EXPECT_NO_THROW(exportBytes(empty, ExportFormat::Vtp, {}));
}

}  // namespace
}  // namespace hexoderm
