#pragma once

#include "hexoderm/io/export_mesh.h"

namespace hexoderm {

/// The prisms in metres, every point in the colour of its cell's worst used link (grey: the cell has none).
ExportMesh plyMesh(const Reconstruction& reconstruction);

/// ASCII PLY with uchar colours and a comment that names unit and frame.
std::string plyBytes(const ExportMesh& mesh, const std::string& file);
void verifyPly(const std::string& bytes, const ExportMesh& meant, const std::string& file);

}  // namespace hexoderm
