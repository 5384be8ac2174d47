// Meshes as Assimp reads them: the same points, and the same area and volume.

#include "hexoderm/io/exporter.h"
#include "tests/core/robots/mesh_test.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>

namespace hexoderm {
namespace {

using test::TemporaryFolder;

void appendNode(const aiScene& scene, const aiNode& node, const aiMatrix4x4& T_file_parent, TriangleMesh& result) {
  const aiMatrix4x4 T_file_node = T_file_parent * node.mTransformation;
  for (unsigned k = 0; k < node.mNumMeshes; ++k) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[k]];
    const auto first = static_cast<std::uint32_t>(result.points.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D point = T_file_node * mesh.mVertices[v];
      result.points.emplace_back(point.x, point.y, point.z);
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;
      result.triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    }
  }
  for (unsigned k = 0; k < node.mNumChildren; ++k) appendNode(scene, *node.mChildren[k], T_file_node, result);
}

TriangleMesh byAssimp(const std::filesystem::path& file) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  TriangleMesh result;
  EXPECT_NE(scene, nullptr) << importer.GetErrorString();
  if (scene != nullptr) appendNode(*scene, *scene->mRootNode, {}, result);
  return result;
}

/// Each point of one is near one of the other. Assimp computes with single precision.
void expectPointsAmong(const TriangleMesh& some, TriangleMesh others, double tolerance, const std::string& file) {
  const auto xOf = [](const Eigen::Vector3d& point) { return point.x(); };
  std::ranges::sort(others.points, {}, xOf);
  for (const Eigen::Vector3d& point : some.points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (auto other = std::ranges::lower_bound(others.points, point.x() - tolerance, {}, xOf);
         other != others.points.end() && other->x() <= point.x() + tolerance; ++other) {
      nearest = std::min(nearest, (*other - point).norm());
    }
    ASSERT_LE(nearest, tolerance) << file << ": " << point.transpose();
  }
}

void expectSameAsByAssimp(const std::filesystem::path& file) {
  const TriangleMesh mesh = readMeshFile(file);
  const TriangleMesh meant = byAssimp(file);
  const double size = boundingBox(meant).size().norm();
  constexpr double kSingle = 1e-6;
  EXPECT_EQ(mesh.triangles.size(), meant.triangles.size()) << file;
  EXPECT_NEAR(areaOf(mesh), areaOf(meant), 10 * kSingle * areaOf(meant)) << file;
  EXPECT_NEAR(enclosedVolume(mesh), enclosedVolume(meant), 10 * kSingle * size * size * size) << file;
  expectPointsAmong(mesh, meant, kSingle * size, file.string());
  expectPointsAmong(meant, mesh, kSingle * size, file.string());
  std::set<std::array<double, 3>> points;
  for (const Eigen::Vector3d& point : mesh.points) {
    EXPECT_TRUE(points.insert({point.x(), point.y(), point.z()}).second) << file << ": joined";
  }
}

TEST(MeshByAssimp, TheDemoRobotsMeshesAreTheSame) {
  const std::filesystem::path folder = std::filesystem::path(HEXODERM_DEMO_ROBOT).parent_path() / "meshes";
  for (const char* name : {"forearm.obj", "upper_arm.obj"}) expectSameAsByAssimp(folder / name);
}

TEST(MeshByAssimp, WhatIsExportedIsTheSame) {
  const TemporaryFolder folder;
  Reconstruction skin = makeTestReconstruction();
  skin.patches.resize(1);
  for (const auto& [format, name] :
       {std::pair(ExportFormat::Ply, "skin.ply"), std::pair(ExportFormat::Stl, "skin.stl"),
        std::pair(ExportFormat::Obj, "skin.obj"), std::pair(ExportFormat::Gltf, "skin.glb")}) {
    exportReconstruction(skin, format, folder.path() / name);
    expectSameAsByAssimp(folder.path() / name);
  }
}

/// What Assimp writes of the demo robot's forearm, in every format that it writes and we read.
TEST(MeshByAssimp, WhatAssimpWritesIsTheSame) {
  const TemporaryFolder folder;
  const std::filesystem::path forearm = std::filesystem::path(HEXODERM_DEMO_ROBOT).parent_path() / "meshes/forearm.obj";
  const std::pair<std::string, std::string> formats[] = {{"stl", "stl"},    {"stlb", "stl"}, {"obj", "obj"},
                                                         {"ply", "ply"},    {"plyb", "ply"}, {"collada", "dae"},
                                                         {"gltf2", "gltf"}, {"glb2", "glb"}};
  for (const auto& [id, extension] : formats) {
    const std::filesystem::path file = folder.path() / (id + "." + extension);
    Assimp::Importer importer;
    Assimp::Exporter exporter;
    const aiScene* scene = importer.ReadFile(forearm.string(), 0);
    ASSERT_NE(scene, nullptr);
    ASSERT_EQ(exporter.Export(scene, id, file.string()), aiReturn_SUCCESS) << exporter.GetErrorString();
    expectSameAsByAssimp(file);
  }
}

/// The valid ones among the fuzz target's inputs, which use more of each format.
TEST(MeshByAssimp, TheMeshesOfTheCorpusAreTheSame) {
  const std::filesystem::path corpus = HEXODERM_TEST_DATA "/../fuzz/corpus/mesh";
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(corpus)) {
    if (!entry.path().filename().string().starts_with("seed_")) continue;
    expectSameAsByAssimp(entry.path());
    ++count;
  }
  EXPECT_GE(count, 8U);
}

}  // namespace
}  // namespace hexoderm
