#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <cstdint>

namespace hexoderm {

// The colours by which links, and cells by their links, are told apart: the only table, for exported files and for the
// window. 0xRRGGBB.

/// What the colours stand on; files are drawn on a light one.
enum class Background { Light, Dark };

std::uint32_t qualityColor(EdgeQuality quality, Background background);  ///< the colour of a quality as 0xRRGGBB

/// Grey: a link that is not used, and a cell without a link that is.
std::uint32_t unusedColor(Background background);

}  // namespace hexoderm
