#pragma once

namespace hexoderm::test {

/// Debug and sanitizer builds take a few seeds only: there the code is watched, not the figures.
#ifdef NDEBUG
inline constexpr bool kFewSeeds = false;
#else
inline constexpr bool kFewSeeds = true;
#endif

}  // namespace hexoderm::test
