#pragma once

#include <chrono>

namespace hexoderm::test {

/// How long a test waits for what has to come. It costs nothing where it comes, and a busy computer, a sanitizer or a
/// virtual machine may take its time; a test's own time limit (CTest) is longer.
inline constexpr std::chrono::seconds kPatience{120};

/// For a device or a host that is not to lose its patience first: beyond any test's time limit.
inline constexpr std::chrono::hours kForever{10};

}  // namespace hexoderm::test
