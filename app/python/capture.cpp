#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/interruptible.h"

#include "hexoderm/course/live_capture.h"
#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

std::unique_ptr<LiveCapture> start(const std::string& source, std::size_t poses, bool automatic,
                                   const std::optional<std::filesystem::path>& output, bool keep_raw,
                                   const std::optional<std::filesystem::path>& record, double timeout) {
  // LiveCapture refuses them too, by their names in C++.
  if (!(timeout > 0)) throw InvalidArgument("timeout: expected seconds above 0");
  if (output && !output->empty() && !output->string().ends_with(".hexo")) {
    throw InvalidArgument("output: expected a name that ends in .hexo, found \"" + output->string() + "\"");
  }
  LiveCaptureOptions options;
  options.source = source;
  options.poses = poses;
  options.automatic = automatic;
  if (output) options.file = *output;
  options.keep_raw = keep_raw;
  if (record) options.record_to = *record;
  options.timeout_s = timeout;
  return std::make_unique<LiveCapture>(std::move(options));
}

SessionPose next(LiveCapture& self) {
  const auto captured = interruptible([&](const std::stop_token& stop) { return self.next(stop); });
  if (!captured) throw py::stop_iteration();
  return {captured->pose, false, {}, captured->joint_angles};
}

std::vector<std::string> remarksOn(const PoseKept& kept) {
  const CapturedPose& captured = kept.captured;
  std::vector<std::string> remarks;
  if (!captured.silent_cells.empty()) remarks.push_back("silent " + listInWords(captured.silent_cells));
  if (captured.repeats) {
    remarks.push_back("it repeats pose " + toString(*captured.repeats) + " (" +
                      formatFixed(toDegrees(captured.repeat_angle_rad), 1) + "°)");
  }
  for (const OddCell& odd : captured.odd_cells) remarks.push_back(describe(odd).english());
  if (!kept.without_raw.empty()) remarks.push_back("kept without its raw samples: " + kept.without_raw.english());
  return remarks;
}

void close(LiveCapture& self) {
  const py::gil_scoped_release released;
  self.close();
}

/// Deleted without the interpreter's lock: it waits for the device and the disk.
struct DeleteWithoutLock {
  void operator()(LiveCapture* capture) const {
    const py::gil_scoped_release released;
    delete capture;
  }
};

std::string sourcesInWords() {
  std::string kinds;
  for (const SourceKind& kind : sourceKinds()) kinds += (kinds.empty() ? "" : ", ") + std::string(kind.example);
  return kinds;
}

}  // namespace

void bindCapture(py::module_& module) {
  py::class_<LiveCapture, std::unique_ptr<LiveCapture, DeleteWithoutLock>>(
      module, "Capture",
      "A live capture: an iterator over its poses, each as soon as it counts as captured. While it is waited for the\n"
      "next one, Python's other threads go on, and Ctrl+C ends the wait.")
      .def(py::init([](const std::string& source, std::size_t poses, bool automatic,
                       const std::optional<std::filesystem::path>& output, bool keep_raw,
                       const std::optional<std::filesystem::path>& record, double timeout) {
             const py::gil_scoped_release released;
             return std::unique_ptr<LiveCapture, DeleteWithoutLock>(
                 start(source, poses, automatic, output, keep_raw, record, timeout).release());
           }),
           py::arg("source"), py::kw_only(), py::arg("poses") = 0, py::arg("auto") = false,
           py::arg("output") = py::none(), py::arg("keep_raw") = false, py::arg("record") = py::none(),
           py::arg("timeout") = LiveCaptureOptions().timeout_s,
           ("Connects to a skin; the options are those of `hexoderm-cli capture`.\n\n"
            "source: " +
            sourcesInWords() +
            ".\n"
            "poses: end after so many; 0: at the stream's end, with auto when they are good.\n"
            "auto: the device turns itself, to where each pose helps most.\n"
            "output: a new *.hexo in which nothing captured is ever lost; without one the session is in memory alone.\n"
            "keep_raw: keep every sample of the poses in that file too.\n"
            "record: write all that the device sends to this file, for replay:FILE.\n"
            "timeout: seconds to wait for a device to describe itself; with auto also for each pose.")
               .c_str())
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &next)
      .def("__enter__", [](py::object self) { return self; })
      .def("__exit__", [](LiveCapture& self, const py::args& /*error*/) { close(self); })
      .def("close", &close, "Ends the capture and waits until all poses are on disk.")
      .def("turn_to_next_pose", &LiveCapture::turnToNextPose, py::call_guard<py::gil_scoped_release>(),
           "Asks a device that can to turn to the pose that would help most.")
      .def_property_readonly(
          "session", [](const LiveCapture& self) { return self.state().session; },
          "A copy of the session as it is; None before a skin described itself.")
      .def_property_readonly(
          "calibration",
          [](const LiveCapture& self) {
            const auto result = self.state().result;
            return result ? std::optional(Calibration{result}) : std::nullopt;
          },
          "The result of all poses so far; None before the first.")
      .def_property_readonly(
          "remarks",
          [](const LiveCapture& self) {
            const auto last = self.state().last;
            return last ? remarksOn(*last) : std::vector<std::string>();
          },
          "What was odd about the pose that came last, in words: cells that were silent or restless, an earlier pose "
          "that\n"
          "it repeats.")
      .def_property_readonly(
          "status", [](const LiveCapture& self) { return self.state().status.english(); },
          "What is waited for, in words.")
      .def_property_readonly(
          "advice", [](const LiveCapture& self) { return self.state().advice.english(); },
          "The pose that would help most, in words; empty where none is known.")
      .def_property_readonly(
          "advised_up",
          [](const LiveCapture& self) {
            const auto up = self.state().up;
            return up ? std::optional(arrayOf(*up)) : std::nullopt;
          },
          "The same: what to turn up, a unit vector in the frame of the largest patch; None where none is known.");
}

}  // namespace hexoderm::python
