#pragma once

// The formats that hold a mesh of the cells.

#include "hexoderm/io/export_selection.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hexoderm {

/// Polygons as a mesh file holds them.
struct ExportMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::vector<std::uint32_t> colors;  ///< 0xRRGGBB of each point; empty: the format has none
  std::string frame;                  ///< frameText(), for formats that have comments
};

/// The prisms in metres, every point in the colour of its cell's worst used link (grey: the cell has none). The
/// selection says in which frame the reconstruction is.
ExportMesh plyMesh(const Reconstruction& reconstruction, const ExportSelection& selection = {});
/// ASCII PLY with uchar colours and a comment that names unit and frame.
std::string plyBytes(const ExportMesh& mesh, const std::string& file);

/// The prisms as triangles that share no points, in the unit asked for.
ExportMesh stlMesh(const Reconstruction& reconstruction, LengthUnit unit);
/// Binary STL.
std::string stlBytes(const ExportMesh& mesh, const std::string& file);

/// Wavefront OBJ in metres: an object "cell_N" for each cell, its colour at each vertex ("v x y z r g b", which most
/// programs read and others skip), no file of materials.
std::string objText(const Reconstruction& reconstruction, const ExportSelection& selection = {});

}  // namespace hexoderm
