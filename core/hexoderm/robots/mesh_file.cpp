#include "hexoderm/robots/mesh_file.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/system_reason.h"
#include "hexoderm/base/text.h"
#include "hexoderm/robots/mesh_input.h"

#include <algorithm>
#include <new>
#include <system_error>

namespace hexoderm {
namespace {

std::string_view withoutMark(std::string_view bytes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kMark)) bytes.remove_prefix(kMark.size());
  return bytes;
}

/// The text without a byte order mark and blanks in front.
std::string_view textOfMesh(std::string_view bytes) {
  bytes = withoutMark(bytes);
  return bytes.substr(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
}

bool hasExtension(const std::filesystem::path& file, std::string_view lower) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension == lower;
}

}  // namespace

std::string readRegularFile(const std::filesystem::path& file, std::uintmax_t max_bytes) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw StorageError(file.string(), message("there is no such mesh file"));
  }
  if (error) throw StorageError(file.string(), message("cannot be read: {}", systemReason(error)));
  if (status.type() != std::filesystem::file_type::regular) {
    throw StorageError(file.string(), message("expected a mesh file, but this is none"));
  }
  // The kernel's own files state no size, and reading some of them waits for events that never come.
  if (std::filesystem::file_size(file, error) == 0) {
    throw StorageError(file.string(), message("expected a mesh file, but this one is empty"));
  }
  return readFile(file, max_bytes);
}

TriangleMesh readMesh(std::string bytes, const std::filesystem::path& file) {
  MeshBuilder mesh(file.string(), bytes.size());
  const std::string_view text = textOfMesh(bytes);
  if (isBinaryStl(bytes)) {
    readStl(bytes, mesh);  // whatever its header says
  } else if (bytes.starts_with("glTF")) {
    readGlb(bytes, file, mesh);
  } else if (text.starts_with('{')) {
    readGltf(text, file, mesh);
  } else if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) {
    readPly(bytes, mesh);
  } else if (text.starts_with('<') || hasExtension(file, ".dae")) {
    readCollada(bytes, mesh);
  } else if (isStlText(bytes) || hasExtension(file, ".stl")) {
    readStl(bytes, mesh);
  } else if (hasExtension(file, ".obj")) {
    readObj(withoutMark(bytes), mesh);  // blank lines in front count
  } else {
    constexpr std::size_t kMaxExcerpt = 30;
    mesh.fail(
        message("expected a mesh as STL, OBJ, COLLADA, glTF or PLY, found \"{}\"", excerptOf(bytes, kMaxExcerpt)));
  }
  TriangleMesh result = mesh.take();
  if (result.empty()) mesh.fail(message("expected a mesh of triangles, but it has none"));
  return result;
}

void noteMeshFile(const std::filesystem::path& file) {
  noteRead(file);
  if (!hasExtension(file, ".gltf")) return;
  try {
    const std::string bytes = readRegularFile(file, kMaxFileBytes);
    for (const std::filesystem::path& buffer : gltfBuffers(textOfMesh(bytes), file)) noteRead(buffer);
  } catch (const Error&) {  // said where the mesh is needed
  } catch (const std::bad_alloc&) {
  }
}

TriangleMesh readMeshFile(const std::filesystem::path& file) {
  try {
    return readMesh(readRegularFile(file, kMaxFileBytes), file);
  } catch (const std::bad_alloc&) {
    throw StorageError(file.string(), message("takes more memory than there is"));
  }
}

}  // namespace hexoderm
