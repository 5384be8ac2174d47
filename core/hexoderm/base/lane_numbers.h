#pragma once

// Views of one lane in the arrays that kernels read and write, which hold kLanes lanes side by side.

#include "hexoderm/base/lanes.h"

#include <Eigen/Core>
#include <cstddef>
#include <type_traits>

namespace hexoderm {

/// 3 x 3, row by row. `Number`: double, or const double where nothing is to be written.
template <class Number>
auto matrixOfLane(Number* numbers, std::size_t lane) {
  using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  using Matching = std::conditional_t<std::is_const_v<Number>, const Matrix, Matrix>;
  return Eigen::Map<Matching, Eigen::Unaligned, Eigen::Stride<3 * kLanes, kLanes>>(numbers + lane);
}
template <class Number>
auto vectorOfLane(Number* numbers, std::size_t lane) {
  using Matching = std::conditional_t<std::is_const_v<Number>, const Eigen::Vector3d, Eigen::Vector3d>;
  return Eigen::Map<Matching, Eigen::Unaligned, Eigen::InnerStride<kLanes>>(numbers + lane);
}
/// Given as xx, xy, xz, yy, yz, zz.
inline Eigen::Matrix3d symmetricOfLane(const double* numbers, std::size_t lane) {
  const auto at = [&](std::size_t k) { return numbers[kLanes * k + lane]; };
  Eigen::Matrix3d matrix;
  matrix << at(0), at(1), at(2), at(1), at(3), at(4), at(2), at(4), at(5);
  return matrix;
}

}  // namespace hexoderm
