#pragma once

#include "hexoderm/util/ids.h"

#include <Eigen/Core>
#include <vector>

namespace hexoderm {

/// What one cell's accelerometer read at one moment, along its own axes (CellModel: accelerometer.T_u_a), g.
struct CellSample {
  CellId cell;
  Eigen::Vector3d acceleration_g;
};

/// What a skin delivers at one tick of the device's clock: samples of any subset of its cells.
struct SampleFrame {
  double time_s = 0;  ///< device time
  std::vector<CellSample> samples;
};

}  // namespace hexoderm
