#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <exception>

namespace hexoderm::test {

/// Runs `body` in a process of its own and returns what it returned, or 128 and the number of the signal that ended it;
/// what it throws is printed and gives 99. `usage`: what the process took.
template <class Body>
int inAnotherProcess(Body body, rusage* usage = nullptr) {
  const pid_t child = ::fork();
  if (child == 0) {
    int result = 99;
    try {
      result = body();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "in another process: %s\n", error.what());
    }
    ::_exit(result);
  }
  int status = 0;
  ::wait4(child, &status, 0, usage);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Runs the body without root's right to write everywhere.
template <class Body>
int asOrdinaryUser(Body body) {
  return inAnotherProcess([&] {
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 && (::setgid(kNobody) != 0 || ::setuid(kNobody) != 0)) return 98;
    return body();
  });
}

}  // namespace hexoderm::test
