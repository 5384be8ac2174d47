#pragma once

#include "widgets/scene/label_atlas.h"
#include "widgets/scene/label_choice.h"
#include "widgets/scene/scene_content.h"
#include "widgets/style/scene_colors.h"

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
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

/// The cells' IDs, upright to the viewer, on faces that look at the camera and are large enough to be read.
class SceneLabels {
 public:
  explicit SceneLabels(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
    parts_->renderer = renderer;
    parts_->texture->InterpolateOff();
    parts_->texture->RepeatOff();
    parts_->texture->MipmapOff();
    parts_->mapper->SetColorModeToDirectScalars();
    parts_->mapper->SetInputData(vtkNew<vtkPolyData>());
    vtkActor* actor = parts_->actor;
    actor->SetMapper(parts_->mapper);
    actor->SetTexture(parts_->texture);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    actor->UseBoundsOff();
    actor->VisibilityOff();
    // Letters leave the depth of the faces under them as it is, so that only faces shade each other.
    actor->ForceTranslucentOn();
    renderer->AddActor(actor);
  }

  /// Null shows nothing.
  void setContent(const std::shared_ptr<const SceneContent>& content) {
    parts_->choice.setContent(content);
    parts_->front_colors.clear();
    parts_->labels.clear();
    parts_->stale = true;
    parts_->actor->VisibilityOff();
    // Behind all faces in the order of drawing, however late these came.
    parts_->renderer->RemoveActor(parts_->actor);
    parts_->renderer->AddActor(parts_->actor);
  }

  void setColors(const std::vector<Rgb>& front_colors, const SceneColors& colors) {
    parts_->front_colors = front_colors;
    parts_->colors = colors;
    parts_->stale = true;
  }

  void setVisible(bool visible) {
    parts_->visible = visible;
    parts_->stale = true;
  }

  /// IDs of cells that are cut away are not drawn.
  void setCut(const std::optional<SceneCut>& cut) {
    parts_->cut = cut;
    parts_->stale = true;
  }

  /// Before each rendering: which are seen, how large, and where.
  void update(const std::array<int, 2>& window_size, int dpi) {
    const LabelSight sight = LabelSight::of(parts_->renderer->GetActiveCamera(), window_size, dpi);
    if (!parts_->stale && sight == parts_->sight) return;
    parts_->stale = false;
    parts_->sight = sight;
    parts_->labels.clear();
    if (parts_->visible && !parts_->front_colors.empty()) parts_->labels = parts_->choice.choose(sight, parts_->cut);
    parts_->actor->SetVisibility(!parts_->labels.empty());
    if (parts_->labels.empty()) return;
    if (parts_->atlas.setDpi(dpi)) parts_->texture->SetInputData(parts_->atlas.picture());
    Sheets sheets(sight);
    for (const PlacedLabel& label : parts_->labels) {
      parts_->write(sheets, label, toRgba(markOn(parts_->front_colors.at(label.cell), parts_->colors)));
    }
    parts_->mapper->SetInputData(sheets.finish());
  }

  /// Those drawn last.
  [[nodiscard]] const std::vector<PlacedLabel>& drawn() const { return parts_->labels; }

 private:
  using Rgba = std::array<unsigned char, 4>;
  static Rgba toRgba(const Rgb& color) {
    Rgba result{0, 0, 0, 255};
    for (std::size_t k = 0; k < 3; ++k) {
      result.at(k) = static_cast<unsigned char>(std::lround(255 * std::clamp(color.at(k), 0.0, 1.0)));
    }
    return result;
  }

  /// Rectangles of the picture, each at a depth of its own, as one mesh in the scene.
  class Sheets {
   public:
    explicit Sheets(const LabelSight& sight) : sight_(sight) {
      texture_->SetNumberOfComponents(2);
      texture_->SetName("TCoords");
      colors_->SetNumberOfComponents(4);
      points_->SetDataTypeToFloat();
    }

    /// `from` and `to`: lower left and upper right, in pixels; the same of the texture, in shares of it.
    void add(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double depth_m,
             const std::array<float, 2>& tex_from, const std::array<float, 2>& tex_to, const Rgba& color) {
      const vtkIdType first = addPoint({from.x(), from.y()}, depth_m, {tex_from[0], tex_from[1]}, color);
      addPoint({to.x(), from.y()}, depth_m, {tex_to[0], tex_from[1]}, color);
      addPoint({to.x(), to.y()}, depth_m, {tex_to[0], tex_to[1]}, color);
      addPoint({from.x(), to.y()}, depth_m, {tex_from[0], tex_to[1]}, color);
      polygons_->InsertNextCell({first, first + 1, first + 2, first + 3});
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
    vtkNew<vtkPoints> points_;
    vtkNew<vtkFloatArray> texture_;
    vtkNew<vtkUnsignedCharArray> colors_;
    vtkNew<vtkCellArray> polygons_;
  };

  struct Parts {
    vtkRenderer* renderer = nullptr;
    LabelChoice choice;
    LabelAtlas atlas;
    std::vector<Rgb> front_colors;
    SceneColors colors;
    bool visible = true;
    std::optional<SceneCut> cut;
    vtkNew<vtkTexture> texture;
    vtkNew<vtkActor> actor;
    vtkNew<vtkPolyDataMapper> mapper;
    std::vector<PlacedLabel> labels;
    // What the present mesh was made for.
    bool stale = true;
    LabelSight sight;

    void write(Sheets& sheets, const PlacedLabel& label, const Rgba& color) const {
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
        sheets.add(from, from + Eigen::Vector2d(glyph.width, glyph.height), label.depth_m,
                   {share(glyph.left, size[0]), share(glyph.bottom, size[1])},
                   {share(glyph.left + glyph.width, size[0]), share(glyph.bottom + glyph.height, size[1])}, color);
        left += advance;
      }
    }
  };
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
