#pragma once

// What kernels take and give: a column for each lane, stored row by row.

#include "hexoderm/geometry/lanes.h"

#include <Eigen/Core>

namespace hexoderm {

using Lanes = Eigen::Matrix<double, Eigen::Dynamic, kLanes, Eigen::RowMajor>;
using MatrixByRows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// A matrix as a column, row by row.
inline Eigen::Matrix<double, 9, 1> columnOf(const MatrixByRows& R) {
  return Eigen::Map<const Eigen::Matrix<double, 9, 1>>(R.data());
}

template <std::size_t Count>
Eigen::Matrix<double, Count / kLanes, 1> laneOf(const double (&values)[Count], Eigen::Index lane) {
  return Eigen::Map<const Lanes>(values, Count / kLanes, kLanes).col(lane);
}

inline Eigen::Matrix3d matrixIn(const double (&values)[9 * kLanes], Eigen::Index lane) {
  const Eigen::Matrix<double, 9, 1> column = laneOf(values, lane);
  return Eigen::Map<const MatrixByRows>(column.data());
}

}  // namespace hexoderm
