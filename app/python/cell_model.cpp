#include "app/python/bindings.h"

#include "hexoderm/skin/cell_model.h"

#include <pybind11/stl/filesystem.h>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

py::dict portsOf(const CellModel& model) {
  py::dict ports;
  for (const Port& port : model.ports) ports[py::cast(port.number)] = port.vector_m;
  return ports;
}

}  // namespace

CellModel modelFrom(const Argument<ModelOrName>& cell_model) {
  const char* const expected =
      "a CellModel, a built-in name or the path of a JSON file (CellModel.from_json() reads JSON text)";
  const ModelOrName model = cell_model.as("cell_model", expected);
  if (const auto* name = std::get_if<std::string>(&model)) return loadCellModel(*name);
  if (const auto* path = std::get_if<std::filesystem::path>(&model)) return loadCellModel(path->string());
  return std::get<CellModel>(model);
}

void bindCellModel(py::module_& module) {
  py::class_<CellModel>(module, "CellModel", "A kind of cell: all that is known of it before anything is measured.")
      .def_static(
          "load", [](const std::filesystem::path& name_or_path) { return loadCellModel(name_or_path.string()); },
          py::arg("name_or_path"), "A built-in model by its name (\"hex-bma150\"), or one from a JSON file.")
      .def_static(
          "from_json", [](const std::string& text, const std::string& file) { return cellModelFromJson(text, file); },
          py::arg("text"), py::arg("file") = "text", "Reads JSON text; errors name `file`.")
      .def("to_json", &cellModelToJson, "The model as JSON text, whose keys are on the page of the formats.")
      .def_readonly("name", &CellModel::name, "The name of the kind of cell.")
      .def_readonly("thickness_m", &CellModel::thickness_m, "From the front face to the back, m.")
      .def_property_readonly(
          "ports", &portsOf,
          "By the port's number, the vector in the cell frame from the centre to half-way across the gap, m.")
      .def_property_readonly(
          "outline", [](const CellModel& model) { return stacked(model.outline(), std::identity()); },
          "(6, 3): the corners of the front face in the cell frame, m, counter-clockwise from outside.")
      .def("__repr__", [](const CellModel& model) { return "<CellModel " + model.name + ">"; });
  module.def("built_in_cell_models", &builtInCellModelNames, "The names that CellModel.load() knows.");
}

}  // namespace hexoderm::python
