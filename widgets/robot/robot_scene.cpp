#include "widgets/robot/robot_scene.h"

#include "hexoderm/reconstruction/figures/patch_mesh.h"
#include "hexoderm/util/units.h"
#include "widgets/scene/blending_renderer.h"
#include "widgets/scene/polydata_builder.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_labels.h"
#include "widgets/scene/scene_skin.h"
#include "widgets/scene/vtk_eigen.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellPicker.h>
#include <vtkCommand.h>
#include <vtkConeSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkWeakPointer.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hexoderm {
namespace {

constexpr double kAboveSkin = 1.2;     // height of arrows over the cells, in side lengths
constexpr double kArrowRadius = 0.08;  // of an arrow's shaft, in side lengths
constexpr double kHeadLength = 0.6;
constexpr double kHeadRadius = 0.25;
constexpr double kShortWay = 2;  // length of an arrow where nothing says how far one can go
constexpr double kPointSize = 0.35;
constexpr std::size_t kFacesOfPrism = 8;

/// What is drawn of one thing.
struct RobotActor {
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  RobotActor() { actor->SetMapper(mapper); }
};

void setPlace(vtkActor* actor, const SE3& T) {
  const vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, T.R(row, column));
    matrix->SetElement(row, 3, T.t(row));
  }
  actor->SetUserMatrix(matrix);
}

vtkSmartPointer<vtkPolyData> polyDataOf(const TriangleMesh& mesh) {
  PolyDataBuilder data;
  for (const Eigen::Vector3d& point : mesh.points) data.addPoint(point);
  for (const auto& triangle : mesh.triangles) {
    data.addPolygon({static_cast<vtkIdType>(triangle[0]), static_cast<vtkIdType>(triangle[1]),
                     static_cast<vtkIdType>(triangle[2])});
  }
  return data.finish();
}

/// The prism of a cell: front, back, and six sides.
void addPrism(const CellModel& model, const SE3& T_w_u, const Rgb& color, PolyDataBuilder& mesh) {
  const vtkIdType first = mesh.pointCount();
  for (const Eigen::Vector3d& corner : prismCorners(model, T_w_u)) mesh.addPoint(corner);
  const Rgb shade = mixed({0, 0, 0}, color, 0.7);
  std::vector<vtkIdType> front;
  std::vector<vtkIdType> back;
  for (vtkIdType k = 0; k < 6; ++k) {
    front.push_back(first + k);
    back.push_back(first + 11 - k);
  }
  mesh.addPolygon(front, color);
  mesh.addPolygon(back, shade);
  for (vtkIdType k = 0; k < 6; ++k) {
    const vtkIdType next = (k + 1) % 6;
    mesh.addPolygon({first + k + 6, first + next + 6, first + next, first + k}, shade);
  }
}

/// Middle and mean normal of a patch, in its frame.
std::pair<Eigen::Vector3d, Eigen::Vector3d> middleAndNormal(const PatchReconstruction& patch) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const CellPlacement& cell : patch.cells) {
    middle += cell.T_o_u.t / static_cast<double>(patch.cells.size());
    normal += cell.T_o_u.R.col(2);
  }
  // A closed ring has none.
  const double length = normal.norm();
  return {middle, length > 1e-9 ? Eigen::Vector3d(normal / length) : Eigen::Vector3d::Zero()};
}

/// Where the patch's middle goes along a free direction, in the link's frame.
std::vector<Eigen::Vector3d> wayOfMiddle(const PatchReconstruction& patch, const RobotPicture::Free& free,
                                         double side_m) {
  const auto [middle_o, normal_o] = middleAndNormal(patch);
  const Eigen::Vector3d above_o = middle_o + kAboveSkin * side_m * normal_o;
  std::vector<Eigen::Vector3d> way;
  for (const SE3& T_l_o : free.direction.way) way.push_back(T_l_o * above_o);
  if (way.size() > 1) return way;
  const Eigen::Vector3d at = free.of.T_l_o * above_o;
  const Eigen::Vector3d motion = free.direction.shift_m + free.direction.turn_rad.cross(at);
  if (!(motion.norm() > 0)) return {};
  const Eigen::Vector3d half = 0.5 * kShortWay * side_m * motion.normalized();
  return {at - half, at + half};
}

vtkSmartPointer<vtkPolyData> tubeAlong(const std::vector<Eigen::Vector3d>& way, double radius_m) {
  PolyDataBuilder line;
  for (const Eigen::Vector3d& point : way) line.addPoint(point);
  for (vtkIdType k = 1; k < line.pointCount(); ++k) line.addLine({k - 1, k});
  const vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(line.finish());
  tube->SetRadius(radius_m);
  tube->SetNumberOfSides(12);
  tube->Update();
  return tube->GetOutput();
}

vtkSmartPointer<vtkPolyData> headAt(const Eigen::Vector3d& end, const Eigen::Vector3d& before, double side_m) {
  const Eigen::Vector3d direction = (end - before).normalized();
  const Eigen::Vector3d center = end + 0.5 * kHeadLength * side_m * direction;
  const vtkNew<vtkConeSource> cone;
  cone->SetResolution(16);
  cone->SetHeight(kHeadLength * side_m);
  cone->SetRadius(kHeadRadius * side_m);
  cone->SetDirection(direction.x(), direction.y(), direction.z());
  cone->SetCenter(center.x(), center.y(), center.z());
  cone->Update();
  return cone->GetOutput();
}

}  // namespace

struct RobotScene::Parts {
  RobotPicture picture;
  SceneColors colors;
  vtkNew<BlendingRenderer> renderer;
  vtkWeakPointer<vtkRenderWindow> window;
  unsigned long observer = 0;
  std::vector<std::unique_ptr<RobotActor>> links;  ///< of every link
  RobotActor skin;
  SceneLabels labels{renderer};
  std::shared_ptr<SceneContent> labelled;  ///< the cells in the frame of the base
  std::vector<std::size_t> patch_of_cell;  ///< index into the picture's patches, of each of these cells
  std::vector<std::unique_ptr<RobotActor>> marks;
  bool fit_pending = false;
  struct Look {
    std::optional<std::size_t> patch;
  };
  std::optional<Look> look_pending;

  Parts();
  ~Parts();
  void beforeRender() {
    moveCamera();
    renderer->ResetCameraClippingRange();
    if (!window) return;
    const int* pixels = window->GetSize();
    labels.update({pixels[0], pixels[1]}, window->GetDPI());
  }

  void fit() {
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetFocalPoint(0, 0, 0);
    camera->SetPosition(1.0, -0.9, 0.55);
    camera->SetViewUp(0, 0, 1);
    renderer->ResetCamera();
  }

  /// From where the cells face.
  void lookAt(const Look& look) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;
    Eigen::Vector3d facing = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < patch_of_cell.size(); ++k) {
      if (look.patch && *look.patch != patch_of_cell[k]) continue;
      const SE3& T_w_u = labelled->layout.cells[k].T_s_u;
      const Eigen::Vector3d reach = Eigen::Vector3d::Constant(picture.skin->model->side_m);
      low = low.cwiseMin(T_w_u.t - reach);
      high = high.cwiseMax(T_w_u.t + reach);
      facing += T_w_u.R.col(2);
    }
    if (!(high.x() >= low.x())) return;
    vtkCamera* camera = renderer->GetActiveCamera();
    const Eigen::Vector3d middle = (low + high) / 2;
    // Patches all around a link face nowhere in the mean: the camera stays on its side then.
    const Eigen::Vector3d back = -Eigen::Vector3d(camera->GetDirectionOfProjection());
    const Eigen::Vector3d from = facing.norm() > 1 ? Eigen::Vector3d(facing.normalized()) : back;
    const Eigen::Vector3d position = middle + from;
    constexpr double kUpright = 0.95;
    camera->SetFocalPoint(middle.x(), middle.y(), middle.z());
    camera->SetPosition(position.x(), position.y(), position.z());
    camera->SetViewUp(std::abs(from.z()) > kUpright ? 1 : 0, 0, std::abs(from.z()) > kUpright ? 0 : 1);
    const std::array<double, 6> bounds{low.x(), high.x(), low.y(), high.y(), low.z(), high.z()};
    renderer->ResetCamera(bounds.data());
  }

  void moveCamera() {
    if (std::exchange(fit_pending, false)) fit();
    if (const auto look = std::exchange(look_pending, std::nullopt)) lookAt(*look);
  }

  void makeLinks() {
    for (const auto& link : links) renderer->RemoveActor(link->actor);
    links.clear();
    if (!picture.bodies) return;
    for (const TriangleMesh& body : *picture.bodies) {
      links.push_back(std::make_unique<RobotActor>());
      links.back()->mapper->SetInputData(polyDataOf(body));
      links.back()->mapper->ScalarVisibilityOff();
      links.back()->actor->SetVisibility(!body.empty());
      renderer->AddActor(links.back()->actor);
    }
  }

  void placeLinks() {
    for (std::size_t k = 0; k < std::min(links.size(), picture.T_w_l.size()); ++k) {
      setPlace(links[k]->actor, picture.T_w_l[k]);
      // The link that is spoken of stands out by being lighter or darker too, not by its hue alone.
      Rgb color = picture.link == k ? mixed(colors.neutral, colors.overlay, 0.45) : colors.neutral;
      links[k]->actor->GetProperty()->SetColor(color.data());
      links[k]->actor->GetProperty()->SetAmbient(0.25);
      links[k]->actor->GetProperty()->SetDiffuse(0.75);
    }
  }

  void makeSkin() {
    PolyDataBuilder mesh;
    std::vector<Rgb> front_colors;
    labelled.reset();
    patch_of_cell.clear();
    if (picture.skin && picture.bodies) {
      labelled = std::make_shared<SceneContent>();
      labelled->reconstruction = picture.skin;
      for (std::size_t index = 0; index < picture.patches.size(); ++index) {
        const RobotPicture::Patch& placed = picture.patches[index];
        if (!isDrawn(placed)) continue;
        const SE3 T_w_o = picture.T_w_l[placed.link] * placed.T_l_o;
        const PatchReconstruction& patch = picture.skin->patches[placed.patch];
        const Rgb color =
            placed.is_proposal ? colors.overlay : categoryColor(colors, placed.patch, picture.skin->patches.size());
        for (const CellPlacement& cell : patch.cells) {
          const SE3 T_w_u = T_w_o * cell.T_o_u;
          addPrism(*picture.skin->model, T_w_u, color, mesh);
          labelled->layout.cells.push_back({cell.cell, T_w_u, placed.patch, cell.cell == patch.origin});
          front_colors.push_back(color);
          patch_of_cell.push_back(index);
        }
      }
    }
    skin.mapper->SetInputData(mesh.finish());
    Rgb edge = colors.edge;
    skin.actor->GetProperty()->SetEdgeColor(edge.data());
    skin.actor->SetVisibility(mesh.pointCount() > 0);
    labels.setContent(labelled);
    labels.setColors(front_colors, colors);
  }

  void makeMarks() {
    for (const auto& mark : marks) renderer->RemoveActor(mark->actor);
    marks.clear();
    if (!picture.skin || !picture.bodies) return;
    const double side_m = picture.skin->model->side_m;
    for (const RobotPicture::Free& free : picture.free) {
      if (!isDrawn(free.of)) continue;
      const std::vector<Eigen::Vector3d> way = wayOfMiddle(picture.skin->patches[free.of.patch], free, side_m);
      if (way.size() < 2) continue;
      const SE3& T_w_l = picture.T_w_l[free.of.link];
      addMark(tubeAlong(way, kArrowRadius * side_m), T_w_l, colors.difference);
      if (free.direction.all_the_way) continue;  // a ring has no ends
      addMark(headAt(way.back(), way[way.size() - 2], side_m), T_w_l, colors.difference);
      addMark(headAt(way.front(), way[1], side_m), T_w_l, colors.difference);
    }
    for (const RobotPicture::Point& point : picture.points) {
      if (point.link >= picture.T_w_l.size()) continue;
      TriangleMesh ball = meshOfSphere(kPointSize * side_m);
      for (Eigen::Vector3d& corner : ball.points) corner += point.x_l;
      addMark(polyDataOf(ball), picture.T_w_l[point.link], colors.arrow_head);
    }
  }

  RobotActor& addMark(vtkSmartPointer<vtkPolyData> data, const SE3& T_w_l, const Rgb& color) {
    marks.push_back(std::make_unique<RobotActor>());
    RobotActor& mark = *marks.back();
    mark.mapper->SetInputData(data);
    mark.mapper->ScalarVisibilityOff();
    Rgb value = color;
    mark.actor->GetProperty()->SetColor(value.data());
    mark.actor->PickableOff();
    setPlace(mark.actor, T_w_l);
    renderer->AddActor(mark.actor);
    return mark;
  }

  bool isDrawn(const RobotPicture::Patch& patch) const {
    return picture.skin && patch.patch < picture.skin->patches.size() && patch.link < picture.T_w_l.size();
  }
};

RobotScene::Parts::Parts() {
  addSceneLights(renderer);
  renderer->GradientBackgroundOn();
  skin.actor->PickableOff();
  skin.actor->GetProperty()->EdgeVisibilityOn();
  renderer->AddActor(skin.actor);
  observer = renderer->AddObserver(vtkCommand::StartEvent, this, &Parts::beforeRender);
}

RobotScene::Parts::~Parts() {
  renderer->RemoveObserver(observer);
  if (window) window->RemoveRenderer(renderer);
}

RobotScene::RobotScene() : parts_(std::make_unique<Parts>()) {}

RobotScene::~RobotScene() = default;

void RobotScene::attachTo(vtkRenderWindow* window) {
  parts_->window = window;
  window->AddRenderer(parts_->renderer);
}

void RobotScene::setPicture(RobotPicture picture) {
  const bool other_robot = picture.bodies != parts_->picture.bodies;
  parts_->picture = std::move(picture);
  if (other_robot) parts_->makeLinks();
  parts_->placeLinks();
  parts_->makeSkin();
  parts_->makeMarks();
  if (other_robot) parts_->fit_pending = true;
}

const RobotPicture& RobotScene::picture() const { return parts_->picture; }

void RobotScene::setColors(const SceneColors& colors) {
  parts_->colors = colors;
  Rgb top = colors.background_top;
  Rgb bottom = colors.background_bottom;
  parts_->renderer->SetBackground(bottom.data());
  parts_->renderer->SetBackground2(top.data());
  parts_->placeLinks();
  parts_->makeSkin();
  parts_->makeMarks();
}

void RobotScene::fit() {
  parts_->fit_pending = true;
  parts_->look_pending.reset();
}

void RobotScene::lookAtSkin(std::optional<std::size_t> patch) { parts_->look_pending = Parts::Look{patch}; }

Eigen::Vector3d RobotScene::wayOnScreen(double right_m, double up_m, std::size_t link) {
  parts_->moveCamera();
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  const Eigen::Vector3d into(camera->GetDirectionOfProjection());
  const Eigen::Vector3d right = into.cross(Eigen::Vector3d(camera->GetViewUp())).normalized();
  const Eigen::Vector3d way_w = right_m * right + up_m * right.cross(into);
  return parts_->picture.T_w_l.at(link).R.transpose() * way_w;
}

void RobotScene::turn(double right_deg, double up_deg) {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  camera->Azimuth(-right_deg);
  camera->Elevation(up_deg);
  camera->OrthogonalizeViewUp();
}

void RobotScene::zoom(double factor) { parts_->renderer->GetActiveCamera()->Dolly(factor); }

std::optional<RobotPicture::Point> RobotScene::pick(double x, double y) {
  parts_->moveCamera();
  const vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0);
  if (picker->Pick(x, y, 0, parts_->renderer) == 0) return std::nullopt;
  const Eigen::Vector3d x_w = toEigen(picker->GetPickPosition());
  for (std::size_t k = 0; k < std::min(parts_->links.size(), parts_->picture.T_w_l.size()); ++k) {
    if (picker->GetActor() != parts_->links[k]->actor) continue;
    return RobotPicture::Point{k, parts_->picture.T_w_l[k].inverse() * x_w};
  }
  return std::nullopt;
}

std::optional<RobotScene::Grip> RobotScene::grip(double x, double y) {
  parts_->moveCamera();
  const vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0);
  parts_->skin.actor->PickableOn();
  const bool hit = picker->Pick(x, y, 0, parts_->renderer) != 0;
  parts_->skin.actor->PickableOff();
  if (!hit || picker->GetActor() != parts_->skin.actor || picker->GetCellId() < 0) return std::nullopt;
  const std::size_t cell = static_cast<std::size_t>(picker->GetCellId()) / kFacesOfPrism;
  if (cell >= parts_->patch_of_cell.size()) return std::nullopt;
  const Eigen::Vector3d x_w = toEigen(picker->GetPickPosition());
  Grip grip;
  grip.patch = parts_->patch_of_cell[cell];
  const std::size_t link = parts_->picture.patches[grip.patch].link;
  const auto below = pick(x, y);
  grip.x_l = below && below->link == link ? below->x_l : parts_->picture.T_w_l[link].inverse() * x_w;
  return grip;
}

std::size_t RobotScene::cellsDrawn() const { return parts_->labelled ? parts_->labelled->layout.cells.size() : 0; }

}  // namespace hexoderm
