#pragma once

#include "hexoderm/skin/cell_model.h"

#include <Eigen/Core>

namespace hexoderm {

inline const CellModel kModel = builtInCellModel("hex-bma150");
inline const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();

}  // namespace hexoderm
