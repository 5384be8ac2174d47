#include "app/python/bindings.h"

#include "hexoderm/base/error.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/io/session_json.h"

#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

/// Runs what takes a while on a copy, which another thread of Python can't change meanwhile.
template <class Work>
auto withoutLock(const Session& session, const Work& work) {
  const Session copy = session;  // poses are shared
  const GilRelease unlocked;
  return work(copy);
}

void setPoseDisabled(Session& session, std::size_t index, bool disabled, const std::string& why) {
  session.setPoseDisabled(index, disabled, why);
}

LinkEnd endFrom(const std::pair<std::uint32_t, std::uint32_t>& end) {
  return {CellId(end.first), PortNumber(end.second)};
}

bool reports(const Session& session, LinkEnd from, LinkEnd to) {
  const auto cell = std::ranges::find(session.neighbors(), from.cell, &CellReport::id);
  return cell != session.neighbors().end() && std::ranges::any_of(cell->neighbors, [&](const NeighborReport& link) {
           return link.port == from.port && link.cell == to.cell && link.cell_port.value_or(to.port) == to.port;
         });
}

void setLinkMuted(Session& session, const std::pair<std::uint32_t, std::uint32_t>& a,
                  const std::pair<std::uint32_t, std::uint32_t>& b, bool muted, const std::string& why) {
  const LinkEnd from = endFrom(a);
  const LinkEnd to = endFrom(b);
  // A slip of the pen would mute nothing, and nobody would notice.
  if (muted && !reports(session, from, to) && !reports(session, to, from)) {
    throw InvalidArgument("no link of the session joins " + hexoderm::inWords(from).english() + " and " +
                          hexoderm::inWords(to).english());
  }
  session.setLinkMuted(from, to, muted, why);
}

void bindPose(py::module_& module) {
  const auto of_samples = [](auto get) {
    return [get](const SessionPose& pose) { return stacked(pose.capture->samples, get); };
  };
  py::class_<SessionPose>(module, "Pose",
                          "A pose of a session: gravity as every cell saw it while the part was held still.")
      .def_property_readonly(
          "id", [](const SessionPose& pose) { return pose.capture->id; },
          "From 1 on, and kept when other poses are removed: not its place in Session.poses.")
      .def_property_readonly(
          "label", [](const SessionPose& pose) { return pose.capture->label; }, "Its name, for people.")
      .def_readonly("disabled", &SessionPose::disabled, "It is not used.")
      .def_readonly("why_disabled", &SessionPose::why_disabled, "The words of whoever disabled it.")
      .def_property_readonly(
          "cells", [](const SessionPose& pose) { return numbersOf(pose.capture->samples, &GravitySample::cell); },
          "(N,): the cells that have a reading.")
      .def_property_readonly("readings", of_samples(&GravitySample::mean_g),
                             "(N, 3): mean readings, g, along the axes of each accelerometer.")
      .def_property_readonly("covariances", of_samples(&GravitySample::cov_g2),
                             "(N, 3, 3): covariances of the means, g^2; zero where they are not known.")
      .def_property_readonly(
          "counts",
          [](const SessionPose& pose) { return row<std::int64_t>(pose.capture->samples, &GravitySample::count); },
          "(N,): samples averaged; 0 where it is not known.")
      .def_property_readonly(
          "taken_at_ms", [](const SessionPose& pose) { return pose.capture->taken_at_ms; },
          "Milliseconds since 1970, UTC; None where it is not known.")
      .def_property_readonly(
          "joint_angles",
          [](const SessionPose& pose) {
            const auto& positions = pose.joint_angles.positions;
            return std::map<std::string, double>(positions.begin(), positions.end());
          },
          "Where the robot's joints stood, rad (prismatic: m); empty where it is not known.")
      .def("__repr__", [](const SessionPose& pose) {
        return "<Pose " + toString(pose.capture->id) + ": " + std::to_string(pose.capture->samples.size()) +
               " readings>";
      });
}

std::string inWords(const Session& session) {
  const auto counted = [](std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  };
  return "<Session: " + counted(session.neighbors().size(), "cell") + ", " + counted(session.poses().size(), "pose") +
         ">";
}

}  // namespace

void bindSession(py::module_& module) {
  bindPose(module);
  py::class_<Session> session(module, "Session",
                              "What was measured: cells with their links, poses, and what was decided about them.");
  bindSessionArrays(session);
  session
      .def_static(
          "from_json", [](const std::string& text, const std::string& file) { return parseSessionJson(text, file); },
          py::arg("text"), py::arg("file") = "text", py::call_guard<GilRelease>(),
          "Reads the text of a *.session.json; errors name `file`.")
      .def(
          "to_json",
          [](const Session& self) { return withoutLock(self, [](const Session& s) { return sessionToJson(s); }); },
          "The text of a *.session.json.")
      .def(
          "write",
          [](const Session& self, const std::filesystem::path& path) {
            withoutLock(self, [&](const Session& s) { saveSession(s, path); });
          },
          py::arg("path"),
          "Writes a *.session.json, which replaces what is there, or a new *.hexo. Either whole or not at all.")
      .def(
          "copy", [](const Session& self) { return self; }, "A session of its own; nothing is shared.")
      .def_property_readonly(
          "cell_model", [](const Session& self) { return self.model(); }, "The kind of its cells.")
      .def_property_readonly(
          "description", [](const Session& self) { return self.source().text; }, "Where it comes from, in words.")
      .def_property_readonly("poses", &Session::poses, "A list, in the order in which they were added.")
      .def(
          "remove_pose", [](Session& self, std::size_t index) { self.removePose(index); }, py::arg("index"),
          "Removes session.poses[index]: the place from 0 on, not the pose's ID.")
      .def("set_pose_disabled", &setPoseDisabled, py::arg("index"), py::arg("disabled"), py::arg("why") = "",
           "Disables session.poses[index], or enables it again: the place from 0 on, not the pose's ID. A disabled\n"
           "pose stays in the session and is not used.")
      .def("set_link_muted", &setLinkMuted, py::arg("a"), py::arg("b"), py::arg("muted"), py::arg("why") = "",
           "Sets the link between two (cell, port) aside, because it is a cable for example, or takes it back.\n"
           "InvalidArgument if there is no such link.")
      .def("__repr__", &inWords);

  module.def(
      "read_session", [](const std::filesystem::path& path) { return openSession(path); }, py::arg("path"),
      py::call_guard<GilRelease>(), "Reads a session: *.session.json or *.hexo, told apart by their content.");
}

}  // namespace hexoderm::python
