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
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace hexoderm {

/// A colour as OpenGL takes it.
inline std::array<unsigned char, 3> toBytes(const Rgb& color) {
  std::array<unsigned char, 3> bytes{};
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    bytes.at(k) = static_cast<unsigned char>(std::lround(255.0 * std::clamp(color.at(k), 0.0, 1.0)));
  }
  return bytes;
}

/// Collects points, lines and polygons for one vtkPolyData. Colours go with lines and polygons, normals with points;
/// either all of them have one or none.
class PolyDataBuilder {
 public:
  PolyDataBuilder() {
    colors_->SetNumberOfComponents(3);
    normals_->SetNumberOfComponents(3);
  }

  vtkIdType addPoint(const Eigen::Vector3d& p) { return points_->InsertNextPoint(p.x(), p.y(), p.z()); }
  vtkIdType addPoint(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) {
    normals_->InsertNextTuple3(normal.x(), normal.y(), normal.z());
    return addPoint(p);
  }
  void addLine(const std::vector<vtkIdType>& ids, const std::optional<Rgb>& color = std::nullopt) {
    add(lines_, ids, color);
  }
  void addPolygon(const std::vector<vtkIdType>& ids, const std::optional<Rgb>& color = std::nullopt) {
    add(polygons_, ids, color);
  }
  /// The IDs of these points, for addLine() or addPolygon().
  template <class Points>
  [[nodiscard]] std::vector<vtkIdType> addPoints(const Points& points) {
    std::vector<vtkIdType> ids;
    for (const Eigen::Vector3d& point : points) ids.push_back(addPoint(point));
    return ids;
  }
  /// Dashes, each a line of its own, because OpenGL draws none: `share` of each `period` is drawn. `phase` of the first
  /// one is left out; returns that of a piece that continues this one.
  double addDashes(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double period, double share,
                   const std::optional<Rgb>& color = std::nullopt, double phase = 0) {
    const double length = (to - from).norm();
    if (length <= 0) return phase;
    const Eigen::Vector3d along = (to - from) / length;
    double at = -phase;
    for (; at < length; at += period) {
      const double begin = std::max(at, 0.0);
      const double end = std::min(at + share * period, length);
      if (end > begin) addLine({addPoint(from + begin * along), addPoint(from + end * along)}, color);
    }
    return length - (at - period);
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
  void add(vtkCellArray* cells, const std::vector<vtkIdType>& ids, const std::optional<Rgb>& color) {
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    if (color) colors_->InsertNextTypedTuple(toBytes(*color).data());
  }

  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> lines_;
  vtkNew<vtkCellArray> polygons_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkFloatArray> normals_;
};

}  // namespace hexoderm
