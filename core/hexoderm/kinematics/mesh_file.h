#pragma once

// Private to core: mesh files, by Assimp.

#include "hexoderm/geometry/triangle_mesh.h"

#include <filesystem>

namespace hexoderm {

/// The triangles of a mesh file (STL, OBJ, Collada, ...), in the file's own frame and unit; a Collada file is in metres
/// by the unit it states, and its axes stay as they are, as robot software takes them. Throws StorageError if it is
/// missing or unreadable, FormatError if it holds no triangles, more than 10 million, or points that are not finite or
/// beyond 1e6.
TriangleMesh readMeshFile(const std::filesystem::path& file);

}  // namespace hexoderm
