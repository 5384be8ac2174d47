#include "widgets/scene/patch_scene.h"

#include "hexoderm/reconstruction/advice/pose_coverage.h"
#include "widgets/scene/cell_meshes.h"
#include "widgets/scene/patch_scene_parts.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkLight.h>
#include <vtkProperty.h>
#include <algorithm>

namespace hexoderm {
namespace {

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
