// OBJ and glTF, as Assimp's own program reads them.

#include "hexoderm/io/exporter.h"
#include "hexoderm/reconstruction/figures/patch_mesh.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/other_programs.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace hexoderm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class ExportScenes : public ExportTest {
 protected:
  /// What Assimp's program makes of a file: the corners of its triangles, as an OBJ says them.
  std::vector<Eigen::Vector3d> pointsByAssimp(const std::string& name) {
    const auto outcome =
        test::runProgram("assimp export " + in(name).string() + " " + in("again.stl").string() + " -fstl -ptv -tri");
    if (!outcome) return {};
    EXPECT_EQ(outcome->exit_code, 0) << outcome->out;
    std::istringstream file(read(in("again.stl")));
    std::vector<Eigen::Vector3d> points;
    for (std::string word; file >> word;) {
      if (word != "vertex") continue;
      Eigen::Vector3d& point = points.emplace_back();
      file >> point.x() >> point.y() >> point.z();
    }
    return points;
  }
  /// Both hold the same points, each as often as it may be there.
  static void expectSamePoints(const std::vector<Eigen::Vector3d>& found, const std::vector<Eigen::Vector3d>& meant) {
    const auto nearIn = [](const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& point) {
      return std::ranges::any_of(points, [&](const Eigen::Vector3d& other) { return (other - point).norm() < 1e-6; });
    };
    for (const Eigen::Vector3d& point : found) EXPECT_TRUE(nearIn(meant, point)) << point.transpose();
    for (const Eigen::Vector3d& point : meant) EXPECT_TRUE(nearIn(found, point)) << point.transpose();
  }
  /// What the triangles enclose; right only if they are the prisms' faces, wound outwards.
  static void expectPrisms(const std::vector<Eigen::Vector3d>& corners, std::size_t prisms) {
    double volume_m3 = 0;
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
      volume_m3 += corners[k].dot(corners[k + 1].cross(corners[k + 2])) / 6;
    }
    const CellModel model = builtInCellModel("hex-bma150");
    const double meant_m3 =
        static_cast<double>(prisms) * 1.5 * std::sqrt(3.0) * model.side_m * model.side_m * model.thickness_m;
    EXPECT_NEAR(volume_m3, meant_m3, 1e-3 * meant_m3);
  }
  static Reconstruction onePatch() {
    Reconstruction one = makeTestReconstruction();
    one.patches.resize(1);
    return one;
  }
};

TEST_F(ExportScenes, ObjHoldsThePrismsForAssimp) {
  exportReconstruction(makeTestReconstruction(), ExportFormat::Obj, in("skin.obj"));
  EXPECT_THAT(read(in("skin.obj")), AllOf(HasSubstr("# metres, in the frame of cell 7"), HasSubstr("o cell_12\n")));
  const auto info = test::runProgram("assimp info " + in("skin.obj").string());
  ASSERT_TRUE(info) << "there is no assimp: packaging/setup.sh --tests installs it";
  EXPECT_EQ(info->exit_code, 0) << info->out;
  EXPECT_THAT(info->out, AllOf(HasSubstr("Meshes:             3"), HasSubstr("cell_12")));
  const std::vector<Eigen::Vector3d> found = pointsByAssimp("skin.obj");
  expectSamePoints(found, makePatchMesh(onePatch()).points);
  expectPrisms(found, 3);
}

TEST_F(ExportScenes, ObjNamesEveryCellAtItsPlace) {
  std::istringstream file(exportBytes(makeTestReconstruction(), ExportFormat::Obj, {}, "skin.obj"));
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

TEST_F(ExportScenes, GltfHoldsThePrismsUprightForAssimp) {
  exportReconstruction(makeTestReconstruction(), ExportFormat::Gltf, in("skin.glb"));
  const auto info = test::runProgram("assimp info " + in("skin.glb").string());
  ASSERT_TRUE(info) << "there is no assimp: packaging/setup.sh --tests installs it";
  EXPECT_EQ(info->exit_code, 0) << info->out;
  EXPECT_THAT(info->out, HasSubstr("cell_12"));
  std::vector<Eigen::Vector3d> meant;
  // z of the skin is +Y of glTF, y is -Z.
  for (const Eigen::Vector3d& p : makePatchMesh(onePatch()).points) meant.emplace_back(p.x(), p.z(), -p.y());
  const std::vector<Eigen::Vector3d> found = pointsByAssimp("skin.glb");
  expectSamePoints(found, meant);
  expectPrisms(found, 3);
}

TEST_F(ExportScenes, GltfIsWellFormed) {
  const std::string bytes = exportBytes(makeTestReconstruction(), ExportFormat::Gltf, {}, "skin.glb");
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof(value));
    return value;
  };
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(4), 2U);
  EXPECT_EQ(word(8), bytes.size());
  EXPECT_EQ(word(12) % 4, 0U);
  const auto json = nlohmann::json::parse(bytes.substr(20, word(12)));
  const std::size_t binary = 20 + word(12);
  EXPECT_EQ(bytes.substr(binary + 4, 3), "BIN");
  EXPECT_EQ(json.at("buffers").at(0).at("byteLength"), word(binary));
  EXPECT_EQ(binary + 8 + word(binary), bytes.size());
  EXPECT_EQ(json.at("nodes").at(0).at("extras").at("frame"), "in the frame of cell 7, the origin of the patch");
  // Each node is the child of one, but for the root.
  std::vector<int> parents(json.at("nodes").size());
  for (const auto& node : json.at("nodes")) {
    if (!node.contains("children")) continue;
    for (const auto& child : node.at("children")) ++parents.at(child.get<std::size_t>());
  }
  EXPECT_EQ(parents.front(), 0);
  EXPECT_TRUE(std::all_of(parents.begin() + 1, parents.end(), [](int count) { return count == 1; }));
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

TEST_F(ExportScenes, GltfHasANodeAtEveryCellAndSensor) {
  const Reconstruction one = onePatch();
  const std::string bytes = exportBytes(one, ExportFormat::Gltf, {}, "skin.glb");
  constexpr std::size_t kBegin = 20;  // behind the header and that of the first chunk
  const auto json = nlohmann::json::parse(bytes.substr(kBegin, bytes.find(std::string("BIN\0", 4)) - 4 - kBegin));
  std::map<std::string, SE3> places;
  placeNodes(json.at("nodes"), 0, {}, places);
  SE3 T_scene_skin;
  T_scene_skin.R << 1, 0, 0, 0, 0, 1, 0, -1, 0;  // z of the skin is +Y of glTF, y is -Z
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
}

}  // namespace
}  // namespace hexoderm
