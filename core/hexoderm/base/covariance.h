#pragma once

#include "hexoderm/base/limits.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace hexoderm {

/// Whether a matrix can be a covariance: symmetric, and no combination of its variables has a negative variance (it is
/// positive semidefinite), to a billionth of its largest variance, which rounding takes. Zero, for "not known", is one.
template <class Derived>
bool isCovariance(const Eigen::MatrixBase<Derived>& values) {
  using Matrix = typename Derived::PlainObject;
  constexpr double kRounding = 1e-9;
  const double largest = values.diagonal().maxCoeff();
  if (largest == 0) return (values.array() == 0).all();
  if (!(largest > 0)) return false;
  const Matrix scaled = values / largest;
  if (!isWithin(scaled, 1 + kRounding)) return false;  // none is larger than the variances of its two variables
  if (!isWithin(scaled - scaled.transpose(), kRounding)) return false;
  if (scaled.diagonal().minCoeff() < 0) return false;
  return Eigen::LLT<Matrix>(scaled + kRounding * Matrix::Identity()).info() == Eigen::Success;
}

/// The upper triangle of a symmetric matrix row by row, as files have it, and the matrix of it.
template <class Derived, int Size = Derived::RowsAtCompileTime,
          std::size_t Count = static_cast<std::size_t>(Size*(Size + 1) / 2)>
std::array<double, Count> upperTriangle(const Eigen::MatrixBase<Derived>& matrix) {
  static_assert(Size > 0, "of a size known when it is compiled");
  std::array<double, Count> values{};
  std::size_t next = 0;
  for (int row = 0; row < Size; ++row) {
    for (int column = row; column < Size; ++column) values[next++] = matrix(row, column);
  }
  return values;
}
template <int Size, std::size_t Count = static_cast<std::size_t>(Size*(Size + 1) / 2)>
Eigen::Matrix<double, Size, Size> fromUpperTriangle(const std::array<double, Count>& values) {
  Eigen::Matrix<double, Size, Size> matrix;
  std::size_t next = 0;
  for (int row = 0; row < Size; ++row) {
    for (int column = row; column < Size; ++column) matrix(row, column) = matrix(column, row) = values[next++];
  }
  return matrix;
}

/// Standard deviation along the worst direction of a 3 x 3 covariance: the root of its largest eigenvalue, within 1e-7
/// of it. 0 where rounding leaves nothing positive.
double largestDeviation(const Eigen::Matrix3d& covariance);

/// Times the deviation along an axis: what is within with 95 % probability, along that axis.
inline constexpr double kSigmasFor95Percent = 1.96;

/// The region that holds a normally distributed point with 95 % probability, as the image of the unit sphere: x = A s
/// with |s| <= 1. The columns of A are the semi-axes, the longest last, sqrt(7.815) = 2.795 deviations long (chi square
/// with three degrees of freedom): more than kSigmasFor95Percent, which is about one direction only.
Eigen::Matrix3d ellipsoid95(const Eigen::Matrix3d& covariance);

}  // namespace hexoderm
