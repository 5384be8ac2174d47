#pragma once

#include "hexoderm/reconstruction/advice/pose_coverage.h"
#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_legend.h"
#include "widgets/scene/blending_renderer.h"
#include "widgets/scene/brush_marks.h"
#include "widgets/scene/cell_meshes.h"
#include "widgets/scene/patch_moment.h"
#include "widgets/scene/patch_overlays.h"
#include "widgets/scene/scene_camera.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_corners.h"
#include "widgets/scene/scene_cut.h"
#include "widgets/scene/scene_ghost.h"
#include "widgets/scene/scene_items.h"
#include "widgets/scene/scene_labels.h"
#include "widgets/scene/scene_overlays.h"
#include "widgets/scene/scene_skin.h"
#include "widgets/style/scene_colors.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
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
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hexoderm {

/// The patch in 3D without Qt: cells, ports, IDs, origin, axes, the direction of gravity, and overlays (SceneItem). VTK
/// draws it into the render window that it is attached to, and only when that window renders.
///
/// A skin of up to SceneContent::kMaxPrismCells cells is drawn as prisms, a larger one as its front faces only. Making
/// a large skin's content takes longer than drawing it, so it can be made on another thread and handed over; every
/// other setter is cheap enough to be called for each new result.
class PatchScene {
 public:
  using View = SceneCamera::View;

  PatchScene() : parts_(std::make_unique<Parts>()) {}

  /// Adds the scene's renderers to the window; once. The scene must outlive the window's last rendering.
  void attachTo(vtkRenderWindow* window) {
    parts_->window = window;
    window->SetMultiSamples(0);
    window->SetNumberOfLayers(2);
    window->AddRenderer(parts_->renderer);
    parts_->corners.attachTo(window);
    parts_->ghost.attachTo(window);
  }

  /// Null empties the scene. The camera moves only when the set of cells has changed.
  void setContent(std::shared_ptr<const SceneContent> content) {
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

  /// Makes the content here and now, and shows it.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
    setContent(makeSceneContent(std::move(reconstruction)));
  }

  void setColors(const SceneColors& colors) {
    parts_->colors = colors;
    parts_->skin.setColors(colors);
    parts_->drawn_overlays.setColors(colors);
    parts_->recolor();
  }

  void setColoring(Coloring coloring) {
    parts_->skin.setColoring(coloring);
    parts_->recolor();
  }

  /// Of the scale of the colouring; none: fitted to what is shown.
  void setFixedRange(const std::optional<ColorRange>& range) {
    parts_->skin.setFixedRange(range);
    parts_->recolor();
  }

  /// Draws anew only the overlays that are other ones than before.
  void setOverlays(const PatchOverlays& overlays) {
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

  [[nodiscard]] const PatchOverlays& overlays() const { return parts_->overlays; }
  /// The enlargement of the differences with another calibration; none: as far as they can be told apart.
  void setShiftFactor(std::optional<double> factor) { parts_->drawn_overlays.setShiftFactor(factor); }
  /// Draws anew only what has changed since the moment before. Cells without a reading are neutral.
  void setMoment(const PatchMoment& moment) {
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

  [[nodiscard]] const PatchMoment& moment() const { return parts_->moment; }
  void setShown(SceneItem item, bool shown) {
    parts_->shown.at(indexOf(item)) = shown;
    parts_->drawn_overlays.setShown(item, shown);
    parts_->updateItems();
  }

  [[nodiscard]] Availability availability(SceneItem item) const { return parts_->drawn_overlays.availability(item); }
  /// Notes on the overlays that are drawn over the cells, with their enlargements.
  [[nodiscard]] const SceneNotes& notes() { return parts_->drawn_overlays.notes(); }
  /// The arrow of gravity is that in the frame of this cell's patch; none, or a cell of another skin: of the largest
  /// patch. What is picked is marked over the picture, so that the scene need not be drawn anew for it.
  void setPicked(std::optional<CellId> cell) {
    parts_->picked_cell = cell;
    parts_->updateGravity();
    parts_->updateGhost();
  }

  /// Marks these cells with a ring on their faces, those of them that the reconstruction has.
  void setBrushed(std::vector<CellId> cells) {
    parts_->brushed = std::move(cells);
    parts_->updateBrushed();
  }

  /// The cells between which is measured: one is outlined, two are joined by a line.
  void setMeasured(std::optional<CellId> first, std::optional<CellId> second) {
    parts_->drawn_overlays.setMeasured(first, second);
  }

  /// Turns the ghost from the present orientation (0) to the next (1).
  void setGhostPhase(double phase) { parts_->ghost.setPhase(phase); }
  [[nodiscard]] bool showsGhost() const { return parts_->ghost.isVisible(); }
  /// The present up, else that of the pose whose gravity is shown; none without either.
  [[nodiscard]] std::optional<Eigen::Vector3d> upShown() const { return parts_->upShown(); }
  /// Makes the part seem to turn about gravity, counter-clockwise seen from above.
  void spin(double angle_rad) { parts_->camera.spin(parts_->upShown(), angle_rad); }
  /// IDs and the letters of the axes; pictures that are compared go without.
  void setTextVisible(bool visible) {
    parts_->text_visible = visible;
    parts_->updateItems();
    parts_->corners.setTextVisible(visible);
  }

  /// Pixels of the window's top that something else covers: what is fitted stays below.
  void setTopMargin(int pixels) { parts_->camera.setTopMargin(pixels); }
  /// The same at the bottom.
  void setBottomMargin(int pixels) { parts_->camera.setBottomMargin(pixels); }
  /// Moves the camera along its direction until everything that is drawn fits into the window.
  void fit() { parts_->camera.fit(); }
  void showStandardView(View view) { parts_->camera.lookFrom(view); }
  /// Brings a cell into the middle of the picture without turning or zooming, if it is there.
  void centerOn(CellId cell) {
    const SceneCell* found = parts_->content ? parts_->content->layout.find(cell) : nullptr;
    if (found != nullptr) parts_->camera.centerOn(found->T_s_u.t);
  }

  /// The view that a knob of the axes stands for, at a pixel of the window (origin lower left); where it is seen from
  /// there already, the opposite one. None beside the knobs.
  [[nodiscard]] std::optional<View> viewAt(double x, double y) const {
    constexpr std::array<View, 3> kPositive = {View::Side, View::Top, View::Front};
    constexpr std::array<View, 3> kNegative = {View::OtherSide, View::Bottom, View::Back};
    const std::optional<AxisEnd> end = parts_->corners.endAt(x, y);
    if (!end) return std::nullopt;
    const View wanted = (end->positive ? kPositive : kNegative).at(end->axis);
    return parts_->camera.looksFrom(wanted) ? (end->positive ? kNegative : kPositive).at(end->axis) : wanted;
  }

  /// Lights the knob at this pixel; true if that changes the picture.
  bool hoverAxes(double x, double y) { return parts_->corners.setHovered(parts_->corners.endAt(x, y)); }
  /// Remembers the present direction; returnToKeptView() looks from there again and fits. Without a kept view it does
  /// nothing.
  void keepView() { parts_->camera.keepView(); }
  void returnToKeptView() { parts_->camera.returnToKeptView(); }
  /// Parallel instead of perspective projection; the point that is looked at keeps its size.
  void setParallel(bool parallel) { parts_->camera.setParallel(parallel); }

  /// Carries out a fit that was asked for, as the next rendering would.
  void fitIfDue() {
    if (parts_->window) parts_->camera.fitIfPending(parts_->surroundings());
  }

  /// Cuts the scene open by a plane that faces the viewer as he looks now: `share` of the skin's depth in that
  /// direction is taken away, 0 to 1. The plane then stays where it is, so that one can look at the cut from elsewhere;
  /// another share moves it along. None: the skin is whole again.
  void setCut(std::optional<double> share) {
    parts_->cut_share = share;
    parts_->updateCut();
  }

  /// Makes the plane face the viewer as he looks now.
  void alignCut() {
    parts_->cut.reset();
    parts_->updateCut();
  }

  [[nodiscard]] const std::optional<SceneCut>& cut() const { return parts_->cut; }

  /// The cells whose IDs the last picture has.
  [[nodiscard]] std::vector<CellId> labelledCells() const {
    std::vector<CellId> cells;
    for (const PlacedLabel& label : parts_->labels.drawn()) {
      cells.push_back(parts_->content->layout.cells.at(label.cell).id);
    }
    return cells;
  }

  /// The cell at a pixel of the window (origin lower left); none beside the skin.
  [[nodiscard]] std::optional<CellId> pick(double x, double y) {
    if (!parts_->window) return std::nullopt;
    fitIfDue();
    return parts_->skin.pick(x, y);
  }

  [[nodiscard]] const SceneContent* content() const { return parts_->content.get(); }
  [[nodiscard]] const CellReadings& readings() const { return parts_->skin.readings(); }
  /// The values that the cells are coloured by, in the unit that is shown; for the legend.
  [[nodiscard]] std::vector<std::optional<double>> values() const {
    if (!parts_->content) return {};
    return cellValues(parts_->skin.coloring(), parts_->content->figures, parts_->skin.readings());
  }

  /// The scale of the colouring, if that is one of a quantity and cells are shown.
  [[nodiscard]] std::optional<ScaleLegend> scale() const { return parts_->skin.scale(); }
  /// True if the arrow of gravity is there: not without a pose, nor while it is switched off.
  [[nodiscard]] bool showsGravity() const { return parts_->upShown().has_value(); }

  [[nodiscard]] vtkRenderer* renderer() const { return parts_->renderer; }

 private:
  struct Parts {
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

    Parts() {
      // An outline lies on the faces and keeps its colour in any light.
      brush_actor->SetMapper(brush_mapper);
      brush_actor->VisibilityOff();
      brush_actor->GetProperty()->LightingOff();
      renderer->AddActor(brush_actor);

      addSceneLights(renderer);
      renderer->GradientBackgroundOn();

      observer = renderer->AddObserver(vtkCommand::StartEvent, this, &Parts::beforeRender);
    }

    ~Parts() {
      renderer->RemoveObserver(observer);
      if (window) {
        corners.detachFrom(window);
        ghost.detachFrom(window);
        window->RemoveRenderer(renderer);
      }
    }

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

    /// Every patch has a frame of its own: this is the gravity of the picked cell's patch, or else of the largest
    /// patch, or of the first that has one.
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
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
