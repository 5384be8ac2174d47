#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

enum class ExportFormat { Csv, Dot, Ply, Stl, Vtp, Urdf };
enum class LengthUnit { Millimetres, Metres };

/// What a format can hold of a skin of several patches. How they lie to each other is not known, so that what has one
/// frame holds one patch.
enum class PatchesInFile {
  One,
  /// Every point names its patch, but programs draw all patches at the same place.
  AllIfAsked,
  All,  ///< rows that name their frame, or a drawing that is no map
};

/// Choices that belong to single formats, which others ignore, and the choice of the patch.
struct ExportOptions {
  LengthUnit stl_unit = LengthUnit::Millimetres;  ///< STL carries no unit of its own
  std::string urdf_robot = "skin";
  std::string urdf_parent_link = "base_link";  ///< created in the file, so that it can be loaded alone
  std::string urdf_prefix = "skin_";           ///< prefix of every link and joint name
  bool urdf_link_per_cell = true;  ///< false: one link per patch, cells as visuals (RViz slows down with many links)
  std::optional<CellId> patch;  ///< the patch that holds this cell, alone; none: as the format has it, or the largest
  bool all_patches = false;     ///< each in its own frame; refused by formats that hold one

  /// Throws InvalidArgument naming the option.
  void validate() const;
};

struct ExportFormatDescription {
  ExportFormat format;
  std::string_view name;       ///< the name on the command line
  std::string_view extension;  ///< with the dot; CSV writes a folder of tables and has none
  Message summary;             ///< one line for help and dialogs
  PatchesInFile patches = PatchesInFile::One;
};
std::span<const ExportFormatDescription> exportFormats();
/// Throws InvalidArgument listing the formats there are.
ExportFormat exportFormatFromName(std::string_view name);

/// A patch that an export leaves out.
struct PatchLeftOut {
  PatchId patch;
  CellId origin;
  std::vector<CellId> cells;
};
/// What exportReconstruction() leaves out with the same arguments. InvalidArgument: the options and the format don't go
/// together, or no patch holds the cell.
std::vector<PatchLeftOut> patchesLeftOut(const Reconstruction& reconstruction, ExportFormat format,
                                         const ExportOptions& options = {});
/// "Not in the file: the patch of cell 20 (1 cell), because ..."; empty if nothing is left out.
Message leftOutInWords(const std::vector<PatchLeftOut>& patches);

/// Writes the reconstruction in one format, reads the file back and compares it with what was meant. Returns the files
/// written (one; for CSV the tables of export_csv.h in the folder `path`).
/// All-or-nothing: a failed comparison throws FormatError and leaves no file, an earlier one stays as it was; storage
/// problems throw StorageError. Links and what is no file are treated as by writeFileAtomically(). InvalidArgument: an
/// option or number makes no sense, or a mesh format (PLY, STL) is asked for without any cells; the other formats then
/// hold none. Of several patches a format holds what patchesLeftOut() does not name.
std::vector<std::filesystem::path> exportReconstruction(const Reconstruction& reconstruction, ExportFormat format,
                                                        const std::filesystem::path& path,
                                                        const ExportOptions& options = {});

/// The bytes of a format that is one file, checked in the same way; `file` is named in errors. InvalidArgument for CSV,
/// which is a folder of files.
std::string exportBytes(const Reconstruction& reconstruction, ExportFormat format, const ExportOptions& options,
                        const std::string& file);

}  // namespace hexoderm
