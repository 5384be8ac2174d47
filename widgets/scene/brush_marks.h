#pragma once

#include "widgets/scene/scene_content.h"
#include "widgets/style/scene_colors.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vector>

namespace hexoderm {

/// A hexagonal ring inside the front face of each of these cells, in the mark that stands out from the face: no hue, so
/// that it goes with every colouring. Cells that are not there have none. `front_colors`: of all cells.
vtkSmartPointer<vtkPolyData> makeBrushMarks(const SceneContent& content, const std::vector<CellId>& cells,
                                            const std::vector<Rgb>& front_colors, const SceneColors& colors);

}  // namespace hexoderm
