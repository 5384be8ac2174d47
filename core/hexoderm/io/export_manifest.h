#pragma once

#include "hexoderm/io/export_selection.h"

#include <span>
#include <string>

namespace hexoderm {

/// A file of a bundle.
struct ManifestFile {
  std::string name;
  std::string sha256;
  const ExportFormatDescription* format = nullptr;  ///< null: none of the export formats
  ExportSelection selection;
  // Where there is no format.
  std::string what{};
  std::string coordinates{};  ///< in words; empty: it has none
};

/// manifest.json of a bundle: version of the program, units, inputs and files with their SHA-256, what each file does
/// not hold, and for every cell in words and numbers into which frame its placement maps, with its covariance.
std::string manifestText(const Reconstruction& reconstruction, std::span<const ManifestFile> files,
                         const ExportOptions& options);

inline constexpr const char* kManifestFile = "manifest.json";

}  // namespace hexoderm
