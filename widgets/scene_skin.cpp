#include "widgets/scene_skin.h"

#include "hexoderm/util/text.h"
#include "widgets/patch_geometry.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkStaticCellLocator.h>
#include <array>
#include <string>
#include <utility>

namespace hexoderm {
namespace {

/// Lights the underside of front faces in a shade of the cell's colour, as prisms have it: two passes, one a side,
/// would take twice as long.
void shadeUnderside(vtkActor* actor) {
  const std::string shade = formatFixed(kUndersideShade, 2);
  const std::string code =
      "//VTK::Color::Impl\n  if (!gl_FrontFacing) { ambientColor *= " + shade + "; diffuseColor *= " + shade + "; }\n";
  actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Color::Impl", true, code, false);
}

/// Where a pixel's line of sight crosses a plane of constant depth, 0 at the front.
std::array<double, 3> onSight(vtkRenderer* renderer, double x, double y, double depth) {
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  const double* p = renderer->GetWorldPoint();
  return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

}  // namespace

struct SceneSkin::Parts {
  vtkRenderer* renderer = nullptr;
  std::shared_ptr<const SceneContent> content;
  CellColoring coloring = CellColoring::LinkQuality;
  CellReadings readings;
  SceneColors colors;
  std::vector<Rgb> front_colors;
  bool ports_visible = true;
  // The two ways of drawing need different shaders.
  vtkNew<vtkActor> prism_actor;
  vtkNew<vtkPolyDataMapper> prism_mapper;
  vtkNew<vtkActor> face_actor;
  vtkNew<vtkPolyDataMapper> face_mapper;
  vtkNew<vtkActor> port_actor;
  vtkNew<vtkPolyDataMapper> port_mapper;
  vtkNew<vtkActor> origin_actor;
  vtkNew<vtkPolyDataMapper> origin_mapper;
  vtkSmartPointer<vtkStaticCellLocator> locator;  ///< made by the first pick

  void add(vtkActor* actor, vtkPolyDataMapper* mapper);
  void recolor();
};

void SceneSkin::Parts::add(vtkActor* actor, vtkPolyDataMapper* mapper) {
  actor->SetMapper(mapper);
  actor->VisibilityOff();
  renderer->AddActor(actor);
}

void SceneSkin::Parts::recolor() {
  prism_actor->GetProperty()->SetEdgeColor(colors.edge.data());
  const bool any = content && !content->layout.cells.empty() && !colors.scale.empty();
  prism_actor->SetVisibility(any && content->prisms);
  face_actor->SetVisibility(any && !content->prisms);
  const bool marked = any && content->layout.cells.size() <= kMaxMarkedCells;
  port_actor->SetVisibility(marked && ports_visible);
  origin_actor->SetVisibility(marked);
  if (!any) {
    front_colors.clear();
    return;
  }
  front_colors = cellColors(coloring, content->figures, readings, colors);
  (content->prisms ? prism_mapper : face_mapper)->SetInputData(makeColoredSurface(*content, front_colors));
  if (marked) {
    port_mapper->SetInputData(makePortMarks(*content, front_colors, colors));
    origin_mapper->SetInputData(makeOriginMarks(*content, front_colors, colors));
  }
}

SceneSkin::SceneSkin(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
  parts_->renderer = renderer;
  parts_->add(parts_->prism_actor, parts_->prism_mapper);
  parts_->add(parts_->face_actor, parts_->face_mapper);
  parts_->add(parts_->port_actor, parts_->port_mapper);
  parts_->add(parts_->origin_actor, parts_->origin_mapper);
  for (vtkActor* actor : {parts_->prism_actor.Get(), parts_->face_actor.Get()}) {
    vtkProperty* property = actor->GetProperty();
    property->SetAmbient(0.58);
    property->SetDiffuse(0.42);
    property->SetSpecular(0.0);
  }
  parts_->prism_actor->GetProperty()->SetInterpolationToFlat();
  parts_->prism_actor->GetProperty()->EdgeVisibilityOn();
  parts_->prism_actor->GetProperty()->SetLineWidth(1.2F);
  shadeUnderside(parts_->face_actor);
  // Marks lie on the faces and keep their colour in any light.
  parts_->port_actor->GetProperty()->LightingOff();
  parts_->origin_actor->GetProperty()->LightingOff();
}

SceneSkin::~SceneSkin() = default;

void SceneSkin::setContent(std::shared_ptr<const SceneContent> content) {
  parts_->content = std::move(content);
  parts_->locator = nullptr;
  parts_->recolor();
}

void SceneSkin::setColoring(CellColoring coloring) {
  parts_->coloring = coloring;
  parts_->recolor();
}

void SceneSkin::setReadings(CellReadings readings) {
  readings.surface_distance_m = std::move(parts_->readings.surface_distance_m);
  parts_->readings = std::move(readings);
  if (isReading(parts_->coloring)) parts_->recolor();
}

void SceneSkin::setSurfaceDistances(std::unordered_map<CellId, double> distance_m) {
  parts_->readings.surface_distance_m = std::move(distance_m);
  if (parts_->coloring == CellColoring::SurfaceDistance) parts_->recolor();
}

void SceneSkin::setColors(const SceneColors& colors) {
  parts_->colors = colors;
  parts_->recolor();
}

void SceneSkin::setPortsVisible(bool visible) {
  parts_->ports_visible = visible;
  parts_->port_actor->SetVisibility(visible && parts_->origin_actor->GetVisibility() != 0);
}

const std::vector<Rgb>& SceneSkin::frontColors() const { return parts_->front_colors; }

CellColoring SceneSkin::coloring() const { return parts_->coloring; }

const CellReadings& SceneSkin::readings() const { return parts_->readings; }

std::optional<CellId> SceneSkin::pick(double x, double y) const {
  if (!parts_->content || parts_->content->layout.cells.empty()) return std::nullopt;
  if (!parts_->locator) {
    parts_->locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    parts_->locator->SetDataSet(parts_->content->surface);
    parts_->locator->BuildLocator();
  }
  const auto near = onSight(parts_->renderer, x, y, 0);
  const auto far = onSight(parts_->renderer, x, y, 1);
  constexpr double kTolerance_m = 1e-6;  // not 0: a hit on a tilted face is off its plane by rounding
  double t = 0;
  std::array<double, 3> hit{};
  std::array<double, 3> parametric{};
  int sub_id = 0;
  vtkIdType polygon = -1;
  if (parts_->locator->IntersectWithLine(near.data(), far.data(), kTolerance_m, t, hit.data(), parametric.data(),
                                         sub_id, polygon) == 0) {
    return std::nullopt;
  }
  const std::size_t cell = static_cast<std::size_t>(polygon) / parts_->content->polygonsPerCell();
  return parts_->content->layout.cells.at(cell).id;
}

}  // namespace hexoderm
