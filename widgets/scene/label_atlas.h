#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <array>
#include <map>

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
  bool setDpi(int dpi);
  /// RGBA; null before the first setDpi().
  [[nodiscard]] vtkImageData* picture() const { return picture_; }
  /// `digit` from 0 to 9.
  [[nodiscard]] const Glyph& glyph(int font_px, int digit) const { return glyphs_.at(font_px).at(digit); }
  /// From one digit to the next, in pixels.
  [[nodiscard]] int advance(int font_px) const;

 private:
  int dpi_ = 0;
  vtkSmartPointer<vtkImageData> picture_;
  std::map<int, std::array<Glyph, 10>> glyphs_;
};

}  // namespace hexoderm
