#pragma once

#include <cstddef>
#include <initializer_list>

namespace hexoderm {

/// What stands for an enumerator in a list that has one for each, in the order of their declaration.
template <class Enum, class Value>
Value ofEnum(Enum which, std::initializer_list<Value> values) {
  const auto index = static_cast<std::size_t>(which);
  return index < values.size() ? values.begin()[index] : Value();
}

}  // namespace hexoderm
