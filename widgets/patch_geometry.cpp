#include "widgets/patch_geometry.h"

#include "hexoderm/reconstruction/patch_mesh.h"
#include "hexoderm/util/units.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace hexoderm {
namespace {

constexpr std::size_t kSides = 6;
constexpr std::size_t kPointsPerCell = 2 * kSides;
constexpr double kSideShade = 0.70;       // of the front face's colour
constexpr double kMarkLift = 0.015;       // of the side length, so that marks lie on the face and not in it
constexpr double kPortInset = 0.86;       // of the extended port vector: on the face, beside the gap
constexpr double kPortRadius = 0.075;     // of the side length
constexpr double kPortRingWidth = 0.4;    // of the radius
constexpr double kOriginRadius = 0.42;    // of the side length
constexpr double kOriginRingWidth = 0.1;  // of the radius
constexpr double kLinkLift = 0.07;        // of the side length

vtkSmartPointer<vtkPoints> makePoints() {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToFloat();
  return points;
}

void append(vtkPoints* points, const Eigen::Vector3d& p) { points->InsertNextPoint(p.x(), p.y(), p.z()); }

void append(vtkUnsignedCharArray* colors, const Rgb& color) {
  for (double value : color) {
    colors->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * std::clamp(value, 0.0, 1.0))));
  }
}

vtkSmartPointer<vtkUnsignedCharArray> makeColors() {
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("colors");
  colors->SetNumberOfComponents(3);
  return colors;
}

/// Collects flat rings and discs.
class MarkBuilder {
 public:
  /// In the xy plane of the cell at `center`; `inner` 0 makes a disc.
  void addRing(const SE3& T_s_u, const Eigen::Vector3d& center, double inner, double outer, const Rgb& color) {
    constexpr int kSegments = 24;
    const vtkIdType first = points_->GetNumberOfPoints();
    for (int k = 0; k < kSegments; ++k) {
      const double angle = 2 * kPi * k / kSegments;
      const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0);
      append(points_, T_s_u * (center + outer * direction));
      if (inner > 0) append(points_, T_s_u * (center + inner * direction));
    }
    if (inner > 0) {
      for (vtkIdType k = 0; k < kSegments; ++k) {
        const vtkIdType next = (k + 1) % kSegments;
        addPolygon({first + 2 * k, first + 2 * next, first + 2 * next + 1, first + 2 * k + 1}, color);
      }
    } else {
      std::vector<vtkIdType> disc(kSegments);
      for (vtkIdType k = 0; k < kSegments; ++k) disc[static_cast<std::size_t>(k)] = first + k;
      addPolygon(disc, color);
    }
  }

  vtkSmartPointer<vtkPolyData> finish() {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetPolys(polygons_);
    data->GetCellData()->SetScalars(colors_);
    return data;
  }

 private:
  void addPolygon(const std::vector<vtkIdType>& ids, const Rgb& color) {
    polygons_->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    append(colors_, color);
  }

  vtkSmartPointer<vtkPoints> points_ = makePoints();
  vtkSmartPointer<vtkCellArray> polygons_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkUnsignedCharArray> colors_ = makeColors();
};

/// Smallest class or largest deviation of the used links at each cell.
struct WorstLink {
  EdgeQuality quality = EdgeQuality::Over;
  double sigma_rad = 0;
};

std::unordered_map<CellId, WorstLink> worstLinks(const PatchReconstruction& patch) {
  std::unordered_map<CellId, WorstLink> worst;
  for (const LinkEstimate& link : patch.links) {
    if (!link.used) continue;
    for (const CellId cell : {link.source.cell, link.target.cell}) {
      WorstLink& entry = worst[cell];
      entry.quality = std::min(entry.quality, link.quality);
      entry.sigma_rad = std::max(entry.sigma_rad, link.sigma_rad);
    }
  }
  return worst;
}

const SceneCell* findSceneCell(const SceneLayout& layout, CellId id) {
  const auto found = std::ranges::find(layout.cells, id, &SceneCell::id);
  return found == layout.cells.end() ? nullptr : &*found;
}

}  // namespace

SceneLayout layOutScene(const Reconstruction& reconstruction) {
  SceneLayout layout;
  layout.points = makePatchMesh(reconstruction).points;
  const double between_m = 2 * reconstruction.model->side_m;
  double next_x = 0;
  std::size_t first_point = 0;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    const std::size_t end_point = first_point + kPointsPerCell * patch.cells.size();
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    if (end_point > first_point) {
      const auto by_x = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.x() < b.x(); };
      const auto range = std::minmax_element(layout.points.begin() + static_cast<std::ptrdiff_t>(first_point),
                                             layout.points.begin() + static_cast<std::ptrdiff_t>(end_point), by_x);
      // The first patch stays in its own frame.
      if (first_point > 0) shift.x() = next_x - range.first->x();
      next_x = range.second->x() + shift.x() + between_m;
    }
    for (; first_point < end_point; ++first_point) layout.points[first_point] += shift;
    for (const CellPlacement& cell : patch.cells) {
      layout.cells.push_back({cell.cell, {cell.T_o_u.R, cell.T_o_u.t + shift}, cell.cell == patch.origin});
    }
  }
  return layout;
}

std::vector<Rgb> cellColors(const Reconstruction& reconstruction, CellColoring coloring, const SceneColors& colors) {
  std::vector<Rgb> result;
  for (std::size_t k = 0; k < reconstruction.patches.size(); ++k) {
    const PatchReconstruction& patch = reconstruction.patches[k];
    const auto worst = worstLinks(patch);
    for (const CellPlacement& cell : patch.cells) {
      const auto found = worst.find(cell.cell);
      if (coloring == CellColoring::Patch) {
        result.push_back(patchColor(colors, k, reconstruction.patches.size()));
      } else if (found == worst.end()) {
        result.push_back(colors.neutral);
      } else if (coloring == CellColoring::Deviation) {
        result.push_back(onScale(colors.scale, toDegrees(found->second.sigma_rad) / kDeviationScaleEnd_deg));
      } else {
        result.push_back(colors.quality.at(static_cast<std::size_t>(found->second.quality)));
      }
    }
  }
  return result;
}

PrismData makePrisms(const SceneLayout& layout, const std::vector<Rgb>& front_colors, bool front_faces_only) {
  auto points = makePoints();
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  auto colors = makeColors();
  PrismData data;
  for (const Eigen::Vector3d& point : layout.points) append(points, point);
  const auto add = [&](std::size_t cell, const std::vector<vtkIdType>& ids, const Rgb& color) {
    polygons->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    append(colors, color);
    data.cell_of_polygon.push_back(cell);
  };
  for (std::size_t cell = 0; cell < layout.cells.size(); ++cell) {
    const auto first = static_cast<vtkIdType>(kPointsPerCell * cell);
    const Rgb& color = front_colors[cell];
    add(cell, {first, first + 1, first + 2, first + 3, first + 4, first + 5}, color);
    if (front_faces_only) continue;
    const Rgb shade = mixed({0, 0, 0}, color, kSideShade);
    add(cell, {first + 11, first + 10, first + 9, first + 8, first + 7, first + 6}, shade);
    for (vtkIdType k = 0; k < static_cast<vtkIdType>(kSides); ++k) {
      const vtkIdType next = (k + 1) % static_cast<vtkIdType>(kSides);
      add(cell, {first + next, first + k, first + 6 + k, first + 6 + next}, shade);
    }
  }
  data.surface = vtkSmartPointer<vtkPolyData>::New();
  data.surface->SetPoints(points);
  data.surface->SetPolys(polygons);
  data.surface->GetCellData()->SetScalars(colors);
  return data;
}

vtkSmartPointer<vtkPolyData> makeMarks(const Reconstruction& reconstruction, const SceneLayout& layout,
                                       const std::vector<Rgb>& front_colors, const SceneColors& colors) {
  const CellModel& model = *reconstruction.model;
  const double side_m = model.side_m;
  std::unordered_map<CellId, std::unordered_set<PortNumber>> linked;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      if (!link.used) continue;
      linked[link.source.cell].insert(link.source.port);
      linked[link.target.cell].insert(link.target.port);
    }
  }
  const Eigen::Vector3d lift(0, 0, kMarkLift * side_m);
  const double radius_m = kPortRadius * side_m;
  MarkBuilder builder;
  for (std::size_t k = 0; k < layout.cells.size(); ++k) {
    const SceneCell& cell = layout.cells[k];
    const Rgb& mark = markOn(front_colors[k], colors);
    for (const Port& port : model.ports) {
      const bool joined = linked[cell.id].contains(port.number);
      builder.addRing(cell.T_s_u, kPortInset * port.vector_m + lift, joined ? 0 : (1 - kPortRingWidth) * radius_m,
                      radius_m, joined ? mark : mixed(mark, front_colors[k], 0.35));
    }
    if (cell.origin) {
      const double origin_m = kOriginRadius * side_m;
      builder.addRing(cell.T_s_u, lift, (1 - kOriginRingWidth) * origin_m, origin_m, mark);
    }
  }
  return builder.finish();
}

vtkSmartPointer<vtkPolyData> makeCellOutline(const SceneLayout& layout, std::size_t cell) {
  constexpr double kOutside = 1.015;
  const auto first = layout.points.begin() + static_cast<std::ptrdiff_t>(kPointsPerCell * cell);
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < kPointsPerCell; ++k) center += *(first + static_cast<std::ptrdiff_t>(k));
  center /= static_cast<double>(kPointsPerCell);
  auto points = makePoints();
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  for (std::size_t k = 0; k < kPointsPerCell; ++k) {
    append(points, center + kOutside * (*(first + static_cast<std::ptrdiff_t>(k)) - center));
  }
  for (vtkIdType k = 0; k < 6; ++k) {
    const vtkIdType next = (k + 1) % 6;
    for (const auto& [from, to] : {std::pair(k, next), std::pair(k + 6, next + 6), std::pair(k, k + 6)}) {
      lines->InsertNextCell({from, to});
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

vtkSmartPointer<vtkPolyData> makeLinkStroke(const Reconstruction& reconstruction, const SceneLayout& layout, LinkEnd a,
                                            LinkEnd b) {
  auto points = makePoints();
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  const Eigen::Vector3d lift(0, 0, kLinkLift * reconstruction.model->side_m);
  const SceneCell* cell_a = findSceneCell(layout, a.cell);
  const SceneCell* cell_b = findSceneCell(layout, b.cell);
  const Port* port_a = reconstruction.model->findPort(a.port);
  const Port* port_b = reconstruction.model->findPort(b.port);
  if (cell_a && cell_b && port_a && port_b) {
    append(points, cell_a->T_s_u * lift);
    append(points, cell_a->T_s_u * (port_a->vector_m + lift));
    append(points, cell_b->T_s_u * (port_b->vector_m + lift));
    append(points, cell_b->T_s_u * lift);
    lines->InsertNextCell({0, 1, 2, 3});
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

}  // namespace hexoderm
