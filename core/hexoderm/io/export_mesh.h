#pragma once

#include "hexoderm/io/exporter.h"
#include "hexoderm/reconstruction/result/reconstruction.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hexoderm {

/// Polygons as a mesh file holds them: what was meant, and what was read back.
struct ExportMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::vector<std::uint32_t> colors;  ///< 0xRRGGBB of each point; empty: the format has none
  std::string frame;                  ///< frameInWords(), for formats that have comments
};

/// Bytes of the mesh in a format of Assimp's ("ply", "stlb"). Throws FormatError with Assimp's reason.
std::string meshBytes(const ExportMesh& mesh, const std::string& assimp_format, const std::string& file);

/// Reads the bytes back with Assimp (`extension` without the dot) and compares points, in single precision, polygons
/// and colours. Throws FormatError.
void verifyMesh(const std::string& bytes, const ExportMesh& meant, const std::string& extension,
                const std::string& file);

}  // namespace hexoderm
