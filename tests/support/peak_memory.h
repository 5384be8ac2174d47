#pragma once

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <stdexcept>

namespace hexoderm::test {

/// Most resident memory, in MB, of a process of its own that does this work and then ends: unlike what the running
/// process takes, it does not depend on the tests before. Of no use with a sanitizer, which keeps what is freed.
inline double peakMemory_MB(const std::function<void()>& work) {
  ::malloc_trim(0);  // the child would use freed memory of the tests before, which counts already
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process could be started");
  if (child == 0) {
    try {
      work();
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  int status = 0;
  rusage usage{};
  if (::wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("the process failed");
  }
  constexpr double kPerMB = 1024;
  return static_cast<double>(usage.ru_maxrss) / kPerMB;
}

}  // namespace hexoderm::test
