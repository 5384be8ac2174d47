#pragma once

#include "tests/support/another_process.h"

#include <sched.h>
#include <sys/mount.h>

#include <csignal>
#include <fstream>
#include <string>

namespace hexoderm::test {

/// Makes every write to a file of this process fail (EFBIG) beyond so many bytes of the file, as long as it lives.
class NoFileGrows {
 public:
  explicit NoFileGrows(rlim_t beyond = 0) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit most{beyond, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &most);
  }
  ~NoFileGrows() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  NoFileGrows(const NoFileGrows&) = delete;
  NoFileGrows& operator=(const NoFileGrows&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

/// Runs the body with an empty disk of `size` bytes at `folder`, which only that process sees; -1 if this system lets
/// nobody but root mount one.
template <class Body>
int withSmallDisk(const std::string& folder, std::size_t size, Body body) {
  constexpr int kNoDisk = 97;
  const int result = inAnotherProcess([&] {
    const std::string user = "0 " + std::to_string(::geteuid()) + " 1";
    const std::string group = "0 " + std::to_string(::getegid()) + " 1";
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return kNoDisk;
    std::ofstream("/proc/self/setgroups") << "deny" << std::flush;
    if (!(std::ofstream("/proc/self/uid_map") << user << std::flush)) return kNoDisk;
    if (!(std::ofstream("/proc/self/gid_map") << group << std::flush)) return kNoDisk;
    if (::mount("none", folder.c_str(), "tmpfs", 0, ("size=" + std::to_string(size)).c_str()) != 0) return kNoDisk;
    return body();
  });
  return result == kNoDisk ? -1 : result;
}

}  // namespace hexoderm::test
