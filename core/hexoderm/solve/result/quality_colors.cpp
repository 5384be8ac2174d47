#include "hexoderm/solve/result/quality_colors.h"

#include "hexoderm/base/enum_names.h"

#include <array>
#include <cstddef>

namespace hexoderm {

std::uint32_t qualityColor(EdgeQuality quality, Background background) {
  // In the order of EdgeQuality.
  constexpr auto kOnDark = std::to_array<std::uint32_t>({0xD64A45, 0xFFDE3E, 0x87F5FA, 0x7A6BE8});
  constexpr auto kOnLight = std::to_array<std::uint32_t>({0x7F0D14, 0xE66F15, 0x17A1CA, 0x3A1FB0});
  static_assert(kOnDark.size() == enumeratorCount<EdgeQuality>() && kOnLight.size() == kOnDark.size());
  return (background == Background::Dark ? kOnDark : kOnLight).at(static_cast<std::size_t>(quality));
}

std::uint32_t unusedColor(Background background) { return background == Background::Dark ? 0x757F8B : 0x8A939E; }

}  // namespace hexoderm
