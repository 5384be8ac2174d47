#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

namespace hexoderm::test {

template <class Options>
Options with(Options options) {
  return options;
}

/// Options with some of them changed: `with(options, &SolverOptions::solver, Solver::Tree, &SolverOptions::weights,
/// ...)`.
template <class Options, class Owner, class Value, class... Others>
requires std::derived_from<Options, Owner> Options with(Options options, Value Owner::*option,
                                                        std::type_identity_t<Value> value, Others... others) {
  options.*option = std::move(value);
  return with(std::move(options), std::move(others)...);
}

/// The same of the defaults: `with(&SolverOptions::centring, Centring::On)`.
template <class Options, class Value, class... Others>
Options with(Value Options::*option, std::type_identity_t<Value> value, Others... others) {
  return with(Options(), option, std::move(value), std::move(others)...);
}

}  // namespace hexoderm::test
