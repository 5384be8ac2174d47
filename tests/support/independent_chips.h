#pragma once

#include "hexoderm/skin/cell_model.h"

namespace hexoderm {

/// The built-in cell model with chips that have nothing in common and sit straight in their cells.
inline CellModel independentChips(double offset_sigma_mg = 60) {
  CellModel model = builtInCellModel("hex-bma150");
  model.accelerometer.offset_sigma_g.setConstant(offset_sigma_mg / 1000);
  model.accelerometer.offset_shared_sigma_g = 0;
  model.accelerometer.scale_shared_sigma = 0;
  model.mounting_sigma_rad = 0;
  return model;
}

}  // namespace hexoderm
