#pragma once

namespace hexoderm {

/// Directions to look from: Front from +z (out of the origin cell's skin), Side from +x, Top from +y; Back, OtherSide
/// and Bottom from the other ends of these axes; Isometric from between all three; Oblique as at first.
enum class StandardView { Oblique, Front, Side, Top, Back, OtherSide, Bottom, Isometric };

}  // namespace hexoderm
