#pragma once

// Private to io and its tests: the two ways to read a calibration file, and what they have in common.

#include "hexoderm/reconstruction/result/reconstruction.h"
#include "hexoderm/util/json_reader.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// The quick one, which makes no document of cells and links: for files that are as they usually are. Null for any
/// other, be it right or wrong. What it reads, calibrationFromDocument() reads as the same result, to the last bit.
std::shared_ptr<const Reconstruction> scanCalibrationJson(std::string_view text, const std::string& file);

/// The thorough one, which throws FormatError with what is wrong and where.
std::shared_ptr<const Reconstruction> calibrationFromDocument(std::string_view text, const std::string& file);

/// From the format to the cell model.
void readCalibrationHead(const JsonReader& json, Reconstruction& result);
/// The table of poses, for patches that are there.
std::vector<PoseSummary> readPoseTable(const JsonReader& json, const std::vector<PatchReconstruction>& patches);
/// From the findings to the placements, and the layout.
void readCalibrationTail(const JsonReader& json, Reconstruction& result);
std::optional<GapShareEstimate> readGapShare(const JsonReader& json);
GravityDirection readGravity(const JsonReader& json);
/// A cell that has a predecessor, but whose predecessors don't lead to the origin, or that is the origin.
std::optional<std::size_t> cellWithoutWay(const PatchReconstruction& patch);

}  // namespace hexoderm
