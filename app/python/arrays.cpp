#include "app/python/arrays.h"

#include "hexoderm/util/error.h"

#include <algorithm>
#include <string>

namespace hexoderm::python {
namespace {

template <class Sizes>
std::string shapeInWords(const Sizes& sizes) {
  std::string words = "(";
  std::size_t count = 0;
  for (const pybind11::ssize_t size : sizes) {
    words += (count++ == 0 ? "" : ", ") + (size < 0 ? std::string("any") : std::to_string(size));
  }
  return words + (count == 1 ? ",)" : ")");
}

}  // namespace

Doubles unknowns(std::initializer_list<std::size_t> shape) {
  Doubles array(std::vector<pybind11::ssize_t>(shape.begin(), shape.end()));
  std::fill_n(array.mutable_data(), array.size(), std::numeric_limits<double>::quiet_NaN());
  return array;
}

Doubles arrayOf(const Eigen::Vector3d& vector) {
  Doubles array(3);
  copyTo(array.mutable_data(), vector);
  return array;
}

Doubles arrayOf(const Eigen::Matrix3d& matrix) {
  Doubles array({3, 3});
  copyTo(array.mutable_data(), matrix);
  return array;
}

Doubles arrayOf(const Matrix6d& matrix) {
  Doubles array({6, 6});
  copyTo(array.mutable_data(), matrix);
  return array;
}

Numbers wholeNumbers(const pybind11::object& given, const char* what) {
  const auto array = pybind11::array::ensure(given);
  if (!array) throw pybind11::error_already_set();
  const char kind = array.dtype().kind();
  if (kind == 'i' || kind == 'u' || array.size() == 0) return Numbers::ensure(array.attr("astype")("int64"));
  throw InvalidArgument(std::string(what) + ": expected whole numbers");
}

void requireShape(const pybind11::array& array, const std::vector<pybind11::ssize_t>& shape, const char* what) {
  const std::vector<pybind11::ssize_t> found(array.shape(), array.shape() + array.ndim());
  const auto fits = [](pybind11::ssize_t size, pybind11::ssize_t wanted) { return wanted < 0 || size == wanted; };
  if (std::ranges::equal(found, shape, fits)) return;
  throw InvalidArgument(std::string(what) + ": expected the shape " + shapeInWords(shape) + ", found " +
                        shapeInWords(found));
}

}  // namespace hexoderm::python
