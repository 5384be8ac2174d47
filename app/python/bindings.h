#pragma once

#include "app/python/arrays.h"
#include "app/python/given.h"

#include "hexoderm/base/message.h"
#include "hexoderm/session/session.h"
#include "hexoderm/skin/cell_model.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cxxabi.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <stop_token>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

// How Python sees core's values, by conversions of pybind11: IDs as numbers, messages and names of enumerations as
// strings, matrices as arrays of their own.

namespace hexoderm::python {

/// To Python only: as what `seen` makes of the value.
template <class Value, auto seen>
struct SeenAs {
  using Caster = pybind11::detail::make_caster<std::remove_cvref_t<std::invoke_result_t<decltype(seen), const Value&>>>;
  static constexpr auto name = Caster::name;
  template <class>
  using cast_op_type = Value;

  static pybind11::handle cast(const Value& value, pybind11::return_value_policy policy, pybind11::handle parent) {
    return Caster::cast(std::invoke(seen, value), policy, parent);
  }
};

inline std::pair<std::uint32_t, std::uint32_t> numbersOfEnd(const LinkEnd& end) {
  return {end.cell.value(), end.port.value()};
}

}  // namespace hexoderm::python

namespace pybind11::detail {

template <class Tag>
struct type_caster<hexoderm::StrongId<Tag>>
    : hexoderm::python::SeenAs<hexoderm::StrongId<Tag>, &hexoderm::StrongId<Tag>::value> {};
template <>
struct type_caster<hexoderm::LinkEnd> : hexoderm::python::SeenAs<hexoderm::LinkEnd, hexoderm::python::numbersOfEnd> {};
template <>
struct type_caster<hexoderm::Message> : hexoderm::python::SeenAs<hexoderm::Message, &hexoderm::Message::english> {};
template <>
struct type_caster<hexoderm::FindingCode> : hexoderm::python::SeenAs<hexoderm::FindingCode, hexoderm::codeName> {};
template <>
struct type_caster<hexoderm::Severity> : hexoderm::python::SeenAs<hexoderm::Severity, hexoderm::severityName> {};
template <>
struct type_caster<hexoderm::VerdictLevel> : hexoderm::python::SeenAs<hexoderm::VerdictLevel, hexoderm::verdictName> {};
template <>
struct type_caster<hexoderm::Limit> : hexoderm::python::SeenAs<hexoderm::Limit, hexoderm::limitName> {};
template <>
struct type_caster<hexoderm::Remedy> : hexoderm::python::SeenAs<hexoderm::Remedy, hexoderm::remedyName> {};
template <>
struct type_caster<hexoderm::EdgeQuality> : hexoderm::python::SeenAs<hexoderm::EdgeQuality, hexoderm::qualityName> {};
template <int Rows, int Columns, int Options>
struct type_caster<Eigen::Matrix<double, Rows, Columns, Options>>
    : hexoderm::python::SeenAs<Eigen::Matrix<double, Rows, Columns, Options>,
                               hexoderm::python::arrayOf<Rows, Columns, Options>> {};

}  // namespace pybind11::detail

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

/// Runs `work(stop)` on a thread of its own and waits for it without the interpreter's lock, so that Python's other
/// threads go on. Ctrl+C, or whatever else a signal handler of Python raises, requests `stop`; it is raised once the
/// work has ended.
template <class Work>
auto interruptible(const Work& work) {
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
    const pybind11::error_scope kept;  // what was raised, while the work ends
    const GilRelease unlocked;
    result.wait();
  }
  if (is_interrupted) throw pybind11::error_already_set();
  return result.get();
}

/// A result, as Python holds it: of a solve, or read from a file. Nothing that Python is shown of it changes it.
using Calibration = std::shared_ptr<Reconstruction>;
inline Calibration calibrationOf(std::shared_ptr<const Reconstruction> result) {
  return std::const_pointer_cast<Reconstruction>(std::move(result));
}

/// A cell model by itself, or as a built-in name or a file.
using ModelOrName = std::variant<CellModel, std::string, std::filesystem::path>;
/// Of the argument cell_model. Throws TypeError naming it.
CellModel modelFrom(const Argument<ModelOrName>& cell_model);

/// What a session has as arrays; a part of bindSession.
void bindSessionArrays(pybind11::class_<Session>& session);

/// Each adds its part to the module.
using Bind = void(pybind11::module_& module);
Bind bindErrors, bindCellModel, bindSession, bindSimulate, bindPatch, bindCalibration, bindSolve, bindExports,
    bindCapture;

}  // namespace hexoderm::python
