#pragma once

#include "tests/support/another_process.h"

#include <malloc.h>

#include <functional>
#include <stdexcept>

namespace hexoderm::test {

/// Most resident memory, in MB, of a process of its own that does this work and then ends: unlike what the running
/// process takes, it does not depend on the tests before. Of no use with a sanitizer, which keeps what is freed.
inline double peakMemory_MB(const std::function<void()>& work) {
  ::malloc_trim(0);  // the child would use freed memory of the tests before, which counts already
  rusage usage{};
  const auto worked = [&work] {
    work();
    return 0;
  };
  if (inAnotherProcess(worked, &usage) != 0) throw std::runtime_error("the process failed");
  constexpr double kPerMB = 1024;
  return static_cast<double>(usage.ru_maxrss) / kPerMB;
}

}  // namespace hexoderm::test
