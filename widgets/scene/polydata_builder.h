#pragma once

#include "widgets/style/scene_colors.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace hexoderm {

/// Collects points, lines and polygons for one vtkPolyData. Colours go with lines and polygons, normals with points;
/// either all of them have one or none.
class PolyDataBuilder {
 public:
  vtkIdType addPoint(const Eigen::Vector3d& p) { return points_->InsertNextPoint(p.x(), p.y(), p.z()); }
  vtkIdType addPoint(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) {
    normals_->InsertNextTuple3(normal.x(), normal.y(), normal.z());
    return addPoint(p);
  }
  void addLine(std::initializer_list<vtkIdType> ids) { lines_->InsertNextCell(ids); }
  void addLine(std::initializer_list<vtkIdType> ids, const Rgb& color) {
    addLine(ids);
    addColor(color);
  }
  void addPolygon(std::initializer_list<vtkIdType> ids) { polygons_->InsertNextCell(ids); }
  void addPolygon(std::initializer_list<vtkIdType> ids, const Rgb& color) {
    addPolygon(ids);
    addColor(color);
  }
  void addPolygon(const std::vector<vtkIdType>& ids, const Rgb& color) {
    polygons_->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    addColor(color);
  }
  [[nodiscard]] vtkIdType pointCount() const { return points_->GetNumberOfPoints(); }

  vtkSmartPointer<vtkPolyData> finish() {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetLines(lines_);
    data->SetPolys(polygons_);
    if (colors_->GetNumberOfTuples() > 0) data->GetCellData()->SetScalars(colors_);
    if (normals_->GetNumberOfTuples() > 0) data->GetPointData()->SetNormals(normals_);
    return data;
  }

 private:
  void addColor(const Rgb& color) {
    if (colors_->GetNumberOfComponents() != 3) colors_->SetNumberOfComponents(3);
    for (const double value : color) {
      colors_->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * std::clamp(value, 0.0, 1.0))));
    }
  }

  vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkCellArray> lines_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkCellArray> polygons_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkUnsignedCharArray> colors_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
  vtkSmartPointer<vtkFloatArray> normals_ = [] {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfComponents(3);
    return array;
  }();
};

}  // namespace hexoderm
