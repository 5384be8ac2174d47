#pragma once

namespace hexoderm::test {

/// Debug and sanitizer builds, in which algebra takes a hundred times as long, get fewer seeds and smaller skins: there
/// the code is watched, not the figures.
#ifdef NDEBUG
inline constexpr bool kSlowBuild = false;
#else
inline constexpr bool kSlowBuild = true;
#endif

}  // namespace hexoderm::test
