#include "hexoderm/io/export_manifest.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/io/export_formats.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace hexoderm {
namespace {

using ManifestJson = nlohmann::ordered_json;

/// Names of files and sensors may hold what is not UTF-8.
std::string dumped(const ManifestJson& json) {
  return json.dump(2, ' ', false, ManifestJson::error_handler_t::replace) + "\n";
}

ManifestJson lengthUnitOf(const ExportFormatDescription& format, bool has_lengths, const ExportOptions& options) {
  if (!has_lengths || format.format == ExportFormat::Dot) return nullptr;
  if (format.format == ExportFormat::Stl && options.stl_unit == LengthUnit::Millimetres) return "mm";
  if (format.format == ExportFormat::Skinware) return "nm";
  return "m";
}

std::string coordinatesText(const Reconstruction& reconstruction, const ManifestFile& file) {
  if (!file.selection.mounted.empty()) {
    std::string words;
    for (const ExportMount& mount : file.selection.mounted) {
      words += std::string(words.empty() ? "" : "; ") + "the patch of cell " + toString(mount.patch->origin) +
               (mount.placed ? " placed on link " + mount.link
                             : " joined to link " + mount.link + " without any offset, for its place is not known");
    }
    return words;
  }
  return frameText(reconstruction, file.selection);
}

ManifestJson patchesLeftOutOf(const Reconstruction& reconstruction, const ExportSelection& selection) {
  ManifestJson origins = ManifestJson::array();
  for (const PatchReconstruction& patch : reconstruction.patches) {
    if (!patch.cells.empty() && std::ranges::find(selection.patches, &patch) == selection.patches.end()) {
      origins.push_back(patch.origin.value());
    }
  }
  return origins;
}

ManifestJson fileJson(const Reconstruction& reconstruction, const ManifestFile& file, const ExportOptions& options) {
  if (file.format == nullptr) {
    ManifestJson json = {{"file", file.name}, {"format", file.what}, {"sha256", file.sha256}};
    if (!file.coordinates.empty()) json["coordinates"] = file.coordinates;
    return json;
  }
  const CsvContents contents = file.format->format == ExportFormat::Csv ? csvContents(file.name) : CsvContents();
  ManifestJson json = {{"file", file.name},
                       {"format", file.format->name},
                       {"sha256", file.sha256},
                       {"length_unit", lengthUnitOf(*file.format, contents.lengths, options)}};
  if (contents.in_frame) json["coordinates"] = coordinatesText(reconstruction, file);
  if (!file.format->not_carried.empty()) json["not_carried"] = file.format->not_carried.english();
  json["patches_left_out"] = patchesLeftOutOf(reconstruction, file.selection);
  const auto taxels = [&] { return taxelMap(*reconstruction.model, file.selection.mounted, options); };
  if (file.format->format == ExportFormat::Icub) {
    ManifestJson cells = ManifestJson::array();
    for (const Taxel& taxel : taxels().taxels) cells.push_back(taxel.cell.value());
    json["cell_of_row"] = cells;
  }
  if (file.format->format == ExportFormat::Skinware) json["links"] = taxels().links;
  return json;
}

ManifestJson rowsOf(const Eigen::Matrix3d& R) {
  ManifestJson rows = ManifestJson::array();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index col = 0; col < 3; ++col) rows.push_back(R(row, col));
  }
  return rows;
}

ManifestJson frameJson(const PatchReconstruction& patch, const CellPlacement& in_patch, const ExportOptions& options) {
  const PatchOnLink* place = placementOf(patch, options);
  const CellPlacement cell = place != nullptr ? onLink(in_patch, *place) : in_patch;
  const std::string into = place != nullptr ? "link " + place->link
                                            : "the patch of cell " + toString(patch.origin) + ", in that cell's frame";
  const SE3 T = rigid(cell.T_o_u);
  ManifestJson json = {{"cell", cell.cell.value()},
                       {"frame", place != nullptr ? place->link : "cell " + toString(patch.origin)},
                       {"words", "maps points of cell " + toString(cell.cell) + " into " + into},
                       {"R", rowsOf(T.R)},
                       {"t_m", {T.t.x(), T.t.y(), T.t.z()}}};
  if (cell.cov_t_r) json["cov_t_r"] = upperTriangle(*cell.cov_t_r);
  return json;
}

ManifestJson inputsJson(const Reconstruction& reconstruction, const ExportOptions& options) {
  ManifestJson inputs = ManifestJson::array();
  for (const ExportInput& input : options.inputs) {
    inputs.push_back({{"role", input.role}, {"file", input.file}, {"sha256", input.sha256}});
  }
  if (!reconstruction.source.sha256.empty()) {
    inputs.push_back(
        {{"role", "source"}, {"file", reconstruction.source.file}, {"sha256", reconstruction.source.sha256}});
  }
  return inputs;
}

}  // namespace

std::string manifestText(const Reconstruction& reconstruction, std::span<const ManifestFile> files,
                         const ExportOptions& options) {
  ManifestJson json = {
      {"format", "hexoderm-manifest"},
      {"version", 1},
      {"program", "Hexoderm " HEXODERM_VERSION},
      {"units", {{"length", "m"}, {"angle", "rad"}}},
      {"conventions",
       "x_frame = R x_cell + t_m, R row-major; cov_t_r is the upper triangle of the covariance, position "
       "in the frame, then rotation, its error right-multiplied in the cell's frame; units are those of this document, "
       "and columns of a CSV file end in theirs"}};
  json["cell_model"] = reconstruction.model->name;
  json["inputs"] = inputsJson(reconstruction, options);
  ManifestJson list = ManifestJson::array();
  std::set<const PatchReconstruction*> exported;
  for (const ManifestFile& file : files) {
    list.push_back(fileJson(reconstruction, file, options));
    exported.insert(file.selection.patches.begin(), file.selection.patches.end());
  }
  json["files"] = list;
  ManifestJson frames = ManifestJson::array();
  for (const PatchReconstruction& patch : reconstruction.patches) {
    if (!exported.contains(&patch)) continue;
    for (const CellPlacement& cell : patch.cells) frames.push_back(frameJson(patch, cell, options));
  }
  json["frames"] = frames;
  return dumped(json);
}

}  // namespace hexoderm
