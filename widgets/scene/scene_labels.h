#pragma once

#include "widgets/scene/label_choice.h"
#include "widgets/scene/mesh_actor.h"
#include "widgets/scene/polydata_builder.h"
#include "widgets/scene/scene_content.h"
#include "widgets/style/scene_colors.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkTexture.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {

/// White digits in every size of LabelChoice::kFonts in one picture, from which IDs are put together.
class LabelAtlas {
 public:
  /// A digit's place in the picture, in pixels.
  struct Glyph {
    int left = 0;
    int bottom = 0;
    int width = 0;
    int height = 0;
  };

  /// Draws the digits anew if this is another density of pixels; true if it has.
  bool setDpi(int dpi) {
    if (std::exchange(dpi_, dpi) == dpi) return false;
    int height = 0;
    for (const int font_px : LabelChoice::kFonts) height += cellOf(font_px);
    picture_ = vtkSmartPointer<vtkImageData>::New();
    picture_->SetDimensions(10 * cellOf(LabelChoice::kFonts.back()), height, 1);
    picture_->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto* pixels = static_cast<unsigned char*>(picture_->GetScalarPointer());
    std::fill_n(pixels, 4 * picture_->GetNumberOfPoints(), static_cast<unsigned char>(255));
    for (vtkIdType k = 0; k < picture_->GetNumberOfPoints(); ++k) pixels[4 * k + 3] = 0;
    const vtkNew<vtkTextProperty> letters;
    letters->SetColor(1, 1, 1);
    letters->BoldOn();
    int bottom = 0;
    for (const int font_px : LabelChoice::kFonts) {
      letters->SetFontSize(font_px);
      for (int digit = 0; digit < 10; ++digit) {
        const vtkNew<vtkImageData> image;
        std::array<int, 2> size{};
        if (!vtkTextRenderer::GetInstance()->RenderString(letters, std::to_string(digit), image, size.data(), dpi)) {
          size = {0, 0};
        }
        glyphs_[font_px].at(static_cast<std::size_t>(digit)) = copy(image, size, digit * cellOf(font_px), bottom);
      }
      bottom += cellOf(font_px);
    }
    return true;
  }

  /// RGBA; null before the first setDpi().
  [[nodiscard]] vtkImageData* picture() const { return picture_; }
  /// `digit` from 0 to 9.
  [[nodiscard]] const Glyph& glyph(int font_px, int digit) const { return glyphs_.at(font_px).at(digit); }
  /// From one digit to the next, in pixels.
  [[nodiscard]] int advance(int font_px) const {
    return std::max(1, static_cast<int>(std::lround(LabelChoice::kDigitAdvance * font_px * dpi_ / 72.0)));
  }

 private:
  /// Side of the square in which a digit of this size has room.
  [[nodiscard]] int cellOf(int font_px) const { return 2 * font_px * dpi_ / 72; }
  [[nodiscard]] static unsigned char& inkAt(vtkImageData* image, int x, int y) {
    const int* extent = image->GetExtent();
    return static_cast<unsigned char*>(image->GetScalarPointer(extent[0] + x, extent[2] + y, 0))[3];
  }

  /// Without the rows that have no ink: digits have no descenders, and without the room for these they stand in the
  /// middle of their cells.
  Glyph copy(vtkImageData* image, const std::array<int, 2>& size, int left, int bottom) {
    Glyph glyph{left, bottom, size[0], 0};
    for (int y = 0; y < size[1]; ++y) {
      bool any = false;
      for (int x = 0; x < size[0]; ++x) {
        const unsigned char ink = inkAt(image, x, y);
        inkAt(picture_, left + x, bottom + glyph.height) = ink;
        any = any || ink > 0;
      }
      if (any) ++glyph.height;
    }
    return glyph;
  }

  int dpi_ = 0;
  vtkSmartPointer<vtkImageData> picture_;
  std::map<int, std::array<Glyph, 10>> glyphs_;
};

/// The cells' IDs, upright to the viewer, on faces that look at the camera and are large enough to be read.
class SceneLabels {
 public:
  explicit SceneLabels(vtkRenderer* renderer) : renderer_(renderer) {
    texture_->InterpolateOff();
    texture_->RepeatOff();
    texture_->MipmapOff();
    mesh_.mapper->SetColorModeToDirectScalars();
    mesh_.actor->SetTexture(texture_);
    mesh_.property()->LightingOff();
    mesh_.actor->PickableOff();
    mesh_.actor->UseBoundsOff();
    // Letters leave the depth of the faces under them as it is.
    mesh_.actor->ForceTranslucentOn();
    mesh_.show(nullptr);
    renderer->AddActor(mesh_.actor);
  }

  /// Null shows nothing.
  void setContent(const std::shared_ptr<const SceneContent>& content) {
    choice_.setContent(content);
    front_colors_.clear();
    labels_.clear();
    stale_ = true;
    mesh_.show(nullptr);
    // Behind all faces in the order of drawing, however late these came.
    renderer_->RemoveActor(mesh_.actor);
    renderer_->AddActor(mesh_.actor);
  }

  void setColors(const std::vector<Rgb>& front_colors, const SceneColors& colors) {
    front_colors_ = front_colors;
    colors_ = colors;
    stale_ = true;
  }

  void setVisible(bool visible) {
    visible_ = visible;
    stale_ = true;
  }

  /// IDs of cells that are cut away are not drawn.
  void setCut(const std::optional<SceneCut>& cut) {
    cut_ = cut;
    stale_ = true;
  }

  /// Before each rendering: which are seen, how large, and where.
  void update(const SceneSight& sight) {
    if (!std::exchange(stale_, false) && sight == sight_) return;
    sight_ = sight;
    labels_.clear();
    if (visible_ && !front_colors_.empty()) labels_ = choice_.choose(sight, cut_);
    if (labels_.empty()) {
      mesh_.show(nullptr);
      return;
    }
    if (atlas_.setDpi(static_cast<int>(std::lround(72 * sight.text_scale)))) {
      texture_->SetInputData(atlas_.picture());
    }
    mesh_.show(makeLetters());
  }

  /// Those drawn last.
  [[nodiscard]] const std::vector<PlacedLabel>& drawn() const { return labels_; }

 private:
  /// A rectangle for each letter, at the depth of its label, with its part of the texture.
  [[nodiscard]] vtkSmartPointer<vtkPolyData> makeLetters() const {
    PolyDataBuilder mesh;
    const vtkNew<vtkFloatArray> texture;
    texture->SetNumberOfComponents(2);
    texture->SetName("TCoords");
    const vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    const int* size = atlas_.picture()->GetDimensions();
    for (const PlacedLabel& label : labels_) {
      const auto color = toBytes(markOn(front_colors_.at(label.cell), colors_));
      const std::string id = toString(choice_.content()->layout.cells[label.cell].id);
      const int advance = atlas_.advance(label.font_px);
      // On whole pixels the letters are as sharp as they were drawn.
      double left = std::round(label.at_px.x() - 0.5 * advance * static_cast<double>(id.size()));
      for (const char letter : id) {
        const LabelAtlas::Glyph& glyph = atlas_.glyph(label.font_px, letter - '0');
        const Eigen::Vector2d from(left + std::floor(0.5 * (advance - glyph.width)),
                                   std::round(label.at_px.y() - 0.5 * glyph.height));
        std::vector<vtkIdType> corners;
        for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
          const Eigen::Vector2d pixel = from + Eigen::Vector2d(x * glyph.width, y * glyph.height);
          corners.push_back(mesh.addPoint(sight_.pointAt(pixel, label.depth_m)));
          texture->InsertNextTuple2(1.0 * (glyph.left + x * glyph.width) / size[0],
                                    1.0 * (glyph.bottom + y * glyph.height) / size[1]);
          colors->InsertNextTypedTuple(color.data());
        }
        mesh.addPolygon(corners);
        left += advance;
      }
    }
    vtkSmartPointer<vtkPolyData> data = mesh.finish();
    data->GetPointData()->SetTCoords(texture);
    data->GetPointData()->SetScalars(colors);
    return data;
  }

  vtkRenderer* renderer_;
  LabelChoice choice_;
  LabelAtlas atlas_;
  std::vector<Rgb> front_colors_;
  SceneColors colors_;
  bool visible_ = true;
  std::optional<SceneCut> cut_;
  vtkNew<vtkTexture> texture_;
  MeshActor mesh_;
  std::vector<PlacedLabel> labels_;
  // What the present mesh was made for.
  bool stale_ = true;
  SceneSight sight_;
};

}  // namespace hexoderm
