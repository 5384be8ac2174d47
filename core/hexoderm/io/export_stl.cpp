#include "hexoderm/io/export_stl.h"

#include "hexoderm/reconstruction/figures/patch_mesh.h"
#include "hexoderm/util/units.h"

namespace hexoderm {

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

}  // namespace hexoderm
