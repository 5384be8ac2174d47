#pragma once

#include "hexoderm/base/text.h"
#include "widgets/coloring/cell_colors.h"
#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_legend.h"
#include "widgets/scene/cell_meshes.h"
#include "widgets/scene/mesh_actor.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_cut.h"
#include "widgets/scene/scene_sight.h"
#include "widgets/style/scene_colors.h"

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkStaticCellLocator.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {

/// Both shine from the camera's side and turn with it: a soft key light from above its left shoulder, and a weaker one
/// from its right, so that what is turned away from the first is not dark. What faces the camera has its full colour.
struct SceneLights {
  static constexpr std::array<double, 3> kKeyFrom = {-0.45, 0.7, 1.0};  ///< right, up, towards the viewer
  static constexpr double kKey = 0.85;
  static constexpr std::array<double, 3> kFillFrom = {0.6, -0.35, 0.8};
  static constexpr double kFill = 0.42;
};

inline void addSceneLights(vtkRenderer* renderer) {
  const auto add = [renderer](const std::array<double, 3>& from, double intensity) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(from[0], from[1], from[2]);
    light->SetFocalPoint(0, 0, 0);
    light->SetIntensity(intensity);
    renderer->AddLight(light);
  };
  add(SceneLights::kKeyFrom, SceneLights::kKey);
  add(SceneLights::kFillFrom, SceneLights::kFill);
}

/// The cells in the scene: prisms or front faces, their colours, ports, origin and signs; and which of them a pixel
/// shows.
class SceneSkin {
 public:
  /// Ports of more cells than these are specks.
  static constexpr std::size_t kMaxMarkedCells = 500;

  explicit SceneSkin(vtkRenderer* renderer) {
    for (MeshActor* mesh :
         std::initializer_list<MeshActor*>{&prisms_, &hexagons_, &bricks_, &backs_, &ports_, &origins_, &signs_}) {
      mesh->show(nullptr);
      renderer->AddActor(mesh->actor);
    }
    lightByCorner(hexagons_.actor, 6);
    lightByCorner(bricks_.actor, 4);
    for (const MeshActor* mesh : {&prisms_, &backs_}) {
      mesh->setAmbient(kAmbient);
      mesh->property()->BackfaceCullingOn();  // they are closed: half of the work for the same picture
    }
    prisms_.property()->SetInterpolationToFlat();
    prisms_.property()->EdgeVisibilityOn();
    prisms_.property()->SetLineWidth(1.2F);
    // Marks lie on the faces and keep their colour in any light.
    for (const MeshActor* mark : {&ports_, &origins_, &signs_}) mark->property()->LightingOff();
  }

  /// Null shows nothing.
  void setContent(std::shared_ptr<const SceneContent> content) {
    content_ = std::move(content);
    recolor();
  }

  void setColoring(Coloring coloring) {
    coloring_ = coloring;
    recolor();
  }

  /// Of the scale of the colouring; none: fitted to what is shown.
  void setFixedRange(const std::optional<ColorRange>& range) {
    if (std::exchange(fixed_range_, range) != range && isQuantity(coloring_)) recolor();
  }

  void setReadings(CellReadings readings) {
    readings.surface_distance_m = std::move(readings_.surface_distance_m);
    readings_ = std::move(readings);
    if (isReading(coloring_)) recolor();
  }

  void setSurfaceDistances(std::unordered_map<CellId, double> distance_m) {
    readings_.surface_distance_m = std::move(distance_m);
    if (coloring_ == Coloring::SurfaceDistance) recolor();
  }

  void setColors(const SceneColors& colors) {
    colors_ = colors;
    recolor();
  }

  void setPortsVisible(bool visible) {
    ports_visible_ = visible;
    ports_.actor->SetVisibility(visible && origins_.isShown());
  }

  /// Cells in front of the plane are cut away; none: nothing is.
  void setCut(const std::optional<SceneCut>& cut) {
    cut_.set(cut, {prisms_.mapper.Get(), hexagons_.mapper.Get(), bricks_.mapper.Get(), backs_.mapper.Get(),
                   ports_.mapper.Get(), origins_.mapper.Get()});
    // Where prisms are cut open, they are seen from within.
    prisms_.property()->SetBackfaceCulling(!cut);
  }

  /// Colour of every cell's front face, in the order of the layout.
  [[nodiscard]] const std::vector<Rgb>& frontColors() const { return front_colors_; }
  [[nodiscard]] Coloring coloring() const { return coloring_; }
  [[nodiscard]] const CellReadings& readings() const { return readings_; }
  /// Of the scale of the colouring, if that is one of a quantity and cells are shown.
  [[nodiscard]] std::optional<ScaleLegend> scale() const {
    if (!content_ || !isQuantity(coloring_)) return std::nullopt;
    return makeScaleLegend(coloring_, cellValues(coloring_, content_->figures, readings_),
                           scaledValues(coloring_, *content_->reconstruction, content_->figures, readings_),
                           fixed_range_, content_->reconstruction->options);
  }

  /// Must be called before each rendering: cells are lit for the camera's position, and drawn in the visible detail.
  void update(const SceneSight& sight) {
    // A hexagon's corners are a quarter of a side away from a brick's: half a pixel.
    constexpr double kBrick_px = 2;
    if (front_colors_.empty() || content_->prisms) return;
    // At which the skin comes closest.
    const double nearest_m =
        (sight.eye - Eigen::Vector3d(content_->surface->GetCenter())).norm() - content_->extent_m / 2;
    const bool is_inside = nearest_m <= 0 && !sight.parallel;
    drawFaces(!is_inside && content_->reconstruction->model->side_m * sight.scaleAt(nearest_m) < kBrick_px);
    setLights(sight);
  }

  /// The cell at a pixel of the window (origin lower left); none beside the skin.
  [[nodiscard]] std::optional<CellId> pick(const SceneSight& sight, const Eigen::Vector2d& pixel) const {
    if (!content_ || content_->layout.cells.empty()) return std::nullopt;
    constexpr double kNear_m = 1e-3;
    const double middle_m = sight.depthOf(Eigen::Vector3d(content_->surface->GetCenter()));
    const double from_m = middle_m - content_->extent_m;
    Eigen::Vector3d from = sight.pointAt(pixel, sight.parallel ? from_m : std::max(kNear_m, from_m));
    Eigen::Vector3d to = sight.pointAt(pixel, std::max(2 * kNear_m, middle_m + content_->extent_m));
    if (cut_.get() && !cut_.get()->shorten(from, to)) return std::nullopt;
    constexpr double kTolerance_m = 1e-6;  // not 0: a hit on a tilted face is off its plane by rounding
    double t = 0;
    std::array<double, 3> hit{};
    std::array<double, 3> parametric{};
    int sub_id = 0;
    vtkIdType polygon = -1;
    if (content_->locator->IntersectWithLine(from.data(), to.data(), kTolerance_m, t, hit.data(), parametric.data(),
                                             sub_id, polygon) == 0) {
      return std::nullopt;
    }
    return content_->layout.cells.at(static_cast<std::size_t>(polygon) / content_->polygonsPerCell()).id;
  }

 private:
  static constexpr double kAmbient = 0.52;  // the share of a cell's colour that shows without light
  static constexpr double kDiffuse = 1 - kAmbient;
  static constexpr double kBackFold =
      0.62;  // shade of one half of a face that is seen from behind, of that of the other
  /// Lights front faces corner by corner: a face is flat and has one colour, so this is what VTK would compute pixel by
  /// pixel, and pixels are what takes time. From behind a face is darker and greyed, and one half of it darker still,
  /// so that every cell looks like a tile laid upside down: `corners` of them are a face. Needs `eye` (the camera's
  /// place, or with w = 0 the direction to it), `key` and `fill` (unit, to the lights) and `grey` as uniforms.
  static void lightByCorner(vtkActor* actor, int corners) {
    actor->GetProperty()->LightingOff();
    vtkShaderProperty* shader = actor->GetShaderProperty();
    shader->AddVertexShaderReplacement("//VTK::Normal::Dec", true, "//VTK::Normal::Dec\nin vec3 normalMC;\n", false);
    const std::string light = "float light = " + formatFixed(kAmbient, 3) + " + " +
                              formatFixed(kDiffuse * SceneLights::kKey, 4) + " * max(0.0, dot(n, key)) + " +
                              formatFixed(kDiffuse * SceneLights::kFill, 4) + " * max(0.0, dot(n, fill));\n";
    const std::string code =
        "//VTK::Color::Impl\n"
        "float facing = dot(normalMC, eye.xyz - eye.w * vertexMC.xyz);\n"
        "vec3 n = facing > 0.0 ? normalMC : -normalMC;\n" +
        light + "if (facing <= 0.0) {\n" + "  vertexColorVSOutput.rgb = mix(vertexColorVSOutput.rgb, grey, " +
        formatFixed(kBackGrey, 2) + ");\n" + "  light *= (gl_VertexID % " + std::to_string(corners) + " < " +
        std::to_string(corners / 2) + ") ? " + formatFixed(kUndersideShade * kBackFold, 3) + " : " +
        formatFixed(kUndersideShade, 2) +
        ";\n}\n"
        "vertexColorVSOutput.rgb *= light;\n";
    shader->AddVertexShaderReplacement("//VTK::Color::Impl", true, code, false);
  }

  /// Front faces, near and far: one of the two is drawn.
  struct Faces : MeshActor {
    bool stale = true;  ///< drawn with other colours, or other cells, last
  };

  void recolor() {
    const bool any = content_ && !content_->layout.cells.empty() && !colors_.scale.steps.empty();
    const bool marked = any && content_->layout.cells.size() <= kMaxMarkedCells;
    prisms_.property()->SetEdgeColor(colors_.edge.data());
    backs_.setColor(backGrey(colors_));
    front_colors_.clear();
    if (any) front_colors_ = cellColors(coloring_, content_->figures, readings_, range(), colors_);
    prisms_.show(any && content_->prisms ? makeColoredSurface(*content_, front_colors_, colors_) : nullptr);
    backs_.show(any ? content_->backs : nullptr);
    signs_.show(any ? makeSigns(*content_, front_colors_, colors_) : nullptr);
    ports_.show(marked ? makePortMarks(*content_, front_colors_, colors_) : nullptr);
    origins_.show(marked ? makeOriginMarks(*content_, front_colors_, colors_) : nullptr);
    setPortsVisible(ports_visible_);
    hexagons_.stale = bricks_.stale = true;
    drawFaces(bricks_.isShown());
  }

  [[nodiscard]] ColorRange range() const {
    if (!isQuantity(coloring_)) return {};
    if (fixed_range_) return *fixed_range_;
    return rangeOf(coloring_, scaledValues(coloring_, *content_->reconstruction, content_->figures, readings_), {});
  }

  void drawFaces(bool far) {
    const bool any = !front_colors_.empty() && !content_->prisms;
    hexagons_.actor->SetVisibility(any && !far);
    bricks_.actor->SetVisibility(any && far);
    Faces& shown = far ? bricks_ : hexagons_;
    if (!any || !std::exchange(shown.stale, false)) return;
    shown.mapper->SetInputData(far ? makeColoredBricks(*content_, front_colors_)
                                   : makeColoredSurface(*content_, front_colors_, colors_));
  }

  void setLights(const SceneSight& sight) {
    const auto lightFrom = [&](const std::array<double, 3>& from) {
      const Eigen::Vector3d direction = from[0] * sight.right + from[1] * sight.up + from[2] * sight.back;
      return Eigen::Vector3f(direction.normalized().cast<float>());
    };
    const Eigen::Vector3f key = lightFrom(SceneLights::kKeyFrom);
    const Eigen::Vector3f fill = lightFrom(SceneLights::kFillFrom);
    const Rgb grey_color = backGrey(colors_);
    const Eigen::Vector3f grey = Eigen::Vector3d(grey_color.data()).cast<float>();
    Eigen::Vector4f eye = Eigen::Vector4f::Zero();
    eye.head<3>() = (sight.parallel ? sight.back : sight.eye).cast<float>();
    eye.w() = sight.parallel ? 0 : 1;
    for (Faces* faces : {&hexagons_, &bricks_}) {
      vtkUniforms* uniforms = faces->actor->GetShaderProperty()->GetVertexCustomUniforms();
      uniforms->SetUniform4f("eye", eye.data());
      uniforms->SetUniform3f("key", key.data());
      uniforms->SetUniform3f("fill", fill.data());
      uniforms->SetUniform3f("grey", grey.data());
    }
  }

  std::shared_ptr<const SceneContent> content_;
  Coloring coloring_ = Coloring::LinkQuality;
  std::optional<ColorRange> fixed_range_;
  CellReadings readings_;
  SceneColors colors_;
  std::vector<Rgb> front_colors_;
  bool ports_visible_ = true;
  MeshActor prisms_;
  Faces hexagons_;
  Faces bricks_;
  MeshActor backs_;
  MeshActor ports_;
  MeshActor origins_;
  MeshActor signs_;
  DrawnCut cut_;
};

}  // namespace hexoderm
