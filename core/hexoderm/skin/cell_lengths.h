#pragma once

namespace hexoderm {

// What lengths a cell of any skin for a robot has: whoever writes millimetres is told.
inline constexpr double kMinCellSide_m = 1e-3;
inline constexpr double kMaxCellLength_m = 1;

}  // namespace hexoderm
