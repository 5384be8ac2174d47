#include "hexoderm/io/export_mesh.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/io/export_support.h"
#include "hexoderm/io/skin_tree.h"
#include "hexoderm/solve/metrics/patch_mesh.h"
#include "hexoderm/solve/result/quality_colors.h"

#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <memory>

namespace hexoderm {
namespace {

constexpr std::size_t kPointsPerCell = 12;

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

/// Bytes of the mesh in a format of Assimp's ("ply", "stlb"). Throws FormatError with Assimp's reason.
std::string meshBytes(const ExportMesh& mesh, const std::string& assimp_format, const std::string& file) {
  const auto scene = makeScene(mesh);
  if (assimp_format == "stlb") setFlatNormals(mesh, *scene->mMeshes[0]);
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), assimp_format);
  if (blob == nullptr) throw FormatError(file + ": the mesh could not be made: " + exporter.GetErrorString());
  return {static_cast<const char*>(blob->data), blob->size};
}

}  // namespace

ExportMesh plyMesh(const Reconstruction& reconstruction, const ExportSelection& selection) {
  const PatchMesh prisms = makePatchMesh(reconstruction);
  const auto quality = worstUsedQuality(reconstruction);
  ExportMesh mesh;
  mesh.points = prisms.points;
  mesh.frame = frameText(reconstruction, selection);
  for (const PatchMesh::Polygon& polygon : prisms.polygons) mesh.polygons.push_back(polygon.points);
  for (const CellId cell : prisms.cells) {
    const auto found = quality.find(cell);
    const std::uint32_t color =
        found == quality.end() ? unusedColor(Background::Light) : qualityColor(found->second, Background::Light);
    mesh.colors.insert(mesh.colors.end(), kPointsPerCell, color);
  }
  return mesh;
}

std::string plyBytes(const ExportMesh& mesh, const std::string& file) {
  std::string bytes = meshBytes(mesh, "ply", file);
  const std::string before = "element vertex";
  const std::size_t at = bytes.find(before);
  if (at == std::string::npos) throw FormatError(file + ": the mesh could not be made: expected \"" + before + "\"");
  return bytes.insert(at, "comment metres, " + mesh.frame + "\n");
}

ExportMesh stlMesh(const Reconstruction& reconstruction, LengthUnit unit) {
  const double scale = unit == LengthUnit::Millimetres ? 1 / kMillimetre : 1.0;
  const PatchMesh prisms = makePatchMesh(reconstruction);
  ExportMesh mesh;
  for (const auto& triangle : triangulate(prisms)) {
    std::vector<std::uint32_t> polygon;
    for (const std::uint32_t point : triangle) {
      polygon.push_back(static_cast<std::uint32_t>(mesh.points.size()));
      mesh.points.emplace_back(scale * prisms.points[point]);
    }
    mesh.polygons.push_back(std::move(polygon));
  }
  return mesh;
}

std::string stlBytes(const ExportMesh& mesh, const std::string& file) { return meshBytes(mesh, "stlb", file); }

std::string objText(const Reconstruction& reconstruction, const ExportSelection& selection) {
  const ExportMesh mesh = plyMesh(reconstruction, selection);
  std::string text = "# metres, " + mesh.frame + "\n";
  std::size_t point = 0;
  std::size_t polygon = 0;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      text += "o cell_" + toString(cell.cell) + "\n";
      for (const std::size_t end = point + kPointsPerCell; point < end; ++point) {
        text += "v " + vectorText(mesh.points[point]) + " " + rgbText(mesh.colors[point]) + "\n";
      }
      for (; polygon < mesh.polygons.size() && mesh.polygons[polygon].front() < point; ++polygon) {
        text += "f";
        for (const std::uint32_t corner : mesh.polygons[polygon]) text += " " + std::to_string(corner + 1);  // from 1
        text += "\n";
      }
    }
  }
  return text;
}

}  // namespace hexoderm
