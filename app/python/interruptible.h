#pragma once

#include "app/python/bindings.h"

#include <chrono>
#include <future>
#include <stop_token>

namespace hexoderm::python {

/// Runs `work(stop)` on a thread of its own and waits for it without the interpreter's lock, so that Python's other
/// threads go on. Ctrl+C, or whatever else a signal handler of Python raises, requests `stop`; it is raised once the
/// work has ended.
template <class Work>
auto interruptible(const Work& work) {
  namespace py = pybind11;
  constexpr std::chrono::milliseconds kLookEvery(50);
  std::stop_source stop;
  auto result = std::async(std::launch::async, [&] { return work(stop.get_token()); });
  bool is_interrupted = false;
  for (bool is_done = false; !is_done;) {
    {
      const GilRelease unlocked;
      is_done = result.wait_for(kLookEvery) == std::future_status::ready;
    }
    if (is_done || is_interrupted || PyErr_CheckSignals() == 0) continue;
    is_interrupted = true;
    stop.request_stop();
    const py::error_scope kept;  // what was raised, while the work ends
    const GilRelease unlocked;
    result.wait();
  }
  if (is_interrupted) throw py::error_already_set();
  return result.get();
}

}  // namespace hexoderm::python
