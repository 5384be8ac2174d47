#pragma once

namespace hexoderm {

/// Kernels lay their numbers out for four things side by side, however many they do at a time
/// (lanes.inl).
inline constexpr int kLanes = 4;

}  // namespace hexoderm
