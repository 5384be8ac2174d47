#pragma once

#include "hexoderm/io/export_mesh.h"

namespace hexoderm {

/// The prisms as triangles that share no points, in the unit asked for.
ExportMesh stlMesh(const Reconstruction& reconstruction, LengthUnit unit);

/// Binary STL.
std::string stlBytes(const ExportMesh& mesh, const std::string& file);

}  // namespace hexoderm
