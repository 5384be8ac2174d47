#pragma once

#include "hexoderm/reconstruction/reconstruction.h"
#include "widgets/scene_colors.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// One cell as the scene draws it, in order of patch and ID.
struct SceneCell {
  CellId id;
  SE3 T_s_u;  ///< cell to scene: the placement in its patch, and the patch's place beside the others
  bool origin = false;
};

/// A skin laid out for drawing: patches side by side along x. No Qt, no OpenGL.
struct SceneLayout {
  std::vector<SceneCell> cells;
  std::vector<Eigen::Vector3d> points;  ///< 12 a cell, as in PatchMesh
};
SceneLayout layOutScene(const Reconstruction& reconstruction);

/// The colour of every cell's front face, in the order of the layout. By link quality and by deviation the worst used
/// link of the cell decides; without one the cell is neutral.
std::vector<Rgb> cellColors(const Reconstruction& reconstruction, CellColoring coloring, const SceneColors& colors);

/// True hexagonal prisms, or only their front faces, with one colour per polygon; sides and backs are darker.
struct PrismData {
  vtkSmartPointer<vtkPolyData> surface;
  std::vector<std::size_t> cell_of_polygon;  ///< index into the layout
};
PrismData makePrisms(const SceneLayout& layout, const std::vector<Rgb>& front_colors, bool front_faces_only);

/// Ports as discs (joined to a neighbour by a used link) or rings (free), and a ring about the origin, flat on the
/// front faces in the colour that stands out from each face.
vtkSmartPointer<vtkPolyData> makeMarks(const Reconstruction& reconstruction, const SceneLayout& layout,
                                       const std::vector<Rgb>& front_colors, const SceneColors& colors);

/// The edges of one cell's prism, a hair outside it.
vtkSmartPointer<vtkPolyData> makeCellOutline(const SceneLayout& layout, std::size_t cell);

/// A line from centre to centre through both ports, a little above the front faces. Empty if a cell or port is missing.
vtkSmartPointer<vtkPolyData> makeLinkStroke(const Reconstruction& reconstruction, const SceneLayout& layout, LinkEnd a,
                                            LinkEnd b);

}  // namespace hexoderm
