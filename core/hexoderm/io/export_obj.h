#pragma once

#include "hexoderm/io/export_mesh.h"
#include "hexoderm/io/export_selection.h"

#include <string>

namespace hexoderm {

/// Wavefront OBJ in metres: an object "cell_N" for each cell, its colour at each vertex ("v x y z r g b", which most
/// programs read and others skip), no file of materials.
struct ObjMesh {
  ExportMesh mesh;
  std::vector<CellId> cells;
};
ObjMesh objMesh(const Reconstruction& reconstruction, const ExportSelection& selection = {});
std::string objText(const ObjMesh& obj);

}  // namespace hexoderm
