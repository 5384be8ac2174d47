#include "widgets/scene/scene_labels.h"

#include "hexoderm/util/units.h"
#include "widgets/scene/label_atlas.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hexoderm {
namespace {

using Rgba = std::array<unsigned char, 4>;

Rgba toRgba(const Rgb& color, double opacity = 1) {
  Rgba result{};
  for (std::size_t k = 0; k < 3; ++k) {
    result.at(k) = static_cast<unsigned char>(std::lround(255 * std::clamp(color.at(k), 0.0, 1.0)));
  }
  result[3] = static_cast<unsigned char>(std::lround(255 * opacity));
  return result;
}

/// Rectangles of the picture, each at a depth of its own, as one mesh in the scene.
class Sheets {
 public:
  Sheets(const LabelSight& sight, const std::array<float, 2>& white) : sight_(sight), white_(white) {
    texture_->SetNumberOfComponents(2);
    texture_->SetName("TCoords");
    colors_->SetNumberOfComponents(4);
    points_->SetDataTypeToFloat();
  }

  /// `from` and `to`: lower left and upper right, in pixels; the same of the texture, in shares of it.
  void add(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double depth_m, const std::array<float, 2>& tex_from,
           const std::array<float, 2>& tex_to, const Rgba& color) {
    const vtkIdType first = addPoint({from.x(), from.y()}, depth_m, {tex_from[0], tex_from[1]}, color);
    addPoint({to.x(), from.y()}, depth_m, {tex_to[0], tex_from[1]}, color);
    addPoint({to.x(), to.y()}, depth_m, {tex_to[0], tex_to[1]}, color);
    addPoint({from.x(), to.y()}, depth_m, {tex_from[0], tex_to[1]}, color);
    polygons_->InsertNextCell({first, first + 1, first + 2, first + 3});
  }
  void addFilled(const std::vector<Eigen::Vector2d>& corners, double depth_m, const Rgba& color) {
    polygons_->InsertNextCell(static_cast<int>(corners.size()));
    for (const Eigen::Vector2d& corner : corners) {
      polygons_->InsertCellPoint(addPoint(corner, depth_m, white_, color));
    }
  }
  vtkSmartPointer<vtkPolyData> finish() {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetPolys(polygons_);
    data->GetPointData()->SetTCoords(texture_);
    data->GetPointData()->SetScalars(colors_);
    return data;
  }

 private:
  vtkIdType addPoint(const Eigen::Vector2d& pixel, double depth_m, const std::array<float, 2>& texture,
                     const Rgba& color) {
    const Eigen::Vector2d across = (pixel - sight_.middle_px) / sight_.scaleAt(depth_m);
    const Eigen::Vector3d p = sight_.eye + across.x() * sight_.right + across.y() * sight_.up - depth_m * sight_.back;
    texture_->InsertNextTypedTuple(texture.data());
    colors_->InsertNextTypedTuple(color.data());
    return points_->InsertNextPoint(p.data());
  }

  const LabelSight& sight_;
  std::array<float, 2> white_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> texture_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkCellArray> polygons_;
};

/// Around a rectangle with round ends; clockwise or not does not matter, for no side is culled.
std::vector<Eigen::Vector2d> pill(const Eigen::Vector2d& center, const Eigen::Vector2d& half) {
  constexpr int kPerEnd = 8;
  const double radius = std::min(half.x(), half.y());
  const Eigen::Vector2d straight = half - Eigen::Vector2d::Constant(radius);
  std::vector<Eigen::Vector2d> corners;
  for (int k = 0; k < 4 * kPerEnd; ++k) {
    const double angle = 2 * kPi * (k + 0.5) / (4 * kPerEnd);
    const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    corners.emplace_back(center + radius * way +
                         Eigen::Vector2d(std::copysign(straight.x(), way.x()), std::copysign(straight.y(), way.y())));
  }
  return corners;
}

}  // namespace

struct SceneLabels::Parts {
  vtkRenderer* renderer = nullptr;
  LabelChoice choice;
  LabelAtlas atlas;
  std::vector<Rgb> front_colors;
  SceneColors colors;
  bool visible = true;
  bool picked_visible = true;
  std::optional<CellId> picked;
  std::optional<SceneCut> cut;
  vtkNew<vtkTexture> texture;
  struct Drawn {
    vtkNew<vtkActor> actor;
    vtkNew<vtkPolyDataMapper> mapper;
  };
  Drawn ids;
  Drawn plate;  ///< with the picked cell's ID
  std::vector<PlacedLabel> labels;
  // What the present meshes were made for.
  bool stale = true;
  bool picked_behind = false;
  LabelSight sight;

  [[nodiscard]] std::optional<std::size_t> pickedIndex() const;
  void dress(Drawn& drawn);
  void write(Sheets& sheets, const PlacedLabel& label, double depth_m, const Rgba& color) const;
  void writePlate(Sheets& sheets, const PlacedLabel& label) const;
};

void SceneLabels::Parts::dress(Drawn& drawn) {
  drawn.mapper->SetColorModeToDirectScalars();
  drawn.mapper->SetInputData(vtkNew<vtkPolyData>());
  drawn.actor->SetMapper(drawn.mapper);
  drawn.actor->SetTexture(texture);
  drawn.actor->GetProperty()->LightingOff();
  drawn.actor->PickableOff();
  drawn.actor->UseBoundsOff();
  drawn.actor->VisibilityOff();
  renderer->AddActor(drawn.actor);
}

std::optional<std::size_t> SceneLabels::Parts::pickedIndex() const {
  if (!picked || choice.content() == nullptr) return std::nullopt;
  const SceneLayout& layout = choice.content()->layout;
  const auto found = layout.index.find(*picked);
  return found == layout.index.end() ? std::nullopt : std::optional(found->second);
}

void SceneLabels::Parts::write(Sheets& sheets, const PlacedLabel& label, double depth_m, const Rgba& color) const {
  const std::string id = toString(choice.content()->layout.cells[label.cell].id);
  const int advance = atlas.advance(label.font_px);
  const int* size = atlas.picture()->GetDimensions();
  // On whole pixels the letters are as sharp as they were drawn.
  double left = std::round(label.at_px.x() - 0.5 * advance * static_cast<double>(id.size()));
  for (const char letter : id) {
    const LabelAtlas::Glyph& glyph = atlas.glyph(label.font_px, letter - '0');
    const Eigen::Vector2d from(left + std::floor(0.5 * (advance - glyph.width)),
                               std::round(label.at_px.y() - 0.5 * glyph.height));
    const auto share = [](int pixel, int of) { return static_cast<float>(pixel) / static_cast<float>(of); };
    sheets.add(from, from + Eigen::Vector2d(glyph.width, glyph.height), depth_m,
               {share(glyph.left, size[0]), share(glyph.bottom, size[1])},
               {share(glyph.left + glyph.width, size[0]), share(glyph.bottom + glyph.height, size[1])}, color);
    left += advance;
  }
}

void SceneLabels::Parts::writePlate(Sheets& sheets, const PlacedLabel& label) const {
  const double unit = sight.text_scale;
  const auto digits = static_cast<double>(toString(choice.content()->layout.cells[label.cell].id).size());
  const Eigen::Vector2d half(0.5 * digits * atlas.advance(label.font_px) + 5 * unit,
                             0.5 * unit * label.font_px + 2 * unit);
  const Rgb& ground = picked_behind ? colors.background_bottom : colors.selection;
  const std::vector<Eigen::Vector2d> edge = pill(label.at_px, half + Eigen::Vector2d::Constant(2 * unit));
  if (picked_behind) {
    sheets.addFilled(pill(label.at_px, half + Eigen::Vector2d::Constant(unit)), label.depth_m, toRgba(ground, 0.85));
    const std::vector<Eigen::Vector2d> inner = pill(label.at_px, half + Eigen::Vector2d::Constant(0.5 * unit));
    for (std::size_t k = 0; k < edge.size(); k += 2) {
      const std::size_t next = (k + 1) % edge.size();
      sheets.addFilled({edge[k], edge[next], inner[next], inner[k]}, label.depth_m, toRgba(colors.text));
    }
  } else {
    sheets.addFilled(edge, label.depth_m, toRgba(colors.background_bottom));
    sheets.addFilled(pill(label.at_px, half + Eigen::Vector2d::Constant(unit)), label.depth_m, toRgba(ground));
  }
  write(sheets, label, label.depth_m, toRgba(picked_behind ? colors.text : markOn(ground, colors)));
}

SceneLabels::SceneLabels(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
  parts_->renderer = renderer;
  parts_->texture->InterpolateOff();
  parts_->texture->RepeatOff();
  parts_->texture->MipmapOff();
  parts_->dress(parts_->ids);
  parts_->dress(parts_->plate);
  // Letters leave the depth of the faces under them as it is, so that only faces shade each other. The picked cell's
  // plate is seen through everything.
  parts_->ids.actor->ForceTranslucentOn();
  parts_->plate.actor->ForceOpaqueOn();
  parts_->plate.actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
                                                                         "gl_FragDepth = 0.0;\n", false);
}

SceneLabels::~SceneLabels() = default;

void SceneLabels::setContent(const std::shared_ptr<const SceneContent>& content) {
  parts_->choice.setContent(content);
  parts_->front_colors.clear();
  parts_->labels.clear();
  parts_->stale = true;
  for (Parts::Drawn* drawn : {&parts_->ids, &parts_->plate}) {
    drawn->actor->VisibilityOff();
    // Behind all faces in the order of drawing, however late these came.
    parts_->renderer->RemoveActor(drawn->actor);
    parts_->renderer->AddActor(drawn->actor);
  }
}

void SceneLabels::setColors(const std::vector<Rgb>& front_colors, const SceneColors& colors) {
  parts_->front_colors = front_colors;
  parts_->colors = colors;
  parts_->stale = true;
}

void SceneLabels::setVisible(bool visible, bool with_picked) {
  parts_->visible = visible;
  parts_->picked_visible = with_picked;
  parts_->stale = true;
}

void SceneLabels::setPicked(std::optional<CellId> cell) {
  parts_->picked = cell;
  parts_->stale = true;
}

std::optional<std::size_t> SceneLabels::picked() const { return parts_->pickedIndex(); }

void SceneLabels::setCut(const std::optional<SceneCut>& cut) {
  parts_->cut = cut;
  parts_->stale = true;
}

void SceneLabels::update(const std::array<int, 2>& window_size, int dpi, bool is_picked_covered) {
  const LabelSight sight = LabelSight::of(parts_->renderer->GetActiveCamera(), window_size, dpi);
  const std::optional<std::size_t> picked = parts_->picked_visible ? parts_->pickedIndex() : std::nullopt;
  bool behind = false;
  if (picked) {
    const SE3& T_s_u = parts_->choice.content()->layout.cells[*picked].T_s_u;
    behind = is_picked_covered || (parts_->cut && parts_->cut->removes(T_s_u.t)) ||
             T_s_u.R.col(2).dot(sight.towardEye(T_s_u.t)) <= 0;
  }
  if (!parts_->stale && sight == parts_->sight && behind == parts_->picked_behind) return;
  parts_->stale = false;
  parts_->sight = sight;
  parts_->picked_behind = behind;
  parts_->labels.clear();
  if (parts_->visible) {
    parts_->labels = parts_->choice.choose(sight, picked, parts_->cut);
  } else if (picked) {
    parts_->labels = parts_->choice.choosePicked(sight, *picked);
  }
  parts_->ids.actor->VisibilityOff();
  parts_->plate.actor->VisibilityOff();
  if (parts_->labels.empty()) return;
  if (parts_->atlas.setDpi(dpi)) parts_->texture->SetInputData(parts_->atlas.picture());
  Sheets ids(sight, parts_->atlas.white());
  bool any = false;
  for (const PlacedLabel& label : parts_->labels) {
    if (label.cell == picked) {
      Sheets plate(sight, parts_->atlas.white());
      parts_->writePlate(plate, label);
      parts_->plate.mapper->SetInputData(plate.finish());
      parts_->plate.actor->VisibilityOn();
    } else if (label.cell < parts_->front_colors.size()) {
      any = true;
      parts_->write(ids, label, label.depth_m, toRgba(markOn(parts_->front_colors[label.cell], parts_->colors)));
    }
  }
  if (!any) return;
  parts_->ids.mapper->SetInputData(ids.finish());
  parts_->ids.actor->VisibilityOn();
}

std::vector<PlacedLabel> SceneLabels::drawn() const { return parts_->labels; }

bool SceneLabels::isPickedBehind() const { return parts_->picked_behind; }

}  // namespace hexoderm
