// OBJ and glTF, as Assimp's own program reads them.

#include "hexoderm/io/export_gltf.h"
#include "hexoderm/io/export_obj.h"
#include "hexoderm/reconstruction/figures/patch_mesh.h"
#include "hexoderm/util/error.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/other_programs.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
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
  expectSamePoints(pointsByAssimp("skin.obj"), makePatchMesh(onePatch()).points);
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
  expectSamePoints(pointsByAssimp("skin.glb"), meant);
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

TEST_F(ExportScenes, ATamperedFileIsDetected) {
  const Reconstruction one = onePatch();
  const ObjMesh obj = objMesh(one);
  const std::string text = objText(obj);
  EXPECT_NO_THROW(verifyObj(text, obj, "f"));
  for (const std::string& bytes : {replaced(text, "o cell_12", "o cell_13"), replaced(text, "v 0.0", "v 0.1"),
                                   replaced(text, "f 1 2", "f 2 1"), text.substr(0, text.size() / 2), std::string()}) {
    EXPECT_THROW(verifyObj(bytes, obj, "f"), FormatError) << bytes;
  }
  const std::string gltf = gltfBytes(one, "frame");
  EXPECT_NO_THROW(verifyGltf(gltf, one, "f"));
  EXPECT_THROW(verifyGltf(replaced(gltf, "\"cell_12\"", "\"cell_13\""), one, "f"), FormatError);
  EXPECT_THROW(verifyGltf(gltf.substr(0, gltf.size() / 2), one, "f"), FormatError);
  Reconstruction moved = one;
  moved.patches[0].cells[2].T_o_u.t.x() += 1e-4;
  EXPECT_THROW(verifyGltf(gltf, moved, "f"), FormatError);
}

}  // namespace
}  // namespace hexoderm
