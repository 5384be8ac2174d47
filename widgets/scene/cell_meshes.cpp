#include "widgets/scene/cell_meshes.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/patch_mesh.h"
#include "widgets/scene/polydata_builder.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace hexoderm {
namespace {

constexpr double kMarkLift = 0.015;       // share of the side length, so that marks lie on the face and not in it
constexpr double kPortInset = 0.86;       // share of the extended port vector: on the face, beside the gap
constexpr double kPortRadius = 0.075;     // share of the side length
constexpr double kPortRingWidth = 0.4;    // share of the radius
constexpr double kOriginRadius = 0.42;    // share of the side length
constexpr double kOriginRingWidth = 0.1;  // share of the radius

/// A flat ring in the xy plane of the cell at `center`; `inner` 0 makes a disc.
void addRing(PolyDataBuilder& mesh, const SE3& T_s_u, const Eigen::Vector3d& center, double inner, double outer,
             const Rgb& color) {
  constexpr std::size_t kSegments = 24;
  const auto circle = [&](double radius) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t k = 0; k < kSegments; ++k) {
      const double angle = 2 * kPi * static_cast<double>(k) / kSegments;
      points.push_back(T_s_u * (center + radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0)));
    }
    return mesh.addPoints(points);
  };
  const std::vector<vtkIdType> around = circle(outer);
  if (inner == 0) return mesh.addPolygon(around, color);
  const std::vector<vtkIdType> within = circle(inner);
  for (std::size_t k = 0; k < kSegments; ++k) {
    const std::size_t next = (k + 1) % kSegments;
    mesh.addPolygon({around[k], around[next], within[next], within[k]}, color);
  }
}

/// Ports that used links join, by cell.
std::unordered_map<CellId, std::unordered_set<PortNumber>> joinedPorts(const Reconstruction& reconstruction) {
  std::unordered_map<CellId, std::unordered_set<PortNumber>> joined;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      if (!link.used) continue;
      joined[link.source.cell].insert(link.source.port);
      joined[link.target.cell].insert(link.target.port);
    }
  }
  return joined;
}

/// Colours of points are the fastest to draw.
vtkSmartPointer<vtkPolyData> withPointColors(vtkPolyData* faces, std::size_t points_per_cell,
                                             const std::vector<Rgb>& front_colors) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->ShallowCopy(faces);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(points_per_cell * front_colors.size()));
  unsigned char* out = front_colors.empty() ? nullptr : colors->GetPointer(0);
  for (const Rgb& color : front_colors) {
    const auto bytes = toBytes(color);
    for (std::size_t k = 0; k < points_per_cell; ++k) out = std::ranges::copy(bytes, out).out;
  }
  data->GetPointData()->SetScalars(colors);
  return data;
}

}  // namespace

Rgb backGrey(const SceneColors& colors) { return mixed(colors.neutral, colors.edge, 0.35); }

vtkSmartPointer<vtkPolyData> makeColoredSurface(const SceneContent& content, const std::vector<Rgb>& front_colors,
                                                const SceneColors& scene_colors) {
  if (!content.prisms) return withPointColors(content.surface, 6, front_colors);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->ShallowCopy(content.surface);
  const std::size_t per_cell = content.polygonsPerCell();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(per_cell * front_colors.size()));
  unsigned char* out = front_colors.empty() ? nullptr : colors->GetPointer(0);
  for (const Rgb& color : front_colors) {
    const auto front = toBytes(color);
    const auto back = toBytes(mixed({0, 0, 0}, mixed(color, backGrey(scene_colors), kBackGrey), kUndersideShade));
    const auto side = toBytes(mixed({0, 0, 0}, color, kUndersideShade));
    for (std::size_t k = 0; k < per_cell; ++k) out = std::ranges::copy(k == 0 ? front : k == 1 ? back : side, out).out;
  }
  // The polygons of a prism share their points.
  data->GetCellData()->SetScalars(colors);
  return data;
}

vtkSmartPointer<vtkPolyData> makeColoredBricks(const SceneContent& content, const std::vector<Rgb>& front_colors) {
  return withPointColors(content.bricks, 4, front_colors);
}

vtkSmartPointer<vtkPolyData> makePortMarks(const SceneContent& content, const std::vector<Rgb>& front_colors,
                                           const SceneColors& colors) {
  const CellModel& model = *content.reconstruction->model;
  const auto joined = joinedPorts(*content.reconstruction);
  const Eigen::Vector3d lift(0, 0, kMarkLift * model.side_m);
  const double radius_m = kPortRadius * model.side_m;
  PolyDataBuilder mesh;
  for (std::size_t k = 0; k < content.layout.cells.size(); ++k) {
    const SceneCell& cell = content.layout.cells[k];
    const auto ports = joined.find(cell.id);
    const Rgb& mark = markOn(front_colors[k], colors);
    for (const Port& port : model.ports) {
      const bool is_joined = ports != joined.end() && ports->second.contains(port.number);
      addRing(mesh, cell.T_s_u, kPortInset * port.vector_m + lift, is_joined ? 0 : (1 - kPortRingWidth) * radius_m,
              radius_m, is_joined ? mark : mixed(mark, front_colors[k], 0.35));
    }
  }
  return mesh.finish();
}

vtkSmartPointer<vtkPolyData> makeOriginMarks(const SceneContent& content, const std::vector<Rgb>& front_colors,
                                             const SceneColors& colors) {
  const double side_m = content.reconstruction->model->side_m;
  const double radius_m = kOriginRadius * side_m;
  PolyDataBuilder mesh;
  for (std::size_t k = 0; k < content.layout.cells.size(); ++k) {
    const SceneCell& cell = content.layout.cells[k];
    if (!cell.origin) continue;
    addRing(mesh, cell.T_s_u, {0, 0, kMarkLift * side_m}, (1 - kOriginRingWidth) * radius_m, radius_m,
            markOn(front_colors[k], colors));
  }
  return mesh.finish();
}

}  // namespace hexoderm
