#pragma once

#include <type_traits>
#include <utility>

namespace hexoderm::test {

/// Options with one of them set: `with(&SolverOptions::centring, Centring::On)`.
template <class Options, class Value>
Options with(Value Options::*option, std::type_identity_t<Value> value) {
  Options options;
  options.*option = std::move(value);
  return options;
}

/// ... with one of them set otherwise than in others.
template <class Options, class Value>
Options with(Options options, Value Options::*option, std::type_identity_t<Value> value) {
  options.*option = std::move(value);
  return options;
}

}  // namespace hexoderm::test
