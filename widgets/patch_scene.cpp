#include "widgets/patch_scene.h"

#include "hexoderm/reconstruction/pose_coverage.h"
#include "hexoderm/util/units.h"
#include "widgets/part_camera.h"
#include "widgets/patch_geometry.h"
#include "widgets/scene_corners.h"
#include "widgets/scene_ghost.h"
#include "widgets/scene_labels.h"
#include "widgets/scene_skin.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWeakPointer.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

constexpr double kViewAngle_deg = 30;
constexpr double kEdge = 0.08;  // half the window: what a patch that grows may go beyond the fit
// Parts of the window that a fitted skin fills: the legend below stays free, and what covers the top.
constexpr double kFitWidth = 0.88;
constexpr double kFitHeight = 0.74;
constexpr double kLeastFitHeight = 0.4;
constexpr double kBelowTop = 0.02;  // between what covers the top and the skin

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

bool sameCells(const SceneContent* before, const SceneContent* after) {
  if (before == nullptr || after == nullptr) return before == after;
  return std::ranges::equal(before->layout.cells, after->layout.cells, {}, &SceneCell::id, &SceneCell::id);
}

/// Fewer than half of the cells are the same: not a skin that lost or gained some cells.
bool isOtherSkin(const SceneContent* before, const SceneContent* after) {
  const std::size_t had = before ? before->layout.cells.size() : 0;
  const std::size_t has = after ? after->layout.cells.size() : 0;
  if (had == 0 || has == 0) return had != has;
  const auto kept = std::ranges::count_if(
      after->layout.cells, [&](const SceneCell& cell) { return before->layout.find(cell.id) != nullptr; });
  return 2 * static_cast<std::size_t>(kept) < std::max(had, has);
}

}  // namespace

struct PatchScene::Parts {
  std::shared_ptr<const SceneContent> content;
  SceneColors colors;
  std::optional<CellId> picked_cell;
  std::optional<std::pair<LinkEnd, LinkEnd>> picked_link;
  std::optional<PoseId> pose;
  bool text_visible = true;
  ShownItems shown = kShownAtFirst;

  vtkNew<vtkRenderer> renderer;
  vtkWeakPointer<vtkRenderWindow> window;
  unsigned long observer = 0;
  SceneSkin skin{renderer};
  SceneExtras extras{renderer};
  SceneLabels labels{renderer};
  vtkNew<vtkActor> selection_actor;
  vtkNew<vtkPolyDataMapper> selection_mapper;
  SceneCorners corners;
  SceneGhost ghost;
  std::optional<Eigen::Vector3d> up_o;       ///< now
  std::optional<Eigen::Vector3d> next_up_o;  ///< of the ghost

  bool fit_pending = false;
  bool content_is_new = false;  ///< since the last picture
  int top_margin = 0;           ///< pixels
  /// Camera, window and patch as the last fit left them: while nobody has moved the camera, a resized window or a patch
  /// that has taken another shape (flat at first, bent from the first poses on) is fitted again.
  struct Fitted {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d focus = Eigen::Vector3d::Zero();
    double parallel_scale = 0;
    std::array<int, 2> size{};
    double extent_m = 0;
  };
  std::optional<Fitted> fitted;
  struct KeptView {
    Eigen::Vector3d back;
    Eigen::Vector3d up;
  };
  std::optional<KeptView> kept_view;

  Parts();
  ~Parts();

  void lookFrom(View view);
  void fitNow();
  /// How far the camera has to go to its right so that the arrow of gravity covers none of the points, which are seen
  /// from (right, up, towards the viewer) around what is looked at. None if others would leave the picture.
  [[nodiscard]] std::optional<double> shiftPastArrow(const std::vector<Eigen::Vector3d>& seen, double distance) const;
  /// Nobody has moved the camera since the last fit.
  [[nodiscard]] bool isUntouched() const;
  /// The patch has another shape than it was fitted with, or part of it has come close to the edge of the picture.
  [[nodiscard]] bool hasOutgrownTheFit() const;
  /// Shares of the window.
  [[nodiscard]] double freeWidth() const { return ghost.isVisible() ? kFitWidth - SceneGhost::kShare : kFitWidth; }
  [[nodiscard]] double freeHeight() const;
  /// What a patch that grows may go beyond the fit until it is fitted again, in half heights of the window.
  [[nodiscard]] double slackAbove() const;
  /// The upper left corner of where the arrow of gravity and its word are, in half windows from the window's middle.
  [[nodiscard]] Eigen::Vector2d cornerFrom(int around_px) const;
  /// Where the middle of the window is, seen from what the camera looks at, in half windows.
  [[nodiscard]] Eigen::Vector2d windowCenter() const;
  /// The free part of the window has the focus in its middle.
  void centerInFreePart();
  void beforeRender();
  void recolor();
  void updateItems();
  void updateSelection();
  void updateGravity();
  void updateGhost();
  void showGhostOfLargestPatch();
  void follow(const std::optional<Eigen::Vector3d>& up_o_now);
  [[nodiscard]] std::optional<Eigen::Vector3d> upShown() const;
  [[nodiscard]] const GravityDirection* gravity() const;
  [[nodiscard]] std::array<int, 2> size() const;
};

PatchScene::Parts::Parts() {
  selection_actor->SetMapper(selection_mapper);
  selection_actor->VisibilityOff();
  renderer->AddActor(selection_actor);
  // An outline lies on the faces and keeps its colour in any light.
  selection_actor->GetProperty()->LightingOff();
  selection_actor->GetProperty()->SetLineWidth(3.5F);

  vtkNew<vtkLight> key;
  key->SetLightTypeToCameraLight();
  key->SetPosition(SceneLights::kKeyFrom[0], SceneLights::kKeyFrom[1], SceneLights::kKeyFrom[2]);
  key->SetFocalPoint(0, 0, 0);
  key->SetIntensity(SceneLights::kKey);
  renderer->AddLight(key);
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToHeadlight();
  fill->SetIntensity(SceneLights::kHead);
  renderer->AddLight(fill);
  renderer->GradientBackgroundOn();
  renderer->GetActiveCamera()->SetViewAngle(kViewAngle_deg);

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

std::array<int, 2> PatchScene::Parts::size() const {
  if (!window) return {0, 0};
  const int* pixels = window->GetSize();
  return {pixels[0], pixels[1]};
}

double PatchScene::Parts::freeHeight() const {
  const int height = size()[1];
  if (height <= 0) return kFitHeight;
  const double below = 0.5 * (1 - kFitHeight);
  const double above = static_cast<double>(top_margin) / height;
  return std::max(kLeastFitHeight, 1 - below - std::max(below, above + kBelowTop));
}

double PatchScene::Parts::slackAbove() const {
  const double fitted_top = 2 * freeHeight() - kFitHeight;
  const double covered_from = 1 - 2.0 * top_margin / std::max(1, size()[1]);
  return std::clamp(covered_from - fitted_top, 0.0, kEdge);
}

Eigen::Vector2d PatchScene::Parts::cornerFrom(int around_px) const {
  const auto [width, height] = size();
  const double scale = window ? window->GetDPI() / 72.0 : 1;
  return {1 - 2 * scale * (SceneCorners::kRight + SceneCorners::kSize + around_px) / width,
          -1 + 2 * scale * (SceneCorners::kBottom + SceneCorners::kSize + SceneCorners::kWord + around_px) / height};
}

Eigen::Vector2d PatchScene::Parts::windowCenter() const {
  return {ghost.isVisible() ? SceneGhost::kShare : 0, kFitHeight - freeHeight()};
}

void PatchScene::Parts::centerInFreePart() {
  const Eigen::Vector2d center = windowCenter();
  renderer->GetActiveCamera()->SetWindowCenter(center.x(), center.y());
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

std::optional<double> PatchScene::Parts::shiftPastArrow(const std::vector<Eigen::Vector3d>& seen,
                                                        double distance) const {
  constexpr int kAround_px = 8;
  const auto [width, height] = size();
  const bool parallel = renderer->GetActiveCamera()->GetParallelProjection() != 0;
  const Eigen::Vector2d corner = cornerFrom(kAround_px) + windowCenter();
  const double tan_height = std::tan(0.5 * kViewAngle_deg * kDegree);
  double least = 0;
  double most = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& v : seen) {
    const double half_height = tan_height * (parallel ? distance : distance - v.z());
    const double half_width = half_height * width / height;
    if (v.y() < corner.y() * half_height) least = std::max(least, v.x() - corner.x() * half_width);
    most = std::min(most, v.x() + freeWidth() * half_width);
  }
  if (least > 0 && least > most) return std::nullopt;
  return least;
}

void PatchScene::Parts::fitNow() {
  const auto [width, height] = size();
  if (!content || content->layout.points.empty() || width <= 0 || height <= 0) return;
  fit_pending = false;
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d back = -toEigen(camera->GetDirectionOfProjection());
  const Eigen::Vector3d up =
      (toEigen(camera->GetViewUp()) - toEigen(camera->GetViewUp()).dot(back) * back).normalized();
  const Eigen::Vector3d right = up.cross(back);
  Eigen::AlignedBox3d box;
  const std::vector<Eigen::Vector3d>& points = content->layout.points;
  for (const Eigen::Vector3d& p : points) box.extend(Eigen::Vector3d(right.dot(p), up.dot(p), back.dot(p)));
  const Eigen::Vector3d center = box.center();
  const double tan_height = freeHeight() * std::tan(0.5 * kViewAngle_deg * kDegree);
  const double tan_width = freeWidth() * std::tan(0.5 * kViewAngle_deg * kDegree) * width / height;
  const double least = 2 * content->reconstruction->model->side_m;
  double distance = least;
  double flat_distance = least;  // from where a skin without depth would fit
  std::vector<Eigen::Vector3d> seen;
  seen.reserve(points.size());
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d v = Eigen::Vector3d(right.dot(p), up.dot(p), back.dot(p)) - center;
    seen.push_back(v);
    // A part that is turned has to stay in the picture.
    if (up_o) distance = std::max(distance, v.norm() / std::sin(std::atan(std::min(tan_width, tan_height))));
    const double flat = up_o ? v.norm() / std::min(tan_width, tan_height)
                             : std::max(std::abs(v.x()) / tan_width, std::abs(v.y()) / tan_height);
    flat_distance = std::max(flat_distance, flat);
    distance = std::max(distance, v.z() + flat);
  }
  double shift = 0;
  // A part that is turned has room on all sides.
  if (upShown() && !up_o) {
    constexpr double kFarther = 1.04;
    constexpr double kFarthest = 1.5;
    for (double away = 1; away < kFarthest; away *= kFarther) {
      const auto found = shiftPastArrow(seen, away * (camera->GetParallelProjection() != 0 ? flat_distance : distance));
      if (!found) continue;
      shift = *found;
      distance *= away;
      flat_distance *= away;
      break;
    }
  }
  const Eigen::Vector3d focus = right * (center.x() + shift) + up * center.y() + back * center.z();
  const Eigen::Vector3d position = focus + distance * back;
  camera->SetFocalPoint(focus.x(), focus.y(), focus.z());
  camera->SetPosition(position.x(), position.y(), position.z());
  camera->SetParallelScale(flat_distance * std::tan(0.5 * kViewAngle_deg * kDegree));
  fitted = Fitted{position, focus, camera->GetParallelScale(), {width, height}, content->extent_m};
}

bool PatchScene::Parts::isUntouched() const {
  vtkCamera* camera = renderer->GetActiveCamera();
  return fitted && fitted->position == toEigen(camera->GetPosition()) &&
         fitted->focus == toEigen(camera->GetFocalPoint()) && fitted->parallel_scale == camera->GetParallelScale();
}

bool PatchScene::Parts::hasOutgrownTheFit() const {
  // Small changes, as every new pose brings them, must not make the picture jump.
  constexpr double kOtherShape = 0.1;
  if (std::abs(content->extent_m - fitted->extent_m) > kOtherShape * fitted->extent_m) return true;
  const auto [width, height] = size();
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d position = toEigen(camera->GetPosition());
  const Eigen::Vector3d ahead = toEigen(camera->GetDirectionOfProjection());
  const Eigen::Vector3d right = ahead.cross(toEigen(camera->GetViewUp())).normalized();
  const Eigen::Vector3d up = right.cross(ahead);
  const double tan_height = std::tan(0.5 * kViewAngle_deg * kDegree);
  const double tan_width = tan_height * width / height;
  const bool has_arrow = upShown() && !up_o;
  const Eigen::Vector2d corner = cornerFrom(0) + windowCenter();
  return std::any_of(content->layout.points.begin(), content->layout.points.end(), [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d v = p - position;
    const double depth = camera->GetParallelProjection() ? camera->GetParallelScale() / tan_height : v.dot(ahead);
    return std::abs(v.dot(right)) > (freeWidth() + kEdge) * tan_width * depth ||
           v.dot(up) > (freeHeight() + slackAbove()) * tan_height * depth ||
           -v.dot(up) > (freeHeight() + kEdge) * tan_height * depth ||
           (has_arrow && v.dot(right) > corner.x() * tan_width * depth && v.dot(up) < corner.y() * tan_height * depth);
  });
}

void PatchScene::Parts::beforeRender() {
  centerInFreePart();
  const bool outgrown = std::exchange(content_is_new, false) && content && isUntouched() && hasOutgrownTheFit();
  if (fit_pending || outgrown || (isUntouched() && fitted->size != size())) fitNow();
  extras.update();
  renderer->ResetCameraClippingRange();
  if (!window) return;
  skin.update(size()[1]);
  labels.update(size(), window->GetDPI());
  corners.follow(renderer->GetActiveCamera(), window);
  ghost.follow(renderer->GetActiveCamera(), window);
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
  if (isUntouched()) fit_pending = true;
}

void PatchScene::Parts::showGhostOfLargestPatch() {
  std::size_t first = 0;
  const Reconstruction* shown_skin = content ? content->reconstruction.get() : nullptr;
  const PatchReconstruction* largest = shown_skin ? largestPatch(*shown_skin) : nullptr;
  if (largest != nullptr) {
    for (const PatchReconstruction* patch = shown_skin->patches.data(); patch != largest; ++patch) {
      first += patch->cells.size();
    }
  }
  ghost.setPatch(content ? content->layout : SceneLayout{}, first, largest == nullptr ? 0 : largest->cells.size());
  updateGhost();
}

std::optional<Eigen::Vector3d> PatchScene::Parts::upShown() const {
  if (up_o) return up_o;
  const GravityDirection* direction = gravity();
  return direction == nullptr ? std::nullopt : std::optional<Eigen::Vector3d>(direction->g_o);
}

void PatchScene::Parts::recolor() {
  renderer->SetBackground2(colors.background_top.data());
  renderer->SetBackground(colors.background_bottom.data());
  selection_actor->GetProperty()->SetColor(colors.selection.data());
  corners.setColors(colors);
  ghost.setColors(colors);
  labels.setColors(skin.frontColors(), colors);
}

void PatchScene::Parts::updateItems() {
  skin.setPortsVisible(shown.at(indexOf(SceneItem::Ports)));
  labels.setVisible(text_visible && shown.at(indexOf(SceneItem::Ids)));
  corners.setAxesVisible(content && !content->layout.cells.empty() && shown.at(indexOf(SceneItem::Axes)));
  updateGravity();
}

void PatchScene::Parts::updateSelection() {
  selection_actor->VisibilityOff();
  if (!content) return;
  if (picked_link && content->reconstruction->findLink(picked_link->first, picked_link->second) != nullptr) {
    selection_mapper->SetInputData(makeLinkStroke(*content, picked_link->first, picked_link->second));
    selection_actor->VisibilityOn();
  } else if (picked_cell && content->layout.find(*picked_cell) != nullptr) {
    selection_mapper->SetInputData(makeCellOutline(*content, *picked_cell));
    selection_actor->VisibilityOn();
  }
}

/// Every patch has a frame of its own: the picked cell's patch counts, else the first with a gravity.
const GravityDirection* PatchScene::Parts::gravity() const {
  if (!content || content->layout.cells.empty() || !shown.at(indexOf(SceneItem::Gravity))) return nullptr;
  const Reconstruction* reconstruction = content->reconstruction.get();
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

void PatchScene::setContent(std::shared_ptr<const SceneContent> content) {
  const std::shared_ptr<const SceneContent> before = std::exchange(parts_->content, std::move(content));
  parts_->content_is_new = true;
  const std::shared_ptr<const SceneContent>& after = parts_->content;
  if (!sameCells(before.get(), after.get())) {
    if (isOtherSkin(before.get(), after.get())) {
      parts_->lookFrom(View::Oblique);
    } else {
      parts_->fit_pending = true;
    }
  }
  parts_->skin.setContent(after);
  parts_->extras.setContent(after);
  parts_->labels.setContent(after);
  parts_->recolor();
  parts_->updateItems();
  parts_->updateSelection();
  parts_->showGhostOfLargestPatch();
}

void PatchScene::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  setContent(makeSceneContent(std::move(reconstruction)));
}

void PatchScene::setColors(const SceneColors& colors) {
  parts_->colors = colors;
  parts_->skin.setColors(colors);
  parts_->extras.setColors(colors);
  parts_->recolor();
}

void PatchScene::setColoring(CellColoring coloring) {
  parts_->skin.setColoring(coloring);
  parts_->recolor();
}

void PatchScene::setReadings(CellReadings readings) {
  parts_->skin.setReadings(std::move(readings));
  parts_->recolor();
}

void PatchScene::setTruth(std::shared_ptr<const GroundTruth> truth) { parts_->extras.setTruth(std::move(truth)); }

void PatchScene::setSurface(std::optional<SurfaceEvaluation> surface) {
  std::unordered_map<CellId, double> distance_m;
  if (surface) {
    for (std::size_t k = 0; k < surface->cells.size(); ++k) distance_m[surface->cells[k]] = surface->distance_m[k];
  }
  parts_->skin.setSurfaceDistances(std::move(distance_m));
  parts_->extras.setSurface(std::move(surface));
  parts_->recolor();
}

void PatchScene::setLoop(std::optional<LoopEvaluation> loop) { parts_->extras.setLoop(loop); }

void PatchScene::setComparison(std::vector<Comparison> comparison) {
  parts_->extras.setComparison(std::move(comparison));
}

void PatchScene::setShown(SceneItem item, bool shown) {
  parts_->shown.at(indexOf(item)) = shown;
  parts_->extras.setShown(item, shown);
  parts_->updateItems();
}

Availability PatchScene::availability(SceneItem item) const { return parts_->extras.availability(item); }

const SceneNotes& PatchScene::notes() { return parts_->extras.notes(); }

void PatchScene::setSelection(std::optional<CellId> cell, std::optional<std::pair<LinkEnd, LinkEnd>> link) {
  parts_->picked_cell = cell;
  parts_->picked_link = link;
  parts_->updateSelection();
  parts_->updateGravity();
  parts_->updateGhost();
}

void PatchScene::setMeasured(std::optional<CellId> first, std::optional<CellId> second) {
  parts_->extras.setMeasured(first, second);
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
  parts_->updateItems();
  parts_->corners.setTextVisible(visible);
}

void PatchScene::setSmoothed(bool smoothed) {
  parts_->renderer->SetUseFXAA(smoothed);
  parts_->corners.setSmoothed(smoothed);
  parts_->ghost.setSmoothed(smoothed);
}

void PatchScene::setTopMargin(int pixels) {
  if (std::exchange(parts_->top_margin, pixels) != pixels && parts_->isUntouched()) parts_->fit_pending = true;
}

void PatchScene::fit() { parts_->fit_pending = true; }

void PatchScene::keepView() {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  parts_->kept_view = Parts::KeptView{-toEigen(camera->GetDirectionOfProjection()), toEigen(camera->GetViewUp())};
}

void PatchScene::returnToKeptView() {
  if (!parts_->kept_view) return;
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  const Eigen::Vector3d& up = parts_->kept_view->up;
  const Eigen::Vector3d position = toEigen(camera->GetFocalPoint()) + camera->GetDistance() * parts_->kept_view->back;
  camera->SetPosition(position.x(), position.y(), position.z());
  camera->SetViewUp(up.x(), up.y(), up.z());
  parts_->kept_view.reset();
  parts_->fit_pending = true;
}

void PatchScene::showStandardView(View view) { parts_->lookFrom(view); }

void PatchScene::setParallel(bool parallel) {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  if ((camera->GetParallelProjection() != 0) == parallel) return;
  const double half = std::tan(0.5 * kViewAngle_deg * kDegree);
  if (parts_->isUntouched()) {
    parts_->fit_pending = true;
  } else if (parallel) {
    camera->SetParallelScale(camera->GetDistance() * half);
  } else {
    const Eigen::Vector3d focus = toEigen(camera->GetFocalPoint());
    const Eigen::Vector3d back = -toEigen(camera->GetDirectionOfProjection());
    const Eigen::Vector3d position = focus + camera->GetParallelScale() / half * back;
    camera->SetPosition(position.x(), position.y(), position.z());
  }
  camera->SetParallelProjection(parallel);
}

std::optional<CellId> PatchScene::pick(double x, double y) {
  if (!parts_->window) return std::nullopt;
  if (parts_->fit_pending) parts_->fitNow();
  return parts_->skin.pick(x, y);
}

const SceneContent* PatchScene::content() const { return parts_->content.get(); }

const CellReadings& PatchScene::readings() const { return parts_->skin.readings(); }

std::vector<std::optional<double>> PatchScene::values() const {
  if (!parts_->content) return {};
  return cellValues(parts_->skin.coloring(), parts_->content->figures, parts_->skin.readings());
}

bool PatchScene::showsGravity() const { return parts_->upShown().has_value(); }

vtkRenderer* PatchScene::renderer() const { return parts_->renderer; }

}  // namespace hexoderm
