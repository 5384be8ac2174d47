#include "widgets/robot/robot_scene.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/patch_mesh.h"
#include "widgets/scene/blending_renderer.h"
#include "widgets/scene/cell_meshes.h"
#include "widgets/scene/mesh_actor.h"
#include "widgets/scene/part_camera.h"
#include "widgets/scene/polydata_builder.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_labels.h"
#include "widgets/scene/scene_skin.h"
#include "widgets/scene/vtk_eigen.h"

#include <vtkCamera.h>
#include <vtkCellPicker.h>
#include <vtkCommand.h>
#include <vtkConeSource.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkWeakPointer.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace hexoderm {
namespace {

constexpr double kAboveSkin = 1.2;     // height of arrows over the cells, in side lengths
constexpr double kArrowRadius = 0.08;  // of an arrow's shaft, in side lengths
constexpr double kHeadLength = 0.6;
constexpr double kHeadRadius = 0.25;
constexpr double kShortWay = 2;  // length of an arrow where nothing says how far one can go
constexpr double kPointSize = 0.35;

vtkSmartPointer<vtkPolyData> polyDataOf(const TriangleMesh& mesh) {
  PolyDataBuilder data;
  static_cast<void>(data.addPoints(mesh.points));
  for (const auto& triangle : mesh.triangles) data.addPolygon({triangle.begin(), triangle.end()});
  return data.finish();
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
  line.addLine(line.addPoints(way));
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
  std::vector<std::unique_ptr<MeshActor>> links;  ///< of every link
  MeshActor skin;
  SceneLabels labels{renderer};
  std::shared_ptr<SceneContent> labelled;  ///< the cells in the frame of the base
  std::vector<std::size_t> patch_of_cell;  ///< index into the picture's patches, of each of these cells
  std::vector<std::unique_ptr<MeshActor>> marks;
  bool fit_pending = false;
  struct Look {
    std::optional<std::size_t> patch;
  };
  std::optional<Look> look_pending;

  Parts() {
    addSceneLights(renderer);
    renderer->GradientBackgroundOn();
    skin.actor->PickableOff();
    skin.property()->EdgeVisibilityOn();
    renderer->AddActor(skin.actor);
    observer = renderer->AddObserver(vtkCommand::StartEvent, this, &Parts::beforeRender);
  }
  ~Parts() {
    renderer->RemoveObserver(observer);
    if (window) window->RemoveRenderer(renderer);
  }
  void beforeRender() {
    moveCamera();
    renderer->ResetCameraClippingRange();
    if (!window) return;
    const int* pixels = window->GetSize();
    labels.update(SceneSight::of(renderer->GetActiveCamera(), {pixels[0], pixels[1]}, window->GetDPI()));
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
    Eigen::AlignedBox3d box;
    Eigen::Vector3d facing = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < patch_of_cell.size(); ++k) {
      if (look.patch && *look.patch != patch_of_cell[k]) continue;
      const SE3& T_w_u = labelled->layout.cells[k].T_s_u;
      const Eigen::Vector3d reach = Eigen::Vector3d::Constant(picture.skin->model->side_m);
      box.extend(T_w_u.t - reach);
      box.extend(T_w_u.t + reach);
      facing += T_w_u.R.col(2);
    }
    if (box.isEmpty()) return;
    vtkCamera* camera = renderer->GetActiveCamera();
    const Eigen::Vector3d middle = box.center();
    // Patches all around a link face nowhere in the mean: the camera stays on its side then.
    const Eigen::Vector3d from = facing.norm() > 1 ? Eigen::Vector3d(facing.normalized()) : backOfCamera(camera);
    const Eigen::Vector3d position = middle + from;
    constexpr double kUpright = 0.95;
    camera->SetFocalPoint(middle.data());
    camera->SetPosition(position.data());
    camera->SetViewUp(Eigen::Vector3d::Unit(std::abs(from.z()) > kUpright ? 0 : 2).eval().data());
    const std::array<double, 6> bounds{box.min().x(), box.max().x(), box.min().y(),
                                       box.max().y(), box.min().z(), box.max().z()};
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
      links.push_back(std::make_unique<MeshActor>());
      links.back()->show(polyDataOf(body));
      renderer->AddActor(links.back()->actor);
    }
  }

  void placeLinks() {
    for (std::size_t k = 0; k < std::min(links.size(), picture.T_w_l.size()); ++k) {
      setPlace(links[k]->actor, picture.T_w_l[k].R, picture.T_w_l[k].t);
      // The link that is spoken of stands out by being lighter or darker too, not by its hue alone.
      links[k]->setColor(picture.link == k ? mixed(colors.neutral, colors.overlay, 0.45) : colors.neutral);
      links[k]->setAmbient(0.25);
    }
  }

  void makeSkin() {
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
          std::ranges::copy(prismCorners(*picture.skin->model, T_w_u), std::back_inserter(labelled->layout.points));
          labelled->layout.cells.push_back({cell.cell, T_w_u, placed.patch, cell.cell == patch.origin});
          front_colors.push_back(color);
          patch_of_cell.push_back(index);
        }
      }
    }
    if (labelled) labelled->surface = makePrisms(labelled->layout);
    skin.show(labelled ? makeColoredSurface(*labelled, front_colors, colors) : nullptr);
    skin.property()->SetEdgeColor(colors.edge.data());
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

  void addMark(vtkPolyData* data, const SE3& T_w_l, const Rgb& color) {
    marks.push_back(std::make_unique<MeshActor>());
    const MeshActor& mark = *marks.back();
    mark.mapper->SetInputData(data);
    mark.setColor(color);
    mark.actor->PickableOff();
    setPlace(mark.actor, T_w_l.R, T_w_l.t);
    renderer->AddActor(mark.actor);
  }

  bool isDrawn(const RobotPicture::Patch& patch) const {
    return picture.skin && patch.patch < picture.skin->patches.size() && patch.link < picture.T_w_l.size();
  }
};

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
  parts_->renderer->SetBackground(parts_->colors.background_bottom.data());
  parts_->renderer->SetBackground2(parts_->colors.background_top.data());
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
  const SceneSight sight = SceneSight::of(parts_->renderer->GetActiveCamera(), {}, 72);
  return parts_->picture.T_w_l.at(link).R.transpose() * (right_m * sight.right + up_m * sight.up);
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
  if (!hit || picker->GetActor() != parts_->skin.actor) return std::nullopt;
  const std::size_t cell = static_cast<std::size_t>(picker->GetCellId()) / parts_->labelled->polygonsPerCell();
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
