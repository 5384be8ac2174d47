#include "hexoderm/io/export_mesh.h"

#include "hexoderm/util/error.h"

#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <memory>

namespace hexoderm {
namespace {

/// Assimp's scenes own plain arrays.
std::unique_ptr<aiScene> makeScene(const ExportMesh& mesh) {
  auto scene = std::make_unique<aiScene>();
  scene->mRootNode = new aiNode("skin");
  scene->mRootNode->mNumMeshes = 1;
  scene->mRootNode->mMeshes = new unsigned[1]{0};
  scene->mNumMaterials = 1;
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene->mNumMeshes = 1;
  scene->mMeshes = new aiMesh* [1] { new aiMesh };

  aiMesh& out = *scene->mMeshes[0];
  out.mPrimitiveTypes = aiPrimitiveType_TRIANGLE | aiPrimitiveType_POLYGON;
  out.mNumVertices = static_cast<unsigned>(mesh.points.size());
  out.mVertices = new aiVector3D[mesh.points.size()];
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    const Eigen::Vector3f point = mesh.points[k].cast<float>();
    out.mVertices[k] = {point.x(), point.y(), point.z()};
  }
  if (!mesh.colors.empty()) {
    out.mColors[0] = new aiColor4D[mesh.points.size()];
    for (std::size_t k = 0; k < mesh.points.size(); ++k) {
      // Assimp cuts off when it makes bytes of these; the half keeps every byte what it was.
      const auto channel = [&](unsigned shift) {
        const std::uint32_t byte = (mesh.colors[k] >> shift) & 0xFFU;
        return std::min(1.0F, (static_cast<float>(byte) + 0.5F) / 255.0F);
      };
      out.mColors[0][k] = {channel(16), channel(8), channel(0), 1.0F};
    }
  }
  out.mNumFaces = static_cast<unsigned>(mesh.polygons.size());
  out.mFaces = new aiFace[mesh.polygons.size()];
  for (std::size_t k = 0; k < mesh.polygons.size(); ++k) {
    const auto& polygon = mesh.polygons[k];
    out.mFaces[k].mNumIndices = static_cast<unsigned>(polygon.size());
    out.mFaces[k].mIndices = new unsigned[polygon.size()];
    std::ranges::copy(polygon, out.mFaces[k].mIndices);
  }
  return scene;
}

/// STL has a normal for each triangle, which Assimp takes from the normals of its corners.
void setFlatNormals(const ExportMesh& mesh, aiMesh& out) {
  out.mNormals = new aiVector3D[mesh.points.size()];
  for (const auto& polygon : mesh.polygons) {
    const Eigen::Vector3d& corner = mesh.points[polygon[0]];
    const Eigen::Vector3f normal =
        (mesh.points[polygon[1]] - corner).cross(mesh.points[polygon[2]] - corner).normalized().cast<float>();
    for (const std::uint32_t point : polygon) out.mNormals[point] = {normal.x(), normal.y(), normal.z()};
  }
}

}  // namespace

std::string meshBytes(const ExportMesh& mesh, const std::string& assimp_format, const std::string& file) {
  const auto scene = makeScene(mesh);
  if (assimp_format == "stlb") setFlatNormals(mesh, *scene->mMeshes[0]);
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), assimp_format);
  if (blob == nullptr) throw FormatError(file + ": the mesh could not be made: " + exporter.GetErrorString());
  return {static_cast<const char*>(blob->data), blob->size};
}

}  // namespace hexoderm
