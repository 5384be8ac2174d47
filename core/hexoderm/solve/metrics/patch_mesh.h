#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hexoderm {

/// The skin as true hexagonal prisms in the patch frames, for drawing and for mesh files. Per cell in order of patch
/// and ID: 12 points (front corners counter-clockwise seen from outside, then the back corners below them), 8 polygons
/// (front, back, six sides) wound so that normals point outwards. Metres.
struct PatchMesh {
  std::vector<Eigen::Vector3d> points;
  /// A face of the mesh.
  struct Polygon {
    std::vector<std::uint32_t> points;
    std::uint32_t cell = 0;  ///< index into `cells`
  };
  std::vector<Polygon> polygons;
  std::vector<CellId> cells;
};

/// The points of PatchMesh alone, and of large skins only the six front corners a cell: what is drawn many times a
/// second needs no polygons of its own. Metres, in the frame of each cell's patch.
enum class CellCorners { Prism, Front };
/// The corners of all cells, patch by patch.
std::vector<Eigen::Vector3d> cellCorners(const Reconstruction& reconstruction, CellCorners corners);
/// The twelve points of one cell in the frame that T leads to from the cell frame, m.
std::array<Eigen::Vector3d, 12> prismCorners(const CellModel& model, const SE3& T);

/// Every patch in its own frame (all origins coincide).
PatchMesh makePatchMesh(const Reconstruction& reconstruction);

/// Every polygon cut into triangles (fans), same points.
std::vector<std::array<std::uint32_t, 3>> triangulate(const PatchMesh& mesh);

}  // namespace hexoderm
