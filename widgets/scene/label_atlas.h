#pragma once

#include "widgets/scene/label_choice.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

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

}  // namespace hexoderm
