#include "app/python/bindings.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/io/export_package.h"
#include "hexoderm/io/exporter.h"
#include "hexoderm/solve/result/patch_placements.h"

#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

/// What was written, and what is not in it.
struct Exported {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> remarks;
};

void addOnce(std::vector<std::string>& sentences, const std::string& sentence) {
  const bool is_new = std::ranges::find(sentences, sentence) == sentences.end();
  if (!sentence.empty() && is_new) sentences.push_back(sentence);
}

/// Without one, the option would silently change nothing.
void requireOneThatHas(const ExportOptionDescription& option, const std::vector<ExportFormat>& formats,
                       const std::string& given) {
  const auto has_it = [&](ExportFormat format) {
    return std::ranges::find(option.formats, format) != option.formats.end();
  };
  if (std::ranges::any_of(formats, has_it)) return;
  throw InvalidArgument(given + ": is an option of " + inWords(option.formats) + ", found " + inWords(formats));
}

/// The name of an option of the command line, in Python.
std::string inPython(std::string_view name) {
  std::string underscored(name);
  std::ranges::replace(underscored, '-', '_');
  return underscored;
}

void setOption(ExportOptions& options, const std::vector<ExportFormat>& formats, const std::string& given,
               const std::string& value) {
  for (const ExportOptionDescription& option : exportOptions()) {
    if (inPython(option.name) != inPython(given)) continue;
    requireOneThatHas(option, formats, given);
    const auto is_value = [&](const auto& choice) { return choice.value == value; };
    if (!option.choices.empty() && std::ranges::none_of(option.choices, is_value)) {
      throw InvalidArgument(given + ": expected one of " +
                            inARow(option.choices, [](const auto& choice) { return choice.value; }) + ", found \"" +
                            value + "\"");
    }
    option.set(options, value);
    return;
  }
  throw InvalidArgument(given + ": is no option of an export, expected one of " +
                        inPython(inARow(exportOptions(), &ExportOptionDescription::name)));
}

PatchOnLink placeFrom(std::uint32_t origin, const std::string& link, const Doubles& position, const Doubles& rotation) {
  requireShape(position, {3}, "position");
  requireShape(rotation, {3, 3}, "rotation");
  PatchOnLink place;
  place.origin = CellId(origin);
  place.link = link;
  place.T_l_o.t = Eigen::Map<const Eigen::Vector3d>(position.data());
  place.T_l_o.R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation.data());
  return place;
}

Exported exportTo(const Reconstruction& self, const std::variant<std::string, std::vector<std::string>>& to,
                  const std::filesystem::path& path, std::optional<std::uint32_t> patch, bool all_patches,
                  const std::vector<PatchOnLink>& placements, const std::string& in_link, const py::kwargs& others) {
  const auto* name = std::get_if<std::string>(&to);
  const std::vector<std::string> names = name != nullptr ? std::vector{*name} : std::get<std::vector<std::string>>(to);
  if (names.empty()) throw InvalidArgument("to: expected a format, found none");
  std::vector<ExportFormat> formats;
  for (const std::string& each : names) formats.push_back(exportFormatFromName(each));
  ExportOptions options;
  for (const auto& [option, value] : others) setOption(options, formats, py::cast<std::string>(option), py::str(value));
  if (patch) options.patch = CellId(*patch);
  options.all_patches = all_patches;
  options.in_link = in_link;
  options.placements = placements.empty() ? placedPatches(self) : placements;
  for (const ExportFormat format : formats) options.validateFor(format);
  const bool is_folder = formats.size() > 1 || formats.front() == ExportFormat::Csv || isZip(path);
  if (is_folder && path.extension() == ".csv") {
    throw InvalidArgument("path: expected a folder, or an archive that ends in .zip, for several files; found \"" +
                          path.string() + "\"");
  }

  const GilRelease unlocked;
  Exported exported;
  for (const ExportFormat format : formats) {
    addOnce(exported.remarks, leftOutText(patchesLeftOut(self, format, options)).english());
  }
  for (const ExportFormat format : formats) {
    addOnce(exported.remarks, exportFormatDescription(format).not_carried.english());
  }
  exported.files = is_folder ? exportBundle(self, formats, path, options)
                             : exportReconstruction(self, formats.front(), path, options);
  return exported;
}

std::map<std::string, Message> formatsText() {
  std::map<std::string, Message> formats;
  for (const ExportFormatDescription& format : exportFormats()) formats.emplace(format.name, format.summary);
  return formats;
}

std::map<std::string, Message> optionsText() {
  std::map<std::string, Message> options;
  for (const ExportOptionDescription& option : exportOptions()) options.emplace(inPython(option.name), option.help);
  return options;
}

}  // namespace

void bindExports(py::module_& module) {
  py::class_<PatchOnLink>(module, "PatchOnLink", "Where a patch is on a link of a robot.")
      .def(
          py::init(&placeFrom), py::arg("origin"), py::arg("link"), py::arg("position"), py::arg("rotation"),
          "origin: the patch's origin cell. position (3,), m, and rotation (3, 3) map from the patch's frame into the\n"
          "link's: x_link = rotation @ x_patch + position.")
      .def_readonly("origin", &PatchOnLink::origin, "The patch's origin cell.")
      .def_readonly("link", &PatchOnLink::link, "The link's name in the URDF.")
      .def_property_readonly(
          "position", [](const PatchOnLink& self) { return self.T_l_o.t; }, "(3,), m, in the link's frame.")
      .def_property_readonly(
          "rotation", [](const PatchOnLink& self) { return self.T_l_o.R; },
          "(3, 3): from the patch's frame to the link's.")
      .def("__repr__", [](const PatchOnLink& self) {
        return "<PatchOnLink: patch of cell " + toString(self.origin) + " on " + self.link + ">";
      });
  py::class_<Exported>(module, "Exported", "What an export wrote and read back.")
      .def_readonly("files", &Exported::files, "The paths that were written.")
      .def_readonly("remarks", &Exported::remarks,
                    "In words, the patches that are left out, and what the format can't hold.")
      .def("__repr__",
           [](const Exported& self) { return "<Exported: " + std::to_string(self.files.size()) + " files>"; });

  py::class_<Reconstruction, Calibration> calibration = module.attr("Calibration");
  calibration.def(
      "export", &exportTo, py::arg("to"), py::arg("path"), py::kw_only(), py::arg("patch") = py::none(),
      py::arg("all_patches") = false, py::arg("placements") = std::vector<PatchOnLink>(), py::arg("in_link") = "",
      "Writes it in a form that other software reads; the file is read back and compared byte for byte.\n\n"
      "to: a name of export_formats(); csv, or several, make a folder, or with the ending .zip an archive, with a\n"
      "manifest.json.\n"
      "patch: a cell whose patch is written. all_patches: every patch to a vtp file too.\n"
      "placements: where patches are on links of a robot; without any those that the calibration holds.\n"
      "in_link: coordinates in the frame of this link.\n"
      "Other options are those of export_options().");
  module.def("export_formats", &formatsText, "What Calibration.export() can write: names and a line about each.");
  module.def("export_options", &optionsText, "Options of single formats: names and a line about each.");
}

}  // namespace hexoderm::python
