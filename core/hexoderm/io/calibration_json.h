#pragma once

#include "hexoderm/base/file.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace hexoderm {

/// What stands under `format` and `version`; resources/formats/README.md says when the version grows.
inline constexpr std::string_view kCalibrationFormat = "hexoderm-calibration";
inline constexpr std::uint32_t kCalibrationVersion = 2;  ///< the newest version, which is written

/// `*.calibration.json` (its keys are in resources/formats/README.md): complete enough to export, evaluate and draw
/// from it alone. Throws as for sessions: StorageError, or FormatError naming file, key path and expectation.
std::shared_ptr<const Reconstruction> readCalibrationJson(const std::filesystem::path& path);
/// The same of a text; `file` is named in errors.
std::shared_ptr<const Reconstruction> parseCalibrationJson(std::string_view text, const std::string& file);

/// The text, in pieces; as a whole; and as a file, atomically, which throws StorageError. Numbers that are not finite
/// are InvalidArgument.
void writeCalibrationJson(const Reconstruction& reconstruction, const WriteBytes& write);
std::string calibrationToJson(const Reconstruction& reconstruction);  ///< the text as a whole
/// The text as a file, atomically.
void writeCalibrationJson(const Reconstruction& reconstruction, const std::filesystem::path& path);

}  // namespace hexoderm
