#pragma once

#include "hexoderm/util/limits.h"

#include <Eigen/Cholesky>

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

}  // namespace hexoderm
