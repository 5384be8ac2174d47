#pragma once

#include "hexoderm/solve/metrics/overlays.h"
#include "hexoderm/solve/metrics/surface_mesh.h"
#include "widgets/scene/scene_content.h"
#include "widgets/style/scene_colors.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <initializer_list>
#include <optional>
#include <vector>

namespace hexoderm {

// Things drawn over the cells, each kind as one mesh. No Qt, no OpenGL. All points in the scene's frame.

/// Enlarged figures are drawn this many times as large as they are.
struct EnlargedShape {
  vtkSmartPointer<vtkPolyData> data;
  double factor = 1;
};

/// The region that holds each cell's centre with 95 % probability, relative to the origin. Cells without a covariance,
/// or known exactly, have none.
EnlargedShape makeEllipsoids(const SceneContent& content);

/// The edges of a box about each of these patches, dashed: indices into the reconstruction's.
vtkSmartPointer<vtkPolyData> makePatchFrames(const SceneContent& content, const std::vector<std::size_t>& patches);

/// Every link from centre to centre through both ports, in the colour of its class and dotted, dashed, solid or double
/// as in the graph; excluded links grey, dashed and crossed.
vtkSmartPointer<vtkPolyData> makeLinkLines(const SceneContent& content, const SceneColors& colors);
/// The links of the shortest-path tree alone.
vtkSmartPointer<vtkPolyData> makeTreeLines(const SceneContent& content);

/// The edges of a prism at each of the placements.
vtkSmartPointer<vtkPolyData> makeGhostOutlines(const SceneContent& content, const std::vector<AlignedCell>& cells);

/// The edges of the cells' prisms, a hair outside them. Cells that are not there have none.
vtkSmartPointer<vtkPolyData> makeCellOutlines(const SceneContent& content, std::initializer_list<CellId> cells);

/// The surface as a smooth sheet, `patch` an index into the reconstruction's.
vtkSmartPointer<vtkPolyData> makeSurfaceSheet(const SceneContent& content, const SurfaceMesh& mesh, std::size_t patch);
/// From each foot on the surface towards the cell's centre.
EnlargedShape makeDistanceLines(const SceneContent& content, const SurfaceMesh& mesh, std::size_t patch);

/// From before to now, all ending at the cells' centres. Without a `factor` they are enlarged as far as they can be
/// told apart.
EnlargedShape makeShiftArrows(const SceneContent& content, const std::vector<CellShift>& shifts,
                              std::optional<double> factor = std::nullopt);

/// From one point to the other, enlarged about their middle.
EnlargedShape makeGapArrow(const SceneContent& content, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Straight from a to b.
vtkSmartPointer<vtkPolyData> makeLine(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace hexoderm
