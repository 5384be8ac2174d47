#include "widgets/scene/scene_content.h"

#include "hexoderm/solve/metrics/patch_mesh.h"
#include "widgets/scene/polydata_builder.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <algorithm>
#include <cmath>
#include <span>

namespace hexoderm {
namespace {

constexpr vtkIdType kSides = 6;

/// Sets the boxes beside that of the largest patch, `between_m` apart, and returns by how much each has moved: in
/// columns from top to bottom, about as high as the largest patch or, if there are many, as all of them in a square.
std::vector<Eigen::Vector3d> setBeside(std::vector<Eigen::AlignedBox3d>& boxes, std::size_t largest, double between_m) {
  std::vector<Eigen::Vector3d> shifts(boxes.size(), Eigen::Vector3d::Zero());
  if (boxes.size() < 2 || boxes[largest].isEmpty()) return shifts;
  const Eigen::AlignedBox3d& fixed = boxes[largest];
  double area = 0;
  for (std::size_t p = 0; p < boxes.size(); ++p) {
    if (p == largest || boxes[p].isEmpty()) continue;
    area += (boxes[p].sizes().x() + between_m) * (boxes[p].sizes().y() + between_m);
  }
  const double height = std::max(fixed.sizes().y(), std::sqrt(area));
  const double top = fixed.max().y();
  double left = fixed.max().x() + between_m;
  double right = left;
  double next = top;
  for (std::size_t p = 0; p < boxes.size(); ++p) {
    if (p == largest || boxes[p].isEmpty()) continue;
    const Eigen::Vector3d size = boxes[p].sizes();
    if (next < top && next - size.y() < top - height) {
      left = right + between_m;
      next = top;
    }
    shifts[p] = Eigen::Vector3d(left, next, fixed.center().z()) -
                Eigen::Vector3d(boxes[p].min().x(), boxes[p].max().y(), boxes[p].center().z());
    boxes[p].translate(shifts[p]);
    right = std::max(right, boxes[p].max().x());
    next -= size.y() + between_m;
  }
  return shifts;
}

SceneLayout layOut(const Reconstruction& reconstruction, bool prisms) {
  SceneLayout layout;
  layout.points = cellCorners(reconstruction, prisms ? CellCorners::Prism : CellCorners::Front);
  layout.cells.reserve(reconstruction.cellCount());
  layout.index.reserve(reconstruction.cellCount());
  const std::size_t per_cell = static_cast<std::size_t>(kSides) * (prisms ? 2 : 1);
  layout.boxes.resize(reconstruction.patches.size());
  if (const PatchReconstruction* largest = largestPatch(reconstruction)) {
    layout.largest = static_cast<std::size_t>(largest - reconstruction.patches.data());
  }
  std::size_t point = 0;
  for (std::size_t p = 0; p < reconstruction.patches.size(); ++p) {
    const std::size_t end = point + per_cell * reconstruction.patches[p].cells.size();
    for (; point < end; ++point) layout.boxes[p].extend(layout.points[point]);
  }
  layout.shifts = setBeside(layout.boxes, layout.largest, 2 * reconstruction.model->side_m);
  point = 0;
  for (std::size_t p = 0; p < reconstruction.patches.size(); ++p) {
    const PatchReconstruction& patch = reconstruction.patches[p];
    const Eigen::Vector3d& shift = layout.shifts[p];
    for (const CellPlacement& cell : patch.cells) {
      layout.index.emplace(cell.cell, layout.cells.size());
      layout.cells.push_back({cell.cell, {cell.T_o_u.R, cell.T_o_u.t + shift}, p, cell.cell == patch.origin});
      for (std::size_t k = 0; k < per_cell; ++k) layout.points[point++] += shift;
    }
  }
  return layout;
}

vtkSmartPointer<vtkPoints> makePoints(const std::vector<Eigen::Vector3d>& points) {
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  float* out = coordinates->GetPointer(0);
  for (const Eigen::Vector3d& point : points) {
    for (int k = 0; k < 3; ++k) *out++ = static_cast<float>(point[k]);
  }
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetData(coordinates);
  return result;
}

vtkSmartPointer<vtkPolyData> makeBackMarks(const SceneLayout& layout, double side_m) {
  constexpr double kShare = 0.6;
  constexpr double kLift = 0.015;  // share of the side
  PolyDataBuilder mesh;
  for (std::size_t cell = 0; cell < layout.cells.size(); ++cell) {
    const std::span<const Eigen::Vector3d> back(&layout.points[2 * kSides * cell + kSides], kSides);
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : back) center += corner / kSides;
    const Eigen::Vector3d lift = -kLift * side_m * layout.cells[cell].T_s_u.R.col(2);
    std::vector<Eigen::Vector3d> corners;
    for (const Eigen::Vector3d& corner : back) corners.push_back(center + kShare * (corner - center) + lift);
    std::ranges::reverse(corners);
    mesh.addPolygon(mesh.addPoints(corners));
  }
  return mesh.finish();
}

/// `Points` points a cell with its normal, cut into triangles.
template <std::size_t Points, std::size_t Corners>
vtkSmartPointer<vtkPolyData> makeFaces(const SceneLayout& layout, const std::vector<Eigen::Vector3d>& points,
                                       const std::array<vtkIdType, Corners>& corners_of_cell) {
  const auto count = static_cast<vtkIdType>(layout.cells.size());
  constexpr auto kPoints = static_cast<vtkIdType>(Points);
  constexpr auto kCorners = static_cast<vtkIdType>(Corners);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(kPoints * count);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(kCorners / 3 * count + 1);
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(kCorners * count);
  float* normal = normals->GetPointer(0);
  vtkIdType* corner = corners->GetPointer(0);
  for (vtkIdType cell = 0; cell < count; ++cell) {
    const Eigen::Vector3f n = layout.cells[static_cast<std::size_t>(cell)].T_s_u.R.col(2).cast<float>();
    for (vtkIdType k = 0; k < kPoints; ++k) {
      for (int axis = 0; axis < 3; ++axis) *normal++ = n[axis];
    }
    for (const vtkIdType k : corners_of_cell) *corner++ = kPoints * cell + k;
  }
  for (vtkIdType k = 0; k <= kCorners / 3 * count; ++k) offsets->SetValue(k, 3 * k);
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, corners);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(makePoints(points));
  data->SetPolys(triangles);
  data->GetPointData()->SetNormals(normals);
  return data;
}

vtkSmartPointer<vtkPolyData> makeFrontFaces(const SceneLayout& layout) {
  constexpr std::array<vtkIdType, 12> kTriangles = {0, 1, 2, 0, 2, 3, 0, 3, 5, 3, 4, 5};
  return makeFaces<kSides>(layout, layout.points, kTriangles);
}

/// Two opposite sides made half as long again: 1.5 sides by the hexagon's width is the hexagon's area, and rows of them
/// close as rows of hexagons do.
vtkSmartPointer<vtkPolyData> makeBricks(const SceneLayout& layout) {
  constexpr double kHalfSide = 0.75;
  constexpr std::array<vtkIdType, 6> kTriangles = {0, 1, 2, 0, 2, 3};
  std::vector<Eigen::Vector3d> points;
  points.reserve(4 * layout.cells.size());
  for (std::size_t first = 0; first < layout.points.size(); first += kSides) {
    for (const std::size_t side : {0, 3}) {
      const Eigen::Vector3d& a = layout.points[first + side];
      const Eigen::Vector3d& b = layout.points[first + side + 1];
      const Eigen::Vector3d middle = 0.5 * (a + b);
      points.emplace_back(middle - kHalfSide * (b - a));
      points.emplace_back(middle + kHalfSide * (b - a));
    }
  }
  return makeFaces<4>(layout, points, kTriangles);
}

}  // namespace

vtkSmartPointer<vtkPolyData> makePrisms(const SceneLayout& layout) {
  vtkNew<vtkCellArray> polygons;
  const auto count = static_cast<vtkIdType>(layout.cells.size());
  polygons->AllocateExact(8 * count, 36 * count);
  for (vtkIdType cell = 0; cell < count; ++cell) {
    const vtkIdType first = 2 * kSides * cell;
    polygons->InsertNextCell({first, first + 1, first + 2, first + 3, first + 4, first + 5});
    polygons->InsertNextCell({first + 11, first + 10, first + 9, first + 8, first + 7, first + 6});
    for (vtkIdType k = 0; k < kSides; ++k) {
      const vtkIdType next = (k + 1) % kSides;
      polygons->InsertNextCell({first + next, first + k, first + kSides + k, first + kSides + next});
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(makePoints(layout.points));
  data->SetPolys(polygons);
  return data;
}

std::shared_ptr<const SceneContent> makeSceneContent(std::shared_ptr<const Reconstruction> reconstruction) {
  if (!reconstruction) return nullptr;
  auto content = std::make_shared<SceneContent>();
  content->reconstruction = std::move(reconstruction);
  const Reconstruction& r = *content->reconstruction;
  content->prisms = r.cellCount() <= SceneContent::kMaxPrismCells;
  content->layout = layOut(r, content->prisms);
  content->figures = makeCellMetrics(r);
  content->signs = signsOf(r);
  content->links = CellLinks(r);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : content->layout.points) box.extend(point);
  content->extent_m = box.isEmpty() ? 0 : box.diagonal().norm();
  content->surface = content->prisms ? makePrisms(content->layout) : makeFrontFaces(content->layout);
  if (content->prisms) {
    content->backs = makeBackMarks(content->layout, r.model->side_m);
  } else {
    content->bricks = makeBricks(content->layout);
  }
  content->locator->SetDataSet(content->surface);
  if (!content->layout.cells.empty()) content->locator->BuildLocator();
  return content;
}

}  // namespace hexoderm
