#pragma once

#include "hexoderm/io/export_selection.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hexoderm {

struct StagedFile {
  std::string name;  ///< without folders
  std::string content;
};

/// Writes the files of a folder, all or none: into a temporary folder beside or in it, where each is read back and
/// compared byte for byte, and only then renamed to their places. On any failure the earlier files stay as they were
/// and nothing else is left; the rights of files that are replaced stay. A missing folder is made; other files in an
/// existing one are not touched. Whatever has the name of one of the files and is no file, a link included, is refused.
/// Returns the paths of the files, in their order. Throws StorageError.
/// `before_each` is called before every file is written and before the names are given; what it throws ends the work in
/// the same way.
std::vector<std::filesystem::path> publishFolder(const std::filesystem::path& folder,
                                                 const std::vector<StagedFile>& files,
                                                 const std::function<void()>& before_each = {});

/// The files of one format: one, or for CSV several.
struct FormatFiles {
  std::vector<StagedFile> files;
  ExportSelection selection;  ///< of the reconstruction
};

/// `stem`: the name of a format that is one file, without its extension. Throws as exportReconstruction().
FormatFiles formatFiles(const Reconstruction& reconstruction, ExportFormat format, const ExportOptions& options,
                        const std::string& stem);

}  // namespace hexoderm
