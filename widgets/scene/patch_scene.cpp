#include "widgets/scene/patch_scene.h"

#include "hexoderm/reconstruction/advice/pose_coverage.h"
#include "widgets/scene/blending_renderer.h"
#include "widgets/scene/brush_marks.h"
#include "widgets/scene/cell_meshes.h"
#include "widgets/scene/scene_corners.h"
#include "widgets/scene/scene_ghost.h"
#include "widgets/scene/scene_labels.h"
#include "widgets/scene/scene_overlays.h"
#include "widgets/scene/scene_skin.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkWeakPointer.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace hexoderm {

struct PatchScene::Parts {
  std::shared_ptr<const SceneContent> content;
  SceneColors colors;
  std::optional<CellId> picked_cell;
  std::vector<CellId> brushed;
  PatchMoment moment;
  PatchOverlays overlays;
  std::optional<double> cut_share;
  std::optional<SceneCut> cut;
  bool text_visible = true;
  ShownItems shown = kShownAtFirst;

  vtkNew<BlendingRenderer> renderer;
  vtkWeakPointer<vtkRenderWindow> window;
  unsigned long observer = 0;
  SceneCamera camera{renderer};
  SceneSkin skin{renderer};
  SceneOverlays drawn_overlays{renderer};
  SceneLabels labels{renderer};
  vtkNew<vtkActor> brush_actor;
  vtkNew<vtkPolyDataMapper> brush_mapper;
  SceneCorners corners;
  SceneGhost ghost;

  Parts();
  ~Parts();

  SceneCamera::Surroundings surroundings() const {
    SceneCamera::Surroundings around;
    if (window) {
      const int* pixels = window->GetSize();
      around.window = {pixels[0], pixels[1]};
      around.pixels_per_point = window->GetDPI() / 72.0;
    }
    around.ghost = ghost.isVisible();
    around.arrow_of_gravity = upShown().has_value();
    return around;
  }

  void beforeRender() {
    const SceneCamera::Surroundings around = surroundings();
    if (drawn_overlays.update()) camera.setMore(drawn_overlays.points());
    camera.prepare(around);
    renderer->ResetCameraClippingRange();
    if (!window) return;
    skin.update(around.window[1]);
    labels.update(around.window, window->GetDPI());
    corners.follow(renderer->GetActiveCamera(), window);
    ghost.follow(renderer->GetActiveCamera(), window);
  }

  void recolor() {
    renderer->SetBackground2(colors.background_top.data());
    renderer->SetBackground(colors.background_bottom.data());
    corners.setColors(colors);
    ghost.setColors(colors);
    labels.setColors(skin.frontColors(), colors);
    updateBrushed();
  }

  void updateItems() {
    skin.setPortsVisible(shown.at(indexOf(SceneItem::Ports)));
    labels.setVisible(text_visible && shown.at(indexOf(SceneItem::Ids)));
    corners.setAxesVisible(content && !content->layout.cells.empty() && shown.at(indexOf(SceneItem::Axes)));
    updateGravity();
  }

  void updateBrushed() {
    const bool any = content && !brushed.empty();
    brush_actor->SetVisibility(any);
    if (any) brush_mapper->SetInputData(makeBrushMarks(*content, brushed, skin.frontColors(), colors));
  }

  void updateGravity() {
    const std::optional<Eigen::Vector3d> up = upShown();
    corners.setDown(up ? std::optional<Eigen::Vector3d>(-*up) : std::nullopt);
  }

  void updateGhost() {
    const bool was_there = ghost.isVisible();
    ghost.setTurn(upShown().value_or(Eigen::Vector3d::UnitZ()), upShown() ? moment.next_up_o : std::nullopt);
    // The skin makes room for it.
    if (ghost.isVisible() != was_there) camera.fitIfUntouched();
  }

  void updateCut() {
    if (!cut_share || !content || content->layout.points.empty()) {
      cut.reset();
    } else {
      if (!cut) cut = SceneCut{-Eigen::Vector3d(renderer->GetActiveCamera()->GetDirectionOfProjection()), 0};
      double least = std::numeric_limits<double>::infinity();
      double most = -least;
      for (const Eigen::Vector3d& p : content->layout.points) {
        least = std::min(least, cut->normal.dot(p));
        most = std::max(most, cut->normal.dot(p));
      }
      // At the ends everything is there, or nothing.
      constexpr double kBeyond = 0.001;
      const double beyond = kBeyond * (most - least);
      cut->offset_m = most + beyond - *cut_share * (most - least + 2 * beyond);
    }
    skin.setCut(cut);
    drawn_overlays.setCut(cut);
    labels.setCut(cut);
  }

  void showGhostOfLargestPatch() {
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

  /// The present up, else that of the pose whose gravity is shown; none without either.
  std::optional<Eigen::Vector3d> upShown() const {
    if (moment.up_o) return moment.up_o;
    const GravityDirection* direction = gravity();
    return direction == nullptr ? std::nullopt : std::optional<Eigen::Vector3d>(direction->g_o);
  }

  /// Every patch has a frame of its own: this is the gravity of the picked cell's patch, or else of the largest patch,
  /// or of the first that has one.
  const GravityDirection* gravity() const {
    if (!content || content->layout.cells.empty() || !shown.at(indexOf(SceneItem::Gravity))) return nullptr;
    const Reconstruction* reconstruction = content->reconstruction.get();
    const PatchReconstruction* patch = picked_cell ? reconstruction->find(*picked_cell).patch : nullptr;
    if (patch == nullptr) patch = largestPatch(*reconstruction);
    if (patch->gravity.empty() && !picked_cell) {
      const auto found =
          std::ranges::find_if(reconstruction->patches, [](const auto& p) { return !p.gravity.empty(); });
      if (found == reconstruction->patches.end()) return nullptr;
      patch = &*found;
    }
    if (patch->gravity.empty()) return nullptr;
    if (!moment.pose) return &patch->gravity.back();
    const auto found = std::ranges::find(patch->gravity, *moment.pose, &GravityDirection::pose);
    return found == patch->gravity.end() ? nullptr : &*found;
  }
};

PatchScene::Parts::Parts() {
  // An outline lies on the faces and keeps its colour in any light.
  brush_actor->SetMapper(brush_mapper);
  brush_actor->VisibilityOff();
  brush_actor->GetProperty()->LightingOff();
  renderer->AddActor(brush_actor);

  addSceneLights(renderer);
  renderer->GradientBackgroundOn();

  observer = renderer->AddObserver(vtkCommand::StartEvent, this, &Parts::beforeRender);
}

PatchScene::Parts::~Parts() {
  renderer->RemoveObserver(observer);
  if (window) {
    corners.detachFrom(window);
    ghost.detachFrom(window);
    window->RemoveRenderer(renderer);
  }
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
  parts_->content = std::move(content);
  parts_->camera.setContent(parts_->content);
  parts_->skin.setContent(parts_->content);
  parts_->drawn_overlays.setContent(parts_->content);
  parts_->labels.setContent(parts_->content);
  parts_->recolor();
  parts_->updateItems();
  if (parts_->cut_share) parts_->updateCut();
  parts_->showGhostOfLargestPatch();
}

void PatchScene::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  setContent(makeSceneContent(std::move(reconstruction)));
}

void PatchScene::setColors(const SceneColors& colors) {
  parts_->colors = colors;
  parts_->skin.setColors(colors);
  parts_->drawn_overlays.setColors(colors);
  parts_->recolor();
}

void PatchScene::setColoring(Coloring coloring) {
  parts_->skin.setColoring(coloring);
  parts_->recolor();
}

void PatchScene::setFixedRange(const std::optional<ColorRange>& range) {
  parts_->skin.setFixedRange(range);
  parts_->recolor();
}

void PatchScene::setOverlays(const PatchOverlays& overlays) {
  const bool other_surface = overlays.surface != parts_->overlays.surface;
  parts_->overlays = overlays;
  parts_->drawn_overlays.setOverlays(overlays);
  if (!other_surface) return;
  std::unordered_map<CellId, double> distance_m;
  if (const SurfaceEvaluation* surface = overlays.surface.get()) {
    for (std::size_t k = 0; k < surface->cells.size(); ++k) distance_m[surface->cells[k]] = surface->distance_m[k];
  }
  parts_->skin.setSurfaceDistances(std::move(distance_m));
  parts_->recolor();
}

void PatchScene::setShiftFactor(std::optional<double> factor) { parts_->drawn_overlays.setShiftFactor(factor); }

const PatchOverlays& PatchScene::overlays() const { return parts_->overlays; }

void PatchScene::setMoment(const PatchMoment& moment) {
  const PatchMoment before = std::exchange(parts_->moment, moment);
  if (moment.readings != before.readings) {
    parts_->skin.setReadings(moment.readings ? *moment.readings : CellReadings{});
    if (isReading(parts_->skin.coloring())) parts_->recolor();
  }
  const bool other_up = moment.up_o != before.up_o;
  if (other_up) parts_->camera.follow(moment.up_o);
  if (other_up || moment.pose != before.pose) parts_->updateGravity();
  if (other_up || moment.pose != before.pose || moment.next_up_o != before.next_up_o) parts_->updateGhost();
}

const PatchMoment& PatchScene::moment() const { return parts_->moment; }

void PatchScene::setShown(SceneItem item, bool shown) {
  parts_->shown.at(indexOf(item)) = shown;
  parts_->drawn_overlays.setShown(item, shown);
  parts_->updateItems();
}

Availability PatchScene::availability(SceneItem item) const { return parts_->drawn_overlays.availability(item); }

const SceneNotes& PatchScene::notes() { return parts_->drawn_overlays.notes(); }

void PatchScene::setPicked(std::optional<CellId> cell) {
  parts_->picked_cell = cell;
  parts_->updateGravity();
  parts_->updateGhost();
}

void PatchScene::setBrushed(std::vector<CellId> cells) {
  parts_->brushed = std::move(cells);
  parts_->updateBrushed();
}

void PatchScene::setMeasured(std::optional<CellId> first, std::optional<CellId> second) {
  parts_->drawn_overlays.setMeasured(first, second);
}

void PatchScene::setGhostPhase(double phase) { parts_->ghost.setPhase(phase); }

bool PatchScene::showsGhost() const { return parts_->ghost.isVisible(); }

std::optional<Eigen::Vector3d> PatchScene::upShown() const { return parts_->upShown(); }

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

void PatchScene::setTopMargin(int pixels) { parts_->camera.setTopMargin(pixels); }

void PatchScene::setBottomMargin(int pixels) { parts_->camera.setBottomMargin(pixels); }

void PatchScene::fit() { parts_->camera.fit(); }

void PatchScene::showStandardView(View view) { parts_->camera.lookFrom(view); }

void PatchScene::centerOn(CellId cell) {
  const SceneCell* found = parts_->content ? parts_->content->layout.find(cell) : nullptr;
  if (found != nullptr) parts_->camera.centerOn(found->T_s_u.t);
}

std::optional<PatchScene::View> PatchScene::viewAt(double x, double y) const {
  constexpr std::array<View, 3> kPositive = {View::Side, View::Top, View::Front};
  constexpr std::array<View, 3> kNegative = {View::OtherSide, View::Bottom, View::Back};
  const std::optional<AxisEnd> end = parts_->corners.endAt(x, y);
  if (!end) return std::nullopt;
  const View wanted = (end->positive ? kPositive : kNegative).at(end->axis);
  return parts_->camera.looksFrom(wanted) ? (end->positive ? kNegative : kPositive).at(end->axis) : wanted;
}

bool PatchScene::hoverAxes(double x, double y) { return parts_->corners.setHovered(parts_->corners.endAt(x, y)); }

void PatchScene::setCut(std::optional<double> share) {
  parts_->cut_share = share;
  parts_->updateCut();
}

void PatchScene::alignCut() {
  parts_->cut.reset();
  parts_->updateCut();
}

const std::optional<SceneCut>& PatchScene::cut() const { return parts_->cut; }

PatchScene::Depths PatchScene::depths() const {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  Depths depths;
  depths.parallel = camera->GetParallelProjection() != 0;
  camera->GetClippingRange(depths.near_m, depths.far_m);
  if (!parts_->window) return depths;
  const int* size = parts_->window->GetSize();
  vtkRendererCollection* renderers = parts_->window->GetRenderers();
  renderers->InitTraversal();
  while (vtkRenderer* other = renderers->GetNextItem()) {
    if (other == parts_->renderer || other->GetDraw() == 0) continue;
    const double* place = other->GetViewport();
    depths.elsewhere.push_back(
        {static_cast<int>(std::floor(place[0] * size[0])), static_cast<int>(std::floor(place[1] * size[1])),
         static_cast<int>(std::ceil(place[2] * size[0])), static_cast<int>(std::ceil(place[3] * size[1]))});
  }
  return depths;
}

std::vector<CellId> PatchScene::labelledCells() const {
  std::vector<CellId> cells;
  for (const PlacedLabel& label : parts_->labels.drawn()) {
    cells.push_back(parts_->content->layout.cells.at(label.cell).id);
  }
  return cells;
}

void PatchScene::keepView() { parts_->camera.keepView(); }

void PatchScene::returnToKeptView() { parts_->camera.returnToKeptView(); }

void PatchScene::setParallel(bool parallel) { parts_->camera.setParallel(parallel); }

void PatchScene::spin(double angle_rad) { parts_->camera.spin(parts_->upShown(), angle_rad); }

void PatchScene::fitIfDue() {
  if (parts_->window) parts_->camera.fitIfPending(parts_->surroundings());
}

std::optional<CellId> PatchScene::pick(double x, double y) {
  if (!parts_->window) return std::nullopt;
  fitIfDue();
  return parts_->skin.pick(x, y);
}

const SceneContent* PatchScene::content() const { return parts_->content.get(); }

const CellReadings& PatchScene::readings() const { return parts_->skin.readings(); }

std::vector<std::optional<double>> PatchScene::values() const {
  if (!parts_->content) return {};
  return cellValues(parts_->skin.coloring(), parts_->content->figures, parts_->skin.readings());
}

std::optional<ScaleLegend> PatchScene::scale() const { return parts_->skin.scale(); }

bool PatchScene::showsGravity() const { return parts_->upShown().has_value(); }

vtkRenderer* PatchScene::renderer() const { return parts_->renderer; }

}  // namespace hexoderm
