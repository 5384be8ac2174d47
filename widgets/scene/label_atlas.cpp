#include "widgets/scene/label_atlas.h"

#include "widgets/scene/label_choice.h"

#include <vtkNew.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hexoderm {
namespace {

constexpr int kWhiteSquare = 4;
constexpr int kGap = 1;  // between two digits, so that none shows the edge of its neighbour

struct DrawnDigit {
  vtkNew<vtkImageData> image;
  std::array<int, 2> size{};  ///< of the image's part that is the digit
};

}  // namespace

bool LabelAtlas::setDpi(int dpi) {
  if (dpi == dpi_) return false;
  dpi_ = dpi;
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  vtkNew<vtkTextProperty> letters;
  letters->SetColor(1, 1, 1);
  letters->BoldOn();
  std::vector<std::array<DrawnDigit, 10>> drawn(LabelChoice::kFonts.size());
  int width = kWhiteSquare;
  int height = kWhiteSquare + kGap;
  for (std::size_t row = 0; row < drawn.size(); ++row) {
    letters->SetFontSize(LabelChoice::kFonts.at(row));
    int row_width = 0;
    int row_height = 0;
    std::array<Glyph, 10>& glyphs = glyphs_[LabelChoice::kFonts.at(row)];
    for (std::size_t digit = 0; digit < 10; ++digit) {
      DrawnDigit& one = drawn[row].at(digit);
      if (!renderer->RenderString(letters, std::to_string(digit), one.image, one.size.data(), dpi)) one.size = {0, 0};
      glyphs.at(digit) = {row_width, height, one.size[0], one.size[1]};
      row_width += one.size[0] + kGap;
      row_height = std::max(row_height, one.size[1]);
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
    const bool is_white = k % width < kWhiteSquare && k / width < kWhiteSquare;
    pixels[4 * static_cast<std::ptrdiff_t>(k) + 3] = is_white ? 255 : 0;
  }
  for (std::size_t row = 0; row < drawn.size(); ++row) {
    for (std::size_t digit = 0; digit < 10; ++digit) {
      const Glyph& to = glyphs_[LabelChoice::kFonts.at(row)].at(digit);
      const int* extent = drawn[row].at(digit).image->GetExtent();
      for (int y = 0; y < to.height; ++y) {
        for (int x = 0; x < to.width; ++x) {
          const auto* in = static_cast<const unsigned char*>(
              drawn[row].at(digit).image->GetScalarPointer(extent[0] + x, extent[2] + y, 0));
          pixels[4 * (static_cast<std::ptrdiff_t>(to.bottom + y) * width + to.left + x) + 3] = in[3];
        }
      }
    }
  }
  return true;
}

int LabelAtlas::advance(int font_px) const {
  return std::max(1, static_cast<int>(std::lround(LabelChoice::kDigitAdvance * font_px * dpi_ / 72.0)));
}

std::array<float, 2> LabelAtlas::white() const {
  const int* size = picture_->GetDimensions();
  return {0.5F * kWhiteSquare / static_cast<float>(size[0]), 0.5F * kWhiteSquare / static_cast<float>(size[1])};
}

}  // namespace hexoderm
