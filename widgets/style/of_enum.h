#pragma once

#include "hexoderm/base/enum_names.h"

#include <cstddef>

namespace hexoderm {

/// What stands for an enumerator in a list of values, in the order of their declaration. Each enumerator has one, or it
/// does not compile.
template <class Enum, class Value, std::size_t kCount>
Value ofEnum(Enum which, const Value (&values)[kCount]) {
  static_assert(kCount == enumeratorCount<Enum>(), "one value for each enumerator");
  return values[static_cast<std::size_t>(which)];
}

}  // namespace hexoderm
