#include "hexoderm/base/median.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

TEST(Median, IsTheOneInTheMiddleOrTheUpperOneOfTwo) {
  EXPECT_EQ(median({}), 0);
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({3, 1}), 3);
  EXPECT_EQ(median({5, -1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 3);
}

}  // namespace
}  // namespace hexoderm
