#include "hexoderm/io/export_ply.h"

#include "hexoderm/io/export_support.h"
#include "hexoderm/reconstruction/figures/patch_mesh.h"
#include "hexoderm/reconstruction/result/quality_colors.h"
#include "hexoderm/util/error.h"

namespace hexoderm {
namespace {

constexpr std::size_t kPointsPerCell = 12;

}  // namespace

ExportMesh plyMesh(const Reconstruction& reconstruction, const ExportSelection& selection) {
  const PatchMesh prisms = makePatchMesh(reconstruction);
  const auto quality = worstUsedQuality(reconstruction);
  ExportMesh mesh;
  mesh.points = prisms.points;
  mesh.frame = frameInWords(reconstruction, selection);
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

}  // namespace hexoderm
