#include "hexoderm/io/export_obj.h"

#include "hexoderm/io/export_ply.h"
#include "hexoderm/io/skin_tree.h"
#include "hexoderm/util/text.h"

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

}  // namespace hexoderm
