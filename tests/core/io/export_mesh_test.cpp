// PLY, STL, OBJ and glTF: what we read of them, as Assimp does (robots/second_opinion_test.cpp), and what a reader of
// meshes passes over: colours, normals, names and nodes.

#include "hexoderm/io/exporter.h"
#include "hexoderm/robots/mesh_file.h"
#include "hexoderm/solve/metrics/patch_mesh.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/options.h"
#include "tests/support/testing.h"

#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

namespace hexoderm {
namespace {

Reconstruction onePatch() {
  Reconstruction one = makeTestReconstruction();
  one.patches.resize(1);
  return one;
}

/// z of the skin is +Y of glTF, y is -Z.
Eigen::Matrix3d sceneFromSkin() {
  Eigen::Matrix3d R;
  R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return R;
}

TEST(ExportMesh, HoldsClosedPrismsAtTheirPlaces) {
  struct MeshFile {
    ExportFormat format;
    const char* file;
    LengthUnit stl_unit = LengthUnit::Millimetres;
    double unit = 1;
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  };
  for (const MeshFile& expected : {MeshFile{ExportFormat::Ply, "skin.ply"}, MeshFile{ExportFormat::Obj, "skin.obj"},
                                   MeshFile{ExportFormat::Stl, "skin.stl", LengthUnit::Millimetres, 1e3},
                                   MeshFile{ExportFormat::Stl, "skin.stl", LengthUnit::Metres},
                                   MeshFile{ExportFormat::Gltf, "skin.glb", {}, 1, sceneFromSkin()}}) {
    const std::string bytes =
        exportBytes(makeTestReconstruction(), expected.format, test::with(&ExportOptions::stl_unit, expected.stl_unit));
    const TriangleMesh mesh = readMesh(bytes, expected.file);
    EXPECT_EQ(mesh.triangles.size(), 3U * (4 + 4 + 12)) << expected.file;
    EXPECT_EQ(mesh.points.size(), 3U * 12U) << expected.file;
    for (const Eigen::Vector3d& point : makePatchMesh(onePatch()).points) {
      const Eigen::Vector3d meant = expected.unit * expected.R * point;
      EXPECT_TRUE(std::ranges::any_of(
          mesh.points, [&](const Eigen::Vector3d& found) { return (found - meant).norm() < 1e-8 * expected.unit; }))
          << expected.file << ": " << meant.transpose();
    }
    // Right only if the faces are closed and wound outwards.
    const double meant_m3 = 3 * 1.5 * std::sqrt(3.0) * 0.01502 * 0.01502 * 0.0034;
    EXPECT_NEAR(enclosedVolume(mesh) / std::pow(expected.unit, 3), meant_m3, 1e-6 * meant_m3) << expected.file;
  }
}

TEST(ExportStl, NormalsAreThoseOfTheFacets) {
  const std::string bytes = exportBytes(makeTestReconstruction(), ExportFormat::Stl, {});
  for (std::size_t at = 84; at < bytes.size(); at += 50) {
    Eigen::Matrix<float, 3, 4> facet;  // the normal and the corners
    std::memcpy(facet.data(), bytes.data() + at, sizeof(float) * 12);
    const Eigen::Vector3f wound = (facet.col(2) - facet.col(1)).cross(facet.col(3) - facet.col(1)).normalized();
    EXPECT_LT((facet.col(0) - wound).norm(), 1e-4F) << at;
  }
}

/// Of the vertices of an ASCII PLY, 0xRRGGBB.
std::vector<std::uint32_t> colorsOf(const std::string& ply) {
  EXPECT_THAT(ply, HasSubstr("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"));
  std::vector<std::uint32_t> colors(std::stoul(ply.substr(ply.find("element vertex ") + 15)));
  std::istringstream rows(ply.substr(ply.find("end_header\n") + 11));
  for (std::uint32_t& color : colors) {
    double x = 0, y = 0, z = 0;
    std::uint32_t red = 0, green = 0, blue = 0, alpha = 0;
    rows >> x >> y >> z >> red >> green >> blue >> alpha;
    EXPECT_EQ(alpha, 255U);
    color = red << 16U | green << 8U | blue;
  }
  EXPECT_TRUE(rows);
  return colors;
}

TEST(ExportPly, ColoursCellsByTheirWorstUsedLink) {
  std::vector<std::uint32_t> of_cells;
  for (const std::uint32_t of_patch : {7U, 20U}) {
    const auto colors = colorsOf(
        exportBytes(makeTestReconstruction(), ExportFormat::Ply, test::with(&ExportOptions::patch, CellId(of_patch))));
    for (std::size_t k = 0; k < colors.size(); ++k) {
      if (k % 12 == 0) of_cells.push_back(colors[k]);
      EXPECT_EQ(colors[k], of_cells.back());
    }
  }
  // Cell 7 has links of both classes; the muted links of 7, 12 and 20 don't count.
  EXPECT_THAT(of_cells, ElementsAre(0x17A1CA, 0x17A1CA, 0x3A1FB0, 0x8A939E));
}

TEST(ExportObj, NamesEveryCellAtItsPlace) {
  const std::string text = exportBytes(makeTestReconstruction(), ExportFormat::Obj, {});
  EXPECT_THAT(text, HasSubstr("# metres, in the frame of cell 7"));
  std::istringstream file(text);
  std::map<std::string, std::vector<Eigen::Vector3d>> corners;
  std::string object;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "o") words >> object;
    if (kind != "v") continue;
    Eigen::Vector3d& corner = corners[object].emplace_back();
    words >> corner.x() >> corner.y() >> corner.z();
  }
  EXPECT_EQ(corners.size(), 3U);
  const Reconstruction one = onePatch();
  for (const CellPlacement& cell : one.patches[0].cells) {
    const std::vector<Eigen::Vector3d>& found = corners["cell_" + toString(cell.cell)];
    ASSERT_EQ(found.size(), 12U) << cell.cell;
    EXPECT_LT((found[0] - cell.T_o_u * Eigen::Vector3d(0.01502, 0, 0)).norm(), 1e-12) << cell.cell;
  }
}

/// Puts the place of a node and of those below it, by their names.
void placeNodes(const nlohmann::json& nodes, std::size_t index, const SE3& T_scene_parent,
                std::map<std::string, SE3>& places) {
  const auto& node = nodes.at(index);
  const auto t = node.value("translation", std::array<double, 3>{});
  const auto q = node.value("rotation", std::array<double, 4>{0, 0, 0, 1});
  const SE3 T = T_scene_parent *
                SE3{Eigen::Quaterniond(q[3], q[0], q[1], q[2]).toRotationMatrix(), Eigen::Vector3d(t[0], t[1], t[2])};
  EXPECT_TRUE(places.emplace(node.at("name").get<std::string>(), T).second) << node.at("name");
  for (const auto& child : node.value("children", std::vector<std::size_t>())) placeNodes(nodes, child, T, places);
}

TEST(ExportGltf, HasANodeAtEveryCellAndSensor) {
  const Reconstruction one = onePatch();
  const std::string bytes = exportBytes(one, ExportFormat::Gltf, {});
  constexpr std::size_t kBegin = 20;  // behind the header and that of the first chunk
  const auto json = nlohmann::json::parse(bytes.substr(kBegin, bytes.find(std::string("BIN\0", 4)) - 4 - kBegin));
  EXPECT_EQ(json.at("nodes").at(0).at("extras").at("frame"), "in the frame of cell 7, the origin of the patch");
  std::map<std::string, SE3> places;
  placeNodes(json.at("nodes"), 0, {}, places);
  const SE3 T_scene_skin{sceneFromSkin(), Eigen::Vector3d::Zero()};
  std::size_t count = 1;
  const auto expectAt = [&](const std::string& name, const SE3& T_o_node) {
    ASSERT_TRUE(places.contains(name)) << name;
    const SE3 T = T_scene_skin * T_o_node;
    EXPECT_LT((places.at(name).R - T.R).norm(), 1e-9) << name;
    EXPECT_LT((places.at(name).t - T.t).norm(), 1e-9) << name;
    ++count;
  };
  for (const CellPlacement& cell : one.patches[0].cells) {
    const std::string name = "cell_" + toString(cell.cell);
    expectAt(name, cell.T_o_u);
    for (std::size_t k = 0; k < cell.sensors.size(); ++k) {
      expectAt(name + "_sensor_" + std::to_string(k + 1), cell.sensors[k].T_o_s);
    }
  }
  EXPECT_EQ(places.size(), count);
  EXPECT_EQ(json.at("nodes").size(), count) << "each is the child of one, but for the root";
}

}  // namespace
}  // namespace hexoderm
