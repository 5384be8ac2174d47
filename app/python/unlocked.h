#pragma once

#include <pybind11/pybind11.h>

#include <cxxabi.h>
#include <unistd.h>

namespace hexoderm::python {

/// Lets go of the interpreter's lock while it lives, as pybind11::gil_scoped_release does. That one must not be used
/// here: a daemon thread that takes the lock back while the interpreter ends is ended by Python in the midst of a
/// destructor, and with it the whole program. This one lets such a thread sleep for the instant that the program has
/// left, which is what Python itself does from version 3.14 on.
class GilRelease {
 public:
  GilRelease() : thread_(PyEval_SaveThread()) {}
  ~GilRelease() {
    try {
      PyEval_RestoreThread(thread_);
    } catch (const abi::__forced_unwind&) {
      while (true) pause();
    }
  }
  GilRelease(const GilRelease&) = delete;
  GilRelease& operator=(const GilRelease&) = delete;

 private:
  PyThreadState* thread_;
};

}  // namespace hexoderm::python
