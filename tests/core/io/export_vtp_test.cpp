#include "hexoderm/io/export_vtp.h"

#include "hexoderm/io/exporter.h"
#include "hexoderm/util/error.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <pugixml.hpp>

namespace hexoderm {
namespace {

using ::testing::ElementsAre;
using ExportVtp = ExportTest;

/// The bytes of an array, decoded without OpenSSL, less the length in front, which must be right.
std::string decode(pugi::xml_node array) {
  static const std::string kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  EXPECT_STREQ(array.attribute("format").value(), "binary");
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : std::string(array.text().get())) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<std::uint32_t>(kAlphabet.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
  }
  std::uint64_t length = 0;
  EXPECT_GE(bytes.size(), sizeof length);
  std::memcpy(&length, bytes.data(), sizeof length);
  EXPECT_EQ(length, bytes.size() - sizeof length);
  return bytes.substr(sizeof length);
}

template <class T>
std::vector<T> values(pugi::xml_node section, const char* name) {
  const std::string bytes = decode(section.find_child_by_attribute("Name", name));
  std::vector<T> result(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

std::vector<std::string> strings(pugi::xml_node section, const char* name) {
  const std::string bytes = decode(section.find_child_by_attribute("Name", name));
  std::vector<std::string> result;
  for (std::size_t at = 0; at < bytes.size(); at += result.back().size() + 1) result.emplace_back(bytes.c_str() + at);
  return result;
}

class ExportVtpFile : public ExportTest {
 protected:
  void SetUp() override {
    ExportTest::SetUp();
    exportAllPatches();
    ASSERT_TRUE(document_.load_file(in("skin.vtp").c_str()));
    piece_ = document_.child("VTKFile").child("PolyData").child("Piece");
    cell_data_ = piece_.child("CellData");
  }

  void exportAllPatches() {
    ExportOptions options;
    options.all_patches = true;
    exportReconstruction(reconstruction_, ExportFormat::Vtp, in("skin.vtp"), options);
  }

  Reconstruction reconstruction_ = makeTestReconstruction();
  pugi::xml_document document_;
  pugi::xml_node piece_;
  pugi::xml_node cell_data_;
};

TEST_F(ExportVtpFile, HoldsSensorsAsVerticesAndPrismsAsPolygons) {
  EXPECT_EQ(piece_.attribute("NumberOfPoints").as_uint(), 4U * 12U + 4U);
  EXPECT_EQ(piece_.attribute("NumberOfVerts").as_uint(), 4U);
  EXPECT_EQ(piece_.attribute("NumberOfPolys").as_uint(), 4U * 8U);
  EXPECT_THAT(values<std::int64_t>(piece_.child("Verts"), "connectivity"), ElementsAre(48, 49, 50, 51));
  const auto offsets = values<std::int64_t>(piece_.child("Polys"), "offsets");
  ASSERT_EQ(offsets.size(), 32U);
  EXPECT_EQ(offsets[0], 6);
  EXPECT_EQ(offsets[31], 4 * (2 * 6 + 6 * 4));
  const auto points = values<double>(piece_.child("Points"), "Points");
  const Eigen::Vector3d corner = reconstruction_.patches[0].cells[0].T_o_u * Eigen::Vector3d(0.01502, 0, 0);
  EXPECT_EQ(Eigen::Vector3d(points[0], points[1], points[2]), corner);
  const Eigen::Vector3d& sensor = reconstruction_.patches[0].cells[2].sensors[0].T_o_s.t;
  EXPECT_EQ(Eigen::Vector3d(points[153], points[154], points[155]), sensor);
}

TEST_F(ExportVtpFile, EveryCellArrayHasAValueForEveryVertexAndPolygon) {
  std::size_t arrays = 0;
  for (const pugi::xml_node array : cell_data_.children()) {
    const std::size_t components = array.attribute("NumberOfComponents").as_uint(1);
    const bool is_string = std::string(array.attribute("type").value()) == "String";
    const std::size_t count =
        is_string ? strings(cell_data_, array.attribute("Name").value()).size() : decode(array).size() / 8 / components;
    EXPECT_EQ(count, 36U) << array.attribute("Name").value();
    ++arrays;
  }
  EXPECT_EQ(arrays, 12U);
}

TEST_F(ExportVtpFile, HoldsWhatIsKnownOfEachCell) {
  const auto ids = values<std::int64_t>(cell_data_, "cell_id");
  EXPECT_THAT((std::vector<std::int64_t>{ids[0], ids[1], ids[3], ids[4], ids[12], ids[20], ids[28]}),
              ElementsAre(3, 7, 12, 3, 7, 12, 20));
  const auto quality = values<std::int64_t>(cell_data_, "quality");
  EXPECT_THAT((std::vector<std::int64_t>{quality[4], quality[12], quality[20], quality[28]}), ElementsAre(2, 2, 3, -1));
  EXPECT_EQ(values<std::int64_t>(cell_data_, "patch")[28], 1);
  EXPECT_EQ(values<std::int64_t>(cell_data_, "patch_origin")[20], 7);
  EXPECT_EQ(values<std::int64_t>(cell_data_, "placed_by")[20], 1);
  EXPECT_EQ(values<double>(cell_data_, "position_m")[3 * 20], 0.0123456789012345);
  const auto q = values<double>(cell_data_, "orientation_wxyz");
  const Eigen::Quaterniond orientation(q[4 * 20], q[4 * 20 + 1], q[4 * 20 + 2], q[4 * 20 + 3]);
  EXPECT_LT((orientation.toRotationMatrix() - reconstruction_.patches[0].cells[2].T_o_u.R).norm(), 1e-14);
  EXPECT_EQ(values<double>(cell_data_, "sigma_position_m")[3 * 4], 0.001);
  EXPECT_TRUE(std::isnan(values<double>(cell_data_, "sigma_position_m")[3 * 20]));
  EXPECT_EQ(strings(cell_data_, "body_part")[20], kAwkwardText);
  EXPECT_EQ(strings(cell_data_, "sensor")[1], "force \"1\"/größe");
  EXPECT_EQ(strings(cell_data_, "sensor_type")[1], "force, normal");
  EXPECT_EQ(strings(cell_data_, "sensor")[12], "");
}

TEST_F(ExportVtpFile, HoldsTheCovarianceOfEachCell) {
  const pugi::xml_node field_data = document_.child("VTKFile").child("PolyData").child("FieldData");
  EXPECT_THAT(values<std::int64_t>(field_data, "cells"), ElementsAre(3, 7, 12, 20));
  EXPECT_EQ(field_data.find_child_by_attribute("Name", "cov_t_r").attribute("NumberOfComponents").as_uint(), 21U);
  const auto covariances = values<double>(field_data, "cov_t_r");
  ASSERT_EQ(covariances.size(), 4U * 21U);
  EXPECT_EQ(covariances[0], 1e-6);
  EXPECT_EQ(covariances[1], 0);
  EXPECT_EQ(covariances[20], 1e-6);
  EXPECT_EQ(covariances[21], 0);
  EXPECT_TRUE(std::isnan(covariances[42]));
}

TEST_F(ExportVtpFile, HoldsTheErrorsOfEachCellsSensor) {
  reconstruction_.patches[0].cells[1].accel_offset_g = {0.06, -0.01, 0.02};
  reconstruction_.patches[0].cells[1].accel_scale = {1.02, 0.98, 1};
  exportAllPatches();
  ASSERT_TRUE(document_.load_file(in("skin.vtp").c_str()));
  const pugi::xml_node field_data = document_.child("VTKFile").child("PolyData").child("FieldData");
  const auto offsets = values<double>(field_data, "accel_offset_g");
  const auto scales = values<double>(field_data, "accel_scale");
  ASSERT_EQ(offsets.size(), 4U * 3U);
  ASSERT_EQ(scales.size(), 4U * 3U);
  EXPECT_EQ(offsets[4], -0.01);
  EXPECT_EQ(scales[3], 1.02);
  EXPECT_TRUE(std::isnan(offsets[0])) << "not known";
  EXPECT_TRUE(std::isnan(scales[11]));
}

TEST_F(ExportVtpFile, SaysUnitsAndFrames) {
  const pugi::xml_node field_data = document_.child("VTKFile").child("PolyData").child("FieldData");
  EXPECT_THAT(strings(field_data, "units"), ElementsAre("positions in metres, rotations in radians"));
  EXPECT_THAT(strings(field_data, "frame"), ElementsAre("each patch in the frame of its origin cell"));
  EXPECT_THAT(strings(field_data, "source_file"), ElementsAre("hand \"made\".session.json"));
  EXPECT_THAT(strings(field_data, "verdict"), ElementsAre("usable"));
}

TEST_F(ExportVtp, HoldsTheLargestPatchAloneUnlessAskedForAll) {
  exportReconstruction(makeTestReconstruction(), ExportFormat::Vtp, in("skin.vtp"));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file(in("skin.vtp").c_str()));
  const pugi::xml_node data = document.child("VTKFile").child("PolyData");
  EXPECT_THAT(values<std::int64_t>(data.child("FieldData"), "cells"), ElementsAre(3, 7, 12));
  EXPECT_THAT(values<std::int64_t>(data.child("Piece").child("CellData"), "patch_origin"), ::testing::Each(7));
  EXPECT_THAT(strings(data.child("FieldData"), "frame"),
              ElementsAre("in the frame of cell 7, the origin of the patch"));
}

TEST_F(ExportVtp, EmptyReconstructionGivesAnEmptyMesh) {
  exportReconstruction(test::ResultBuilder().build(), ExportFormat::Vtp, in("empty.vtp"));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file(in("empty.vtp").c_str()));
  const pugi::xml_node piece = document.child("VTKFile").child("PolyData").child("Piece");
  EXPECT_STREQ(piece.attribute("NumberOfPoints").value(), "0");
  EXPECT_TRUE(values<double>(piece.child("Points"), "Points").empty());
}

}  // namespace
}  // namespace hexoderm
