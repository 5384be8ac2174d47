#include "app/python/arrays.h"
#include "app/python/bindings.h"

#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/reconstruction/evaluation/evaluation.h"
#include "hexoderm/util/error.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

std::vector<PatchOf> patchesOf(const Calibration& self) {
  std::vector<PatchOf> patches;
  for (std::size_t k = 0; k < self.result->patches.size(); ++k) patches.push_back({self.result, k});
  return patches;
}

PatchOf patchOf(const Calibration& self, std::uint32_t cell) {
  const PatchReconstruction* patch = self.result->find(CellId(cell)).patch;
  if (patch == nullptr) throw InvalidArgument("no patch holds a cell " + std::to_string(cell));
  return {self.result, static_cast<std::size_t>(patch - self.result->patches.data())};
}

py::dict optionsOf(const Calibration& self) {
  const SolverOptions& options = self.result->options;
  py::dict dict;
  dict["solver"] = solverName(options.solver);
  dict["centre"] = centringName(options.centring);
  dict["support_axes"] = supportAxesName(options.support_axes);
  dict["weights"] = linkWeightsName(options.weights);
  dict["gap_model"] = gapModelName(options.gap_model);
  dict["without"] = valuesOf(options.left_out);
  dict["class_threshold"] = options.class_threshold;
  return dict;
}

std::vector<Comparison> compareToSession(const Calibration& self, const Session& session) {
  if (!session.truth()) throw InvalidArgument("this session holds no truth to compare with");
  return compareToTruth(*self.result, *session.truth());
}

std::vector<Comparison> compareToCalibration(const Calibration& self, const Calibration& other) {
  return compareToReconstruction(*self.result, *other.result);
}

/// Named after what the file holds, as the core tells it apart.
std::variant<Session, Calibration> read(const std::filesystem::path& path, const ModelOrName& cell_model) {
  OpenedFile opened = openFile(path, modelFrom(cell_model));
  if (auto* session = std::get_if<Session>(&opened)) return std::move(*session);
  return Calibration{std::get<std::shared_ptr<const Reconstruction>>(opened)};
}

void bindComparison(py::module_& module) {
  py::class_<Comparison>(module, "Comparison", "A patch beside a reference, after the positions' best fit.")
      .def_property_readonly("patch", [](const Comparison& self) { return self.patch.value(); })
      .def_property_readonly("cells",
                             [](const Comparison& self) {
                               return numbersOf(self.cells,
                                                [](const CellDifference& cell) { return cell.cell.value(); });
                             })
      .def_property_readonly(
          "positions",
          [](const Comparison& self) {
            return stacked(self.cells, [](const CellDifference& cell) { return std::optional(cell.position_m); });
          },
          "(N, 3): differences, m.")
      .def_property_readonly(
          "orientations",
          [](const Comparison& self) {
            Doubles array(static_cast<py::ssize_t>(self.cells.size()));
            double* out = array.mutable_data();
            for (const CellDifference& cell : self.cells) *out++ = cell.orientation_rad;
            return array;
          },
          "(N,): angles, rad.")
      .def_readonly("position_rms_m", &Comparison::position_rms_m)
      .def_readonly("orientation_rms_rad", &Comparison::orientation_rms_rad)
      .def("__repr__", [](const Comparison& self) {
        return "<Comparison of patch " + toString(self.patch) + ": " + std::to_string(self.cells.size()) + " cells>";
      });
}

}  // namespace

void bindCalibration(py::module_& module) {
  bindComparison(module);
  py::class_<Calibration>(module, "Calibration",
                          "Where every cell is: the result of solve(), or of a file. Never changes.")
      .def_static(
          "from_json",
          [](const std::string& text, const std::string& file) {
            return Calibration{parseCalibrationJson(text, file)};
          },
          py::arg("text"), py::arg("file") = "text", py::call_guard<py::gil_scoped_release>(),
          "Reads the text of a *.calibration.json; errors name `file`.")
      .def(
          "to_json", [](const Calibration& self) { return calibrationToJson(*self.result); },
          py::call_guard<py::gil_scoped_release>())
      .def(
          "write",
          [](const Calibration& self, const std::filesystem::path& path) { writeCalibrationJson(*self.result, path); },
          py::arg("path"), py::call_guard<py::gil_scoped_release>(),
          "Writes a *.calibration.json, which replaces what is there. Either whole or not at all.")
      .def_property_readonly("patches", &patchesOf, "In the order of their smallest cells.")
      .def("patch", &patchOf, py::arg("cell"), "The patch that holds a cell.")
      .def_property_readonly("findings", [](const Calibration& self) { return self.result->findings; })
      .def_property_readonly("verdict", [](const Calibration& self) { return self.result->assessment; })
      .def_property_readonly("cell_model", [](const Calibration& self) { return *self.result->model; })
      .def_property_readonly(
          "solver", [](const Calibration& self) { return self.result->solver; }, "global, tree or imported.")
      .def_property_readonly("options", &optionsOf, "What solve() was given.")
      .def_property_readonly(
          "description", [](const Calibration& self) { return self.result->source.text.english(); },
          "Where the session comes from, in words.")
      .def_property_readonly(
          "solve_seconds", [](const Calibration& self) { return self.result->solve_seconds; },
          "How long it took; 0 where it was read from a file.")
      .def("compare", &compareToCalibration, py::arg("other"),
           "Cell by cell with another calibration, or with the truth of a session: one for each patch that has a cell "
           "in\n"
           "common with it.")
      .def("compare", &compareToSession, py::arg("other"))
      .def("__repr__", [](const Calibration& self) {
        return "<Calibration: " + sizeInWords(*self.result).english() + ", " +
               std::string(verdictName(self.result->assessment.level)) + ">";
      });

  module.def(
      "read_calibration",
      [](const std::filesystem::path& path, const ModelOrName& cell_model) {
        return Calibration{openCalibration(path, modelFrom(cell_model))};
      },
      py::arg("path"), py::arg("cell_model") = "hex-bma150", py::call_guard<py::gil_scoped_release>(),
      "Reads a *.calibration.json, or a TUM SkinConfig XML, whose cells are of the given model.");
  module.def("read", &read, py::arg("path"), py::arg("cell_model") = "hex-bma150",
             py::call_guard<py::gil_scoped_release>(),
             "Reads any file of Hexoderm, told apart by its content: a Session or a Calibration.");
}

}  // namespace hexoderm::python
