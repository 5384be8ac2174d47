#pragma once

#include <ctime>

namespace hexoderm::test {

/// What this thread has computed so far, in seconds: unlike the time that goes by, it does not depend on what else the
/// computer does.
inline double threadCpuTime_s() {
  std::timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace hexoderm::test
