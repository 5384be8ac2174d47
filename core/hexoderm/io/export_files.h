#pragma once

#include "hexoderm/io/export_selection.h"
#include "hexoderm/io/export_staging.h"

#include <string>
#include <vector>

namespace hexoderm {

/// The files of one format: one, or for CSV several.
struct FormatFiles {
  std::vector<StagedFile> files;
  ExportSelection selection;  ///< of the reconstruction
};

/// `stem`: the name of a format that is one file, without its extension. Throws as exportReconstruction().
FormatFiles formatFiles(const Reconstruction& reconstruction, ExportFormat format, const ExportOptions& options,
                        const std::string& stem);

}  // namespace hexoderm
