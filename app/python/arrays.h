#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/se3.h"

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
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

template <int Rows, int Columns, int Options>
Doubles arrayOf(const Eigen::Matrix<double, Rows, Columns, Options>& matrix) {
  Doubles array = Columns == 1 ? Doubles(Rows) : Doubles({Rows, Columns});
  copyTo(array.mutable_data(), matrix);
  return array;
}

/// (N, 3) or (N, n, n): what `get`, a function or a member, says of each item, a vector or matrix or an optional one.
/// NaN where it says nothing.
template <class Items, class Get>
Doubles stacked(const Items& items, const Get& get) {
  using Matrix = typename decltype(std::optional(std::invoke(get, *items.begin())))::value_type;
  constexpr std::size_t kRows = Matrix::RowsAtCompileTime;
  constexpr std::size_t kColumns = Matrix::ColsAtCompileTime;
  Doubles array = kColumns == 1 ? unknowns({items.size(), kRows}) : unknowns({items.size(), kRows, kColumns});
  double* out = array.mutable_data();
  for (const auto& item : items) {
    if (const std::optional values = std::invoke(get, item)) copyTo(out, *values);
    out += kRows * kColumns;
  }
  return array;
}

/// (N,): what `get`, a function or a member, says of each item.
template <class Number, class Items, class Get>
pybind11::array_t<Number> row(const Items& items, const Get& get) {
  pybind11::array_t<Number> array(static_cast<pybind11::ssize_t>(items.size()));
  std::ranges::transform(items, array.mutable_data(), [&](const auto& item) { return Number(std::invoke(get, item)); });
  return array;
}
/// The numbers of the IDs that a member of each item is.
template <class Items, class Item, class Tag>
pybind11::array_t<std::int64_t> numbersOf(const Items& items, StrongId<Tag> Item::*id) {
  return row<std::int64_t>(items, [id](const Item& item) { return (item.*id).value(); });
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
