#pragma once

#include "widgets/style/scene_colors.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace hexoderm {

/// A mesh in a picture.
struct MeshActor {
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  MeshActor() { actor->SetMapper(mapper); }
  [[nodiscard]] vtkProperty* property() const { return actor->GetProperty(); }
  [[nodiscard]] bool isShown() const { return actor->GetVisibility() != 0; }
  /// Null, or one without lines and polygons: nothing.
  void show(vtkPolyData* data) {
    const bool any = data != nullptr && data->GetNumberOfCells() > 0;
    if (any) mapper->SetInputData(data);
    actor->SetVisibility(any);
  }
  void setColor(const Rgb& color) const { property()->SetColor(color[0], color[1], color[2]); }
  /// Shares of the colour that are there without light, and that light adds.
  void setAmbient(double ambient) const {
    property()->SetAmbient(ambient);
    property()->SetDiffuse(1 - ambient);
  }
};

}  // namespace hexoderm
