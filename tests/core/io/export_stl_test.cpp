#include "hexoderm/io/export_mesh.h"

#include "hexoderm/io/exporter.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/options.h"

#include <gmock/gmock.h>

#include <cstring>

namespace hexoderm {
namespace {

struct Triangle {
  Eigen::Vector3f normal;
  std::array<Eigen::Vector3f, 3> corners;
};

/// Reads a binary STL byte by byte, without any library.
std::vector<Triangle> readStl(const std::string& bytes) {
  std::uint32_t count = 0;
  EXPECT_GE(bytes.size(), 84U);
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  EXPECT_EQ(bytes.size(), 84U + 50U * count);
  std::vector<Triangle> triangles(count);
  for (std::size_t k = 0; k < count; ++k) {
    std::array<float, 12> numbers{};
    std::memcpy(numbers.data(), bytes.data() + 84 + 50 * k, sizeof numbers);
    triangles[k].normal = Eigen::Map<Eigen::Vector3f>(numbers.data());
    for (std::size_t c = 0; c < 3; ++c)
      triangles[k].corners.at(c) = Eigen::Map<Eigen::Vector3f>(&numbers.at(3 + 3 * c));
  }
  return triangles;
}

/// Enclosed volume; right only if the surface is closed and wound outwards.
double volume(const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) {
    sum += t.corners[0].cast<double>().dot(t.corners[1].cast<double>().cross(t.corners[2].cast<double>())) / 6;
  }
  return sum;
}

constexpr double kPrismVolume_m3 = 2.598076211353316 * 0.01502 * 0.01502 * 0.0034;

TEST(ExportStl, HoldsClosedPrismsInMillimetresByDefault) {
  const auto triangles = readStl(exportBytes(makeTestReconstruction(), ExportFormat::Stl, {}, "skin.stl"));
  ASSERT_EQ(triangles.size(), 3U * (4 + 4 + 12));
  EXPECT_NEAR(volume(triangles), 3 * kPrismVolume_m3 * 1e9, 1e-6 * kPrismVolume_m3 * 1e9 * 3);
}

TEST(ExportStl, WritesMetresIfAskedFor) {
  const Reconstruction reconstruction = makeTestReconstruction();
  const auto triangles = readStl(exportBytes(reconstruction, ExportFormat::Stl,
                                             test::with(&ExportOptions::stl_unit, LengthUnit::Metres), "skin.stl"));
  EXPECT_NEAR(volume(triangles), 3 * kPrismVolume_m3, 1e-6 * kPrismVolume_m3 * 3);
  const SE3& T = reconstruction.patches[0].cells[0].T_o_u;
  EXPECT_EQ(triangles[0].corners[0], (T * Eigen::Vector3d(0.01502, 0, 0)).cast<float>());
  Reconstruction one = reconstruction;
  one.patches.resize(1);
  const ExportMesh meant = stlMesh(one, LengthUnit::Metres);
  for (std::size_t k = 0; k < 3 * triangles.size(); ++k) {
    EXPECT_EQ(triangles[k / 3].corners.at(k % 3), meant.points[k].cast<float>()) << k;
  }
}

TEST(ExportStl, NormalsPointOutOfTheSkin) {
  const Reconstruction reconstruction = makeTestReconstruction();
  const auto triangles = readStl(exportBytes(reconstruction, ExportFormat::Stl, {}, "skin.stl"));
  const Eigen::Vector3d front = reconstruction.patches[0].cells[0].T_o_u.R.col(2);
  EXPECT_LT((triangles[0].normal.cast<double>() - front).norm(), 1e-5);
  for (const Triangle& t : triangles) {
    const Eigen::Vector3f wound = (t.corners[1] - t.corners[0]).cross(t.corners[2] - t.corners[0]).normalized();
    EXPECT_LT((t.normal - wound).norm(), 1e-4F);
  }
}

}  // namespace
}  // namespace hexoderm
