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

// What the signs of findings are made of.

// Shares of a cell's side.
constexpr double kSignLift = 0.02;    // above the face, and above ports
constexpr double kFreeMiddle = 0.44;  // radius that the ID and the origin's ring take
constexpr double kStripe = 0.055;     // width
constexpr double kStripesApart = 0.19;
constexpr double kCrossBar = 0.15;  // width of a cross's bar
constexpr double kBarEnd = 0.93;    // distance of its end from the middle
constexpr double kTriangle = 0.80;  // from the middle to its corners
constexpr double kTriangleBar = 0.11;
constexpr double kDisc = 0.22;    // radius of a link's disc
constexpr double kDiscAt = 0.72;  // share of the way to the port
constexpr double kHatch = 0.30;   // share of the face's own colour in a stripe

/// Draws in the plane of one face; x points to a corner of the hexagon, lengths are in sides.
class FacePainter {
 public:
  FacePainter(PolyDataBuilder& mesh, const SceneCell& cell, const CellModel& model, bool back)
      : mesh_(mesh), side_m_(model.side_m), T_(cell.T_s_u) {
    x_ = model.outline().front().normalized();
    const double up = back ? -1 : 1;
    y_ = up * Eigen::Vector3d::UnitZ().cross(x_);
    base_ = Eigen::Vector3d(0, 0, (back ? -model.thickness_m : 0) + up * kSignLift * side_m_);
  }

  void polygon(const std::vector<Eigen::Vector2d>& corners, const Rgb& color) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector2d& corner : corners) points.push_back(T_ * at(corner));
    mesh_.addPolygon(mesh_.addPoints(points), color);
  }
  void bar(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width, const Rgb& color) {
    const Eigen::Vector2d along = (to - from).normalized();
    const Eigen::Vector2d aside = 0.5 * width * Eigen::Vector2d(-along.y(), along.x());
    polygon({from - aside, to - aside, to + aside, from + aside}, color);
  }
  void disc(const Eigen::Vector2d& center, double radius, const Rgb& color) {
    constexpr int kCorners = 20;
    std::vector<Eigen::Vector2d> corners;
    for (int k = 0; k < kCorners; ++k) corners.push_back(center + radius * direction(2 * kPi * k / kCorners));
    polygon(corners, color);
  }
  /// Of a point in the cell frame.
  [[nodiscard]] Eigen::Vector2d inSides(const Eigen::Vector3d& point_m) const {
    return Eigen::Vector2d(x_.dot(point_m), y_.dot(point_m)) / side_m_;
  }
  static Eigen::Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
  /// Lifts what follows above what was drawn before.
  void lift() { base_ += 0.004 * side_m_ * (base_.z() < 0 ? -1 : 1) * Eigen::Vector3d::UnitZ(); }

 private:
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector2d& p) const {
    return base_ + side_m_ * (p.x() * x_ + p.y() * y_);
  }

  PolyDataBuilder& mesh_;
  double side_m_;
  SE3 T_;
  Eigen::Vector3d x_;
  Eigen::Vector3d y_;
  Eigen::Vector3d base_;
};

/// Stripes along the direction to a corner, cut by the hexagon's edges and by the free middle.
void hatch(FacePainter& face, const Rgb& color) {
  constexpr double kInset = 0.05;
  const double height = std::sqrt(3.0) / 2;
  const auto reach = [](double y) { return 1 - kInset - std::abs(y) / std::sqrt(3.0); };
  const int most = static_cast<int>((height - kInset) / kStripesApart - 0.5);
  for (int k = -most - 1; k <= most; ++k) {
    const double y = (k + 0.5) * kStripesApart;
    const double low = y - 0.5 * kStripe;
    const double high = y + 0.5 * kStripe;
    const double gap = std::abs(y) < kFreeMiddle ? std::sqrt(kFreeMiddle * kFreeMiddle - y * y) : 0;
    if (gap == 0) {
      face.polygon({{-reach(low), low}, {reach(low), low}, {reach(high), high}, {-reach(high), high}}, color);
    } else {
      face.polygon({{-reach(low), low}, {-gap, low}, {-gap, high}, {-reach(high), high}}, color);
      face.polygon({{gap, low}, {reach(low), low}, {reach(high), high}, {gap, high}}, color);
    }
  }
}

/// From four corners towards the middle.
void cross(FacePainter& face, const Rgb& color) {
  for (const int corner : {1, 2, 4, 5}) {
    const Eigen::Vector2d way = FacePainter::direction(corner * kPi / 3);
    face.bar(kFreeMiddle * way, kBarEnd * way, kCrossBar, color);
  }
}

void triangle(FacePainter& face, const Rgb& color) {
  for (int k = 0; k < 3; ++k) {
    // Its corners lie at those of the hexagon, where no port is.
    const Eigen::Vector2d from = kTriangle * FacePainter::direction((2 * k + 1) * kPi / 3);
    const Eigen::Vector2d to = kTriangle * FacePainter::direction((2 * k + 3) * kPi / 3);
    const Eigen::Vector2d more = 0.5 * kTriangleBar * (to - from).normalized();
    face.bar(from - more, to + more, kTriangleBar, color);
  }
}

void crossedPort(FacePainter& face, const Port& port, const Rgb& mark, const Rgb& ground) {
  const Eigen::Vector2d center = kDiscAt * face.inSides(port.vector_m);
  face.disc(center, kDisc, mark);
  face.lift();
  constexpr double kArm = 0.62 * kDisc;
  for (const double turn : {0.25, 0.75}) {
    const Eigen::Vector2d way = kArm * FacePainter::direction(turn * kPi);
    face.bar(center - way, center + way, 0.3 * kDisc, ground);
  }
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

vtkSmartPointer<vtkPolyData> makeSigns(const SceneContent& content, const std::vector<Rgb>& front_colors,
                                       const SceneColors& colors) {
  const CellModel& model = *content.reconstruction->model;
  const SkinSigns& signs = content.signs;
  PolyDataBuilder mesh;
  const auto both = [&](std::size_t cell, const auto& draw) {
    for (const bool back : {false, true}) {
      if (back && !content.prisms) break;
      FacePainter face(mesh, content.layout.cells[cell], model, back);
      draw(face);
    }
  };
  for (std::size_t k = 0; k < signs.cells.size(); ++k) {
    const CellSign& sign = signs.cells[k];
    if (!sign.any()) continue;
    const Rgb& mark = markOn(front_colors[k], colors);
    both(k, [&](FacePainter& face) {
      if (sign.by_links) hatch(face, mixed(mark, front_colors[k], kHatch));
      face.lift();
      if (sign.faulty) cross(face, mark);
      if (sign.doubtful) triangle(face, mark);
    });
  }
  for (const auto& [a, b] : signs.links) {
    for (const LinkEnd& end : {a, b}) {
      const auto found = content.layout.index.find(end.cell);
      const Port* port = model.findPort(end.port);
      if (found == content.layout.index.end() || port == nullptr) continue;
      const Rgb& mark = markOn(front_colors[found->second], colors);
      const Rgb& ground = &mark == &colors.light_mark ? colors.dark_mark : colors.light_mark;
      both(found->second, [&](FacePainter& face) {
        face.lift();
        face.lift();
        crossedPort(face, *port, mark, ground);
      });
    }
  }
  return mesh.finish();
}

}  // namespace hexoderm
