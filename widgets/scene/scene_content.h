#pragma once

#include "hexoderm/solve/metrics/cell_links.h"
#include "hexoderm/solve/metrics/cell_metrics.h"
#include "hexoderm/solve/metrics/skin_signs.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>
#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace hexoderm {

/// One cell as the scene draws it, in order of patch and ID.
struct SceneCell {
  CellId id;
  SE3 T_s_u;  ///< cell to scene: the placement in its patch, and the patch's place beside the others
  std::size_t patch = 0;
  bool origin = false;
};

/// A skin laid out for drawing. How patches lie to each other is not known: the largest lies in its own frame, which is
/// the scene's, and the others stand beside it, in columns to its right in their order, so that no box of one meets
/// that of another. This is the only place that says where a patch is drawn.
struct SceneLayout {
  std::vector<SceneCell> cells;
  std::vector<Eigen::Vector3d> points;  ///< 12 a cell as in PatchMesh, or the first 6 of them
  // One for each patch.
  std::vector<Eigen::Vector3d> shifts;     ///< from its own frame to the scene
  std::vector<Eigen::AlignedBox3d> boxes;  ///< of its points in the scene; empty without cells
  std::size_t largest = 0;                 ///< index of the patch that lies in its own frame
  std::unordered_map<CellId, std::size_t> index;

  [[nodiscard]] const SceneCell* find(CellId id) const {
    const auto found = index.find(id);
    return found == index.end() ? nullptr : &cells[found->second];
  }
  /// Indices of the patches that have cells but are not placed against the largest.
  [[nodiscard]] std::vector<std::size_t> notPlaced() const {
    std::vector<std::size_t> patches;
    for (std::size_t p = 0; p < boxes.size(); ++p) {
      if (p != largest && !boxes[p].isEmpty()) patches.push_back(p);
    }
    return patches;
  }
  /// Those of notPlaced() that stand in frames; none where they are too many to tell apart.
  [[nodiscard]] std::vector<std::size_t> framed() const {
    constexpr std::size_t kMax = 200;
    std::vector<std::size_t> patches = notPlaced();
    if (patches.size() > kMax) patches.clear();
    return patches;
  }
  [[nodiscard]] std::size_t pointsPerCell() const { return cells.empty() ? 0 : points.size() / cells.size(); }
};

/// All that is drawn of a skin's cells but their colours. Making it takes a while for large skins, so it may be made on
/// any thread; no Qt, no OpenGL.
///
/// Up to kMaxPrismCells cells are prisms of eight polygons; a larger skin is its front faces only, as four triangles a
/// cell with points and normals of their own, which is what a software renderer draws fastest.
struct SceneContent {
  static constexpr std::size_t kMaxPrismCells = 2000;

  std::shared_ptr<const Reconstruction> reconstruction;  ///< never null
  SceneLayout layout;
  CellMetrics figures;
  SkinSigns signs;
  CellLinks links;      ///< by index of the layout's cells
  double extent_m = 0;  ///< diagonal of the bounding box
  bool prisms = true;
  vtkSmartPointer<vtkPolyData> surface;  ///< without colours
  /// What tells the backs of prisms from their fronts, whatever their colours: a smaller hexagon on each, a hair
  /// outside. Null for faces.
  vtkSmartPointer<vtkPolyData> backs;
  /// A large skin from far away: hexagons of a few pixels look like bricks of the same area, which join as closely and
  /// have half the triangles. Null for prisms.
  vtkSmartPointer<vtkPolyData> bricks;
  /// Finds where a line meets the surface.
  vtkNew<vtkStaticCellLocator> locator;

  /// The point at which a link joins a cell, in the scene; none if there is no such cell or port.
  [[nodiscard]] std::optional<Eigen::Vector3d> portPoint(const LinkEnd& end) const {
    const SceneCell* cell = layout.find(end.cell);
    const Port* port = reconstruction->model->findPort(end.port);
    return cell != nullptr && port != nullptr ? std::optional(cell->T_s_u * port->vector_m) : std::nullopt;
  }
  /// Corners of the frame about a patch, in the scene: bit k of an index says to which end of axis k the corner lies.
  [[nodiscard]] std::array<Eigen::Vector3d, 8> frameCorners(std::size_t patch) const {
    constexpr double kRoom = 0.4;  // between the frame and the cells, in sides of a cell
    const Eigen::AlignedBox3d& box = layout.boxes.at(patch);
    const Eigen::Vector3d room = Eigen::Vector3d::Constant(kRoom * reconstruction->model->side_m);
    const std::array<Eigen::Vector3d, 2> ends = {box.min() - room, box.max() + room};
    std::array<Eigen::Vector3d, 8> corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      corners.at(k) = {ends.at(k & 1U).x(), ends.at(k >> 1U & 1U).y(), ends.at(k >> 2U & 1U).z()};
    }
    return corners;
  }
  [[nodiscard]] std::size_t polygonsPerCell() const { return prisms ? 8 : 4; }
};

/// Eight polygons a cell, of layouts with 12 points a cell: front, back, sides.
vtkSmartPointer<vtkPolyData> makePrisms(const SceneLayout& layout);

/// Null of null.
std::shared_ptr<const SceneContent> makeSceneContent(std::shared_ptr<const Reconstruction> reconstruction);

}  // namespace hexoderm
