#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <type_traits>
#include <utility>

namespace hexoderm::python {

/// "int: 7", for errors.
std::string foundText(pybind11::handle object);
[[noreturn]] void failFor(const char* name, const std::string& expected, pybind11::handle found);

/// What errors expect where a T is needed.
template <class T>
std::string expectedOf() {
  if constexpr (std::is_same_v<T, std::string>) return "a string";
  if constexpr (std::is_same_v<T, bool>) return "True or False";
  if constexpr (std::is_floating_point_v<T>) return "a number";
  if constexpr (std::is_unsigned_v<T>) return "a whole number of at least 0";
  return "another type";
}

/// An argument that the function itself converts, so that an error has its name: what pybind11 says of one that does
/// not fit names none. help() shows a T.
template <class T>
class Argument {
 public:
  explicit Argument(pybind11::object object) : object_(std::move(object)) {}
  /// Throws TypeError naming the argument.
  [[nodiscard]] decltype(auto) as(const char* name, const std::string& expected = expectedOf<T>()) const {
    constexpr bool kIsOfPython =
        std::is_base_of_v<pybind11::detail::type_caster_generic, pybind11::detail::make_caster<T>>;
    pybind11::detail::make_caster<T> caster;
    if ((kIsOfPython && object_.is_none()) || !caster.load(object_, true)) failFor(name, expected, object_);
    // A reference to what Python holds, or else a copy of what the caster does.
    if constexpr (kIsOfPython) {
      return static_cast<T&>(pybind11::detail::cast_op<T&>(caster));
    } else {
      return T(pybind11::detail::cast_op<T>(std::move(caster)));
    }
  }
  [[nodiscard]] const pybind11::object& object() const { return object_; }

 private:
  pybind11::object object_;
};

/// Has calls that do not fit told which argument is to blame, instead of the dump of all signatures.
/// `function`: one of the module, or of the class that it is a method of.
void explainMisfits(pybind11::handle scope, const char* name);

}  // namespace hexoderm::python

namespace pybind11::detail {

template <class T>
struct type_caster<hexoderm::python::Argument<T>> {
  static constexpr auto name = make_caster<T>::name;
  template <class>
  using cast_op_type = hexoderm::python::Argument<T>;

  bool load(handle source, bool /*convert*/) {
    object_ = reinterpret_borrow<object>(source);
    return true;
  }
  explicit operator hexoderm::python::Argument<T>() { return hexoderm::python::Argument<T>(object_); }

 private:
  object object_;
};

}  // namespace pybind11::detail
