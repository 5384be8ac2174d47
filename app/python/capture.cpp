#include "app/python/bindings.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/capture/live_capture.h"
#include "hexoderm/device/sources/open_source.h"

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

using File = Argument<std::optional<std::filesystem::path>>;
/// Deleted without the interpreter's lock: it waits for the device and the disk.
struct DeleteWithoutLock {
  void operator()(LiveCapture* capture) const {
    const GilRelease unlocked;
    delete capture;
  }
};
using CapturePointer = std::unique_ptr<LiveCapture, DeleteWithoutLock>;

CapturePointer start(const Argument<std::string>& source, const Argument<std::size_t>& poses,
                     const Argument<bool>& automatic, const File& output, const Argument<bool>& keep_raw,
                     const File& record, const Argument<double>& timeout) {
  LiveCaptureOptions options;
  options.source = source.as("source");
  options.poses = poses.as("poses");
  options.automatic = automatic.as("auto");
  options.file = output.as("output", "a path").value_or(std::filesystem::path());
  options.keep_raw = keep_raw.as("keep_raw");
  options.record_to = record.as("record", "a path").value_or(std::filesystem::path());
  options.timeout_s = timeout.as("timeout");
  // LiveCapture refuses them too, by their names in C++.
  if (!(options.timeout_s > 0)) throw InvalidArgument("timeout: expected seconds above 0");
  if (!options.file.empty() && !options.file.string().ends_with(".hexo")) {
    throw InvalidArgument("output: expected a name that ends in .hexo, found \"" + options.file.string() + "\"");
  }
  const GilRelease unlocked;
  return CapturePointer(std::make_unique<LiveCapture>(std::move(options)).release());
}

SessionPose next(LiveCapture& self) {
  const auto captured = interruptible([&](const std::stop_token& stop) { return self.next(stop); });
  if (!captured) throw py::stop_iteration();
  return {captured->pose, false, {}, captured->joint_angles};
}

std::vector<std::string> remarksOn(const PoseKept& kept) {
  const CapturedPose& captured = kept.captured;
  std::vector<std::string> remarks;
  if (!captured.silent_cells.empty()) remarks.push_back("silent " + listText(captured.silent_cells));
  if (captured.repeats) {
    remarks.push_back("it repeats pose " + toString(*captured.repeats) + " (" +
                      formatFixed(toDegrees(captured.repeat_angle_rad), 1) + "°)");
  }
  for (const OddCell& odd : captured.odd_cells) remarks.push_back(describe(odd).english());
  if (!kept.without_raw.empty()) remarks.push_back("kept without its raw samples: " + kept.without_raw.english());
  return remarks;
}

void close(LiveCapture& self) {
  const GilRelease unlocked;
  self.close();
}

}  // namespace

void bindCapture(py::module_& module) {
  py::class_<LiveCapture, CapturePointer> capture(
      module, "Capture",
      "A live capture: an iterator over its poses, each as soon as it counts as captured. While it is waited for the\n"
      "next one, Python's other threads go on, and Ctrl+C ends the wait.\n\n"
      "Poses are taken while somebody waits for the next one, by a for loop or next(), in any thread. Before the\n"
      "first time nothing of what the device sends is looked at: session, calibration and advice are None or empty.");
  capture
      .def(py::init(&start), py::arg("source"), py::kw_only(), py::arg("poses") = 0, py::arg("auto") = false,
           py::arg("output") = py::none(), py::arg("keep_raw") = false, py::arg("record") = py::none(),
           py::arg("timeout") = LiveCaptureOptions().timeout_s,
           ("Connects to a skin; the options are those of `hexoderm-cli capture`.\n\n"
            "source: " +
            sourceKindsText() +
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
      .def("turn_to_next_pose", &LiveCapture::turnToNextPose, py::call_guard<GilRelease>(),
           "Asks a device that can to turn to the pose that would help most. It is the call that waits for the next\n"
           "pose that asks it, in another thread or afterwards. InvalidArgument if it can't turn, or no skin\n"
           "described itself yet.")
      .def_property_readonly(
          "session", [](const LiveCapture& self) { return self.state().session; },
          "A copy of the session as it is; None before a skin described itself, which is noticed by next().")
      .def_property_readonly(
          "calibration", [](const LiveCapture& self) { return calibrationOf(self.state().result); },
          "The result of all poses so far; None before the first.")
      .def_property_readonly(
          "remarks",
          [](const LiveCapture& self) {
            const auto last = self.state().last;
            return last ? remarksOn(*last) : std::vector<std::string>();
          },
          "What was odd about the pose that came last, in words: cells that were silent or restless, an earlier pose\n"
          "that it repeats.")
      .def_property_readonly(
          "status", [](const LiveCapture& self) { return self.state().status; },
          "What is waited for, in words: of the connection until a skin described itself, then of the part.")
      .def_property_readonly(
          "advice", [](const LiveCapture& self) { return self.state().advice; },
          "The pose that would help most, in words; empty where none is known, or where there are enough.")
      .def_property_readonly(
          "advised_up", [](const LiveCapture& self) { return self.state().up; },
          "The same: what to turn up, a unit vector in the frame of the largest patch; None where none is known.");
  explainMisfits(capture, "__init__");
}

}  // namespace hexoderm::python
