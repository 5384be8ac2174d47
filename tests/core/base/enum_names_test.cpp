#include "hexoderm/base/enum_names.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

enum class Fruit { Apple, Pear, Plum };
struct Tree {
  enum class Kind { Broad, Needle };
};
static_assert(enumeratorCount<Fruit>() == 3);
static_assert(enumeratorCount<Tree::Kind>() == 2);

TEST(EnumNames, GoBothWays) {
  constexpr EnumNames<Fruit> kNames = {{"apple", "pear", "plum"}};
  EXPECT_EQ(kNames.of(Fruit::Plum), "plum");
  EXPECT_EQ(kNames.find("pear"), Fruit::Pear);
  EXPECT_EQ(kNames.find("cherry"), std::nullopt);
  EXPECT_EQ(kNames.find(""), std::nullopt);
}

}  // namespace
}  // namespace hexoderm
