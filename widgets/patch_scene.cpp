#include "widgets/patch_scene.h"

#include "hexoderm/reconstruction/pose_coverage.h"
#include "hexoderm/util/units.h"
#include "widgets/part_camera.h"
#include "widgets/patch_geometry.h"
#include "widgets/scene_corners.h"
#include "widgets/scene_ghost.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkCellPicker.h>
#include <vtkCommand.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkWeakPointer.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace hexoderm {
namespace {

constexpr double kViewAngle_deg = 30;
// Parts of the window that a fitted skin fills: buttons above and legend below stay free.
constexpr double kFitWidth = 0.88;
constexpr double kFitHeight = 0.74;
constexpr double kMinLabelFacing = 0.4;  // cosine between a face and the line of sight
constexpr int kMinLabelPixels = 8;
constexpr int kMaxLabelPixels = 26;

Eigen::Vector3d toEigen(const double* v) { return {v[0], v[1], v[2]}; }

struct ViewDirection {
  Eigen::Vector3d from;  ///< unit, from what is looked at to the camera
  Eigen::Vector3d up;
};

ViewDirection directionOf(PatchScene::View view) {
  switch (view) {
    case PatchScene::View::Front:
      return {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY()};
    case PatchScene::View::Side:
      return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};
    case PatchScene::View::Top:
      return {Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitZ()};
    case PatchScene::View::Oblique:
      break;
  }
  return {Eigen::Vector3d(0.45, 0.42, 1.0).normalized(), Eigen::Vector3d::UnitY()};
}

/// Fewer than half of the cells are the same: not a skin that lost or gained some cells.
bool isOtherSkin(const std::vector<SceneCell>& before, const std::vector<SceneCell>& after) {
  std::unordered_set<CellId> known;
  for (const SceneCell& cell : before) known.insert(cell.id);
  const auto kept = std::ranges::count_if(after, [&](const SceneCell& cell) { return known.contains(cell.id); });
  return 2 * static_cast<std::size_t>(kept) < std::max(before.size(), after.size());
}

struct Label {
  vtkNew<vtkBillboardTextActor3D> actor;
  Eigen::Vector3d anchor;
  Eigen::Vector3d normal;
};

}  // namespace

struct PatchScene::Parts {
  std::shared_ptr<const Reconstruction> reconstruction;
  SceneLayout layout;
  PrismData prisms;
  std::vector<Rgb> front_colors;
  SceneColors colors;
  CellColoring coloring = CellColoring::LinkQuality;
  std::optional<CellId> picked_cell;
  std::optional<std::pair<LinkEnd, LinkEnd>> picked_link;
  std::optional<PoseId> pose;
  bool text_visible = true;

  vtkNew<vtkRenderer> renderer;
  vtkWeakPointer<vtkRenderWindow> window;
  unsigned long observer = 0;
  vtkNew<vtkActor> prism_actor;
  vtkNew<vtkPolyDataMapper> prism_mapper;
  vtkNew<vtkActor> mark_actor;
  vtkNew<vtkPolyDataMapper> mark_mapper;
  vtkNew<vtkActor> selection_actor;
  vtkNew<vtkPolyDataMapper> selection_mapper;
  vtkNew<vtkCellPicker> picker;
  std::vector<std::unique_ptr<Label>> labels;
  SceneCorners corners;
  SceneGhost ghost;
  std::optional<Eigen::Vector3d> up_o;       ///< now
  std::optional<Eigen::Vector3d> next_up_o;  ///< of the ghost

  bool fit_pending = false;
  /// Camera, window and patch as the last fit left them: while nobody has moved the camera, a resized window or a patch
  /// that has taken another shape (flat at first, bent from the first poses on) is fitted again.
  struct Fitted {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d focus = Eigen::Vector3d::Zero();
    std::array<int, 2> size{};
    double extent_m = 0;
  };
  std::optional<Fitted> fitted;
  double extent_m = 0;  ///< diagonal of the patch's bounding box

  Parts();
  ~Parts();

  void addActor(vtkActor* actor, vtkPolyDataMapper* mapper);
  void lookFrom(View view);
  void fitNow();
  void beforeRender();
  void updateLabels();
  void rebuildLabels();
  void recolor();
  void updateSelection();
  void updateGravity();
  void updateGhost();
  void showGhostOfLargestPatch();
  void follow(const std::optional<Eigen::Vector3d>& up_o_now);
  [[nodiscard]] bool isUntouched() const;
  [[nodiscard]] std::optional<Eigen::Vector3d> upShown() const;
  [[nodiscard]] const GravityDirection* gravity() const;
  [[nodiscard]] std::array<int, 2> size() const;
};

PatchScene::Parts::Parts() {
  addActor(prism_actor, prism_mapper);
  addActor(mark_actor, mark_mapper);
  addActor(selection_actor, selection_mapper);

  vtkProperty* prism = prism_actor->GetProperty();
  prism->SetInterpolationToFlat();
  prism->SetAmbient(0.58);
  prism->SetDiffuse(0.42);
  prism->SetSpecular(0.0);
  prism->SetLineWidth(1.2F);
  // Marks and outlines lie on the faces and keep their colour in any light.
  mark_actor->GetProperty()->LightingOff();
  selection_actor->GetProperty()->LightingOff();
  selection_actor->GetProperty()->SetLineWidth(3.5F);

  vtkNew<vtkLight> key;
  key->SetLightTypeToCameraLight();
  key->SetPosition(-0.3, 0.45, 1.0);
  key->SetFocalPoint(0, 0, 0);
  key->SetIntensity(0.75);
  renderer->AddLight(key);
  // Straight from the viewer: together they give text, which VTK lights like a surface, its full colour.
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToHeadlight();
  fill->SetIntensity(0.4);
  renderer->AddLight(fill);
  renderer->GradientBackgroundOn();
  renderer->GetActiveCamera()->SetViewAngle(kViewAngle_deg);

  picker->PickFromListOn();
  picker->AddPickList(prism_actor);
  picker->SetTolerance(1e-5);  // not 0: a hit on a tilted face is off its plane by rounding
  observer = renderer->AddObserver(vtkCommand::StartEvent, this, &Parts::beforeRender);
  lookFrom(View::Oblique);
}

PatchScene::Parts::~Parts() {
  renderer->RemoveObserver(observer);
  if (window) {
    corners.detachFrom(window);
    ghost.detachFrom(window);
    window->RemoveRenderer(renderer);
  }
}

void PatchScene::Parts::addActor(vtkActor* actor, vtkPolyDataMapper* mapper) {
  actor->SetMapper(mapper);
  actor->VisibilityOff();
  renderer->AddActor(actor);
}

std::array<int, 2> PatchScene::Parts::size() const {
  if (!window) return {0, 0};
  const int* pixels = window->GetSize();
  return {pixels[0], pixels[1]};
}

void PatchScene::Parts::lookFrom(View view) {
  const ViewDirection direction = directionOf(view);
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d focus = toEigen(camera->GetFocalPoint());
  const Eigen::Vector3d position = focus + std::max(camera->GetDistance(), 1e-3) * direction.from;
  camera->SetPosition(position.x(), position.y(), position.z());
  camera->SetViewUp(direction.up.x(), direction.up.y(), direction.up.z());
  camera->OrthogonalizeViewUp();
  fit_pending = true;
}

void PatchScene::Parts::fitNow() {
  const auto [width, height] = size();
  if (layout.points.empty() || width <= 0 || height <= 0) return;
  fit_pending = false;
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d back = -toEigen(camera->GetDirectionOfProjection());
  const Eigen::Vector3d up =
      (toEigen(camera->GetViewUp()) - toEigen(camera->GetViewUp()).dot(back) * back).normalized();
  const Eigen::Vector3d right = up.cross(back);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : layout.points) box.extend(Eigen::Vector3d(right.dot(p), up.dot(p), back.dot(p)));
  const Eigen::Vector3d center = box.center();
  const double tan_height = kFitHeight * std::tan(0.5 * kViewAngle_deg * kDegree);
  const double free_width = ghost.isVisible() ? kFitWidth - SceneGhost::kShare : kFitWidth;
  const double tan_width = free_width * std::tan(0.5 * kViewAngle_deg * kDegree) * width / height;
  double distance = 2 * reconstruction->model->side_m;
  for (const Eigen::Vector3d& p : layout.points) {
    const Eigen::Vector3d v = Eigen::Vector3d(right.dot(p), up.dot(p), back.dot(p)) - center;
    // A part that is turned has to stay in the picture.
    const double any_way = up_o ? v.norm() / std::sin(std::atan(std::min(tan_width, tan_height))) : 0;
    distance = std::max({distance, any_way, v.z() + std::abs(v.x()) / tan_width, v.z() + std::abs(v.y()) / tan_height});
  }
  const Eigen::Vector3d focus = right * center.x() + up * center.y() + back * center.z();
  const Eigen::Vector3d position = focus + distance * back;
  camera->SetFocalPoint(focus.x(), focus.y(), focus.z());
  camera->SetPosition(position.x(), position.y(), position.z());
  fitted = Fitted{position, focus, {width, height}, extent_m};
}

void PatchScene::Parts::beforeRender() {
  vtkCamera* camera = renderer->GetActiveCamera();
  // Small changes, as every new pose brings them, must not make the picture jump.
  constexpr double kOtherShape = 0.1;
  const bool reshaped = fitted && std::abs(extent_m - fitted->extent_m) > kOtherShape * fitted->extent_m;
  if (fit_pending || (isUntouched() && (reshaped || fitted->size != size()))) fitNow();
  renderer->ResetCameraClippingRange();
  updateLabels();
  if (!window) return;
  corners.follow(camera, window);
  ghost.follow(camera, window);
}

bool PatchScene::Parts::isUntouched() const {
  vtkCamera* camera = renderer->GetActiveCamera();
  return fitted && fitted->position == toEigen(camera->GetPosition()) &&
         fitted->focus == toEigen(camera->GetFocalPoint());
}

void PatchScene::Parts::follow(const std::optional<Eigen::Vector3d>& up_o_now) {
  const bool untouched = isUntouched();
  vtkCamera* camera = renderer->GetActiveCamera();
  if (up_o_now && up_o) {
    turnCameraWithPart(camera, *up_o, *up_o_now);
  } else if (up_o_now) {
    standCameraUpright(camera, *up_o_now);
  }
  // Following is not somebody's hand on the camera.
  if (untouched) fitted->position = toEigen(camera->GetPosition());
  if (up_o_now.has_value() != up_o.has_value() && (untouched || !fitted)) fit_pending = true;
  up_o = up_o_now;
  updateGravity();
  updateGhost();
}

void PatchScene::Parts::updateGhost() {
  const bool was_there = ghost.isVisible();
  ghost.setTurn(upShown().value_or(Eigen::Vector3d::UnitZ()), upShown() ? next_up_o : std::nullopt);
  if (ghost.isVisible() == was_there) return;
  // The skin makes room for it.
  renderer->GetActiveCamera()->SetWindowCenter(ghost.isVisible() ? SceneGhost::kShare : 0, 0);
  if (isUntouched()) fit_pending = true;
}

void PatchScene::Parts::showGhostOfLargestPatch() {
  std::size_t first = 0;
  const PatchReconstruction* largest = reconstruction ? largestPatch(*reconstruction) : nullptr;
  if (largest != nullptr) {
    for (const PatchReconstruction* patch = reconstruction->patches.data(); patch != largest; ++patch) {
      first += patch->cells.size();
    }
  }
  ghost.setPatch(layout, first, largest == nullptr ? 0 : largest->cells.size());
  updateGhost();
}

std::optional<Eigen::Vector3d> PatchScene::Parts::upShown() const {
  if (up_o) return up_o;
  const GravityDirection* direction = gravity();
  return direction == nullptr ? std::nullopt : std::optional<Eigen::Vector3d>(direction->g_o);
}

void PatchScene::Parts::updateLabels() {
  if (!window || labels.empty()) return;
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d eye = toEigen(camera->GetPosition());
  const double side_m = reconstruction->model->side_m;
  const double pixels_at_one_m = 0.5 * size()[1] / std::tan(0.5 * camera->GetViewAngle() * kDegree);
  const double text_scale = window->GetDPI() / 72.0;
  for (const auto& label : labels) {
    const Eigen::Vector3d sight = eye - label->anchor;
    const double distance = sight.norm();
    const Eigen::Vector3d toward = sight / distance;
    const double facing = label->normal.dot(toward);
    // Even sizes only, so that zooming does not make new letters at every step.
    const double wanted = 0.52 * side_m * pixels_at_one_m / distance / text_scale;
    const int font = 2 * (std::min(static_cast<int>(wanted), kMaxLabelPixels) / 2);
    const bool visible = text_visible && facing > kMinLabelFacing && font >= kMinLabelPixels;
    label->actor->SetVisibility(visible);
    if (!visible) continue;
    if (label->actor->GetTextProperty()->GetFontSize() != font) label->actor->GetTextProperty()->SetFontSize(font);
    // The text stands upright to the viewer: it moves along the line of sight until its own tilted face can't cut it,
    // and stays behind everything that really is in front.
    const double tilt = std::sqrt(std::max(0.0, 1 - facing * facing)) / facing;
    const Eigen::Vector3d p = label->anchor + side_m * (0.05 + 0.4 * tilt) * toward;
    label->actor->SetPosition(p.x(), p.y(), p.z());
  }
}

void PatchScene::Parts::rebuildLabels() {
  const std::size_t wanted = layout.cells.size() <= kMaxLabelledCells ? layout.cells.size() : 0;
  while (labels.size() > wanted) {
    renderer->RemoveActor(labels.back()->actor);
    labels.pop_back();
  }
  while (labels.size() < wanted) {
    labels.push_back(std::make_unique<Label>());
    vtkTextProperty* property = labels.back()->actor->GetTextProperty();
    property->SetJustificationToCentered();
    property->SetVerticalJustificationToCentered();
    property->BoldOn();
    labels.back()->actor->PickableOff();
    renderer->AddActor(labels.back()->actor);
  }
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const SceneCell& cell = layout.cells[k];
    labels[k]->actor->SetInput(toString(cell.id).c_str());
    labels[k]->anchor = cell.T_s_u.t;
    labels[k]->normal = cell.T_s_u.R.col(2);
  }
}

void PatchScene::Parts::recolor() {
  renderer->SetBackground2(colors.background_top.data());
  renderer->SetBackground(colors.background_bottom.data());
  prism_actor->GetProperty()->SetEdgeColor(colors.edge.data());
  selection_actor->GetProperty()->SetColor(colors.selection.data());
  corners.setColors(colors);
  ghost.setColors(colors);
  if (!reconstruction) return;
  front_colors = cellColors(*reconstruction, coloring, colors);
  const bool many = layout.cells.size() > kMaxPrismCells;
  prisms = makePrisms(layout, front_colors, many);
  prism_mapper->SetInputData(prisms.surface);
  prism_actor->GetProperty()->SetEdgeVisibility(!many);
  prism_actor->SetVisibility(!layout.cells.empty());
  const bool marked = !layout.cells.empty() && layout.cells.size() <= kMaxMarkedCells;
  if (marked) mark_mapper->SetInputData(makeMarks(*reconstruction, layout, front_colors, colors));
  mark_actor->SetVisibility(marked);
  for (std::size_t k = 0; k < labels.size(); ++k) {
    Rgb mark = markOn(front_colors[k], colors);
    labels[k]->actor->GetTextProperty()->SetColor(mark.data());
  }
}

void PatchScene::Parts::updateSelection() {
  selection_actor->VisibilityOff();
  if (!reconstruction) return;
  if (picked_link && reconstruction->findLink(picked_link->first, picked_link->second) != nullptr) {
    selection_mapper->SetInputData(makeLinkStroke(*reconstruction, layout, picked_link->first, picked_link->second));
    selection_actor->VisibilityOn();
  } else if (picked_cell) {
    const auto found = std::ranges::find(layout.cells, *picked_cell, &SceneCell::id);
    if (found == layout.cells.end()) return;
    selection_mapper->SetInputData(makeCellOutline(layout, static_cast<std::size_t>(found - layout.cells.begin())));
    selection_actor->VisibilityOn();
  }
}

/// Every patch has a frame of its own: the picked cell's patch counts, else the first with a gravity.
const GravityDirection* PatchScene::Parts::gravity() const {
  if (!reconstruction) return nullptr;
  const std::optional<CellId> picked = picked_link ? std::optional(picked_link->first.cell) : picked_cell;
  const PatchReconstruction* patch = picked ? reconstruction->find(*picked).patch : nullptr;
  if (patch == nullptr) {
    const auto found = std::ranges::find_if(reconstruction->patches, [](const auto& p) { return !p.gravity.empty(); });
    if (found == reconstruction->patches.end()) return nullptr;
    patch = &*found;
  }
  if (patch->gravity.empty()) return nullptr;
  if (!pose) return &patch->gravity.back();
  const auto found = std::ranges::find(patch->gravity, *pose, &GravityDirection::pose);
  return found == patch->gravity.end() ? nullptr : &*found;
}

void PatchScene::Parts::updateGravity() {
  const std::optional<Eigen::Vector3d> up = upShown();
  corners.setDown(up ? std::optional<Eigen::Vector3d>(-*up) : std::nullopt);
}

PatchScene::PatchScene() : parts_(std::make_unique<Parts>()) { setSmoothed(true); }
PatchScene::~PatchScene() = default;

void PatchScene::attachTo(vtkRenderWindow* window) {
  parts_->window = window;
  window->SetMultiSamples(0);
  window->SetNumberOfLayers(2);
  window->AddRenderer(parts_->renderer);
  parts_->corners.attachTo(window);
  parts_->ghost.attachTo(window);
}

void PatchScene::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  const std::vector<SceneCell> before = std::move(parts_->layout.cells);
  parts_->reconstruction = std::move(reconstruction);
  parts_->layout = parts_->reconstruction ? layOutScene(*parts_->reconstruction) : SceneLayout{};
  const std::vector<SceneCell>& after = parts_->layout.cells;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : parts_->layout.points) box.extend(point);
  parts_->extent_m = box.isEmpty() ? 0 : box.diagonal().norm();
  if (isOtherSkin(before, after)) {
    parts_->lookFrom(View::Oblique);
  } else if (!std::ranges::equal(before, after, {}, &SceneCell::id, &SceneCell::id)) {
    parts_->fit_pending = true;
  }
  if (after.empty()) {
    parts_->prism_actor->VisibilityOff();
    parts_->mark_actor->VisibilityOff();
  }
  parts_->corners.setVisible(!after.empty());
  parts_->rebuildLabels();
  parts_->recolor();
  parts_->updateSelection();
  parts_->updateGravity();
  parts_->showGhostOfLargestPatch();
}

void PatchScene::setColors(const SceneColors& colors) {
  parts_->colors = colors;
  parts_->recolor();
}

void PatchScene::setColoring(CellColoring coloring) {
  parts_->coloring = coloring;
  parts_->recolor();
}

void PatchScene::setSelection(std::optional<CellId> cell, std::optional<std::pair<LinkEnd, LinkEnd>> link) {
  parts_->picked_cell = cell;
  parts_->picked_link = link;
  parts_->updateSelection();
  parts_->updateGravity();
  parts_->updateGhost();
}

void PatchScene::setPose(std::optional<PoseId> pose) {
  parts_->pose = pose;
  parts_->updateGravity();
  parts_->updateGhost();
}

void PatchScene::setUp(const std::optional<Eigen::Vector3d>& up_o) { parts_->follow(up_o); }

void PatchScene::setNextUp(const std::optional<Eigen::Vector3d>& up_o) {
  parts_->next_up_o = up_o;
  parts_->updateGhost();
}

void PatchScene::setGhostPhase(double phase) { parts_->ghost.setPhase(phase); }

bool PatchScene::showsGhost() const { return parts_->ghost.isVisible(); }

std::optional<Eigen::Vector3d> PatchScene::upShown() const { return parts_->upShown(); }

void PatchScene::spin(double angle_rad) {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  const Eigen::Vector3d up = parts_->upShown().value_or(toEigen(camera->GetViewUp()));
  const bool untouched = parts_->isUntouched();
  spinPartInPicture(camera, up, angle_rad);
  if (untouched) parts_->fitted->position = toEigen(camera->GetPosition());
}

void PatchScene::setTextVisible(bool visible) {
  parts_->text_visible = visible;
  parts_->corners.setTextVisible(visible);
}

void PatchScene::setSmoothed(bool smoothed) {
  parts_->renderer->SetUseFXAA(smoothed);
  parts_->corners.setSmoothed(smoothed);
  parts_->ghost.setSmoothed(smoothed);
}

void PatchScene::fit() { parts_->fit_pending = true; }

void PatchScene::showStandardView(View view) { parts_->lookFrom(view); }

std::optional<CellId> PatchScene::pick(double x, double y) {
  if (parts_->layout.cells.empty() || !parts_->window) return std::nullopt;
  if (parts_->fit_pending) parts_->fitNow();
  if (parts_->picker->Pick(x, y, 0, parts_->renderer) == 0) return std::nullopt;
  const auto polygon = static_cast<std::size_t>(parts_->picker->GetCellId());
  if (polygon >= parts_->prisms.cell_of_polygon.size()) return std::nullopt;
  return parts_->layout.cells[parts_->prisms.cell_of_polygon[polygon]].id;
}

bool PatchScene::showsGravity() const { return parts_->upShown().has_value(); }

vtkRenderer* PatchScene::renderer() const { return parts_->renderer; }

}  // namespace hexoderm
