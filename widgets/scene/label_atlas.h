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
    if (dpi == dpi_) return false;
    dpi_ = dpi;
    vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
    vtkNew<vtkTextProperty> letters;
    letters->SetColor(1, 1, 1);
    letters->BoldOn();
    std::vector<std::array<DrawnDigit, 10>> drawn(LabelChoice::kFonts.size());
    int width = 1;
    int height = 0;
    for (std::size_t row = 0; row < drawn.size(); ++row) {
      letters->SetFontSize(LabelChoice::kFonts.at(row));
      int row_width = 0;
      int row_height = 0;
      std::array<Glyph, 10>& glyphs = glyphs_[LabelChoice::kFonts.at(row)];
      for (std::size_t digit = 0; digit < 10; ++digit) {
        DrawnDigit& one = drawn[row].at(digit);
        if (!renderer->RenderString(letters, std::to_string(digit), one.image, one.size.data(), dpi)) one.size = {0, 0};
        // Digits have no descenders: without the room for these they stand in the middle of their cells.
        int lowest = 0;
        int above = one.size[1];
        while (lowest < above && one.isEmptyRow(lowest)) ++lowest;
        while (above > lowest && one.isEmptyRow(above - 1)) --above;
        one.lowest = lowest;
        glyphs.at(digit) = {row_width, height, one.size[0], above - lowest};
        row_width += one.size[0] + kGap;
        row_height = std::max(row_height, above - lowest);
      }
      width = std::max(width, row_width);
      height += row_height + kGap;
    }
    picture_ = vtkSmartPointer<vtkImageData>::New();
    picture_->SetDimensions(width, height, 1);
    picture_->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto* pixels = static_cast<unsigned char*>(picture_->GetScalarPointer());
    for (int k = 0; k < width * height; ++k) {
      std::fill_n(pixels + 4 * static_cast<std::ptrdiff_t>(k), 3, static_cast<unsigned char>(255));
      pixels[4 * static_cast<std::ptrdiff_t>(k) + 3] = 0;
    }
    for (std::size_t row = 0; row < drawn.size(); ++row) {
      for (std::size_t digit = 0; digit < 10; ++digit) {
        const Glyph& to = glyphs_[LabelChoice::kFonts.at(row)].at(digit);
        const DrawnDigit& one = drawn[row].at(digit);
        for (int y = 0; y < to.height; ++y) {
          for (int x = 0; x < to.width; ++x) {
            pixels[4 * (static_cast<std::ptrdiff_t>(to.bottom + y) * width + to.left + x) + 3] =
                one.inkAt(x, one.lowest + y);
          }
        }
      }
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
  static constexpr int kGap = 1;  // between two digits, so that none shows the edge of its neighbour
  struct DrawnDigit {
    vtkNew<vtkImageData> image;
    std::array<int, 2> size{};  ///< of the image's part that is the digit
    int lowest = 0;             ///< row with ink

    [[nodiscard]] unsigned char inkAt(int x, int y) const {
      const int* extent = image->GetExtent();
      return static_cast<const unsigned char*>(image->GetScalarPointer(extent[0] + x, extent[2] + y, 0))[3];
    }
    [[nodiscard]] bool isEmptyRow(int y) const {
      for (int x = 0; x < size[0]; ++x) {
        if (inkAt(x, y) > 0) return false;
      }
      return true;
    }
  };

  int dpi_ = 0;
  vtkSmartPointer<vtkImageData> picture_;
  std::map<int, std::array<Glyph, 10>> glyphs_;
};

}  // namespace hexoderm
