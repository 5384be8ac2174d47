#include "hexoderm/solve/metrics/patch_mesh.h"

namespace hexoderm {

std::vector<Eigen::Vector3d> cellCorners(const Reconstruction& reconstruction, CellCorners corners) {
  const std::ptrdiff_t kept = corners == CellCorners::Prism ? 12 : 6;  // the front's come first
  std::vector<Eigen::Vector3d> points;
  points.reserve(static_cast<std::size_t>(kept) * reconstruction.cellCount());
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& placement : patch.cells) {
      const auto prism = prismCorners(*reconstruction.model, placement.T_o_u);
      points.insert(points.end(), prism.begin(), prism.begin() + kept);
    }
  }
  return points;
}

std::array<Eigen::Vector3d, 12> prismCorners(const CellModel& model, const SE3& T) {
  const auto outline = model.outline();
  const Eigen::Vector3d down(0, 0, -model.thickness_m);
  std::array<Eigen::Vector3d, 12> points;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    points.at(k) = T * outline.at(k);
    points.at(k + outline.size()) = T * (outline.at(k) + down);
  }
  return points;
}

PatchMesh makePatchMesh(const Reconstruction& reconstruction) {
  constexpr std::uint32_t kSides = 6;
  PatchMesh mesh;
  mesh.points = cellCorners(reconstruction, CellCorners::Prism);
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& placement : patch.cells) {
      const auto cell = static_cast<std::uint32_t>(mesh.cells.size());
      const std::uint32_t first = 2 * kSides * cell;
      mesh.cells.push_back(placement.cell);
      PatchMesh::Polygon front{{}, cell};
      PatchMesh::Polygon back{{}, cell};
      for (std::uint32_t k = 0; k < kSides; ++k) {
        front.points.push_back(first + k);
        back.points.push_back(first + 2 * kSides - 1 - k);
      }
      mesh.polygons.push_back(std::move(front));
      mesh.polygons.push_back(std::move(back));
      for (std::uint32_t k = 0; k < kSides; ++k) {
        const std::uint32_t next = (k + 1) % kSides;
        mesh.polygons.push_back({{first + next, first + k, first + kSides + k, first + kSides + next}, cell});
      }
    }
  }
  return mesh;
}

std::vector<std::array<std::uint32_t, 3>> triangulate(const PatchMesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const PatchMesh::Polygon& polygon : mesh.polygons) {
    for (std::size_t k = 2; k < polygon.points.size(); ++k) {
      triangles.push_back({polygon.points[0], polygon.points[k - 1], polygon.points[k]});
    }
  }
  return triangles;
}

}  // namespace hexoderm
