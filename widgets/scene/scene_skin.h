#pragma once

#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"
#include "widgets/coloring/cell_colors.h"
#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_legend.h"
#include "widgets/scene/cell_meshes.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_cut.h"
#include "widgets/scene/scene_signs.h"
#include "widgets/style/scene_colors.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkStaticCellLocator.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <array>
#include <cmath>
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

  explicit SceneSkin(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
    parts_->renderer = renderer;
    parts_->add(parts_->prism_actor, parts_->prism_mapper);
    for (Parts::Faces* faces : {&parts_->hexagons, &parts_->bricks}) parts_->add(faces->actor, faces->mapper);
    lightByCorner(parts_->hexagons.actor, 6);
    lightByCorner(parts_->bricks.actor, 4);
    parts_->add(parts_->back_actor, parts_->back_mapper);
    parts_->add(parts_->port_actor, parts_->port_mapper);
    parts_->add(parts_->origin_actor, parts_->origin_mapper);
    parts_->add(parts_->sign_actor, parts_->sign_mapper);
    vtkProperty* prism = parts_->prism_actor->GetProperty();
    prism->SetAmbient(kAmbient);
    prism->SetDiffuse(kDiffuse);
    prism->SetSpecular(0.0);
    prism->SetInterpolationToFlat();
    prism->EdgeVisibilityOn();
    prism->SetLineWidth(1.2F);
    prism->BackfaceCullingOn();  // they are closed: half of the work for the same picture
    vtkProperty* back = parts_->back_actor->GetProperty();
    back->SetAmbient(kAmbient);
    back->SetDiffuse(kDiffuse);
    back->BackfaceCullingOn();
    parts_->back_actor->PickableOff();
    // Marks lie on the faces and keep their colour in any light.
    parts_->port_actor->GetProperty()->LightingOff();
    parts_->origin_actor->GetProperty()->LightingOff();
    parts_->sign_actor->GetProperty()->LightingOff();
  }

  /// Null shows nothing.
  void setContent(std::shared_ptr<const SceneContent> content) {
    parts_->content = std::move(content);
    parts_->locator = parts_->content ? parts_->content->locator : nullptr;
    const bool has_backs = parts_->content && parts_->content->prisms;
    parts_->back_mapper->SetInputData(has_backs ? parts_->content->backs : vtkSmartPointer<vtkPolyData>::New());
    parts_->recolor();
  }

  void setColoring(Coloring coloring) {
    parts_->coloring = coloring;
    parts_->recolor();
  }

  /// Of the scale of the colouring; none: fitted to what is shown.
  void setFixedRange(const std::optional<ColorRange>& range) {
    if (range == parts_->fixed_range) return;
    parts_->fixed_range = range;
    if (isQuantity(parts_->coloring)) parts_->recolor();
  }

  void setReadings(CellReadings readings) {
    readings.surface_distance_m = std::move(parts_->readings.surface_distance_m);
    parts_->readings = std::move(readings);
    if (isReading(parts_->coloring)) parts_->recolor();
  }

  void setSurfaceDistances(std::unordered_map<CellId, double> distance_m) {
    parts_->readings.surface_distance_m = std::move(distance_m);
    if (parts_->coloring == Coloring::SurfaceDistance) parts_->recolor();
  }

  void setColors(const SceneColors& colors) {
    parts_->colors = colors;
    parts_->recolor();
  }

  void setPortsVisible(bool visible) {
    parts_->ports_visible = visible;
    parts_->port_actor->SetVisibility(visible && parts_->origin_actor->GetVisibility() != 0);
  }

  /// Cells in front of the plane are cut away; none: nothing is.
  void setCut(const std::optional<SceneCut>& cut) {
    parts_->cut.set(cut, {parts_->prism_mapper.Get(), parts_->hexagons.mapper.Get(), parts_->bricks.mapper.Get(),
                          parts_->back_mapper.Get(), parts_->port_mapper.Get(), parts_->origin_mapper.Get()});
    // Where prisms are cut open, they are seen from within.
    parts_->prism_actor->GetProperty()->SetBackfaceCulling(!cut);
  }

  /// Colour of every cell's front face, in the order of the layout.
  [[nodiscard]] const std::vector<Rgb>& frontColors() const { return parts_->front_colors; }
  [[nodiscard]] Coloring coloring() const { return parts_->coloring; }
  [[nodiscard]] const CellReadings& readings() const { return parts_->readings; }
  /// Of the scale of the colouring, if that is one of a quantity and cells are shown.
  [[nodiscard]] std::optional<ScaleLegend> scale() const {
    if (!parts_->content || !isQuantity(parts_->coloring)) return std::nullopt;
    const SceneContent& content = *parts_->content;
    return makeScaleLegend(parts_->coloring, cellValues(parts_->coloring, content.figures, parts_->readings),
                           scaledValues(parts_->coloring, *content.reconstruction, content.figures, parts_->readings),
                           parts_->fixed_range, content.reconstruction->options);
  }

  /// Must be called before each rendering: cells are lit for the camera's position, and drawn in the visible detail.
  void update(int window_height) {
    // A hexagon's corners are a quarter of a side away from a brick's: half a pixel.
    constexpr double kBrickPixels = 2;
    if (!parts_->content || parts_->content->prisms || parts_->front_colors.empty()) return;
    vtkCamera* camera = parts_->renderer->GetActiveCamera();
    double height_m = 2 * camera->GetParallelScale();
    if (camera->GetParallelProjection() == 0) {
      // The point at which the skin comes closest.
      std::array<double, 3> middle{};
      parts_->content->surface->GetCenter(middle.data());
      const double distance = (Eigen::Vector3d(camera->GetPosition()) - Eigen::Vector3d(middle.data())).norm() -
                              parts_->content->extent_m / 2;
      height_m = 2 * std::max(distance, 0.0) * std::tan(0.5 * camera->GetViewAngle() * kDegree);
    }
    const double side_m = parts_->content->reconstruction->model->side_m;
    parts_->drawFaces(side_m * window_height < kBrickPixels * height_m);
    parts_->setLights();
  }

  /// The cell at a pixel of the window (origin lower left); none beside the skin.
  [[nodiscard]] std::optional<CellId> pick(double x, double y) const {
    const auto cell = parts_->firstCell(onSight(parts_->renderer, x, y, 0), onSight(parts_->renderer, x, y, 1));
    return cell ? std::optional(parts_->content->layout.cells.at(*cell).id) : std::nullopt;
  }

 private:
  // The share of a cell's colour that shows without light, and the share of light that it gives back.
  static constexpr double kAmbient = 0.52;
  static constexpr double kDiffuse = 0.48;
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

  /// The point at which a pixel's line of sight crosses a plane of constant depth, 0 at the front.
  static Eigen::Vector3d onSight(vtkRenderer* renderer, double x, double y, double depth) {
    renderer->SetDisplayPoint(x, y, depth);
    renderer->DisplayToWorld();
    const double* p = renderer->GetWorldPoint();
    return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
  }

  struct Parts {
    vtkRenderer* renderer = nullptr;
    std::shared_ptr<const SceneContent> content;
    Coloring coloring = Coloring::LinkQuality;
    std::optional<ColorRange> fixed_range;
    CellReadings readings;
    SceneColors colors;
    std::vector<Rgb> front_colors;
    bool ports_visible = true;
    vtkNew<vtkActor> prism_actor;
    vtkNew<vtkPolyDataMapper> prism_mapper;
    /// Front faces, near and far: one of the two is drawn.
    struct Faces {
      vtkNew<vtkActor> actor;
      vtkNew<vtkPolyDataMapper> mapper;
      bool stale = true;  ///< drawn with other colours, or other cells, last
    };
    Faces hexagons;
    Faces bricks;
    vtkNew<vtkActor> back_actor;
    vtkNew<vtkPolyDataMapper> back_mapper;
    vtkNew<vtkActor> port_actor;
    vtkNew<vtkPolyDataMapper> port_mapper;
    vtkNew<vtkActor> origin_actor;
    vtkNew<vtkPolyDataMapper> origin_mapper;
    vtkNew<vtkActor> sign_actor;
    vtkNew<vtkPolyDataMapper> sign_mapper;
    DrawnCut cut;
    mutable vtkSmartPointer<vtkStaticCellLocator> locator;  ///< a large skin's, or made by the first pick

    void add(vtkActor* actor, vtkPolyDataMapper* mapper) {
      actor->SetMapper(mapper);
      actor->VisibilityOff();
      renderer->AddActor(actor);
    }

    void recolor() {
      prism_actor->GetProperty()->SetEdgeColor(colors.edge.data());
      const bool any = content && !content->layout.cells.empty() && !colors.scale.steps.empty();
      prism_actor->SetVisibility(any && content->prisms);
      back_actor->SetVisibility(any && content->prisms);
      Rgb grey = backGrey(colors);
      back_actor->GetProperty()->SetColor(grey.data());
      hexagons.stale = true;
      bricks.stale = true;
      if (!any || content->prisms) {
        hexagons.actor->VisibilityOff();
        bricks.actor->VisibilityOff();
      }
      const bool marked = any && content->layout.cells.size() <= kMaxMarkedCells;
      port_actor->SetVisibility(marked && ports_visible);
      origin_actor->SetVisibility(marked);
      if (!any) {
        front_colors.clear();
        drawSigns(false);
        return;
      }
      front_colors = cellColors(coloring, content->figures, readings, range(), colors);
      drawSigns(true);
      if (content->prisms) {
        prism_mapper->SetInputData(makeColoredSurface(*content, front_colors, colors));
      } else {
        drawFaces(bricks.actor->GetVisibility() != 0);
      }
      if (marked) {
        port_mapper->SetInputData(makePortMarks(*content, front_colors, colors));
        origin_mapper->SetInputData(makeOriginMarks(*content, front_colors, colors));
      }
    }

    void drawSigns(bool any) {
      const vtkSmartPointer<vtkPolyData> signs = any ? makeSigns(*content, front_colors, colors) : nullptr;
      sign_actor->SetVisibility(signs != nullptr);
      if (signs) sign_mapper->SetInputData(signs);
    }

    ColorRange range() const {
      if (!isQuantity(coloring)) return {};
      if (fixed_range) return *fixed_range;
      return rangeOf(coloring, scaledValues(coloring, *content->reconstruction, content->figures, readings), {});
    }

    void drawFaces(bool far) {
      hexagons.actor->SetVisibility(!far);
      bricks.actor->SetVisibility(far);
      Faces& shown = far ? bricks : hexagons;
      if (!shown.stale) return;
      shown.mapper->SetInputData(far ? makeColoredBricks(*content, front_colors)
                                     : makeColoredSurface(*content, front_colors, colors));
      shown.stale = false;
    }

    void setLights() {
      vtkCamera* camera = renderer->GetActiveCamera();
      const Eigen::Vector3d back = -Eigen::Vector3d(camera->GetDirectionOfProjection());
      const Eigen::Vector3d up = Eigen::Vector3d(camera->GetViewUp());
      const Eigen::Vector3d right = up.cross(back).normalized();
      Eigen::Matrix3d R_s_view;
      R_s_view << right, back.cross(right), back;
      const Eigen::Vector3f key = (R_s_view * Eigen::Vector3d(SceneLights::kKeyFrom.data()).normalized()).cast<float>();
      const Eigen::Vector3f fill =
          (R_s_view * Eigen::Vector3d(SceneLights::kFillFrom.data()).normalized()).cast<float>();
      const Rgb grey_color = backGrey(colors);
      const Eigen::Vector3f grey = Eigen::Vector3d(grey_color.data()).cast<float>();
      const bool parallel = camera->GetParallelProjection() != 0;
      Eigen::Vector4f eye = Eigen::Vector4f::Zero();
      eye.head<3>() = back.cast<float>();
      if (!parallel) eye << Eigen::Vector3d(camera->GetPosition()).cast<float>(), 1;
      for (Faces* faces : {&hexagons, &bricks}) {
        vtkUniforms* uniforms = faces->actor->GetShaderProperty()->GetVertexCustomUniforms();
        uniforms->SetUniform4f("eye", eye.data());
        uniforms->SetUniform3f("key", key.data());
        uniforms->SetUniform3f("fill", fill.data());
        uniforms->SetUniform3f("grey", grey.data());
      }
    }

    /// The polygon that a line from one point to another meets first.
    std::optional<std::size_t> firstCell(Eigen::Vector3d from, Eigen::Vector3d to) const {
      if (!content || content->layout.cells.empty()) return std::nullopt;
      if (cut.get() && !cut.get()->shorten(from, to)) return std::nullopt;
      if (!locator) {
        locator = vtkSmartPointer<vtkStaticCellLocator>::New();
        locator->SetDataSet(content->surface);
        locator->BuildLocator();
      }
      constexpr double kTolerance_m = 1e-6;  // not 0: a hit on a tilted face is off its plane by rounding
      double t = 0;
      std::array<double, 3> hit{};
      std::array<double, 3> parametric{};
      int sub_id = 0;
      vtkIdType polygon = -1;
      if (locator->IntersectWithLine(from.data(), to.data(), kTolerance_m, t, hit.data(), parametric.data(), sub_id,
                                     polygon) == 0) {
        return std::nullopt;
      }
      return static_cast<std::size_t>(polygon) / content->polygonsPerCell();
    }
  };
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
