#pragma once

#include <chrono>

namespace hexoderm::test {

/// The longest wait of a test for an event that has to come. It costs nothing if the event comes, and a busy computer,
/// a sanitizer or a virtual machine may take its time; a test's own time limit (CTest) is longer.
inline constexpr std::chrono::seconds kPatience{120};

/// The patience of a device or a host that must not give up first: beyond any test's time limit.
inline constexpr std::chrono::hours kForever{10};

}  // namespace hexoderm::test
