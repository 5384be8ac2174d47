#pragma once

#include "hexoderm/base/ids.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace hexoderm {

/// One cell's accelerometer reading at one moment, along its own axes (CellModel: accelerometer.T_u_a), g.
struct CellSample {
  CellId cell;
  Eigen::Vector3d acceleration_g;
};

/// A mean made by the cell itself, for wires too slow for every sample. Axes as in CellSample.
struct CellMean {
  CellId cell;
  Eigen::Vector3d mean_g;
  Eigen::Vector3d variance_g2;  ///< variance of one sample, not of the mean, per axis
  std::uint32_t count = 0;      ///< samples averaged, at least 1
};

/// A temperature that a cell measured.
struct CellTemperature {
  CellId cell;
  double temperature_c = 0;
};

/// The delivery of a skin at one tick of the device's clock: samples of any subset of its cells.
struct SampleFrame {
  double time_s = 0;                            ///< device time; of the last sample where there are means
  std::vector<CellSample> samples{};            ///< each at time_s
  std::vector<CellMean> means{};                ///< means of the readings since the cell's previous one, up to time_s
  std::vector<CellTemperature> temperatures{};  ///< empty where the device does not measure them
};

}  // namespace hexoderm
