#pragma once

// What nearly every test of core needs.

#include "tests/support/error_matchers.h"

#include <gmock/gmock.h>
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace hexoderm::test {

/// A member of each item, or what a function makes of it.
template <class Items, class Projection>
auto collect(const Items& items, Projection projection) {
  std::vector<std::remove_cvref_t<std::invoke_result_t<Projection&, decltype(*std::begin(items))>>> result;
  for (const auto& item : items) result.push_back(std::invoke(projection, item));
  return result;
}

}  // namespace hexoderm::test

namespace hexoderm {

using test::collect;
using test::expectRefusedWhereverCutOff;
using test::messageOf;
using test::replaced;
using test::saysAll;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

}  // namespace hexoderm
