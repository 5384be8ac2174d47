#pragma once

#include "hexoderm/solve/metrics/overlays.h"
#include "widgets/scene/mesh_actor.h"
#include "widgets/scene/overlay_meshes.h"
#include "widgets/scene/patch_moment.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_cut.h"
#include "widgets/scene/scene_items.h"
#include "widgets/style/scene_colors.h"

#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {

/// The things that are drawn over the cells: frames about patches that are not placed, links, tree, uncertainty, truth,
/// fitted surface, loop gap, differences, and the line of a measurement. Each kind is made anew only when it is drawn
/// after a change; setters cost nothing.
class SceneOverlays {
 public:
  /// More would be neither told apart nor quick.
  static constexpr std::size_t kMaxCells = 5000;
  static constexpr std::size_t kMaxEllipsoids = 2000;

  explicit SceneOverlays(vtkRenderer* renderer) {
    for (DrawnOverlay& thing : drawn_) {
      thing.show(nullptr);
      renderer->AddActor(thing.actor);
    }
    const auto property = [this](Kind kind) { return drawn_.at(kind).property(); };
    for (const Kind kind : {kFrames, kLinks, kTree, kTruth, kDistances, kMeasure}) property(kind)->LightingOff();
    property(kFrames)->SetLineWidth(1.5F);
    property(kLinks)->SetLineWidth(3.0F);
    property(kTree)->SetLineWidth(6.0F);
    property(kTree)->SetOpacity(0.45);
    property(kTruth)->SetLineWidth(1.5F);
    property(kTruth)->SetOpacity(0.75);
    property(kDistances)->SetLineWidth(2.5F);
    property(kMeasure)->SetLineWidth(3.5F);
    property(kEllipsoids)->SetOpacity(0.7);
    property(kSheet)->SetOpacity(0.28);
    drawn_.at(kSheet).setAmbient(0.5);
    for (const Kind kind : {kEllipsoids, kLoop, kShifts}) drawn_.at(kind).setAmbient(0.45);
    // Faces lie in the fitted surface, which cuts them here and there; drawn a little behind them it leaves them whole.
    setDepth(kSheet, "min(gl_FragCoord.z + 0.01, 1.0)");
    // Arrows come from below the faces as well as from above: they are seen through everything, as is what is measured.
    for (const Kind kind : {kLoop, kShifts, kMeasure}) setDepth(kind, "0.001 * gl_FragCoord.z");
  }

  void setContent(std::shared_ptr<const SceneContent> content) {
    content_ = std::move(content);
    surface_mesh_.reset();
    invalidateAll();
  }

  void setColors(const SceneColors& colors) {
    colors_ = colors;
    const std::pair<Kind, Rgb> paints[] = {
        {kFrames, colors.neutral},  {kTree, colors.text},         {kEllipsoids, colors.ellipsoid},
        {kTruth, colors.overlay},   {kSheet, colors.overlay},     {kDistances, colors.text},
        {kLoop, colors.difference}, {kShifts, colors.difference}, {kMeasure, colors.selection}};
    for (const auto& [kind, color] : paints) drawn_.at(kind).setColor(color);
    invalidate({kLinks});
  }

  void setShown(SceneItem item, bool shown) {
    shown_.at(indexOf(item)) = shown;
    invalidateAll();
  }

  void setOverlays(const PatchOverlays& overlays) {
    const PatchOverlays before = std::exchange(overlays_, overlays);
    if (overlays.truth != before.truth) invalidate({kTruth});
    if (overlays.surface != before.surface) {
      surface_mesh_.reset();
      invalidate({kSheet, kDistances});
    }
    if (overlays.loop != before.loop) invalidate({kLoop});
    if (overlays.comparison != before.comparison) invalidate({kShifts});
  }

  /// The enlargement of the differences; none: as far as they can be told apart.
  void setShiftFactor(std::optional<double> factor) {
    if (std::exchange(shift_factor_, factor) != factor) invalidate({kShifts});
  }

  /// A line between the centres of two cells of a patch, or outlines about cells of two patches or the first alone.
  void setMeasured(std::optional<CellId> first, std::optional<CellId> second) {
    first_ = first;
    second_ = second;
    invalidate({kMeasure});
  }

  /// Availability of the items that are drawn here; the others are always available.
  [[nodiscard]] Availability availability(SceneItem item) const {
    if (cells() == 0) return Availability::NoSkin;
    const auto needs = [](bool data) { return data ? Availability::Available : Availability::NoData; };
    const Availability limited = cells() > kMaxCells ? Availability::TooManyCells : Availability::Available;
    switch (item) {
      case SceneItem::Links:
      case SceneItem::Tree:
        return limited;
      case SceneItem::Ellipsoids: {
        const auto& known = content_->figures.position_95_m;
        const bool any = std::ranges::any_of(known, [](const auto& figure) { return figure.value_or(0) > 0; });
        return any && cells() > kMaxEllipsoids ? Availability::TooManyCells : needs(any);
      }
      case SceneItem::Truth:
        return overlays_.truth ? limited : Availability::NoData;
      case SceneItem::Comparison:
        return overlays_.comparison && !overlays_.comparison->empty() ? limited : Availability::NoData;
      case SceneItem::Surface:
        return needs(surfacePatch().has_value());
      case SceneItem::Loop:
        return needs(loopPoints().has_value());
      default:
        return Availability::Available;
    }
  }

  [[nodiscard]] const SceneNotes& notes() {
    update();
    return notes_;
  }

  /// Brings what is drawn up to date; called before each rendering.
  /// True if something is drawn otherwise than before.
  bool update() {
    bool changed = false;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      DrawnOverlay& thing = drawn_.at(kind);
      if (!std::exchange(thing.stale, false)) continue;
      const bool was_shown = thing.isShown();
      thing.show(make(static_cast<Kind>(kind)));
      changed = changed || was_shown || thing.isShown();
    }
    return changed;
  }

  /// Points of all that is drawn but measurements and frames; after update().
  [[nodiscard]] std::vector<Eigen::Vector3d> points() const {
    std::vector<Eigen::Vector3d> points;
    for (const Kind kind : {kEllipsoids, kTruth, kSheet, kDistances, kLoop, kShifts}) {
      const DrawnOverlay& thing = drawn_.at(kind);
      if (!thing.isShown()) continue;
      vtkPolyData* data = thing.mapper->GetInput();
      for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k) points.emplace_back(Eigen::Vector3d(data->GetPoint(k)));
    }
    return points;
  }

  /// What lies in front of the plane is cut away, but for arrows and what is measured, which are seen through
  /// everything.
  void setCut(const std::optional<SceneCut>& cut) {
    const auto mapper = [this](Kind kind) -> vtkMapper* { return drawn_.at(kind).mapper; };
    cut_.set(cut, {mapper(kFrames), mapper(kLinks), mapper(kTree), mapper(kEllipsoids), mapper(kTruth), mapper(kSheet),
                   mapper(kDistances)});
  }

 private:
  /// One kind of overlay.
  struct DrawnOverlay : MeshActor {
    bool stale = true;
  };

  enum Kind : std::size_t {
    kFrames,
    kLinks,
    kTree,
    kEllipsoids,
    kTruth,
    kSheet,
    kDistances,
    kLoop,
    kShifts,
    kMeasure,
    kKinds
  };

  /// The depth at which a thing counts, as GLSL.
  void setDepth(Kind kind, const std::string& depth) {
    drawn_.at(kind).actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
                                                                             "gl_FragDepth = " + depth + ";\n", false);
  }

  void invalidate(std::initializer_list<Kind> kinds) {
    for (const Kind kind : kinds) drawn_.at(kind).stale = true;
  }
  void invalidateAll() {
    for (DrawnOverlay& thing : drawn_) thing.stale = true;
  }
  [[nodiscard]] std::size_t cells() const { return content_ ? content_->layout.cells.size() : 0; }
  [[nodiscard]] bool draws(SceneItem item) const {
    return shown_.at(indexOf(item)) && availability(item) == Availability::Available;
  }
  /// Index of the evaluated patch, or none.
  [[nodiscard]] std::optional<std::size_t> surfacePatch() const {
    if (!content_ || !overlays_.surface) return std::nullopt;
    const auto& patches = content_->reconstruction->patches;
    const auto found = std::ranges::find(patches, overlays_.surface->patch, &PatchReconstruction::id);
    return found == patches.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - patches.begin()));
  }

  /// The link points of the loop, second first, in the scene; none if they are in different patches.
  [[nodiscard]] std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> loopPoints() const {
    if (!content_ || !overlays_.loop) return std::nullopt;
    const auto to = content_->portPoint(overlays_.loop->first);
    const auto from = content_->portPoint(overlays_.loop->second);
    if (!to || !from) return std::nullopt;
    const auto patchOf = [this](const LinkEnd& end) { return content_->layout.find(end.cell)->patch; };
    if (patchOf(overlays_.loop->first) != patchOf(overlays_.loop->second)) return std::nullopt;
    return std::pair(*from, *to);
  }

  /// Null where nothing is to be drawn.
  vtkSmartPointer<vtkPolyData> make(Kind kind) {
    const auto enlarged = [](EnlargedShape shape, std::optional<double>& factor) {
      factor = shape.factor;
      return shape.data;
    };
    switch (kind) {
      case kFrames: {
        const std::vector<std::size_t> apart = content_ ? content_->layout.notPlaced() : std::vector<std::size_t>();
        notes_.not_placed.clear();
        for (const std::size_t p : apart) notes_.not_placed.push_back(content_->reconstruction->patches[p].origin);
        const std::vector<std::size_t> framed = content_ ? content_->layout.framed() : std::vector<std::size_t>();
        notes_.frames = !framed.empty();
        return notes_.frames ? makePatchFrames(*content_, framed) : nullptr;
      }
      case kLinks:
        return draws(SceneItem::Links) ? makeLinkLines(*content_, colors_) : nullptr;
      case kTree:
        notes_.tree = draws(SceneItem::Tree);
        return notes_.tree ? makeTreeLines(*content_) : nullptr;
      case kEllipsoids:
        notes_.ellipsoid_factor.reset();
        return draws(SceneItem::Ellipsoids) ? enlarged(makeEllipsoids(*content_), notes_.ellipsoid_factor) : nullptr;
      case kTruth:
        notes_.truth = draws(SceneItem::Truth);
        return notes_.truth ? makeGhostOutlines(*content_, alignTruth(*content_->reconstruction, *overlays_.truth))
                            : nullptr;
      case kSheet:
      case kDistances: {
        if (kind == kDistances) notes_.distance_factor.reset();
        if (!draws(SceneItem::Surface)) return nullptr;
        const std::size_t patch = *surfacePatch();
        const Reconstruction& r = *content_->reconstruction;
        if (!surface_mesh_) surface_mesh_ = meshSurface(*overlays_.surface, r.patches[patch], 1.5 * r.model->side_m);
        if (surface_mesh_->points.empty()) return nullptr;
        if (kind == kSheet) return makeSurfaceSheet(*content_, *surface_mesh_, patch);
        return cells() > kMaxCells
                   ? nullptr
                   : enlarged(makeDistanceLines(*content_, *surface_mesh_, patch), notes_.distance_factor);
      }
      case kLoop: {
        notes_.loop_factor.reset();
        if (!draws(SceneItem::Loop)) return nullptr;
        const auto [from, to] = *loopPoints();
        return enlarged(makeGapArrow(*content_, from, to), notes_.loop_factor);
      }
      case kShifts: {
        notes_.shift_factor.reset();
        if (!draws(SceneItem::Comparison)) return nullptr;
        const auto shifts = shiftsOf(*content_->reconstruction, *overlays_.comparison);
        return enlarged(makeShiftArrows(*content_, shifts, shift_factor_), notes_.shift_factor);
      }
      case kMeasure:
        return makeMeasure();
      case kKinds:
        break;
    }
    return nullptr;
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> makeMeasure() const {
    const SceneCell* a = content_ && first_ ? content_->layout.find(*first_) : nullptr;
    if (a == nullptr) return nullptr;
    const SceneCell* b = second_ ? content_->layout.find(*second_) : nullptr;
    if (b == nullptr) return makeCellOutlines(*content_, {*first_});
    // There is no distance between patches, and so no line.
    return a->patch == b->patch ? makeLine(a->T_s_u.t, b->T_s_u.t) : makeCellOutlines(*content_, {*first_, *second_});
  }

  std::shared_ptr<const SceneContent> content_;
  SceneColors colors_;
  ShownItems shown_ = kShownAtFirst;
  PatchOverlays overlays_;
  std::optional<SurfaceMesh> surface_mesh_;  ///< the sheet and the distances are drawn from the same mesh
  std::optional<double> shift_factor_;
  std::optional<CellId> first_;
  std::optional<CellId> second_;
  std::array<DrawnOverlay, kKinds> drawn_;
  DrawnCut cut_;
  SceneNotes notes_;
};

}  // namespace hexoderm
