#include "hexoderm/solve/result/quality_colors.h"

#include "hexoderm/base/error.h"

namespace hexoderm {

std::uint32_t qualityColor(EdgeQuality quality, Background background) {
  const bool dark = background == Background::Dark;
  switch (quality) {
    case EdgeQuality::Undefined:
      return dark ? 0xD64A45 : 0x7F0D14;
    case EdgeQuality::Partially:
      return dark ? 0xFFDE3E : 0xE66F15;
    case EdgeQuality::Fully:
      return dark ? 0x87F5FA : 0x17A1CA;
    case EdgeQuality::Over:
      return dark ? 0x7A6BE8 : 0x3A1FB0;
  }
  throw InvalidArgument("qualityColor: no such quality");
}

std::uint32_t unusedColor(Background background) { return background == Background::Dark ? 0x757F8B : 0x8A939E; }

}  // namespace hexoderm
