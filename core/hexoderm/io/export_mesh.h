#pragma once

#include "hexoderm/io/exporter.h"
#include "hexoderm/reconstruction/result/reconstruction.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hexoderm {

/// Polygons as a mesh file holds them.
struct ExportMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::vector<std::uint32_t> colors;  ///< 0xRRGGBB of each point; empty: the format has none
  std::string frame;                  ///< frameInWords(), for formats that have comments
};

/// Bytes of the mesh in a format of Assimp's ("ply", "stlb"). Throws FormatError with Assimp's reason.
std::string meshBytes(const ExportMesh& mesh, const std::string& assimp_format, const std::string& file);

}  // namespace hexoderm
