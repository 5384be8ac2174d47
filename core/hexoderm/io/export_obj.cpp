#include "hexoderm/io/export_obj.h"

#include "hexoderm/io/export_ply.h"
#include "hexoderm/io/export_support.h"
#include "hexoderm/io/skin_tree.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"

#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>

namespace hexoderm {
namespace {

constexpr std::size_t kObjPointsPerCell = 12;

std::string objName(CellId cell) { return "cell_" + toString(cell); }

std::string objColor(std::uint32_t rgb) {
  std::string text;
  for (const unsigned shift : {16U, 8U, 0U}) text += " " + formatFixed(((rgb >> shift) & 0xFFU) / 255.0, 4);
  return text;
}

}  // namespace

ObjMesh objMesh(const Reconstruction& reconstruction, const ExportSelection& selection) {
  ObjMesh obj{plyMesh(reconstruction, selection), {}};
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) obj.cells.push_back(cell.cell);
  }
  return obj;
}

std::string objText(const ObjMesh& obj) {
  const auto& [mesh, cells] = obj;
  std::string text = "# metres, " + mesh.frame + "\n";
  std::size_t polygon = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    text += "o " + objName(cells[k]) + "\n";
    const std::size_t end = (k + 1) * kObjPointsPerCell;
    for (std::size_t point = k * kObjPointsPerCell; point < end; ++point) {
      text += "v " + vectorText(mesh.points[point]) + objColor(mesh.colors[point]) + "\n";
    }
    for (; polygon < mesh.polygons.size() && mesh.polygons[polygon].front() < end; ++polygon) {
      text += "f";
      for (const std::uint32_t point : mesh.polygons[polygon]) text += " " + std::to_string(point + 1);  // from 1
      text += "\n";
    }
  }
  return text;
}

void verifyObj(const std::string& bytes, const ObjMesh& meant, const std::string& file) {
  const auto& [mesh, cells] = meant;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "obj");
  if (scene == nullptr) throw FormatError(file + ": cannot be read back as a mesh: " + importer.GetErrorString());
  requireMeant(scene->mNumMeshes == cells.size(), file, "expected " + std::to_string(cells.size()) + " objects");
  double largest = 0;
  for (const Eigen::Vector3d& point : mesh.points) largest = std::max(largest, point.cwiseAbs().maxCoeff());
  std::size_t polygon = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const aiMesh& found = *scene->mMeshes[k];
    requireMeant(objName(cells[k]) == found.mName.C_Str(), file, "object " + objName(cells[k]) + " is missing");
    for (unsigned face = 0; face < found.mNumFaces; ++face, ++polygon) {
      requireMeant(polygon < mesh.polygons.size() && found.mFaces[face].mNumIndices == mesh.polygons[polygon].size(),
                   file, "a polygon has other corners");
      for (unsigned corner = 0; corner < found.mFaces[face].mNumIndices; ++corner) {
        const aiVector3D& at = found.mVertices[found.mFaces[face].mIndices[corner]];
        const Eigen::Vector3d& expected = mesh.points[mesh.polygons[polygon][corner]];
        const double off = (Eigen::Vector3f(at.x, at.y, at.z).cast<double>() - expected).cwiseAbs().maxCoeff();
        requireMeant(off <= 1e-6 * largest, file, objName(cells[k]) + " is elsewhere");  // false for NaN, too
      }
    }
  }
  requireMeant(polygon == mesh.polygons.size(), file, "polygons are missing");
}

}  // namespace hexoderm
