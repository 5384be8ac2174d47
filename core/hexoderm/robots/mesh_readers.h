#pragma once

// One reader for each format. Each adds the triangles of a file to the builder, and throws
// FormatError naming the file. Time and memory are bounded by the size of the file.

#include "hexoderm/robots/mesh_input.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// Whether a file is as long as a binary STL with its count of triangles, whatever its header says ("solid" too).
bool isBinaryStl(std::string_view bytes);
/// Whether a text begins as an STL file of text, or as the header of a binary one.
bool isStlText(std::string_view text);
/// STL, of text or binary.
void readStl(std::string_view bytes, MeshBuilder& mesh);
/// Wavefront OBJ: points and faces.
void readObj(std::string_view text, MeshBuilder& mesh);
/// PLY of text or binary: faces and strips of triangles. All other elements and properties are skipped.
void readPly(std::string_view bytes, MeshBuilder& mesh);
/// COLLADA: the scene, in metres. `bytes` are written over.
void readCollada(std::string& bytes, MeshBuilder& mesh);
/// glTF 2.0: the scene. `file` is where the files of its buffers are looked for.
void readGltf(std::string_view text, const std::filesystem::path& file, MeshBuilder& mesh);
/// The same in its binary form.
void readGlb(std::string_view bytes, const std::filesystem::path& file, MeshBuilder& mesh);
/// The files of a glTF's buffers, as far as it names any. Throws FormatError for what is no JSON.
std::vector<std::filesystem::path> gltfBuffers(std::string_view text, const std::filesystem::path& file);

/// The bytes of a mesh file, or of one that it refers to. Throws StorageError for what is no regular file or can't be
/// read, FormatError for more than `max_bytes`.
std::string readRegularFile(const std::filesystem::path& file, std::uintmax_t max_bytes);

}  // namespace hexoderm
