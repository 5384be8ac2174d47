#pragma once

#include "hexoderm/solve/metrics/patch_mesh.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_legend.h"
#include "widgets/scene/blending_renderer.h"
#include "widgets/scene/mesh_actor.h"
#include "widgets/scene/patch_moment.h"
#include "widgets/scene/polydata_builder.h"
#include "widgets/scene/scene_camera.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_corners.h"
#include "widgets/scene/scene_cut.h"
#include "widgets/scene/scene_ghost.h"
#include "widgets/scene/scene_items.h"
#include "widgets/scene/scene_labels.h"
#include "widgets/scene/scene_overlays.h"
#include "widgets/scene/scene_sight.h"
#include "widgets/scene/scene_skin.h"
#include "widgets/style/scene_colors.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>
#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hexoderm {

// Shares of the way from the middle to a corner: between an ID in the middle and the ports at the edges.
inline constexpr double kBrushInner = 0.58;
inline constexpr double kBrushOuter = 0.72;
inline constexpr double kBrushLift = 0.02;  // of the side's length, so that it lies on the face and not in it

/// A hexagonal ring inside the front face of each of these cells, in the mark that stands out from the face: no hue, so
/// that it goes with every colouring. Cells that are not there have none. `front_colors`: of all cells.
inline vtkSmartPointer<vtkPolyData> makeBrushMarks(const SceneContent& content, const std::vector<CellId>& cells,
                                                   const std::vector<Rgb>& front_colors, const SceneColors& colors) {
  PolyDataBuilder mesh;
  if (cells.empty()) return mesh.finish();
  const CellModel& model = *content.reconstruction->model;
  for (const CellId cell : cells) {
    const SceneCell* found = content.layout.find(cell);
    if (found == nullptr) continue;
    const auto index = static_cast<std::size_t>(found - content.layout.cells.data());
    const Rgb& mark = markOn(index < front_colors.size() ? front_colors[index] : colors.neutral, colors);
    const auto corners = prismCorners(model, found->T_s_u);
    const Eigen::Vector3d center = found->T_s_u.t;
    const Eigen::Vector3d lift = found->T_s_u.R * Eigen::Vector3d(0, 0, kBrushLift * model.side_m);
    const vtkIdType first = mesh.pointCount();
    for (std::size_t k = 0; k < 6; ++k) {
      mesh.addPoint(center + lift + kBrushInner * (corners.at(k) - center));
      mesh.addPoint(center + lift + kBrushOuter * (corners.at(k) - center));
    }
    for (vtkIdType k = 0; k < 6; ++k) {
      const vtkIdType next = (k + 1) % 6;
      mesh.addPolygon({first + 2 * k, first + 2 * k + 1, first + 2 * next + 1, first + 2 * next}, mark);
    }
  }
  return mesh.finish();
}

/// The patch in 3D without Qt: cells, ports, IDs, origin, axes, the direction of gravity, and overlays (SceneItem). VTK
/// draws it into the render window that it is attached to, and only when that window renders.
///
/// A skin of up to SceneContent::kMaxPrismCells cells is drawn as prisms, a larger one as its front faces only. Making
/// a large skin's content takes longer than drawing it, so it can be made on another thread and handed over; every
/// other setter is cheap enough to be called for each new result.
class PatchScene {
 public:
  using View = SceneCamera::View;

  PatchScene() {
    // A ring lies on the faces and keeps its colour in any light.
    brush_.property()->LightingOff();
    brush_.show(nullptr);
    renderer_->AddActor(brush_.actor);
    addSceneLights(renderer_);
    renderer_->GradientBackgroundOn();
    observer_ = renderer_->AddObserver(vtkCommand::StartEvent, this, &PatchScene::beforeRender);
  }

  ~PatchScene() {
    renderer_->RemoveObserver(observer_);
    if (!window_) return;
    corners_.detachFrom(window_);
    ghost_.detachFrom(window_);
    window_->RemoveRenderer(renderer_);
  }

  PatchScene(const PatchScene&) = delete;
  PatchScene& operator=(const PatchScene&) = delete;

  /// Adds the scene's renderers to the window; once. The scene must outlive the window's last rendering.
  void attachTo(vtkRenderWindow* window) {
    window_ = window;
    window->SetMultiSamples(0);
    window->SetNumberOfLayers(2);
    window->AddRenderer(renderer_);
    corners_.attachTo(window);
    ghost_.attachTo(window);
  }

  /// Null empties the scene. The camera moves only when the set of cells has changed.
  void setContent(std::shared_ptr<const SceneContent> content) {
    content_ = std::move(content);
    camera_.setContent(content_);
    skin_.setContent(content_);
    drawn_overlays_.setContent(content_);
    labels_.setContent(content_);
    ghost_.setLayout(content_ ? content_->layout : SceneLayout{});
    recolor();
    updateItems();
    if (cut_share_) updateCut();
  }

  /// Makes the content here and now, and shows it.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
    setContent(makeSceneContent(std::move(reconstruction)));
  }

  void setColors(const SceneColors& colors) {
    colors_ = colors;
    skin_.setColors(colors);
    drawn_overlays_.setColors(colors);
    recolor();
  }

  void setColoring(Coloring coloring) {
    skin_.setColoring(coloring);
    recolor();
  }

  /// Of the scale of the colouring; none: fitted to what is shown.
  void setFixedRange(const std::optional<ColorRange>& range) {
    skin_.setFixedRange(range);
    recolor();
  }

  /// Draws anew only the overlays that are other ones than before.
  void setOverlays(const PatchOverlays& overlays) {
    drawn_overlays_.setOverlays(overlays);
    if (std::exchange(surface_, overlays.surface) == overlays.surface) return;
    std::unordered_map<CellId, double> distance_m;
    if (const SurfaceEvaluation* surface = overlays.surface.get()) {
      for (std::size_t k = 0; k < surface->cells.size(); ++k) distance_m[surface->cells[k]] = surface->distance_m[k];
    }
    skin_.setSurfaceDistances(std::move(distance_m));
    recolor();
  }

  /// The enlargement of the differences with another calibration; none: as far as they can be told apart.
  void setShiftFactor(std::optional<double> factor) { drawn_overlays_.setShiftFactor(factor); }
  /// Draws anew only what has changed since the moment before. Cells without a reading are neutral.
  void setMoment(const PatchMoment& moment) {
    const PatchMoment before = std::exchange(moment_, moment);
    if (moment.readings != before.readings) {
      skin_.setReadings(moment.readings ? *moment.readings : CellReadings{});
      if (isReading(skin_.coloring())) recolor();
    }
    const bool other_up = moment.up_o != before.up_o;
    if (other_up) camera_.follow(moment.up_o);
    if (other_up || moment.pose != before.pose || moment.next_up_o != before.next_up_o) updateUp();
  }

  [[nodiscard]] const PatchMoment& moment() const { return moment_; }
  void setShown(SceneItem item, bool shown) {
    shown_.at(indexOf(item)) = shown;
    drawn_overlays_.setShown(item, shown);
    updateItems();
  }

  [[nodiscard]] Availability availability(SceneItem item) const { return drawn_overlays_.availability(item); }
  /// Notes on the overlays that are drawn over the cells, with their enlargements.
  [[nodiscard]] const SceneNotes& notes() { return drawn_overlays_.notes(); }
  /// The arrow of gravity is that in the frame of this cell's patch; none, or a cell of another skin: of the largest
  /// patch. What is picked is marked over the picture, so that the scene need not be drawn anew for it.
  void setPicked(std::optional<CellId> cell) {
    picked_cell_ = cell;
    updateUp();
  }

  /// Marks these cells with a ring on their faces, those of them that the reconstruction has.
  void setBrushed(std::vector<CellId> cells) {
    brushed_ = std::move(cells);
    updateBrushed();
  }

  /// The cells between which is measured: one is outlined, two are joined by a line.
  void setMeasured(std::optional<CellId> first, std::optional<CellId> second) {
    drawn_overlays_.setMeasured(first, second);
  }

  /// Turns the ghost from the present orientation (0) to the next (1).
  void setGhostPhase(double phase) { ghost_.setPhase(phase); }
  [[nodiscard]] bool showsGhost() const { return ghost_.isVisible(); }
  /// The present up, else that of the pose whose gravity is shown; none without either.
  [[nodiscard]] std::optional<Eigen::Vector3d> upShown() const {
    if (moment_.up_o) return moment_.up_o;
    const GravityDirection* direction = gravity();
    return direction == nullptr ? std::nullopt : std::optional<Eigen::Vector3d>(direction->g_o);
  }

  /// Makes the part seem to turn about gravity, counter-clockwise seen from above.
  void spin(double angle_rad) { camera_.spin(upShown(), angle_rad); }
  /// IDs and the letters of the axes; pictures that are compared go without.
  void setTextVisible(bool visible) {
    text_visible_ = visible;
    updateItems();
    corners_.setTextVisible(visible);
  }

  /// Pixels of the window's top that something else covers: what is fitted stays below.
  void setTopMargin(int pixels) { camera_.setTopMargin(pixels); }
  /// The same at the bottom.
  void setBottomMargin(int pixels) { camera_.setBottomMargin(pixels); }
  /// Moves the camera along its direction until everything that is drawn fits into the window.
  void fit() { camera_.fit(); }
  void showStandardView(View view) { camera_.lookFrom(view); }
  /// Brings a cell into the middle of the picture without turning or zooming, if it is there.
  void centerOn(CellId cell) {
    const SceneCell* found = content_ ? content_->layout.find(cell) : nullptr;
    if (found != nullptr) camera_.centerOn(found->T_s_u.t);
  }

  /// The view that a knob of the axes stands for, at a pixel of the window (origin lower left); where it is seen from
  /// there already, the opposite one. None beside the knobs.
  [[nodiscard]] std::optional<View> viewAt(double x, double y) const {
    constexpr std::array<View, 3> kPositive = {View::Side, View::Top, View::Front};
    constexpr std::array<View, 3> kNegative = {View::OtherSide, View::Bottom, View::Back};
    const std::optional<AxisEnd> end = corners_.endAt(x, y);
    if (!end) return std::nullopt;
    const View wanted = (end->positive ? kPositive : kNegative).at(end->axis);
    return camera_.looksFrom(wanted) ? (end->positive ? kNegative : kPositive).at(end->axis) : wanted;
  }

  /// Lights the knob at this pixel; true if that changes the picture.
  bool hoverAxes(double x, double y) { return corners_.setHovered(corners_.endAt(x, y)); }
  /// Remembers the present direction; returnToKeptView() looks from there again and fits. Without a kept view it does
  /// nothing.
  void keepView() { camera_.keepView(); }
  void returnToKeptView() { camera_.returnToKeptView(); }
  /// Parallel instead of perspective projection; the point that is looked at keeps its size.
  void setParallel(bool parallel) { camera_.setParallel(parallel); }

  /// Carries out a fit that was asked for, as the next rendering would.
  void fitIfDue() {
    if (window_) camera_.fitIfPending(surroundings());
  }

  /// Cuts the scene open by a plane that faces the viewer as he looks now: `share` of the skin's depth in that
  /// direction is taken away, 0 to 1. The plane then stays where it is, so that one can look at the cut from elsewhere;
  /// another share moves it along. None: the skin is whole again.
  void setCut(std::optional<double> share) {
    cut_share_ = share;
    updateCut();
  }

  /// Makes the plane face the viewer as he looks now.
  void alignCut() {
    cut_.reset();
    updateCut();
  }

  [[nodiscard]] const std::optional<SceneCut>& cut() const { return cut_; }

  /// The cells whose IDs the last picture has.
  [[nodiscard]] std::vector<CellId> labelledCells() const {
    std::vector<CellId> cells;
    for (const PlacedLabel& label : labels_.drawn()) {
      cells.push_back(content_->layout.cells.at(label.cell).id);
    }
    return cells;
  }

  /// The cell at a pixel of the window (origin lower left); none beside the skin.
  [[nodiscard]] std::optional<CellId> pick(double x, double y) {
    if (!window_) return std::nullopt;
    fitIfDue();
    return skin_.pick(sight(), {x, y});
  }

  [[nodiscard]] const SceneContent* content() const { return content_.get(); }
  [[nodiscard]] const CellReadings& readings() const { return skin_.readings(); }
  /// The scale of the colouring, if that is one of a quantity and cells are shown.
  [[nodiscard]] std::optional<ScaleLegend> scale() const { return skin_.scale(); }
  /// True if the arrow of gravity is there: not without a pose, nor while it is switched off.
  [[nodiscard]] bool showsGravity() const { return upShown().has_value(); }

  [[nodiscard]] vtkRenderer* renderer() const { return renderer_; }
  /// As the camera looks now.
  [[nodiscard]] SceneSight sight() const {
    const int* pixels = window_ ? window_->GetSize() : nullptr;
    const std::array<int, 2> size = {pixels != nullptr ? pixels[0] : 0, pixels != nullptr ? pixels[1] : 0};
    return SceneSight::of(renderer_->GetActiveCamera(), size, window_ ? window_->GetDPI() : 72);
  }

 private:
  SceneCamera::Surroundings surroundings() const {
    const SceneSight now = sight();
    return {now.window, now.text_scale, ghost_.isVisible(), showsGravity()};
  }

  void beforeRender() {
    if (drawn_overlays_.update()) camera_.setMore(drawn_overlays_.points());
    camera_.prepare(surroundings());
    renderer_->ResetCameraClippingRange();
    if (!window_) return;
    const SceneSight now = sight();
    skin_.update(now);
    labels_.update(now);
    corners_.follow(now);
    ghost_.follow(now);
  }

  void recolor() {
    renderer_->SetBackground2(colors_.background_top.data());
    renderer_->SetBackground(colors_.background_bottom.data());
    corners_.setColors(colors_);
    ghost_.setColors(colors_);
    labels_.setColors(skin_.frontColors(), colors_);
    updateBrushed();
  }

  void updateItems() {
    skin_.setPortsVisible(shown_.at(indexOf(SceneItem::Ports)));
    labels_.setVisible(text_visible_ && shown_.at(indexOf(SceneItem::Ids)));
    corners_.setAxesVisible(content_ && !content_->layout.cells.empty() && shown_.at(indexOf(SceneItem::Axes)));
    updateUp();
  }

  void updateBrushed() {
    const bool any = content_ && !brushed_.empty();
    brush_.show(any ? makeBrushMarks(*content_, brushed_, skin_.frontColors(), colors_) : nullptr);
  }

  void updateUp() {
    const std::optional<Eigen::Vector3d> up = upShown();
    corners_.setDown(up ? std::optional<Eigen::Vector3d>(-*up) : std::nullopt);
    const bool was_there = ghost_.isVisible();
    ghost_.setTurn(up.value_or(Eigen::Vector3d::UnitZ()), up ? moment_.next_up_o : std::nullopt);
    // The skin makes room for it.
    if (ghost_.isVisible() != was_there) camera_.fitIfUntouched();
  }

  void updateCut() {
    if (!cut_share_ || !content_ || content_->layout.points.empty()) {
      cut_.reset();
    } else {
      if (!cut_) cut_ = SceneCut{backOfCamera(renderer_->GetActiveCamera()), 0};
      double least = std::numeric_limits<double>::infinity();
      double most = -least;
      for (const Eigen::Vector3d& p : content_->layout.points) {
        least = std::min(least, cut_->normal.dot(p));
        most = std::max(most, cut_->normal.dot(p));
      }
      // At the ends everything is there, or nothing.
      constexpr double kBeyond = 0.001;
      const double beyond = kBeyond * (most - least);
      cut_->offset_m = most + beyond - *cut_share_ * (most - least + 2 * beyond);
    }
    skin_.setCut(cut_);
    drawn_overlays_.setCut(cut_);
    labels_.setCut(cut_);
  }

  /// Every patch has a frame of its own: this is the gravity of the picked cell's patch, or else of the largest
  /// patch, or of the first that has one.
  const GravityDirection* gravity() const {
    if (!content_ || content_->layout.cells.empty() || !shown_.at(indexOf(SceneItem::Gravity))) return nullptr;
    const Reconstruction* reconstruction = content_->reconstruction.get();
    const PatchReconstruction* patch = picked_cell_ ? reconstruction->find(*picked_cell_).patch : nullptr;
    if (patch == nullptr) patch = largestPatch(*reconstruction);
    if (patch->gravity.empty() && !picked_cell_) {
      const auto found =
          std::ranges::find_if(reconstruction->patches, [](const auto& p) { return !p.gravity.empty(); });
      if (found == reconstruction->patches.end()) return nullptr;
      patch = &*found;
    }
    if (patch->gravity.empty()) return nullptr;
    if (!moment_.pose) return &patch->gravity.back();
    const auto found = std::ranges::find(patch->gravity, *moment_.pose, &GravityDirection::pose);
    return found == patch->gravity.end() ? nullptr : &*found;
  }

  std::shared_ptr<const SceneContent> content_;
  SceneColors colors_;
  std::optional<CellId> picked_cell_;
  std::vector<CellId> brushed_;
  PatchMoment moment_;
  std::shared_ptr<const SurfaceEvaluation> surface_;
  std::optional<double> cut_share_;
  std::optional<SceneCut> cut_;
  bool text_visible_ = true;
  ShownItems shown_ = kShownAtFirst;

  vtkNew<BlendingRenderer> renderer_;
  vtkWeakPointer<vtkRenderWindow> window_;
  unsigned long observer_ = 0;
  SceneCamera camera_{renderer_};
  SceneSkin skin_{renderer_};
  SceneOverlays drawn_overlays_{renderer_};
  SceneLabels labels_{renderer_};
  MeshActor brush_;
  SceneCorners corners_;
  SceneGhost ghost_;
};

}  // namespace hexoderm
