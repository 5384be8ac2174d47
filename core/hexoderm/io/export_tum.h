#pragma once

#include "hexoderm/io/exporter.h"

#include <string>

namespace hexoderm {

/// TUM SkinConfig XML: every patch with its cells in the frame of its origin (the root cell), their neighbours at each
/// port, and a patchExtrinsics element with where the root cell is in the link it is placed on. Metres, 12 decimals.
std::string tumBytes(const Reconstruction& reconstruction, const ExportOptions& options);

}  // namespace hexoderm
