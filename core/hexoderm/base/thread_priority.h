#pragma once

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace hexoderm {

/// From now on this thread computes where threads of usual priority leave it time: a thread that a window waits for is
/// not kept from a processor by one that nobody waits for in that moment. On Linux, where each thread has a niceness of
/// its own; elsewhere nothing happens, and all share alike.
inline void giveWayToOtherThreads() {
#ifdef __linux__
  constexpr int kNicer = 5;
  // Always granted: only the other direction takes rights.
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()),
                ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid())) + kNicer);
#endif
}

}  // namespace hexoderm
