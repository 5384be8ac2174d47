#pragma once

#include "hexoderm/solve/metrics/patch_mesh.h"
#include "widgets/scene/polydata_builder.h"
#include "widgets/scene/scene_content.h"
#include "widgets/style/scene_colors.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace hexoderm {

// Shares of the way from the middle to a corner: between an ID in the middle and the ports at the edges.
inline constexpr double kBrushInner = 0.58;
inline constexpr double kBrushOuter = 0.72;
inline constexpr double kBrushLift = 0.02;  // of the side's length, so that it lies on the face and not in it

/// A hexagonal ring inside the front face of each of these cells, in the mark that stands out from the face: no hue, so
/// that it goes with every colouring. Cells that are not there have none. `front_colors`: of all cells.
inline vtkSmartPointer<vtkPolyData> makeBrushMarks(const SceneContent& content, const std::vector<CellId>& cells,
                                                   const std::vector<Rgb>& front_colors, const SceneColors& colors) {
  PolyDataBuilder mesh;
  if (cells.empty()) return mesh.finish();
  const CellModel& model = *content.reconstruction->model;
  for (const CellId cell : cells) {
    const SceneCell* found = content.layout.find(cell);
    if (found == nullptr) continue;
    const auto index = static_cast<std::size_t>(found - content.layout.cells.data());
    const Rgb& mark = markOn(index < front_colors.size() ? front_colors[index] : colors.neutral, colors);
    const auto corners = prismCorners(model, found->T_s_u);
    const Eigen::Vector3d center = found->T_s_u.t;
    const Eigen::Vector3d lift = found->T_s_u.R * Eigen::Vector3d(0, 0, kBrushLift * model.side_m);
    const vtkIdType first = mesh.pointCount();
    for (std::size_t k = 0; k < 6; ++k) {
      mesh.addPoint(center + lift + kBrushInner * (corners.at(k) - center));
      mesh.addPoint(center + lift + kBrushOuter * (corners.at(k) - center));
    }
    for (vtkIdType k = 0; k < 6; ++k) {
      const vtkIdType next = (k + 1) % 6;
      mesh.addPolygon({first + 2 * k, first + 2 * k + 1, first + 2 * next + 1, first + 2 * next}, mark);
    }
  }
  return mesh.finish();
}

}  // namespace hexoderm
