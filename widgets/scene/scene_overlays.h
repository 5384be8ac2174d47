#pragma once

#include "hexoderm/reconstruction/figures/overlays.h"
#include "widgets/scene/cell_meshes.h"
#include "widgets/scene/overlay_meshes.h"
#include "widgets/scene/patch_overlays.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_cut.h"
#include "widgets/scene/scene_items.h"
#include "widgets/style/scene_colors.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
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

  explicit SceneOverlays(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
    parts_->renderer = renderer;
    for (DrawnOverlay& thing : parts_->drawn) {
      thing.actor->SetMapper(thing.mapper);
      thing.actor->PickableOff();
      thing.actor->VisibilityOff();
      renderer->AddActor(thing.actor);
    }
    const auto property = [this](Kind kind) { return parts_->drawn.at(kind).actor->GetProperty(); };
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
    property(kSheet)->SetAmbient(0.5);
    property(kSheet)->SetDiffuse(0.5);
    for (const Kind kind : {kEllipsoids, kLoop, kShifts}) {
      property(kind)->SetAmbient(0.45);
      property(kind)->SetDiffuse(0.55);
    }
    // Faces lie in the fitted surface, which cuts them here and there; drawn a little behind them it leaves them whole.
    setDepth(parts_->drawn.at(kSheet).actor, "min(gl_FragCoord.z + 0.01, 1.0)");
    // Arrows come from below the faces as well as from above: they are seen through everything, as is what is measured.
    for (const Kind kind : {kLoop, kShifts, kMeasure}) setDepth(parts_->drawn.at(kind).actor, "0.001 * gl_FragCoord.z");
  }

  void setContent(std::shared_ptr<const SceneContent> content) {
    parts_->content = std::move(content);
    parts_->surface_mesh.reset();
    parts_->invalidateAll();
  }

  void setColors(const SceneColors& colors) {
    parts_->colors = colors;
    parts_->setStyles();
    parts_->invalidate({kFrames, kLinks});
  }

  void setShown(SceneItem item, bool shown) {
    parts_->shown.at(indexOf(item)) = shown;
    parts_->invalidateAll();
  }

  void setOverlays(const PatchOverlays& overlays) {
    const PatchOverlays before = std::exchange(parts_->overlays, overlays);
    if (overlays.truth != before.truth) parts_->invalidate({kTruth});
    if (overlays.surface != before.surface) {
      parts_->surface_mesh.reset();
      parts_->invalidate({kSheet, kDistances});
    }
    if (overlays.loop != before.loop) parts_->invalidate({kLoop});
    if (overlays.comparison != before.comparison) parts_->invalidate({kShifts});
  }

  /// The enlargement of the differences; none: as far as they can be told apart.
  void setShiftFactor(std::optional<double> factor) {
    if (std::exchange(parts_->shift_factor, factor) != factor) parts_->invalidate({kShifts});
  }

  /// A line between the centres of two cells of a patch, or outlines about cells of two patches or the first alone.
  void setMeasured(std::optional<CellId> first, std::optional<CellId> second) {
    parts_->first = first;
    parts_->second = second;
    parts_->invalidate({kMeasure});
  }

  /// Availability of the items that are drawn here; the others are always available.
  [[nodiscard]] Availability availability(SceneItem item) const { return parts_->availability(item); }
  [[nodiscard]] const SceneNotes& notes() {
    update();
    return parts_->notes;
  }

  /// Brings what is drawn up to date; called before each rendering.
  /// True if something is drawn otherwise than before.
  bool update() {
    bool changed = false;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      DrawnOverlay& thing = parts_->drawn.at(kind);
      if (!thing.stale) continue;
      thing.stale = false;
      const vtkSmartPointer<vtkPolyData> data = parts_->make(static_cast<Kind>(kind));
      const bool any = data && data->GetNumberOfCells() > 0;
      if (any) thing.mapper->SetInputData(data);
      changed = changed || any || thing.actor->GetVisibility() != 0;
      thing.actor->SetVisibility(any);
    }
    return changed;
  }

  /// Points of all that is drawn but measurements and frames; after update().
  [[nodiscard]] std::vector<Eigen::Vector3d> points() const {
    std::vector<Eigen::Vector3d> points;
    for (const Kind kind : {kEllipsoids, kTruth, kSheet, kDistances, kLoop, kShifts}) {
      const DrawnOverlay& thing = parts_->drawn.at(kind);
      if (thing.actor->GetVisibility() == 0) continue;
      vtkPolyData* data = thing.mapper->GetInput();
      for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k) points.emplace_back(Eigen::Vector3d(data->GetPoint(k)));
    }
    return points;
  }

  /// What lies in front of the plane is cut away, but for arrows and what is measured, which are seen through
  /// everything.
  void setCut(const std::optional<SceneCut>& cut) {
    const auto mapper = [this](Kind kind) -> vtkMapper* { return parts_->drawn.at(kind).mapper; };
    parts_->cut.set(cut, {mapper(kFrames), mapper(kLinks), mapper(kTree), mapper(kEllipsoids), mapper(kTruth),
                          mapper(kSheet), mapper(kDistances)});
  }

 private:
  /// One kind of overlay.
  struct DrawnOverlay {
    vtkNew<vtkActor> actor;
    vtkNew<vtkPolyDataMapper> mapper;
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
  static void setDepth(vtkActor* actor, const std::string& depth) {
    actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
                                                             "gl_FragDepth = " + depth + ";\n", false);
  }

  struct Parts {
    vtkRenderer* renderer = nullptr;
    std::shared_ptr<const SceneContent> content;
    SceneColors colors;
    ShownItems shown = kShownAtFirst;
    PatchOverlays overlays;
    std::optional<SurfaceMesh> surface_mesh;  ///< the sheet and the distances are drawn from the same mesh
    std::optional<double> shift_factor;
    std::optional<CellId> first;
    std::optional<CellId> second;
    std::array<DrawnOverlay, kKinds> drawn;
    DrawnCut cut;
    SceneNotes notes;

    void setStyles() {
      const auto paint = [&](Kind kind, const Rgb& color) {
        Rgb copy = color;
        drawn.at(kind).actor->GetProperty()->SetColor(copy.data());
      };
      paint(kFrames, colors.neutral);
      paint(kTree, colors.text);
      paint(kEllipsoids, colors.ellipsoid);
      paint(kTruth, colors.overlay);
      paint(kSheet, colors.overlay);
      paint(kDistances, colors.text);
      paint(kLoop, colors.difference);
      paint(kShifts, colors.difference);
      paint(kMeasure, colors.selection);
    }

    void invalidate(std::initializer_list<Kind> kinds) {
      for (const Kind kind : kinds) drawn.at(kind).stale = true;
    }
    void invalidateAll() {
      for (DrawnOverlay& thing : drawn) thing.stale = true;
    }
    [[nodiscard]] std::size_t cells() const { return content ? content->layout.cells.size() : 0; }
    Availability availability(SceneItem item) const {
      if (cells() == 0) return Availability::NoSkin;
      const auto needs = [](bool data) { return data ? Availability::Available : Availability::NoData; };
      const Availability limited = cells() > kMaxCells ? Availability::TooManyCells : Availability::Available;
      switch (item) {
        case SceneItem::Links:
        case SceneItem::Tree:
          return limited;
        case SceneItem::Ellipsoids: {
          const auto& known = content->figures.position_95_m;
          const bool any = std::ranges::any_of(known, [](const auto& figure) { return figure.value_or(0) > 0; });
          return !any ? Availability::NoData : cells() > kMaxEllipsoids ? Availability::TooManyCells : needs(true);
        }
        case SceneItem::Truth:
          return overlays.truth ? limited : Availability::NoData;
        case SceneItem::Comparison:
          return overlays.comparison && !overlays.comparison->empty() ? limited : Availability::NoData;
        case SceneItem::Surface:
          return needs(surfacePatch().has_value());
        case SceneItem::Loop:
          return needs(loopPoints().has_value());
        case SceneItem::Ports:
        case SceneItem::Ids:
        case SceneItem::Axes:
        case SceneItem::Gravity:
          break;
      }
      return Availability::Available;
    }

    [[nodiscard]] bool draws(SceneItem item) const {
      return shown.at(indexOf(item)) && availability(item) == Availability::Available;
    }
    /// Index of the evaluated patch, or none.
    std::optional<std::size_t> surfacePatch() const {
      if (!content || !overlays.surface) return std::nullopt;
      const auto& patches = content->reconstruction->patches;
      const auto found = std::ranges::find(patches, overlays.surface->patch, &PatchReconstruction::id);
      return found == patches.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - patches.begin()));
    }

    /// The link points of the loop, second first, in the scene; none if they are in different patches.
    std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> loopPoints() const {
      if (!content || !overlays.loop) return std::nullopt;
      const auto point = [&](const LinkEnd& end) -> std::optional<Eigen::Vector3d> {
        const SceneCell* cell = content->layout.find(end.cell);
        const Port* port = content->reconstruction->model->findPort(end.port);
        if (cell == nullptr || port == nullptr) return std::nullopt;
        return cell->T_s_u * port->vector_m;
      };
      const SceneCell* first_cell = content->layout.find(overlays.loop->first.cell);
      const SceneCell* second_cell = content->layout.find(overlays.loop->second.cell);
      if (!first_cell || !second_cell || first_cell->patch != second_cell->patch) return std::nullopt;
      const auto to = point(overlays.loop->first);
      const auto from = point(overlays.loop->second);
      if (!to || !from) return std::nullopt;
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
          const std::vector<std::size_t> apart = content ? content->layout.notPlaced() : std::vector<std::size_t>();
          notes.not_placed.clear();
          for (const std::size_t p : apart) notes.not_placed.push_back(content->reconstruction->patches[p].origin);
          const std::vector<std::size_t> framed = content ? content->layout.framed() : std::vector<std::size_t>();
          notes.frames = !framed.empty();
          return notes.frames ? makePatchFrames(*content, framed, colors.neutral) : nullptr;
        }
        case kLinks:
          notes.links = draws(SceneItem::Links);
          return notes.links ? makeLinkLines(*content, colors) : nullptr;
        case kTree:
          notes.tree = draws(SceneItem::Tree);
          return notes.tree ? makeTreeLines(*content) : nullptr;
        case kEllipsoids:
          notes.ellipsoid_factor.reset();
          return draws(SceneItem::Ellipsoids) ? enlarged(makeEllipsoids(*content), notes.ellipsoid_factor) : nullptr;
        case kTruth:
          notes.truth = draws(SceneItem::Truth);
          return notes.truth ? makeGhostOutlines(*content, alignTruth(*content->reconstruction, *overlays.truth))
                             : nullptr;
        case kSheet:
        case kDistances: {
          if (kind == kDistances) notes.distance_factor.reset();
          if (!draws(SceneItem::Surface)) return nullptr;
          const std::size_t patch = *surfacePatch();
          const Reconstruction& r = *content->reconstruction;
          if (!surface_mesh) surface_mesh = meshSurface(*overlays.surface, r.patches[patch], 1.5 * r.model->side_m);
          const SurfaceMesh& mesh = *surface_mesh;
          if (mesh.points.empty()) return nullptr;
          if (kind == kSheet) return makeSurfaceSheet(*content, mesh, patch);
          return cells() > kMaxCells ? nullptr
                                     : enlarged(makeDistanceLines(*content, mesh, patch), notes.distance_factor);
        }
        case kLoop: {
          notes.loop_factor.reset();
          if (!draws(SceneItem::Loop)) return nullptr;
          const auto [from, to] = *loopPoints();
          return enlarged(makeGapArrow(*content, from, to), notes.loop_factor);
        }
        case kShifts:
          notes.shift_factor.reset();
          return draws(SceneItem::Comparison)
                     ? enlarged(makeShiftArrows(*content, shiftsOf(*content->reconstruction, *overlays.comparison),
                                                shift_factor),
                                notes.shift_factor)
                     : nullptr;
        case kMeasure:
          return makeMeasure();
        case kKinds:
          break;
      }
      return nullptr;
    }

    vtkSmartPointer<vtkPolyData> makeMeasure() const {
      if (!content || !first) return nullptr;
      const SceneCell* a = content->layout.find(*first);
      if (a == nullptr) return nullptr;
      const SceneCell* b = second ? content->layout.find(*second) : nullptr;
      if (b == nullptr) return makeCellOutlines(*content, {*first});
      // There is no distance between patches, and so no line.
      return a->patch == b->patch ? makeLine(a->T_s_u.t, b->T_s_u.t) : makeCellOutlines(*content, {*first, *second});
    }
  };
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
