#pragma once

// Mesh files of robots.

#include "hexoderm/base/triangle_mesh.h"

#include <filesystem>
#include <string>

namespace hexoderm {

/// The triangles of a mesh file (STL, OBJ, COLLADA, glTF or PLY), in the file's own frame and unit; a COLLADA file is
/// in metres by the unit it states, and its axes stay as they are, as robot software takes them. What a file holds
/// decides its format, and its name where the content does not tell. Polygons become triangles by fans, which is right
/// for convex ones. Throws StorageError if the file is missing or unreadable, FormatError if it is of another format,
/// is not what its format says, holds no triangles, more than 10 million, or points that are not finite or beyond 1e6.
TriangleMesh readMeshFile(const std::filesystem::path& file);

/// The same from the bytes of a file. Others that it refers to (glTF) are looked for beside `file`.
TriangleMesh readMesh(std::string bytes, const std::filesystem::path& file);

/// That a mesh file is an input (noteRead()), with the buffers that it names if it is a glTF. A file that is missing or
/// malformed, or takes more memory than there is, is none: that is said when it is read.
void noteMeshFile(const std::filesystem::path& file);

}  // namespace hexoderm
