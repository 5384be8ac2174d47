#include "hexoderm/io/exporter.h"

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/base/text.h"
#include "hexoderm/io/export_formats.h"
#include "hexoderm/io/export_selection.h"
#include "hexoderm/io/export_staging.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

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

void requireName(const char* option, const std::string& name) {
  if (!isLinkName(name)) {
    throw InvalidArgument(option, message("expected letters, digits and _ - . /, found \"{}\"", name));
  }
}

/// A file could hold such numbers, but no reader could use them.
void requireFinite(const Reconstruction& reconstruction) {
  const auto require = [](bool finite, CellId cell, const auto& inWords) {
    if (!finite) throw InvalidArgument(message("cell {}: {} is not a finite number, nothing written", cell, inWords()));
  };
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      require(cell.T_o_u.R.allFinite() && cell.T_o_u.t.allFinite(), cell.cell, [] { return message("its placement"); });
      for (const std::optional<Matrix6d>& covariance : {cell.cov_t_r, cell.shape_cov_t_r}) {
        require(!covariance || covariance->allFinite(), cell.cell, [] { return message("its covariance"); });
      }
      require((!cell.accel_offset_g || cell.accel_offset_g->allFinite()) &&
                  (!cell.accel_scale || cell.accel_scale->allFinite()),
              cell.cell, [] { return message("its accelerometer's offset or scale"); });
      for (const SensorPlacement& sensor : cell.sensors) {
        require(sensor.T_o_s.R.allFinite() && sensor.T_o_s.t.allFinite(), cell.cell,
                [&] { return message("the placement of its sensor {}", sensor.name); });
      }
    }
  }
  for (const FlatCell& cell : reconstruction.layout.cells) {
    require(cell.center.allFinite(), cell.cell, [] { return message("its place in the layout"); });
  }
}

/// There are cells, and a mesh, whose numbers are in single precision, can hold where they are.
void requireMesh(const Reconstruction& reconstruction, std::string_view format) {
  if (reconstruction.cellCount() == 0) {
    throw InvalidArgument(message(
        "there are no cells, and so nothing to draw in a {} file: export csv, dot, vtp or urdf instead", format));
  }
  // In millimetres, and with what is around it.
  constexpr double kFarthest_m = static_cast<double>(std::numeric_limits<float>::max()) / 1e4;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      bool is_held = isWithin(cell.T_o_u.t, kFarthest_m);
      for (const SensorPlacement& sensor : cell.sensors) is_held = is_held && isWithin(sensor.T_o_s.t, kFarthest_m);
      if (is_held) continue;
      throw InvalidArgument(
          message("cell {}: the single precision of a {} file can't hold how far away it is", cell.cell, format));
    }
  }
}

/// The bytes of a format that is one file.
std::string bytesOf(const Reconstruction& reconstruction, const ExportSelection& selection, ExportFormat format,
                    const ExportOptions& options) {
  const auto tree = [&] { return skinTree(*reconstruction.model, selection.mounted, reconstruction, options); };
  const auto frames = [&] { return skinFrames(tree(), options.link_per_cell); };
  const auto taxels = [&] { return taxelMap(*reconstruction.model, selection.mounted, options); };
  switch (format) {
    case ExportFormat::Csv:
      break;
    case ExportFormat::Dot:
      return dotText(reconstruction);
    case ExportFormat::Ply:
      requireMesh(reconstruction, "PLY");
      return plyText(reconstruction, selection);
    case ExportFormat::Stl:
      requireMesh(reconstruction, "STL");
      return stlBytes(reconstruction, options.stl_unit);
    case ExportFormat::Vtp:
      return vtpBytes(vtpData(reconstruction, selection));
    case ExportFormat::Urdf:
      return urdfBytes({tree(), options.link_per_cell, options.urdf_form});
    case ExportFormat::RobotUrdf:
      return robotUrdfBytes(readRobotUrdf(options.robot_urdf), {tree(), options.link_per_cell, UrdfForm::Part});
    case ExportFormat::TfRos1:
      return rosLaunchText(frames());
    case ExportFormat::TfRos2:
      return ros2LaunchText(frames());
    case ExportFormat::TfYaml:
      return transformsYaml(frames());
    case ExportFormat::Tum:
      return tumBytes(reconstruction, options);
    case ExportFormat::Icub:
      return icubText(taxels());
    case ExportFormat::Skinware:
      return skinwareText(taxels());
    case ExportFormat::Obj:
      requireMesh(reconstruction, "OBJ");
      return objText(reconstruction, selection);
    case ExportFormat::Gltf:
      requireMesh(reconstruction, "glTF");
      return gltfBytes(reconstruction, frameText(reconstruction, selection));
    case ExportFormat::Sdf:
      return sdfBytes(tree());
    case ExportFormat::Mjcf:
      return mjcfBytes(tree());
  }
  return {};
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

void ExportOptions::validate() const {
  requireName("model_name", model_name);
  requireName("parent_link", parent_link);
  if (!prefix.empty()) requireName("prefix", prefix);
  if (!in_link.empty()) requireName("in_link", in_link);
  if (patch && all_patches) throw InvalidArgument(message("all_patches: patch asks for one of them"));
  std::set<CellId> origins;
  for (const PatchOnLink& place : placements) {
    requireName("placements", place.link);
    if (!place.T_l_o.R.allFinite() || !place.T_l_o.t.allFinite() || (place.cov_t_r && !place.cov_t_r->allFinite())) {
      throw InvalidArgument("placements", message("expected finite numbers for the patch of cell {}", place.origin));
    }
    if (!origins.insert(place.origin).second) {
      throw InvalidArgument("placements", message("the patch of cell {} is placed twice", place.origin));
    }
  }
}

void ExportOptions::validateFor(ExportFormat format) const {
  validate();
  if (format == ExportFormat::RobotUrdf && robot_urdf.empty()) {
    throw InvalidArgument("robot", message("expected the URDF of the robot that gets the skin"));
  }
}

std::span<const ExportFormatDescription> exportFormats() {
  // Built at its first use, for a message is no constant expression.
  static const std::vector<ExportFormatDescription> the_formats = {
      {ExportFormat::Csv,
       "csv",
       "",
       message("folder of tables: cells, sensors, links, poses, residuals, covariances"),
       PatchesInFile::All,
       {}},
      {ExportFormat::Dot, "dot", ".dot", message("skin graph for Graphviz, with ports and quality"), PatchesInFile::All,
       message("A DOT file is a flat drawing without places and uncertainties.")},
      {ExportFormat::Ply, "ply", ".ply", message("mesh of the cells in metres, coloured by quality"),
       PatchesInFile::One, message("A PLY file holds no sensors and no uncertainties.")},
      {ExportFormat::Stl, "stl", ".stl", message("mesh of the cells for CAD, in millimetres or metres"),
       PatchesInFile::One, message("An STL file holds no IDs, colours, sensors and uncertainties.")},
      {ExportFormat::Vtp, "vtp", ".vtp",
       message("everything about the cells and sensors for ParaView and VTK, lossless"), PatchesInFile::AllIfAsked,
       message("A VTP file holds no links between cells.")},
      {ExportFormat::Urdf, "urdf", ".urdf", message("links for every cell and sensor, or one for the patch, for ROS"),
       PatchesInFile::OnLinks, message("A URDF holds no uncertainties.")},
      {ExportFormat::RobotUrdf, "robot-urdf", ".robot.urdf",
       message("the robot's own URDF, unchanged, with the skin on its links"), PatchesInFile::OnLinks,
       message("A URDF holds no uncertainties.")},
      {ExportFormat::TfRos1, "tf-ros1", ".launch", message("static transforms of all frames, a ROS 1 launch file"),
       PatchesInFile::OnLinks, message("Static transforms hold no shapes and no uncertainties.")},
      {ExportFormat::TfRos2, "tf-ros2", ".launch.py", message("static transforms of all frames, a ROS 2 launch file"),
       PatchesInFile::OnLinks, message("Static transforms hold no shapes and no uncertainties.")},
      {ExportFormat::TfYaml, "tf-yaml", ".tf.yaml",
       message("static transforms of all frames, TransformStamped in YAML"), PatchesInFile::OnLinks,
       message("Static transforms hold no shapes and no uncertainties.")},
      {ExportFormat::Tum, "tum", ".tum.xml", message("SkinConfig of the TUM skin's own software"), PatchesInFile::All,
       message("A SkinConfig holds no sensors, no uncertainties, and not the port of the computer.")},
      {ExportFormat::Icub, "icub", ".icub.txt", message("taxel positions as iCub reads them, a taxel for each cell"),
       PatchesInFile::OnALink,
       message("Taxel positions are centres and normals of the cells, without IDs, turns about the normal and "
               "uncertainties.")},
      {ExportFormat::Skinware, "skinware", ".skinware.txt", message("map of the cells for Skinware (CySkin)"),
       PatchesInFile::OnLinks,
       message("A Skinware map holds centres and normals of the cells, without turns about the normal and "
               "uncertainties.")},
      {ExportFormat::Obj, "obj", ".obj", message("mesh of the cells in metres, an object for each cell"),
       PatchesInFile::One, message("An OBJ file holds no sensors and no uncertainties.")},
      {ExportFormat::Gltf, "gltf", ".glb", message("scene with a node for each cell and sensor (glTF 2.0)"),
       PatchesInFile::One, message("A glTF scene holds no uncertainties.")},
      {ExportFormat::Sdf, "sdf", ".sdf", message("model for Gazebo, with a frame for each cell and sensor"),
       PatchesInFile::OnALink,
       message("An SDF model holds no uncertainties; the skin's mass is not known, and 1 g stands for it.")},
      {ExportFormat::Mjcf, "mjcf", ".mjcf.xml", message("model for MuJoCo, with a site for each sensor"),
       PatchesInFile::OnALink, message("An MJCF model holds no uncertainties and no mass of the skin.")},
  };
  return the_formats;
}

const ExportFormatDescription& exportFormatDescription(ExportFormat format) {
  return *std::ranges::find(exportFormats(), format, &ExportFormatDescription::format);
}

ExportFormat exportFormatFromName(std::string_view name) {
  const std::span<const ExportFormatDescription> formats = exportFormats();
  const auto found = std::ranges::find(formats, name, &ExportFormatDescription::name);
  if (found != formats.end()) return found->format;
  throw InvalidArgument(message("export format \"{}\" is not known, expected one of {}", name,
                                inARow(formats, &ExportFormatDescription::name)));
}

std::string inWords(const std::vector<ExportFormat>& formats) {
  return inARow(formats, [](ExportFormat format) { return exportFormatDescription(format).name; });
}

std::vector<PatchLeftOut> patchesLeftOut(const Reconstruction& reconstruction, ExportFormat format,
                                         const ExportOptions& options) {
  options.validate();
  const ExportSelection selection = selectForExport(reconstruction, exportFormatDescription(format), options);
  const std::set<const PatchReconstruction*> exported(selection.patches.begin(), selection.patches.end());
  const bool on_links = !selection.frame_link.empty() ||
                        std::ranges::any_of(selection.mounted, [](const ExportMount& mount) { return mount.placed; });
  std::vector<PatchLeftOut> left_out;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    if (exported.contains(&patch) || patch.cells.empty()) continue;
    PatchLeftOut& added = left_out.emplace_back(PatchLeftOut{patch.id, patch.origin, {}, on_links});
    for (const CellPlacement& cell : patch.cells) added.cells.push_back(cell.cell);
  }
  return left_out;
}

Message leftOutText(const std::vector<PatchLeftOut>& patches) {
  if (patches.empty()) return {};
  constexpr std::size_t kNamed = 6;
  std::vector<CellId> origins;
  std::size_t count = 0;
  for (const PatchLeftOut& patch : patches) {
    origins.push_back(patch.origin);
    count += patch.cells.size();
  }
  const Message cells = count == 1 ? message("1 cell") : message("{} cells", count);
  if (patches.front().not_on_link) {
    if (patches.size() == 1) {
      return message(
          "Not in the file: the patch of cell {} ({}), because it is not placed on a link that the file holds.",
          origins.front(), cells);
    }
    return message("Not in the file: {} patches ({}), because they are not placed on a link that the file holds.",
                   patches.size(), cells);
  }
  if (patches.size() == 1) {
    return message(
        "Not in the file: the patch of cell {} ({}), because how it lies to the exported patch is not known.",
        origins.front(), cells);
  }
  if (patches.size() <= kNamed) {
    return message(
        "Not in the file: the patches of cells {} ({}), because how they lie to the exported patch is not known.",
        origins, cells);
  }
  return message("Not in the file: {} patches ({}), because how they lie to the exported patch is not known.",
                 patches.size(), cells);
}

std::vector<std::filesystem::path> exportReconstruction(const Reconstruction& reconstruction, ExportFormat format,
                                                        const std::filesystem::path& path,
                                                        const ExportOptions& options) {
  options.validateFor(format);
  if (path.empty()) throw InvalidArgument(message("expected the name of a file or folder to export to"));
  if (format == ExportFormat::Csv) return exportBundle(reconstruction, std::array{format}, path, options);
  const KeptFile robot(options.robot_urdf);
  writeFileAtomically(path, exportBytes(reconstruction, format, options));
  return {path};
}

FormatFiles formatFiles(const Reconstruction& reconstruction, ExportFormat format, const ExportOptions& options,
                        const std::string& stem) {
  const ExportFormatDescription& description = exportFormatDescription(format);
  FormatFiles made{{}, selectForExport(reconstruction, description, options)};
  const ExportSelection& selection = made.selection;
  std::optional<Reconstruction> selected;
  if (selection.patches.size() != reconstruction.patches.size() || !selection.frame_link.empty()) {
    selected = exportedPart(reconstruction, selection, options);
  }
  const Reconstruction& part = selected ? *selected : reconstruction;
  requireFinite(part);
  if (format == ExportFormat::Csv) {
    for (const CsvTable& table : csvTables(part)) made.files.push_back({table.file, csvText(table)});
  } else {
    const std::string name = stem + std::string(description.extension);
    made.files.push_back({name, bytesOf(part, selection, format, options)});
  }
  return made;
}

std::string exportBytes(const Reconstruction& reconstruction, ExportFormat format, const ExportOptions& options) {
  options.validateFor(format);
  if (format == ExportFormat::Csv) {
    throw InvalidArgument(message("csv is a folder of several files and can't be written as one: give a folder"));
  }
  return std::move(formatFiles(reconstruction, format, options, "").files.front().content);
}

}  // namespace hexoderm
