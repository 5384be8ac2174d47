#include "hexoderm/io/exporter.h"

#include "hexoderm/io/export_csv.h"
#include "hexoderm/io/export_dot.h"
#include "hexoderm/io/export_ply.h"
#include "hexoderm/io/export_staging.h"
#include "hexoderm/io/export_stl.h"
#include "hexoderm/io/export_urdf.h"
#include "hexoderm/io/export_vtp.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hexoderm {
namespace {

/// Built at its first use, for a message is no constant expression.
const std::array<ExportFormatDescription, 6>& formats() {
  static const std::array<ExportFormatDescription, 6> the_formats = {{
      {ExportFormat::Csv, "csv", "", message("folder of tables: cells, sensors, links, poses, residuals"),
       PatchesInFile::All},
      {ExportFormat::Dot, "dot", ".dot", message("skin graph for Graphviz, with ports and quality"),
       PatchesInFile::All},
      {ExportFormat::Ply, "ply", ".ply", message("mesh of the cells in metres, coloured by quality"),
       PatchesInFile::One},
      {ExportFormat::Stl, "stl", ".stl", message("mesh of the cells for CAD, in millimetres or metres"),
       PatchesInFile::One},
      {ExportFormat::Vtp, "vtp", ".vtp",
       message("everything about the cells and sensors for ParaView and VTK, lossless"), PatchesInFile::AllIfAsked},
      {ExportFormat::Urdf, "urdf", ".urdf", message("links for every cell and sensor, or one for the patch, for ROS"),
       PatchesInFile::One},
  }};
  return the_formats;
}

const ExportFormatDescription& descriptionOf(ExportFormat format) {
  return *std::ranges::find(formats(), format, &ExportFormatDescription::format);
}

/// The patch that is alone in the file; null: all of them are in it.
const PatchReconstruction* onlyPatch(const Reconstruction& reconstruction, ExportFormat format,
                                     const ExportOptions& options) {
  const ExportFormatDescription& description = descriptionOf(format);
  if (options.all_patches && description.patches == PatchesInFile::One) {
    throw InvalidArgument(located(
        "all_patches", message("{} has one frame, and how the patches lie to each other is not known: write each to a "
                               "file of its own",
                               description.name)));
  }
  if (options.patch) {
    const PatchReconstruction* patch = reconstruction.find(*options.patch).patch;
    if (patch == nullptr) throw InvalidArgument(located("patch", message("no patch holds a cell {}", *options.patch)));
    return patch;
  }
  const bool holds_all = options.all_patches || description.patches == PatchesInFile::All;
  return holds_all ? nullptr : largestPatch(reconstruction);
}

/// The reconstruction with one of its patches. Its links to cells of other patches stay.
Reconstruction partOf(const Reconstruction& reconstruction, const PatchReconstruction& patch) {
  Reconstruction part = reconstruction;
  part.patches = {patch};
  std::erase_if(part.layout.cells, [&](const FlatCell& cell) { return patch.findCell(cell.cell) == nullptr; });
  std::erase_if(part.layout.links, [&](const FlatLink& link) { return link.patch != patch.id; });
  return part;
}

/// Calls `use` with what is to be in the file.
template <class Use>
auto withExported(const Reconstruction& reconstruction, ExportFormat format, const ExportOptions& options, Use use) {
  const PatchReconstruction* only = onlyPatch(reconstruction, format, options);
  if (only == nullptr || reconstruction.patches.size() == 1) return use(reconstruction);
  return use(partOf(reconstruction, *only));
}

void requireName(const char* option, const std::string& name) {
  if (!isUrdfName(name)) {
    throw InvalidArgument(located(option, message("expected letters, digits and _ - . /, found \"{}\"", name)));
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

void requireCells(const Reconstruction& reconstruction, std::string_view format) {
  if (reconstruction.cellCount() == 0) {
    throw InvalidArgument(message(
        "there are no cells, and so nothing to draw in a {} file: export csv, dot, vtp or urdf instead", format));
  }
}

std::vector<std::filesystem::path> exportCsv(const Reconstruction& reconstruction, const std::filesystem::path& path) {
  std::vector<StagedFile> files;
  for (const CsvTable& table : csvTables(reconstruction)) {
    files.push_back({table.file, csvText(table), [table](const std::string& bytes) { verifyCsv(bytes, table); }});
  }
  return publishFolder(path, files);
}

/// The bytes of a file, and what checks them.
struct ExportedFile {
  std::string bytes;
  VerifyBytes verify;
};

ExportedFile exportedFile(const Reconstruction& reconstruction, ExportFormat format, const ExportOptions& options,
                          const std::string& file) {
  const auto exported = [&file](auto content, std::string bytes, auto verify) {
    return ExportedFile{std::move(bytes), [content = std::move(content), file, verify](const std::string& found) {
                          verify(found, content, file);
                        }};
  };
  switch (format) {
    case ExportFormat::Csv:
      break;
    case ExportFormat::Dot: {
      DotGraph graph = dotGraph(reconstruction);
      std::string bytes = dotText(graph);
      return exported(std::move(graph), std::move(bytes), verifyDot);
    }
    case ExportFormat::Ply: {
      requireCells(reconstruction, "PLY");
      ExportMesh mesh = plyMesh(reconstruction);
      std::string bytes = plyBytes(mesh, file);
      return exported(std::move(mesh), std::move(bytes), verifyPly);
    }
    case ExportFormat::Stl: {
      requireCells(reconstruction, "STL");
      ExportMesh mesh = stlMesh(reconstruction, options.stl_unit);
      std::string bytes = stlBytes(mesh, file);
      return exported(std::move(mesh), std::move(bytes), verifyStl);
    }
    case ExportFormat::Vtp: {
      VtpData data = vtpData(reconstruction);
      std::string bytes = vtpBytes(data);
      return exported(std::move(data), std::move(bytes), verifyVtp);
    }
    case ExportFormat::Urdf: {
      UrdfModel model = urdfModel(reconstruction, options);
      std::string bytes = urdfBytes(model);
      return exported(std::move(model), std::move(bytes), verifyUrdf);
    }
  }
  throw InvalidArgument(message("csv is a folder of several files and can't be written as one: give a folder"));
}

}  // namespace

void ExportOptions::validate() const {
  requireName("urdf_robot", urdf_robot);
  requireName("urdf_parent_link", urdf_parent_link);
  if (!urdf_prefix.empty()) requireName("urdf_prefix", urdf_prefix);
  if (patch && all_patches) throw InvalidArgument(message("all_patches: patch asks for one of them"));
}

std::span<const ExportFormatDescription> exportFormats() { return formats(); }

ExportFormat exportFormatFromName(std::string_view name) {
  const auto* const found = std::ranges::find(formats(), name, &ExportFormatDescription::name);
  if (found != formats().end()) return found->format;
  std::string names;
  for (const ExportFormatDescription& format : formats()) {
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  }
  throw InvalidArgument(message("export format \"{}\" is not known, expected one of {}", name, names));
}

std::vector<PatchLeftOut> patchesLeftOut(const Reconstruction& reconstruction, ExportFormat format,
                                         const ExportOptions& options) {
  options.validate();
  const PatchReconstruction* only = onlyPatch(reconstruction, format, options);
  std::vector<PatchLeftOut> left_out;
  if (only == nullptr) return left_out;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    if (&patch == only || patch.cells.empty()) continue;
    PatchLeftOut& added = left_out.emplace_back(PatchLeftOut{patch.id, patch.origin, {}});
    for (const CellPlacement& cell : patch.cells) added.cells.push_back(cell.cell);
  }
  return left_out;
}

Message leftOutInWords(const std::vector<PatchLeftOut>& patches) {
  if (patches.empty()) return {};
  constexpr std::size_t kNamed = 6;
  std::vector<CellId> origins;
  std::size_t count = 0;
  for (const PatchLeftOut& patch : patches) {
    origins.push_back(patch.origin);
    count += patch.cells.size();
  }
  const Message cells = count == 1 ? message("1 cell") : message("{} cells", count);
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
  options.validate();
  if (path.empty()) throw InvalidArgument(message("expected the name of a file or folder to export to"));
  return withExported(reconstruction, format, options,
                      [&](const Reconstruction& exported) -> std::vector<std::filesystem::path> {
                        requireFinite(exported);
                        if (format == ExportFormat::Csv) return exportCsv(exported, path);
                        const ExportedFile file = exportedFile(exported, format, options, path.string());
                        writeFileAtomically(path, file.bytes, file.verify);
                        return {path};
                      });
}

std::string exportBytes(const Reconstruction& reconstruction, ExportFormat format, const ExportOptions& options,
                        const std::string& file) {
  options.validate();
  return withExported(reconstruction, format, options, [&](const Reconstruction& part) {
    requireFinite(part);
    ExportedFile exported = exportedFile(part, format, options, file);
    exported.verify(exported.bytes);
    return std::move(exported.bytes);
  });
}

}  // namespace hexoderm
