#pragma once

#include <ctime>

namespace hexoderm::test {

/// Computing time of this thread so far, in seconds: unlike the time that goes by, it does not depend on other
/// programs.
inline double threadCpuTime_s() {
  std::timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace hexoderm::test
