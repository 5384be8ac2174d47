#include "app/python/arrays.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace hexoderm::python {
namespace {

std::string axisText(const Axis& axis) {
  if (axis.name == nullptr) return std::to_string(*axis.length);
  return axis.name + (axis.length ? "=" + std::to_string(*axis.length) : std::string());
}

std::string shapeText(const std::vector<Axis>& shape) {
  return "(" + inARow(shape, axisText) + (shape.size() == 1 ? ",)" : ")");
}

/// Exact: no fraction is cut off, and nothing is wrapped around.
bool areWhole(const Doubles& values) {
  constexpr double kMax = 1e15;
  return std::all_of(values.data(), values.data() + values.size(),
                     [](double value) { return std::abs(value) <= kMax && value == std::floor(value); });
}

}  // namespace

Doubles unknowns(std::initializer_list<std::size_t> shape) {
  Doubles array(std::vector<pybind11::ssize_t>(shape.begin(), shape.end()));
  std::fill_n(array.mutable_data(), array.size(), std::numeric_limits<double>::quiet_NaN());
  return array;
}

Numbers wholeNumbers(const pybind11::object& given, const char* what) {
  const auto array = pybind11::array::ensure(given);
  if (!array) throw pybind11::error_already_set();
  const char kind = array.dtype().kind();
  // Numbers that a text file held, as numpy.loadtxt() has them, are floating.
  const bool is_whole = kind == 'f' && areWhole(Doubles::ensure(array));
  if (kind == 'i' || kind == 'u' || is_whole || array.size() == 0) {
    return Numbers::ensure(array.attr("astype")("int64"));
  }
  throw InvalidArgument(std::string(what) + ": expected whole numbers");
}

void requireShape(const pybind11::array& array, const std::vector<Axis>& shape, const char* what,
                  const std::string& advice) {
  const std::vector<pybind11::ssize_t> found(array.shape(), array.shape() + array.ndim());
  const auto fits = [](pybind11::ssize_t size, const Axis& axis) { return !axis.length || size == *axis.length; };
  if (std::ranges::equal(found, shape, fits)) return;
  throw InvalidArgument(std::string(what) + ": expected the shape " + shapeText(shape) + ", found " +
                        shapeText(std::vector<Axis>(found.begin(), found.end())) + advice);
}

}  // namespace hexoderm::python
