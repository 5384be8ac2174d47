#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace hexoderm {

/// TUM SkinConfig XML: what a skin configuration of the closest tool holds.
struct TumSkinConfig {
  /// A cell of a SkinConfig.
  struct Cell {
    CellReport report;  ///< ID and neighbours; the file names no port of the other side
    std::uint32_t patch = 0;
    std::uint32_t segment = 0;
    CellId root;  ///< the cell in whose frame it is placed
    SE3 T_root_u;
  };
  std::vector<Cell> cells;
  std::string sha256;  ///< of the file's bytes
};

/// Throws StorageError, or FormatError naming the file, the element and what was expected. Positions are at most 1000 m
/// along each axis.
TumSkinConfig readTumXml(const std::filesystem::path& path);
/// The same of a text; `file` is named in errors.
TumSkinConfig parseTumXml(std::string_view text, const std::string& file);

/// The topology alone, as a session without poses.
Session sessionFromTum(const TumSkinConfig& config, const CellModel& model, const std::string& file);

/// The placements as a calibration with `solver` "imported": links carry the rotations that follow from the
/// placements, findings name links whose bend, twist or yaw no skin link has. A patch's origin is its root cell if that
/// lies in it, else its smallest ID; links between cells placed in frames of different root cells are muted.
std::shared_ptr<const Reconstruction> calibrationFromTum(const TumSkinConfig& config, const CellModel& model,
                                                         const std::string& file);

}  // namespace hexoderm
