#include "widgets/scene/overlay_meshes.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/patch_mesh.h"
#include "widgets/scene/polydata_builder.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkSphereSource.h>
#include <vtkTensorGlyph.h>
#include <array>

namespace hexoderm {
namespace {

// Parts of a cell's side length.
constexpr double kEllipsoidRoom = 0.8;  // the longest semi-axis
constexpr double kShiftRoom = 1.2;      // the longest arrow
constexpr double kDistanceRoom = 0.8;   // the longest distance line
constexpr double kLinkLineLift = 0.05;  // above the front faces
constexpr double kTreeLift = 0.035;     // below the links
constexpr double kDoubleApart = 0.035;  // distance of a double line's strokes from its middle
constexpr double kDash = 0.22;          // a dash and the gap behind it
constexpr double kDot = 0.09;
constexpr double kFrameDash = 0.5;  // of a frame about a patch
constexpr double kCross = 0.12;     // half of an excluded link's cross
constexpr double kGapRoom = 1.2;    // the arrow of a gap
constexpr double kGapArrowWidth = 0.12;
constexpr double kShiftArrowWidth = 0.09;

/// The two ends of a link in the scene; none if a cell or port is not there.
struct PlacedLink {
  const SceneCell* source;
  const SceneCell* target;
  Eigen::Vector3d source_port_u;
  Eigen::Vector3d target_port_u;
};

std::optional<PlacedLink> place(const SceneContent& content, const LinkEstimate& link) {
  const CellModel& model = *content.reconstruction->model;
  const SceneCell* source = content.layout.find(link.source.cell);
  const SceneCell* target = content.layout.find(link.target.cell);
  const Port* source_port = model.findPort(link.source.port);
  const Port* target_port = model.findPort(link.target.port);
  if (source == nullptr || target == nullptr || source_port == nullptr || target_port == nullptr) return std::nullopt;
  return PlacedLink{source, target, source_port->vector_m, target_port->vector_m};
}

/// Centre, port, port, centre; `lift` above the faces and `aside` to the left on the way from source to target.
std::array<Eigen::Vector3d, 4> wayOf(const PlacedLink& link, double lift, double aside) {
  const Eigen::Vector3d up(0, 0, lift);
  const Eigen::Vector3d left_source = aside * Eigen::Vector3d::UnitZ().cross(link.source_port_u.normalized()) + up;
  const Eigen::Vector3d left_target = -aside * Eigen::Vector3d::UnitZ().cross(link.target_port_u.normalized()) + up;
  return {link.source->T_s_u * left_source, link.source->T_s_u * (link.source_port_u + left_source),
          link.target->T_s_u * (link.target_port_u + left_target), link.target->T_s_u * left_target};
}

void addDashed(PolyDataBuilder& mesh, const std::array<Eigen::Vector3d, 4>& way, double period, double share,
               const Rgb& color) {
  double phase = 0;  // the pattern runs on from piece to piece
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    phase = mesh.addDashes(way.at(k), way.at(k + 1), period, share, color, phase);
  }
}

void addCross(PolyDataBuilder& mesh, const PlacedLink& link, double lift, double size, const Rgb& color) {
  const SE3& T = link.source->T_s_u;
  const Eigen::Vector3d middle = link.source_port_u + Eigen::Vector3d(0, 0, lift);
  for (const double sign : {1.0, -1.0}) {
    const Eigen::Vector3d arm(size, sign * size, 0);
    mesh.addLine({mesh.addPoint(T * (middle - arm)), mesh.addPoint(T * (middle + arm))}, color);
  }
}

/// The edges of a prism with these corners, as prismCorners() has them.
void addPrismEdges(PolyDataBuilder& mesh, const std::array<Eigen::Vector3d, 12>& corners) {
  const std::vector<vtkIdType> ids = mesh.addPoints(corners);
  for (std::size_t k = 0; k < 6; ++k) {
    const std::size_t next = (k + 1) % 6;
    mesh.addLine({ids[k], ids[next]});
    mesh.addLine({ids[k + 6], ids[next + 6]});
    mesh.addLine({ids[k], ids[k + 6]});
  }
}

void addArrow(PolyDataBuilder& mesh, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double width) {
  constexpr int kSegments = 10;
  const double length = (to - from).norm();
  if (length <= 0) return;
  const Eigen::Vector3d along = (to - from) / length;
  const Eigen::Vector3d u = along.unitOrthogonal();
  const Eigen::Vector3d v = along.cross(u);
  const double head = std::min(2.6 * width, 0.6 * length);
  const double radius = std::min(0.5 * width, 0.2 * head);
  // Rings: begin and end of the shaft, then the foot of the cone; their points in turns.
  const Eigen::Vector3d neck = to - head * along;
  const vtkIdType tail = mesh.addPoint(from, -along);
  const vtkIdType tip = mesh.addPoint(to, along);
  const vtkIdType first = mesh.pointCount();
  for (int k = 0; k < kSegments; ++k) {
    const double angle = 2 * kPi * k / kSegments;
    const Eigen::Vector3d out = std::cos(angle) * u + std::sin(angle) * v;
    mesh.addPoint(from + radius * out, out);
    mesh.addPoint(neck + radius * out, out);
    mesh.addPoint(neck + 2.6 * radius * out, (out + 0.4 * along).normalized());
  }
  for (vtkIdType k = 0; k < kSegments; ++k) {
    const vtkIdType here = first + 3 * k;
    const vtkIdType next = first + 3 * ((k + 1) % kSegments);
    mesh.addPolygon({here, next, next + 1, here + 1});
    mesh.addPolygon({here + 1, next + 1, next + 2, here + 2});
    mesh.addPolygon({here + 2, next + 2, tip});
    mesh.addPolygon({next, here, tail});
  }
}

}  // namespace

EnlargedShape makeEllipsoids(const SceneContent& content) {
  constexpr vtkIdType kFew = 300;
  const vtkNew<vtkPoints> centers;
  const vtkNew<vtkDoubleArray> stretches;  // of a ball, by columns
  stretches->SetNumberOfComponents(9);
  double largest = 0;
  for (std::size_t p = 0; p < content.reconstruction->patches.size(); ++p) {
    for (const CellPlacement& cell : content.reconstruction->patches[p].cells) {
      if (!cell.cov_t_r) continue;
      const Eigen::Matrix3d covariance = cell.cov_t_r->topLeftCorner<3, 3>();
      // No axis is shorter than a thousandth of the longest, nor is the ball mirrored, or it would be lit wrongly.
      Eigen::Matrix3d A = ellipsoid95(covariance + 1e-6 * covariance.trace() * Eigen::Matrix3d::Identity());
      if (A.determinant() < 0) A.col(0) *= -1;
      const double longest = A.col(2).norm();
      if (longest <= 0) continue;
      largest = std::max(largest, longest);
      const Eigen::Vector3d center = cell.T_o_u.t + content.layout.shifts[p];
      centers->InsertNextPoint(center.data());
      stretches->InsertNextTypedTuple(A.data());
    }
  }
  if (centers->GetNumberOfPoints() == 0) return {};
  EnlargedShape shape;
  shape.factor = enlargement(largest, kEllipsoidRoom * content.reconstruction->model->side_m);
  const vtkNew<vtkPolyData> placed;
  placed->SetPoints(centers);
  placed->GetPointData()->SetTensors(stretches);
  const int rings = centers->GetNumberOfPoints() <= kFew ? 10 : 6;
  const vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1);
  ball->SetPhiResolution(rings + 1);
  ball->SetThetaResolution(2 * rings);
  const vtkNew<vtkTensorGlyph> ellipsoids;
  ellipsoids->SetInputData(placed);
  ellipsoids->SetSourceConnection(ball->GetOutputPort());
  ellipsoids->ExtractEigenvaluesOff();
  ellipsoids->ColorGlyphsOff();
  ellipsoids->SetScaleFactor(shape.factor);
  ellipsoids->Update();
  shape.data = ellipsoids->GetOutput();
  return shape;
}

vtkSmartPointer<vtkPolyData> makePatchFrames(const SceneContent& content, const std::vector<std::size_t>& patches) {
  const double side_m = content.reconstruction->model->side_m;
  PolyDataBuilder mesh;
  for (const std::size_t patch : patches) {
    const std::array<Eigen::Vector3d, 8> corners = content.frameCorners(patch);
    for (unsigned from = 0; from < 8; ++from) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        const unsigned to = from | 1U << axis;
        if (to != from) mesh.addDashes(corners.at(from), corners.at(to), kFrameDash * side_m, 0.55);
      }
    }
  }
  return mesh.finish();
}

vtkSmartPointer<vtkPolyData> makeLinkLines(const SceneContent& content, const SceneColors& colors) {
  const double side_m = content.reconstruction->model->side_m;
  const double lift = kLinkLineLift * side_m;
  PolyDataBuilder mesh;
  for (const PatchReconstruction& patch : content.reconstruction->patches) {
    for (const LinkEstimate& link : patch.links) {
      const std::optional<PlacedLink> placed = place(content, link);
      if (!placed) continue;
      const Rgb& color = colors.link_line.at(static_cast<std::size_t>(link.quality));
      if (!link.used) {
        addDashed(mesh, wayOf(*placed, lift, 0), kDash * side_m, 0.5, colors.neutral);
        addCross(mesh, *placed, lift, kCross * side_m, colors.neutral);
      } else if (link.quality == EdgeQuality::Undefined) {
        addDashed(mesh, wayOf(*placed, lift, 0), kDot * side_m, 0.4, color);
      } else if (link.quality == EdgeQuality::Partially) {
        addDashed(mesh, wayOf(*placed, lift, 0), kDash * side_m, 0.65, color);
      } else if (link.quality == EdgeQuality::Fully) {
        mesh.addLine(mesh.addPoints(wayOf(*placed, lift, 0)), color);
      } else {
        for (const double aside : {kDoubleApart * side_m, -kDoubleApart * side_m}) {
          mesh.addLine(mesh.addPoints(wayOf(*placed, lift, aside)), color);
        }
      }
    }
  }
  return mesh.finish();
}

vtkSmartPointer<vtkPolyData> makeTreeLines(const SceneContent& content) {
  PolyDataBuilder mesh;
  for (const PatchReconstruction& patch : content.reconstruction->patches) {
    for (const LinkEstimate& link : patch.links) {
      if (!link.used || !link.in_tree) continue;
      const std::optional<PlacedLink> placed = place(content, link);
      if (!placed) continue;
      mesh.addLine(mesh.addPoints(wayOf(*placed, kTreeLift * content.reconstruction->model->side_m, 0)));
    }
  }
  return mesh.finish();
}

vtkSmartPointer<vtkPolyData> makeGhostOutlines(const SceneContent& content, const std::vector<AlignedCell>& cells) {
  PolyDataBuilder mesh;
  for (const AlignedCell& cell : cells) {
    auto corners = prismCorners(*content.reconstruction->model, cell.T_o_u);
    for (Eigen::Vector3d& corner : corners) corner += content.layout.shifts[cell.patch];
    addPrismEdges(mesh, corners);
  }
  return mesh.finish();
}

vtkSmartPointer<vtkPolyData> makeCellOutlines(const SceneContent& content, std::initializer_list<CellId> cells) {
  constexpr double kOutside = 1.015;
  PolyDataBuilder mesh;
  for (const CellId cell : cells) {
    const SceneCell* found = content.layout.find(cell);
    if (found == nullptr) continue;
    auto corners = prismCorners(*content.reconstruction->model, found->T_s_u);
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : corners) center += corner / static_cast<double>(corners.size());
    for (Eigen::Vector3d& corner : corners) corner = center + kOutside * (corner - center);
    addPrismEdges(mesh, corners);
  }
  return mesh.finish();
}

vtkSmartPointer<vtkPolyData> makeSurfaceSheet(const SceneContent& content, const SurfaceMesh& mesh, std::size_t patch) {
  const Eigen::Vector3d& shift = content.layout.shifts[patch];
  PolyDataBuilder builder;
  for (std::size_t k = 0; k < mesh.points.size(); ++k) builder.addPoint(mesh.points[k] + shift, mesh.normals[k]);
  const auto columns = static_cast<vtkIdType>(mesh.columns);
  for (vtkIdType row = 0; row + 1 < static_cast<vtkIdType>(mesh.rows); ++row) {
    for (vtkIdType column = 0; column + 1 < columns; ++column) {
      const vtkIdType corner = row * columns + column;
      builder.addPolygon({corner, corner + 1, corner + columns + 1, corner + columns});
    }
  }
  return builder.finish();
}

EnlargedShape makeDistanceLines(const SceneContent& content, const SurfaceMesh& mesh, std::size_t patch) {
  const Eigen::Vector3d& shift = content.layout.shifts[patch];
  double largest = 0;
  for (std::size_t k = 0; k < mesh.feet.size(); ++k) {
    largest = std::max(largest, (mesh.centers[k] - mesh.feet[k]).norm());
  }
  EnlargedShape shape;
  shape.factor = enlargement(largest, kDistanceRoom * content.reconstruction->model->side_m);
  PolyDataBuilder builder;
  for (std::size_t k = 0; k < mesh.feet.size(); ++k) {
    const Eigen::Vector3d foot = mesh.feet[k] + shift;
    const Eigen::Vector3d end = foot + shape.factor * (mesh.centers[k] - mesh.feet[k]);
    builder.addLine({builder.addPoint(foot), builder.addPoint(end)});
  }
  shape.data = builder.finish();
  return shape;
}

EnlargedShape makeShiftArrows(const SceneContent& content, const std::vector<CellShift>& shifts,
                              std::optional<double> factor) {
  const double side_m = content.reconstruction->model->side_m;
  double largest = 0;
  for (const CellShift& shift : shifts) largest = std::max(largest, (shift.now_o - shift.before_o).norm());
  EnlargedShape shape;
  shape.factor = factor.value_or(enlargement(largest, kShiftRoom * side_m));
  PolyDataBuilder mesh;
  for (const CellShift& shift : shifts) {
    const Eigen::Vector3d now = shift.now_o + content.layout.shifts[shift.patch];
    addArrow(mesh, now + shape.factor * (shift.before_o - shift.now_o), now, kShiftArrowWidth * side_m);
  }
  shape.data = mesh.finish();
  return shape;
}

EnlargedShape makeGapArrow(const SceneContent& content, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double side_m = content.reconstruction->model->side_m;
  EnlargedShape shape;
  shape.factor = enlargement((to - from).norm(), kGapRoom * side_m);
  const Eigen::Vector3d middle = 0.5 * (from + to);
  PolyDataBuilder mesh;
  addArrow(mesh, middle + shape.factor * (from - middle), middle + shape.factor * (to - middle),
           kGapArrowWidth * side_m);
  shape.data = mesh.finish();
  return shape;
}

vtkSmartPointer<vtkPolyData> makeLine(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  PolyDataBuilder mesh;
  mesh.addLine({mesh.addPoint(a), mesh.addPoint(b)});
  return mesh.finish();
}

}  // namespace hexoderm
