#pragma once

// The two ways to read a calibration file.

#include "hexoderm/solve/result/reconstruction.h"

#include <memory>
#include <string>
#include <string_view>

namespace hexoderm {

/// The quick one, which makes no document of cells and links: for files that are as they usually are. Null for any
/// other, be it right or wrong. What it reads, calibrationFromDocument() reads as the same result, to the last bit.
std::shared_ptr<const Reconstruction> scanCalibrationJson(std::string_view text, const std::string& file);

/// The thorough one, which throws FormatError with what is wrong and where.
std::shared_ptr<const Reconstruction> calibrationFromDocument(std::string_view text, const std::string& file);

}  // namespace hexoderm
