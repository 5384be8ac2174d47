#pragma once

// How Python sees core's values, by conversions of pybind11: IDs as numbers, messages and names of enumerations as
// strings, matrices as arrays of their own.

#include "app/python/arrays.h"

#include "hexoderm/base/message.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <type_traits>
#include <utility>

namespace hexoderm::python {

/// To Python only: as what `seen` makes of the value.
template <class Value, auto seen>
struct SeenAs {
  using Caster = pybind11::detail::make_caster<std::remove_cvref_t<std::invoke_result_t<decltype(seen), const Value&>>>;
  static constexpr auto name = Caster::name;
  template <class>
  using cast_op_type = Value;

  static pybind11::handle cast(const Value& value, pybind11::return_value_policy policy, pybind11::handle parent) {
    return Caster::cast(std::invoke(seen, value), policy, parent);
  }
};

inline std::pair<std::uint32_t, std::uint32_t> numbersOfEnd(const LinkEnd& end) {
  return {end.cell.value(), end.port.value()};
}

}  // namespace hexoderm::python

namespace pybind11::detail {

template <class Tag>
struct type_caster<hexoderm::StrongId<Tag>>
    : hexoderm::python::SeenAs<hexoderm::StrongId<Tag>, &hexoderm::StrongId<Tag>::value> {};
template <>
struct type_caster<hexoderm::LinkEnd> : hexoderm::python::SeenAs<hexoderm::LinkEnd, hexoderm::python::numbersOfEnd> {};
template <>
struct type_caster<hexoderm::Message> : hexoderm::python::SeenAs<hexoderm::Message, &hexoderm::Message::english> {};
template <>
struct type_caster<hexoderm::FindingCode> : hexoderm::python::SeenAs<hexoderm::FindingCode, hexoderm::codeName> {};
template <>
struct type_caster<hexoderm::Severity> : hexoderm::python::SeenAs<hexoderm::Severity, hexoderm::severityName> {};
template <>
struct type_caster<hexoderm::VerdictLevel> : hexoderm::python::SeenAs<hexoderm::VerdictLevel, hexoderm::verdictName> {};
template <>
struct type_caster<hexoderm::Limit> : hexoderm::python::SeenAs<hexoderm::Limit, hexoderm::limitName> {};
template <>
struct type_caster<hexoderm::Remedy> : hexoderm::python::SeenAs<hexoderm::Remedy, hexoderm::remedyName> {};
template <>
struct type_caster<hexoderm::EdgeQuality> : hexoderm::python::SeenAs<hexoderm::EdgeQuality, hexoderm::qualityName> {};
template <int Rows, int Columns, int Options>
struct type_caster<Eigen::Matrix<double, Rows, Columns, Options>>
    : hexoderm::python::SeenAs<Eigen::Matrix<double, Rows, Columns, Options>,
                               hexoderm::python::arrayOf<Rows, Columns, Options>> {};

}  // namespace pybind11::detail
