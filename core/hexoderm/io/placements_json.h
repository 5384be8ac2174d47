#pragma once

#include "hexoderm/skin/patch_on_link.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

inline constexpr const char* kPlacementsFormat = "hexoderm-placements";  ///< what stands under `format`
inline constexpr int kPlacementsVersion = 1;                             ///< what stands under `version`

/// Where patches are on the links of a robot, as JSON (resources/formats/README.md has the keys). Throws
/// InvalidArgument for numbers that are not finite.
std::string placementsToJson(const std::vector<PatchOnLink>& placements);

/// Throw FormatError naming file, key and expectation, readPlacementsJson() also StorageError.
std::vector<PatchOnLink> placementsFromJson(std::string_view text, const std::string& file);
std::vector<PatchOnLink> readPlacementsJson(const std::filesystem::path& path);  ///< the placements of a file

}  // namespace hexoderm
