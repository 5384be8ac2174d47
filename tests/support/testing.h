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
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {

using test::expectRefusedWhereverCutOff;
using test::messageOf;
using test::replaced;
using test::saysAll;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

}  // namespace hexoderm
