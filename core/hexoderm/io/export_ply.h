#pragma once

#include "hexoderm/io/export_mesh.h"
#include "hexoderm/io/export_selection.h"

namespace hexoderm {

/// The prisms in metres, every point in the colour of its cell's worst used link (grey: the cell has none). The
/// selection says in which frame the reconstruction is.
ExportMesh plyMesh(const Reconstruction& reconstruction, const ExportSelection& selection = {});

/// ASCII PLY with uchar colours and a comment that names unit and frame.
std::string plyBytes(const ExportMesh& mesh, const std::string& file);

}  // namespace hexoderm
