#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace hexoderm {

/// `*.calibration.json` (its keys are in README.md in this folder): complete enough to export, evaluate and draw from
/// it alone. Throws as for sessions: StorageError, or FormatError naming file, key path and expectation.
std::shared_ptr<const Reconstruction> readCalibrationJson(const std::filesystem::path& path);
std::shared_ptr<const Reconstruction> parseCalibrationJson(std::string_view text, const std::string& file);

std::string calibrationToJson(const Reconstruction& reconstruction);
/// Atomic. Throws StorageError.
void writeCalibrationJson(const Reconstruction& reconstruction, const std::filesystem::path& path);

}  // namespace hexoderm
