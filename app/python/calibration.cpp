#include "app/python/bindings.h"

#include "hexoderm/base/error.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/metrics/pose_coverage.h"

#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

/// A patch, which keeps the result that it is a part of.
std::shared_ptr<PatchReconstruction> patchAt(const Calibration& self, std::size_t index) {
  return {self, &self->patches[index]};
}

std::vector<std::shared_ptr<PatchReconstruction>> patchesOf(const Calibration& self) {
  std::vector<std::shared_ptr<PatchReconstruction>> patches;
  for (std::size_t k = 0; k < self->patches.size(); ++k) patches.push_back(patchAt(self, k));
  return patches;
}

std::shared_ptr<PatchReconstruction> patchOf(const Calibration& self, std::uint32_t cell) {
  const PatchReconstruction* patch = self->find(CellId(cell)).patch;
  if (patch == nullptr) throw InvalidArgument("no patch holds a cell " + std::to_string(cell));
  return patchAt(self, static_cast<std::size_t>(patch - self->patches.data()));
}

py::dict optionsOf(const Reconstruction& self) {
  const SolverOptions& options = self.options;
  py::dict dict;
  for (const SolverChoice& choice : solverChoices()) {
    std::string name(choice.name);
    std::ranges::replace(name, '-', '_');
    dict[py::str(name)] = choice.get(options);
  }
  dict["without"] = options.left_out;
  dict["class_threshold"] = options.class_threshold;
  dict["goal"] = std::pair(options.goal.position_m, options.goal.orientation_rad);
  return dict;
}

/// The pose that would help most next; none without a pose so far, for the first may be any.
std::optional<PoseAdvice> adviceOf(const Reconstruction& self) {
  const GilRelease unlocked;
  const std::vector<Eigen::Vector3d> seen_o = directionsSeen(self);
  return seen_o.empty() ? std::nullopt : std::optional(adviseNextPose(*self.model, seen_o));
}

std::vector<Comparison> compareToSession(const Reconstruction& self, const Session& session) {
  if (!session.truth()) throw InvalidArgument("this session holds no truth to compare with");
  return compareToTruth(self, *session.truth());
}

/// Named after what the file holds, as the core tells it apart.
std::variant<Session, Calibration> read(const std::filesystem::path& path, const Argument<ModelOrName>& cell_model) {
  const CellModel model = modelFrom(cell_model);
  const GilRelease unlocked;
  OpenedFile opened = openFile(path, model);
  if (auto* session = std::get_if<Session>(&opened)) return std::move(*session);
  return calibrationOf(std::get<std::shared_ptr<const Reconstruction>>(opened));
}

std::string findingText(const Finding& finding) {
  return std::string(severityName(finding.severity)) + "  " + std::string(codeName(finding.code)) + ": " +
         finding.message.english();
}

void bindFinding(py::module_& module) {
  py::class_<Finding>(module, "Finding", "Something to know about a skin, its links or its poses.")
      .def_readonly("code", &Finding::code, "Its name in files, for example \"one-sided-link\".")
      .def_readonly("severity", &Finding::severity, "info, warning or error.")
      .def_readonly("text", &Finding::message, "What is wrong, in words.")
      .def_readonly("cells", &Finding::cells, "The IDs of the cells that it is about.")
      .def_readonly("ports", &Finding::ports, "Where there are any, one for each of `cells`.")
      .def_readonly("poses", &Finding::poses, "The IDs of the poses that it is about.")
      .def("__str__", &findingText)
      .def("__repr__", [](const Finding& finding) { return "<Finding " + findingText(finding) + ">"; });
}

void bindVerdict(py::module_& module) {
  py::class_<Assessment>(module, "Verdict", "How well the skin is known, what limits that, and what helps next.")
      .def_readonly("level", &Assessment::level, "good, usable, coarse, not_enough, not_trusted or failed.")
      .def_property_readonly("is_usable", &Assessment::isUsable, "The level is good, usable or coarse.")
      .def_readonly("reason", &Assessment::reason, "Why it is this level, in words.")
      .def_readonly("position_95_m", &Assessment::position_95_m,
                    "At the worst measured cell, relative to its origin, with 95 %, m: 1.96 times the root of the\n"
                    "largest eigenvalue of its covariance. None where it is not known.")
      .def_readonly("orientation_95_rad", &Assessment::orientation_95_rad, "The same of its orientation, rad.")
      .def_readonly("limit", &Assessment::limit,
                    "What keeps it from being better: nothing, no_skin, no_pose, directions, readings, mould,\n"
                    "patches or findings.")
      .def_readonly("limiting_cells", &Assessment::limiting_cells,
                    "Where readings are the limit, the IDs of the cells that lack some.")
      .def_readonly("remedy", &Assessment::remedy, "What helps most: nothing, check_skin, take_pose or retake_poses.")
      .def_readonly("retake", &Assessment::retake, "The IDs of the poses to take again.")
      .def_readonly("next_action", &Assessment::next_action,
                    "The remedy in words. Calibration.advised_up has the next pose as a direction.")
      .def("__str__",
           [](const Assessment& verdict) {
             return std::string(verdictName(verdict.level)) + ": " + verdict.reason.english();
           })
      .def("__repr__", [](const Assessment& verdict) {
        return "<Verdict " + std::string(verdictName(verdict.level)) + ": " + verdict.reason.english() + ">";
      });
}

void bindComparison(py::module_& module) {
  py::class_<Comparison>(
      module, "Comparison",
      "A patch beside a reference, after the positions' best fit: the rotation and shift that bring\n"
      "its cells as near to the reference's as can be. Orientations have the one rotation taken off\n"
      "that fits all of them best.")
      .def_readonly("patch", &Comparison::patch, "The patch's ID.")
      .def_property_readonly(
          "cells", [](const Comparison& self) { return numbersOf(self.cells, &CellDifference::cell); },
          "(N,): the IDs of the cells that both have.")
      .def_property_readonly(
          "positions", [](const Comparison& self) { return stacked(self.cells, &CellDifference::position_m); },
          "(N, 3): the reference's position less the fitted one of this patch, in the frame of the reference, m.")
      .def_property_readonly(
          "orientations",
          [](const Comparison& self) { return row<double>(self.cells, &CellDifference::orientation_rad); },
          "(N,): the angle between both orientations, from 0 on, rad.")
      .def_readonly("position_rms_m", &Comparison::position_rms_m, "Root mean square of the lengths of `positions`, m.")
      .def_readonly("orientation_rms_rad", &Comparison::orientation_rms_rad, "Root mean square of `orientations`, rad.")
      .def("__repr__", [](const Comparison& self) {
        return "<Comparison of patch " + toString(self.patch) + ": " + std::to_string(self.cells.size()) + " cells>";
      });
}

}  // namespace

void bindCalibration(py::module_& module) {
  bindFinding(module);
  bindVerdict(module);
  bindComparison(module);
  py::class_<Reconstruction, Calibration>(module, "Calibration",
                                          "Where every cell is: the result of solve(), or of a file. Never changes.")
      .def_static(
          "from_json",
          [](const std::string& text, const std::string& file) {
            return calibrationOf(parseCalibrationJson(text, file));
          },
          py::arg("text"), py::arg("file") = "text", py::call_guard<GilRelease>(),
          "Reads the text of a *.calibration.json; errors name `file`.")
      .def(
          "to_json", [](const Reconstruction& self) { return calibrationToJson(self); }, py::call_guard<GilRelease>(),
          "The text of a *.calibration.json.")
      .def(
          "write",
          [](const Reconstruction& self, const std::filesystem::path& path) { writeCalibrationJson(self, path); },
          py::arg("path"), py::call_guard<GilRelease>(),
          "Writes a *.calibration.json, which replaces what is there. Either whole or not at all.")
      .def_property_readonly("patches", &patchesOf, "In the order of their smallest cells.")
      .def("patch", &patchOf, py::arg("cell"), "The patch that holds a cell.")
      .def_readonly("findings", &Reconstruction::findings,
                    "What is wrong with the skin, its links or poses, or worth knowing.")
      .def_readonly("verdict", &Reconstruction::assessment, "How well the skin is known, and what helps next.")
      .def_property_readonly(
          "cell_model", [](const Reconstruction& self) { return *self.model; }, "The kind of its cells.")
      .def_property_readonly(
          "advice",
          [](const Reconstruction& self) {
            const auto advice = adviceOf(self);
            return advice ? adviceText(*advice, self).english() : std::string();
          },
          "The pose that would help most next, in words; empty before the first, which may be any.\n"
          "verdict.remedy says whether another one is needed.")
      .def_property_readonly(
          "advised_up",
          [](const Reconstruction& self) {
            const auto advice = adviceOf(self);
            return advice ? std::optional(advice->up) : std::nullopt;
          },
          "The same: what to turn up, a unit vector in the frame of the largest patch; None before the first pose.")
      .def_readonly("solver", &Reconstruction::solver, "global, tree or imported.")
      .def_property_readonly("options", &optionsOf, "What solve() was given.")
      .def_property_readonly(
          "description", [](const Reconstruction& self) { return self.source.text; },
          "Where the session comes from, in words.")
      .def_readonly("solve_seconds", &Reconstruction::solve_seconds,
                    "How long it took; 0 where it was read from a file.")
      .def("compare", &compareToReconstruction, py::arg("other"),
           "Cell by cell with another calibration, or with the truth of a session: one for each patch that has a cell\n"
           "in common with it.")
      .def("compare", &compareToSession, py::arg("other"),
           "The session's truth is that of the simulator, or what from_arrays() was given.")
      .def("__repr__", [](const Reconstruction& self) {
        return "<Calibration: " + sizeText(self).english() + ", " + std::string(verdictName(self.assessment.level)) +
               ">";
      });

  module.def(
      "read_calibration",
      [](const std::filesystem::path& path, const Argument<ModelOrName>& cell_model) {
        const CellModel model = modelFrom(cell_model);
        const GilRelease unlocked;
        return calibrationOf(openCalibration(path, model));
      },
      py::arg("path"), py::arg("cell_model") = "hex-bma150",
      "Reads a *.calibration.json, or a TUM SkinConfig XML, whose cells are of the given model.");
  module.def("read", &read, py::arg("path"), py::arg("cell_model") = "hex-bma150",
             "Reads any file of Hexoderm, told apart by its content: a Session or a Calibration.");
}

}  // namespace hexoderm::python
