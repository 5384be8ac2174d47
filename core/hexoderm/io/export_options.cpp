#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/error.h"
#include "hexoderm/io/exporter.h"

#include <optional>

namespace hexoderm {
namespace {

using OptionKind = ExportOptionDescription::Kind;

enum class LinksFor { Cell, Patch };
constexpr EnumNames<LengthUnit> kLengthUnits = {{"mm", "m"}};
constexpr EnumNames<LinksFor> kLinksFor = {{"cell", "patch"}};
constexpr EnumNames<UrdfForm> kForms = {{"alone", "part", "xacro"}};

/// The value of an option with few of them.
template <class Value>
Value valueOf(const EnumNames<Value>& names, const std::string& text, const char* option) {
  if (const std::optional<Value> value = names.find(text)) return *value;
  throw InvalidArgument(option, message("\"{}\" is none of its values", text));
}

}  // namespace

std::span<const ExportOptionDescription> exportOptions() {
  using enum ExportFormat;
  static const std::vector<ExportFormat> with_links = {Urdf, RobotUrdf, TfRos1, TfRos2, TfYaml};
  static const std::vector<ExportOptionDescription> the_options = {
      {"stl-unit",
       message("Unit"),
       message("mm or m; STL itself has no unit"),
       OptionKind::Choice,
       {{"mm", message("Millimetres")}, {"m", message("Metres")}},
       {Stl},
       [](const ExportOptions& o) { return std::string(kLengthUnits.of(o.stl_unit)); },
       [](ExportOptions& o, const std::string& value) { o.stl_unit = valueOf(kLengthUnits, value, "stl-unit"); }},
      {"robot",
       message("URDF of the robot"),
       message("URDF of the robot that gets the skin"),
       OptionKind::File,
       {},
       {RobotUrdf},
       [](const ExportOptions& o) { return o.robot_urdf.string(); },
       [](ExportOptions& o, const std::string& value) { o.robot_urdf = value; }},
      {"model-name",
       message("Name of the model"),
       message("Name of the model"),
       OptionKind::Text,
       {},
       {Urdf, Sdf, Mjcf},
       [](const ExportOptions& o) { return o.model_name; },
       [](ExportOptions& o, const std::string& value) { o.model_name = value; }},
      {"parent",
       message("Parent link"),
       message("Link that a patch is fixed to whose place is not known"),
       OptionKind::Text,
       {},
       {Urdf, RobotUrdf, TfRos1, TfRos2, TfYaml, Tum, Icub, Skinware, Sdf, Mjcf},
       [](const ExportOptions& o) { return o.parent_link; },
       [](ExportOptions& o, const std::string& value) { o.parent_link = value; }},
      {"prefix",
       message("Prefix of names"),
       message("Prefix of the names of links, joints and frames"),
       OptionKind::Text,
       {},
       {Urdf, RobotUrdf, TfRos1, TfRos2, TfYaml, Sdf, Mjcf},
       [](const ExportOptions& o) { return o.prefix; },
       [](ExportOptions& o, const std::string& value) { o.prefix = value; }},
      {"links",
       message("Links"),
       message("One link or frame per cell and sensor, or one per patch"),
       OptionKind::Choice,
       {{"cell", message("One for each cell")}, {"patch", message("One for the patch (lighter in RViz)")}},
       with_links,
       [](const ExportOptions& o) {
         return std::string(kLinksFor.of(o.link_per_cell ? LinksFor::Cell : LinksFor::Patch));
       },
       [](ExportOptions& o, const std::string& value) {
         o.link_per_cell = valueOf(kLinksFor, value, "links") == LinksFor::Cell;
       }},
      {"urdf-form",
       message("Form"),
       message("alone: loads by itself; part: to be included in a robot that has the parent link; xacro: a macro for "
               "each patch"),
       OptionKind::Choice,
       {{"alone", message("Loads by itself")},
        {"part", message("Part of a robot, without the parent link")},
        {"xacro", message("xacro macro for each patch")}},
       {Urdf},
       [](const ExportOptions& o) { return std::string(kForms.of(o.urdf_form)); },
       [](ExportOptions& o, const std::string& value) { o.urdf_form = valueOf(kForms, value, "urdf-form"); }},
  };
  return the_options;
}

}  // namespace hexoderm
