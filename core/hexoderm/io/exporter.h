#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

enum class ExportFormat { Csv, Dot, Ply, Stl, Vtp, Urdf };
enum class LengthUnit { Millimetres, Metres };

/// Choices that belong to single formats; others ignore them.
struct ExportOptions {
  LengthUnit stl_unit = LengthUnit::Millimetres;  ///< STL carries no unit of its own
  std::string urdf_robot = "skin";
  std::string urdf_parent_link = "base_link";  ///< created in the file, so that it can be loaded alone
  std::string urdf_prefix = "skin_";           ///< prefix of every link and joint name
  bool urdf_link_per_cell = true;  ///< false: one link per patch, cells as visuals (RViz slows down with many links)

  /// Throws InvalidArgument naming the option.
  void validate() const;
};

struct ExportFormatDescription {
  ExportFormat format;
  std::string_view name;       ///< the name on the command line
  std::string_view extension;  ///< with the dot; CSV writes a folder of tables and has none
  Message summary;             ///< one line for help and dialogs
};
std::span<const ExportFormatDescription> exportFormats();
/// Throws InvalidArgument listing the formats there are.
ExportFormat exportFormatFromName(std::string_view name);

/// Writes the reconstruction in one format, reads the file back and compares it with what was meant. Returns the files
/// written (one; for CSV the tables of export_csv.h in the folder `path`).
/// All-or-nothing: a failed comparison throws FormatError and leaves no file, an earlier one stays as it was; storage
/// problems throw StorageError. Links and what is no file are treated as by writeFileAtomically(). InvalidArgument: an
/// option or number makes no sense, or a mesh format (PLY, STL) is asked for without any cells; the other formats then
/// hold none.
std::vector<std::filesystem::path> exportReconstruction(const Reconstruction& reconstruction, ExportFormat format,
                                                        const std::filesystem::path& path,
                                                        const ExportOptions& options = {});

/// The bytes of a format that is one file, checked in the same way; `file` is named in errors. InvalidArgument for CSV,
/// which is a folder of files.
std::string exportBytes(const Reconstruction& reconstruction, ExportFormat format, const ExportOptions& options,
                        const std::string& file);

}  // namespace hexoderm
