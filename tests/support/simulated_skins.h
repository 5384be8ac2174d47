#pragma once

#include "hexoderm/sim/simulated_session.h"

#include <cmath>
#include <string>

namespace hexoderm::test {

/// Options of a simulated skin, the others as by default.
inline SimulatedSkinOptions skinOptions(const std::string& patch, const std::string& surface = "",
                                        std::uint64_t seed = 1) {
  SimulatedSkinOptions options;
  options.patch = patch;
  options.surface = surface;
  options.seed = seed;
  return options;
}

/// A sheet bent round a cylinder of a size that goes with it.
inline SimulatedSkinOptions bentSheet(std::size_t rows, std::size_t columns, std::uint64_t seed = 1) {
  const double share = std::sqrt(static_cast<double>(rows * columns) / 1260);
  return skinOptions("sheet:" + std::to_string(rows) + "x" + std::to_string(columns),
                     "cylinder:r=" + std::to_string(0.25 * share), seed);
}

/// Options of a skin on a robot with its motors on.
inline SimulatedSkinOptions robotOptions(const std::string& patch, const std::string& surface, std::uint64_t seed = 1) {
  SimulatedSkinOptions options = SimulatedSkinOptions::robot();
  options.patch = patch;
  options.surface = surface;
  options.seed = seed;
  return options;
}

/// A simulated skin of the built-in cell model.
inline SimulatedSkin simulatedSkin(const SimulatedSkinOptions& options = {}) {
  return {builtInCellModel("hex-bma150"), options};
}

/// A scripted calibration of it: so many poses, each the mean of so many readings.
inline Session simulatedSession(const SimulatedSkinOptions& options, std::size_t poses, std::size_t readings = 100) {
  SimulatedSkin skin = simulatedSkin(options);
  return simulateSession(skin, poses, readings);
}

/// Where a cell is in truth.
inline const SE3& truePlacement(const SimulatedSkin& skin, CellId cell) { return skin.truth()[cell.value() - 1].T_b_u; }

}  // namespace hexoderm::test
