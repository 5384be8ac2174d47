#pragma once

#include <pybind11/pybind11.h>

#include <cxxabi.h>
#include <unistd.h>

namespace hexoderm::python {

/// Lets go of the interpreter's lock while it lives, as pybind11::gil_scoped_release does. That one must not be used
/// here: a daemon thread that takes the lock back while the interpreter ends is ended by Python in the midst of a
/// destructor, and with it the whole program. This one lets such a thread sleep for the instant that the program has
/// left, which is what Python itself does from version 3.14 on.
class Unlocked {
 public:
  Unlocked() : thread_(PyEval_SaveThread()) {}
  ~Unlocked() {
    try {
      PyEval_RestoreThread(thread_);
    } catch (const abi::__forced_unwind&) {
      while (true) pause();
    }
  }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  PyThreadState* thread_;
};

}  // namespace hexoderm::python
