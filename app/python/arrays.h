#pragma once

#include "hexoderm/geometry/se3.h"
#include "hexoderm/util/ids.h"

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace hexoderm::python {

/// As an argument it takes whatever NumPy makes such an array of: a list, for example.
using Doubles = pybind11::array_t<double, pybind11::array::c_style>;
/// Not as an argument: NumPy would cut the fractions of a list off, see wholeNumbers().
using Numbers = pybind11::array_t<std::int64_t, pybind11::array::c_style>;

/// A new array of this shape, filled with NaN: "not known".
Doubles unknowns(std::initializer_list<std::size_t> shape);

/// Row by row, as NumPy has it.
template <class Matrix>
void copyTo(double* out, const Matrix& values) {
  for (Eigen::Index row = 0; row < values.rows(); ++row) {
    for (Eigen::Index column = 0; column < values.cols(); ++column) *out++ = values(row, column);
  }
}

Doubles arrayOf(const Eigen::Vector3d& vector);
Doubles arrayOf(const Eigen::Matrix3d& matrix);
Doubles arrayOf(const Matrix6d& matrix);

/// (N, 3) or (N, n, n): what `get`, a function or a member, says of each item, an optional vector or matrix. NaN where
/// it says nothing.
template <class Items, class Get>
Doubles stacked(const Items& items, const Get& get) {
  using Matrix = typename std::remove_cvref_t<decltype(std::invoke(get, *items.begin()))>::value_type;
  constexpr std::size_t kRows = Matrix::RowsAtCompileTime;
  constexpr std::size_t kColumns = Matrix::ColsAtCompileTime;
  Doubles array = kColumns == 1 ? unknowns({items.size(), kRows}) : unknowns({items.size(), kRows, kColumns});
  double* out = array.mutable_data();
  for (const auto& item : items) {
    if (const std::optional<Matrix> values = std::invoke(get, item)) copyTo(out, *values);
    out += kRows * kColumns;
  }
  return array;
}

/// What `get` says of each item: whole numbers.
template <class Items, class Get>
Numbers numbersOf(const Items& items, const Get& get) {
  Numbers array(static_cast<pybind11::ssize_t>(items.size()));
  std::int64_t* out = array.mutable_data();
  for (const auto& item : items) *out++ = static_cast<std::int64_t>(get(item));
  return array;
}

/// The numbers of IDs, as a list of Python.
template <class Ids>
std::vector<std::uint32_t> valuesOf(const Ids& ids) {
  std::vector<std::uint32_t> values;
  values.reserve(ids.size());
  for (const auto& id : ids) values.push_back(id.value());
  return values;
}

/// Of whatever NumPy makes an array of. Throws InvalidArgument naming `what` if these are no whole numbers.
Numbers wholeNumbers(const pybind11::object& given, const char* what);

/// An axis of an array as errors say it: "cells", "cells=17" or "3".
struct Axis {
  Axis(pybind11::ssize_t fixed) : length(fixed) {}
  /// Without a length, of any.
  Axis(const char* axis, std::optional<pybind11::ssize_t> known = std::nullopt) : name(axis), length(known) {}

  const char* name = nullptr;
  std::optional<pybind11::ssize_t> length;
};
/// Throws InvalidArgument naming `what` unless the array has this shape; `advice` ends the sentence.
void requireShape(const pybind11::array& array, const std::vector<Axis>& shape, const char* what,
                  const std::string& advice = {});

}  // namespace hexoderm::python
