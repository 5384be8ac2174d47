#include "app/python/bindings.h"

#include "hexoderm/base/finding.h"
#include "hexoderm/solve/result/assessment.h"

namespace hexoderm::python {
namespace {

namespace py = pybind11;

std::string inWords(const Finding& finding) {
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
      .def("__str__", &inWords)
      .def("__repr__", [](const Finding& finding) { return "<Finding " + inWords(finding) + ">"; });
}

}  // namespace

void bindJudgement(py::module_& module) {
  bindFinding(module);
  py::class_<Assessment>(module, "Verdict", "How well the skin is known, what limits that, and what helps next.")
      .def_readonly("level", &Assessment::level, "good, usable, not_enough or failed.")
      .def_property_readonly("is_usable", &Assessment::isUsable, "The level is good or usable.")
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

}  // namespace hexoderm::python
